#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace trama {

/// One enumerator and the name the protocol document gives it.
template <class E>
struct named {
    E value;
    std::string_view name;
};
template <class E>
named(E, const char*) -> named<E>;  // clang 14 has no deduction guides for aggregates

/// An enumeration whose values are listed by `names(E)`, found by argument-dependent lookup.
/// The list is validator and printer; values without a name are kept as numbers.
template <class E>
concept enumerated = std::is_enum_v<E> && requires { names(E{}); };

/// An enumerated type whose values combine: `flags(E)` is declared beside `names(E)` and gives all bits that the wire can carry.
template <class E>
concept flag_set = enumerated<E> && requires { flags(E{}); };

/// True when `value` has a name. Any union of bits is fine for a flag set.
template <enumerated E>
constexpr bool is_listed(E value) noexcept {
    if constexpr (flag_set<E>) {
        return true;
    } else {
        constexpr auto table = names(E{});
        // As uintmax_t, since a value may be wider than std::size_t.
        constexpr bool dense = [&] {
            for (std::size_t i = 0; i != table.size(); ++i)
                if (static_cast<std::uintmax_t>(table[i].value) != i) return false;
            return true;
        }();
        if constexpr (dense) return static_cast<std::uintmax_t>(value) < table.size();
        for (const auto& e : table)
            if (e.value == value) return true;
        return false;
    }
}

/// The document's name of `value`, empty when it has none; its data end in NUL in either case.
template <enumerated E>
constexpr std::string_view name_of(E value) noexcept {
    constexpr auto table = names(E{});
    for (const auto& e : table)
        if (e.value == value) return e.name;
    return "";
}

/// The names alone, in the order of their declaration.
template <enumerated E>
inline constexpr auto name_list = [] {
    constexpr auto table = names(E{});
    std::array<std::string_view, table.size()> list{};
    for (std::size_t i = 0; i != table.size(); ++i) list[i] = table[i].name;
    return list;
}();

}  // namespace trama
