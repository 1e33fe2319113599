#pragma once

#include "trama/core/sink.hpp"
#include "trama/core/validate.hpp"

namespace trama {

/// How a message is written: as JSON, or as `name=value` pairs to be read by people.
enum class notation : std::uint8_t { json, plain };

namespace detail {

template <class E>
void print_flags(text_sink& out, E value, notation n) noexcept {
    auto left = static_cast<std::uint64_t>(value);
    std::string_view gap;
    out << '[';
    const auto put = [&](std::string_view name, std::uint64_t bit) {
        out << gap;
        if (name.empty()) out << bit;
        else if (n == notation::json) out.quoted(name);
        else out << name;
        gap = ",";
    };
    for (std::uint64_t bit = 1; left != 0; bit <<= 1) {
        if ((left & bit) == 0) continue;
        left &= ~bit;
        put(name_of(static_cast<E>(bit)), bit);
    }
    out << ']';
}

template <class E>
void print_enum(text_sink& out, E value, notation n) noexcept {
    const std::string_view name = name_of(value);
    if (name.empty()) out << static_cast<std::int64_t>(value);
    else if (n == notation::json) out.quoted(name);
    else out << name;
}

inline void print_name(text_sink& out, std::string_view& gap, std::string_view name, notation n) noexcept {
    out << gap;
    if (n == notation::json) out.quoted(name) << ':';
    else out << name << '=';
    gap = n == notation::json ? "," : " ";
}

}  // namespace detail

/// Writes the fields of `m`: `{"name":value,…}` or `name=value …`.
template <has_layout M>
void print_fields(text_sink& out, const M& m, notation n) noexcept;

/// Writes one value of wire type `W`.
template <class W, class V>
void print_value(text_sink& out, const V& v, notation n) noexcept {
    if constexpr (requires { typename W::element; }) {
        out << '[';
        for (std::size_t i = 0; i != v.size(); ++i) {
            if (i != 0) out << ',';
            print_value<typename W::element>(out, v[i], n);
        }
        out << ']';
    } else if constexpr (has_layout<V>) {
        if (n == notation::plain) out << '{';
        print_fields(out, v, n);
        if (n == notation::plain) out << '}';
    } else if constexpr (flag_set<V>) {
        detail::print_flags(out, v, n);
    } else if constexpr (enumerated<V>) {
        detail::print_enum(out, v, n);
    } else if constexpr (W::printed == wire::print::tenths) {
        out.tenths(v);
    } else if constexpr (W::printed == wire::print::number) {
        out << v;
    } else if constexpr (requires { v.columns; }) {
        out.quoted(v.view());
    } else if constexpr (W::printed == wire::print::hex) {
        if (n == notation::json) out << '"';
        out.hex(v.bytes());
        if (n == notation::json) out << '"';
    } else {
        out.quoted(v.bytes());
    }
}

template <has_layout M>
void print_fields(text_sink& out, const M& m, notation n) noexcept {
    std::string_view gap;
    if (n == notation::json) out << '{';
    each_index<M>([&]<std::size_t I>() {
        constexpr auto& one = field_of<M, I>;
        if (!one.exists(m)) return;
        detail::print_name(out, gap, one.name, n);
        print_value<typename std::remove_cvref_t<decltype(one)>::wire_type>(out, m.*one.member, n);
    });
    if (n == notation::json) out << '}';
}

/// Writes the path of a field as the documentation prints it: `orders[1].level`; of a daisy packet's addresses `source`
/// or `destination`; of a can message's identifier `id`; nothing if `at` names no field.
template <has_layout M>
void print_path(text_sink& out, field_ref at) noexcept {
    if (at.field == field_ref::source) out << "source";
    if (at.field == field_ref::destination) out << "destination";
    if (at.field == field_ref::id) out << "id";
    each_index<M>([&]<std::size_t I>() {
        if (at.field != I) return;
        constexpr auto& one = field_of<M, I>;
        using wire_type = typename std::remove_cvref_t<decltype(one)>::wire_type;
        out << one.name;
        if (at.index != field_ref::none) out << '[' << at.index << ']';
        const auto inner = [&]<has_layout S>() {
            each_index<S>([&]<std::size_t J>() { if (at.sub == J) out << '.' << field_of<S, J>.name; });
        };
        if constexpr (requires { wire_type::element::value::layout; }) inner.template operator()<typename wire_type::element::value>();
        else if constexpr (has_layout<typename std::remove_cvref_t<decltype(one)>::value>) inner.template operator()<typename std::remove_cvref_t<decltype(one)>::value>();
    });
}

/// The JSON object of a message's fields, in `out`: the characters written, or `buffer_too_small`.
template <has_layout M>
result<std::size_t> to_json(const M& m, std::span<char> out) noexcept {
    text_sink sink(out);
    print_fields(sink, m, notation::json);
    if (sink.full()) return errc::buffer_too_small;
    return sink.size();
}

/// As `to_json`, as `name=value` pairs.
template <has_layout M>
result<std::size_t> to_text(const M& m, std::span<char> out) noexcept {
    text_sink sink(out);
    print_fields(sink, m, notation::plain);
    if (sink.full()) return errc::buffer_too_small;
    return sink.size();
}

}  // namespace trama
