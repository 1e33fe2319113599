#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>
#include <utility>

#include "trama/core/names.hpp"
#include "trama/core/rule.hpp"
#include "trama/core/wire.hpp"

namespace trama {

template <class T>
struct member_traits;
template <class M, class V>
struct member_traits<V M::*> {
    using message = M;
    using value = V;
};

/// A field that is always there.
inline constexpr auto always = nullptr;

/// One member of a message: where its value lives, how it is written, what it may be, what it means.
/// `Present` is a member function that tells whether the field exists in a given message.
template <auto Member, class Wire, auto Present = always>
struct field {
    using wire_type = Wire;
    using value = typename member_traits<decltype(Member)>::value;
    using message = typename member_traits<decltype(Member)>::message;
    static constexpr auto member = Member;
    static constexpr auto present = Present;
    static constexpr bool optional = !std::is_null_pointer_v<decltype(Present)>;
    static constexpr std::size_t size = optional ? 0 : Wire::size;

    std::string_view name;
    rule allowed{};
    std::string_view meaning{};

    template <class M>
    static constexpr bool exists([[maybe_unused]] const M& m) noexcept {
        if constexpr (optional) return (m.*Present)();
        else return true;
    }
};

/// One slot of a `fields` list. Plain inheritance: std::tuple costs a third of the compile time.
template <std::size_t I, class Field>
struct slot { Field value; };

template <class Indices, class... Fields>
struct slots;
template <std::size_t... I, class... Fields>
struct slots<std::index_sequence<I...>, Fields...> : slot<I, Fields>... {};

template <std::size_t I, class Field>
constexpr const Field& slot_at(const slot<I, Field>& s) noexcept { return s.value; }

/// The most bytes that a field can take.
template <class Field>
constexpr std::size_t max_size_of() noexcept {
    if constexpr (wire::variable<typename Field::wire_type>) return Field::wire_type::max_size;
    else return Field::wire_type::size;
}

/// The wire layout of a message: its fields in wire order, without gaps.
template <class... Fields>
struct fields {
    slots<std::index_sequence_for<Fields...>, Fields...> list;
    static constexpr std::size_t count = sizeof...(Fields);
    static constexpr bool fixed = (true && ... && !(Fields::optional || wire::variable<typename Fields::wire_type>));
    static constexpr std::size_t size = (std::size_t{0} + ... + Fields::size);  ///< Of the fields that are always there.
    static constexpr std::size_t max_size = (std::size_t{0} + ... + max_size_of<Fields>());
    static constexpr auto offsets = [] {  ///< Of each field, valid where no variable one precedes it.
        std::array<std::size_t, count + 1> at{};
        std::size_t i = 0;
        ((at[i + 1] = at[i] + Fields::size, ++i), ...);
        return at;
    }();

    constexpr explicit fields(Fields... f) : list{{f}...} {}
};

/// The I-th field as an object of its own: g++ folds its bounds, which it does not do inside a tuple.
template <class M, std::size_t I>
inline constexpr auto field_of = slot_at<I>(M::layout.list);

/// A type that declares its fields: a message or a nested structure.
template <class T>
concept has_layout = requires { T::layout.max_size; };

/// Calls `f.operator()<I>()` for the position of every field, in wire order.
template <has_layout M>
constexpr void each_index(auto&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (f.template operator()<I>(), ...); }(std::make_index_sequence<M::layout.count>{});
}
/// The same for hot paths. Printing must not use it: inlining everything there costs half a minute of compile time.
template <has_layout M>
[[gnu::always_inline]] constexpr void each_index_inline(auto&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) { (f.template operator()<I>(), ...); }(std::make_index_sequence<M::layout.count>{});
}

/// Reflection: calls `f(name, value)` for every top-level field that exists in `m`, in wire order. `value` is the
/// member itself: a number, an enumerator, a text, a list, a nested structure (with a layout of its own).
template <has_layout M>
constexpr void for_each_field(const M& m, auto&& f) {
    each_index<M>([&]<std::size_t I>() {
        constexpr auto& one = field_of<M, I>;
        if (one.exists(m)) f(one.name, m.*one.member);
    });
}

/// Position of the field that `Member` points to; no such field does not compile.
template <has_layout M, auto Member>
constexpr std::size_t index_of() noexcept {
    std::size_t found = M::layout.count;
    each_index<M>([&]<std::size_t I>() {
        if constexpr (std::is_same_v<std::remove_cv_t<decltype(Member)>, std::remove_cv_t<decltype(field_of<M, I>.member)>>)
            if (field_of<M, I>.member == Member) found = I;
    });
    return found;
}

}  // namespace trama
