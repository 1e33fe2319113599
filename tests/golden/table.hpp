#pragma once
/// Tables of golden vectors: each row is a packet as hand-worked units, the message it carries and its JSON.
/// `proven<table>` checks them at compile time, the functions of check.hpp again, and more closely, at run time.

#include <string_view>
#include <utility>

#include "properties.hpp"
#include "trama/core/layout.hpp"

namespace trama::golden {

template <wire_format F, class M, std::size_t N>
struct row {
    using format = F;
    using message = M;
    std::string_view name;  ///< As JSON and command line call the message.
    std::array<typename F::unit, N> wire;
    typename F::envelope envelope;
    M value;
    std::string_view json;  ///< Its fields.

    constexpr std::span<const typename F::unit> units() const { return wire; }
};

/// Rows of any types. Held as a layout holds its fields, which compiles faster than a std::tuple.
template <class... Rows>
struct table {
    slots<std::index_sequence_for<Rows...>, Rows...> list;
    static constexpr auto indices = std::index_sequence_for<Rows...>{};

    constexpr explicit table(const Rows&... rows) : list{{rows}...} {}
};

/// The bytes that a literal spells in hex, one space between them. Anything else does not compile.
template <std::size_t Size>
consteval std::array<std::uint8_t, Size / 3> octets(const char (&hex)[Size]) {
    static_assert(Size % 3 == 0);
    const auto digit = [](char c) -> int { return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : throw "no hex digit"; };
    std::array<std::uint8_t, Size / 3> out{};
    for (std::size_t i = 0; i != out.size(); ++i) {
        out[i] = static_cast<std::uint8_t>(digit(hex[3 * i]) * 16 + digit(hex[3 * i + 1]));
        if (3 * i + 3 != Size && hex[3 * i + 2] != ' ') throw "no space between bytes";
    }
    return out;
}
/// The characters of a literal, without its end.
template <std::size_t Size>
consteval std::array<std::uint8_t, Size - 1> characters(const char (&s)[Size]) {
    std::array<std::uint8_t, Size - 1> out{};
    for (std::size_t i = 0; i != out.size(); ++i) out[i] = static_cast<std::uint8_t>(s[i]);
    return out;
}

/// Calls `f(row)` for every row.
template <class Table>
constexpr void each_row(const Table& table, auto&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (f(slot_at<I>(table.list)), ...); }(table.indices);
}

/// Encodes to exactly its units and decodes from them, whole and in some chunks.
constexpr bool holds(const auto& row, std::size_t stride) {
    using F = typename std::remove_cvref_t<decltype(row)>::format;
    const properties::expected_message<F, std::remove_cvref_t<decltype(row.value)>> expected(row.envelope, row.value);
    return row.name == row.value.name && properties::encodes_to<F>(row.envelope, row.value, row.units(), stride) &&
           properties::decodes_in_chunks<F>(expected, row.units(), stride) && properties::decodes_at_splits<F>(expected, row.units(), stride);
}

/// One row's proof, so that the compiler names the row that fails, and so that each has its own step budget.
template <const auto& Table, std::size_t I>
struct proof {
    static constexpr auto& one = slot_at<I>(Table.list);
    static_assert(holds(one, one.wire.size() < 16 ? 3 : 61), "row I of Table does not hold");
    static constexpr bool value = true;
};
template <const auto& Table>
inline constexpr bool proven = []<std::size_t... I>(std::index_sequence<I...>) {
    return (proof<Table, I>::value && ...);
}(Table.indices);

/// True when every message of `List` has a row.
template <class List, class Table>
constexpr bool covers(const Table& table) {
    bool all = true;
    List::each([&]<class M>() {
        bool found = false;
        each_row(table, [&](const auto& row) { found = found || std::is_same_v<M, typename std::remove_cvref_t<decltype(row)>::message>; });
        all = all && found;
    });
    return all;
}

}  // namespace trama::golden
