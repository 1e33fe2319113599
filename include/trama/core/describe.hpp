#pragma once

#include "trama/core/print.hpp"

namespace trama {

/// One line of a message's layout table.
struct layout_row {
    std::string_view name;     ///< Field, or sub-field of a structure.
    std::string_view parent;   ///< The structure's field, else empty.
    std::size_t count = 1;     ///< Elements of an array.
    std::size_t offset = 0;    ///< Of the first byte, from the first field of the message; see `from_end`.
    bool from_end = false;     ///< A field of varying size precedes: `offset` counts back from the end, 1 is the last byte.
    std::size_t size = 0;      ///< Bytes of one element; 0 if it varies.
    std::size_t stride = 0;    ///< Bytes from one element of the surrounding array to the next.
    std::string_view type;     ///< Name of the wire type.
    const rule* allowed = nullptr;             ///< Its own rule, its names, or what the wire can carry; null of texts, flag sets and structures without a rule.
    std::string_view meaning;
    char constant = '\0';                      ///< A byte that follows and is always the same.
    bool optional = false;                     ///< Exists only in some messages.
    std::size_t split = 0;                     ///< Of a structure in two pieces, the bytes of the first; `size` is that of both.
    std::span<const std::string_view> flags{}; ///< Of a flag set, the names of its bits, lowest first.
};

inline constexpr rule tenths_range{0, 0, 0, 0, {}, "0.0..999.9"};

/// The numbers that wire type `W` can carry, spelled as it prints them.
template <class W>
constexpr const rule& printed_range() noexcept {
    if constexpr (W::printed == wire::print::tenths) return tenths_range;
    else return wire_rule<W>;
}

/// What is to be said about a value: the field's own rule, its names, or what the wire can carry; null of texts, flag sets and structures without a rule.
template <class W, class V>
constexpr const rule* documented_rule(const rule& own) noexcept {
    if (!own.any()) return &own;
    if constexpr (requires { typename W::element; }) return documented_rule<typename W::element, typename W::element::value>(own);
    else if constexpr (flag_set<V>) return nullptr;
    else if constexpr (enumerated<V>) return &names_rule<V>;
    else if constexpr (requires { W::low; W::printed; }) return &printed_range<W>();
    else return nullptr;
}

namespace detail {

template <class M, std::size_t I>
constexpr layout_row row_of(std::size_t offset) noexcept {
    using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
    using wire_type = typename one::wire_type;
    layout_row row{};
    row.name = field_of<M, I>.name;
    row.offset = offset;
    row.type = wire_type::type_name;
    row.meaning = field_of<M, I>.meaning;
    row.allowed = documented_rule<wire_type, typename one::value>(field_of<M, I>.allowed);
    row.optional = one::optional;
    row.size = wire_type::size;
    if constexpr (requires { wire_type::first_piece; }) {
        row.size = wire_type::value::layout.size;
        row.split = wire_type::first_piece;
    }
    if constexpr (flag_set<typename one::value>) row.flags = name_list<typename one::value>;
    if constexpr (requires { wire_type::constant; }) { row.constant = wire_type::constant; row.size -= 1; }
    if constexpr (requires { typename wire_type::element; }) {
        row.count = wire_type::max_count;
        row.size = wire_type::element::size;
        row.stride = wire_type::element::size;
    }
    return row;
}

/// The structure inside a field, if there is one.
template <class Wire>
struct structure { using type = void; };
template <class T>
struct structure<wire::record<T>> { using type = T; };
template <class T, std::size_t... N>
struct structure<wire::torn_record<T, N...>> { using type = T; };
template <class Element, std::size_t Count>
struct structure<wire::repeated<Element, Count>> : structure<Element> {};

template <class Wire>
constexpr std::size_t torn(std::size_t offset) noexcept {
    if constexpr (requires { Wire::at(offset); }) return Wire::at(offset);
    else return offset;
}

/// Of a field behind one of varying size, how far its first byte lies before the end of the message; 0 of all others.
template <has_layout M, std::size_t I>
inline constexpr std::size_t from_end = [] {
    bool floats = false;
    std::size_t bytes = 0;
    each_index<M>([&]<std::size_t J>() {
        using wire_type = typename std::remove_cvref_t<decltype(field_of<M, J>)>::wire_type;
        floats = floats || (J < I && wire::variable<wire_type>);
        if (J >= I) bytes += wire_type::size;
    });
    return floats ? bytes : 0;
}();

}  // namespace detail

/// Calls `f(const layout_row&)` for every field of `M`, those of nested structures after the field that holds them.
template <has_layout M>
constexpr void for_each_row(auto&& f) {
    each_index<M>([&]<std::size_t I>() {
        using wire_type = typename std::remove_cvref_t<decltype(field_of<M, I>)>::wire_type;
        layout_row outer = detail::row_of<M, I>(M::layout.offsets[I]);
        if constexpr (detail::from_end<M, I> != 0) {
            outer.offset = detail::from_end<M, I>;
            outer.from_end = true;
        }
        f(outer);
        using inner = typename detail::structure<wire_type>::type;
        if constexpr (has_layout<inner>)
            each_index<inner>([&]<std::size_t J>() {
                layout_row row = detail::row_of<inner, J>(outer.offset + detail::torn<wire_type>(inner::layout.offsets[J]));
                row.parent = outer.name;
                row.count = outer.count;
                row.stride = outer.stride;
                f(row);
            });
    });
}

}  // namespace trama
