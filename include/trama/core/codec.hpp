#pragma once

#include "trama/core/column_map.hpp"
#include "trama/core/layout.hpp"

namespace trama {

template <has_layout M>
constexpr std::uint64_t load_fields(const std::uint8_t* p, M& m) noexcept;
template <has_layout M>
constexpr void store_fields(std::uint8_t* p, const M& m) noexcept;
template <has_layout M>
constexpr field_ref locate_fields(const std::uint8_t* p) noexcept;

/// Reads one value of wire type `W`. Nonzero when the bytes are malformed; `v` is then unspecified.
template <class W, class V>
[[gnu::always_inline]] constexpr std::uint64_t load_value(const std::uint8_t* p, V& v) noexcept {
    if constexpr (requires { typename W::element; }) {
        std::uint64_t bad = 0;
        for (std::size_t i = 0; i != W::count; ++i) bad |= load_value<typename W::element>(p + i * W::element::size, v[i]);
        return bad;
    } else if constexpr (requires { W::gather(p); }) {
        return load_fields(W::gather(p).data(), v);
    } else if constexpr (has_layout<V>) {
        return load_fields(p, v);
    } else if constexpr (std::is_enum_v<V> || std::integral<V>) {
        typename W::value raw{};
        const std::uint64_t bad = W::load(p, raw);
        v = static_cast<V>(raw);
        return bad;
    } else {
        return W::load(p, v);
    }
}

/// Writes one value of wire type `W`. Precondition: the wire can carry it.
template <class W, class V>
[[gnu::always_inline]] constexpr void store_value(std::uint8_t* p, const V& v) noexcept {
    if constexpr (wire::variable<W>) W::store(p, v);
    else if constexpr (requires { typename W::element; })
        for (std::size_t i = 0; i != W::count; ++i) store_value<typename W::element>(p + i * W::element::size, v[i]);
    else if constexpr (requires { W::gather(p); }) {
        std::array<std::uint8_t, V::layout.size> whole{};
        store_fields(whole.data(), v);
        W::scatter(p, whole);
    } else if constexpr (has_layout<V>) store_fields(p, v);
    else if constexpr (std::is_enum_v<V> || std::integral<V>) W::store(p, static_cast<typename W::value>(v));
    else W::store(p, v);
}

/// The wire type of field `I` of `M`.
template <class M, std::size_t I>
using wire_type_of = typename std::remove_cvref_t<decltype(field_of<M, I>)>::wire_type;

/// True for a number that is read with a column_map of its message's first 64 columns.
template <class M, std::size_t I>
concept mapped_field = requires { wire_type_of<M, I>::digits_only; } && M::layout.offsets[I] + wire_type_of<M, I>::size <= 64 && wire_type_of<M, I>::size <= 7;

/// The columns of `M` that a column_map describes; none where there are too few numbers for it to pay.
template <has_layout M>
inline constexpr std::uint64_t mapped_columns = [] {
    std::uint64_t columns = 0;
    std::size_t numbers = 0;
    if (M::layout.fixed && M::layout.size >= 16)
        each_index<M>([&]<std::size_t I>() {
            if constexpr (mapped_field<M, I>) {
                columns |= ((std::uint64_t{1} << wire_type_of<M, I>::size) - 1) << M::layout.offsets[I];
                ++numbers;
            }
        });
    return numbers >= 3 ? columns : 0;
}();

/// Reads the fields of a fixed layout, the numbers of its first 64 columns together.
template <has_layout M>
[[gnu::always_inline]] constexpr std::uint64_t load_mapped_fields(const std::uint8_t* p, M& m) noexcept {
    const column_map map = map_columns<M::layout.size, mapped_columns<M>>(p);
    std::uint64_t digits_only = 0, bad = 0, odd = 0;
    each_index_inline<M>([&]<std::size_t I>() __attribute__((always_inline)) {
        using wire_type = wire_type_of<M, I>;
        constexpr std::size_t at = M::layout.offsets[I];
        auto& member = m.*field_of<M, I>.member;
        if constexpr (mapped_field<M, I>) {
            typename wire_type::value raw{};
            odd |= wire_type::template load_mapped<M::layout.size - at>(p + at, column_map{map.digits >> at, map.others >> at}, raw);
            member = static_cast<std::remove_cvref_t<decltype(member)>>(raw);
            digits_only |= wire_type::digits_only << at;
        } else {
            bad |= load_value<wire_type>(p + at, member);
        }
    });
    return (odd & 1) | bad | (map.others & digits_only);
}

/// Reads the fields of a fixed layout one by one: the reference. Each returns its badness as a word and they are OR-ed:
/// no branch on the way.
template <has_layout M>
constexpr std::uint64_t load_each_field(const std::uint8_t* p, M& m) noexcept {
    return [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
        return (std::uint64_t{0} | ... | load_value<typename decltype(field_of<M, I>)::wire_type>(p + M::layout.offsets[I], m.*field_of<M, I>.member));
    }(std::make_index_sequence<M::layout.count>{});
}

/// Reads the fields of a fixed layout. Nonzero when any is malformed.
template <has_layout M>
constexpr std::uint64_t load_fields(const std::uint8_t* p, M& m) noexcept {
    if constexpr (mapped_columns<M> != 0) return load_mapped_fields(p, m);
    else return load_each_field(p, m);
}

/// Writes the fields of a fixed layout.
template <has_layout M>
constexpr void store_fields(std::uint8_t* p, const M& m) noexcept {
    each_index_inline<M>([&]<std::size_t I>() __attribute__((always_inline)) {
        store_value<typename decltype(field_of<M, I>)::wire_type>(p + M::layout.offsets[I], m.*field_of<M, I>.member);
    });
}

/// Where inside a value of wire type `W` the malformed bytes are; false when there are none.
template <class W, class V>
constexpr bool locate_value(const std::uint8_t* p, field_ref& at) noexcept {
    V scratch{};
    if constexpr (requires { typename W::element; }) {
        for (std::size_t i = 0; i != W::count; ++i)
            if (locate_value<typename W::element, typename V::value_type>(p + i * W::element::size, at)) {
                at.index = static_cast<std::uint8_t>(i);
                return true;
            }
        return false;
    } else if constexpr (has_layout<V>) {
        if (load_value<W>(p, scratch) == 0) return false;
        if constexpr (requires { W::gather(p); }) at.sub = locate_fields<V>(W::gather(p).data()).field;
        else at.sub = locate_fields<V>(p).field;
        return true;
    } else {
        return load_value<W>(p, scratch) != 0;
    }
}

/// The first malformed field of a fixed layout. The slow path, taken only after `load_fields` reported badness.
template <has_layout M>
constexpr field_ref locate_fields(const std::uint8_t* p) noexcept {
    field_ref at{};
    each_index<M>([&]<std::size_t I>() {
        if (at.field != field_ref::none) return;
        field_ref inner{};
        using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
        if (!locate_value<typename one::wire_type, typename one::value>(p + M::layout.offsets[I], inner)) return;
        at = {static_cast<std::uint8_t>(I), inner.index, inner.sub};
    });
    return at;
}

}  // namespace trama
