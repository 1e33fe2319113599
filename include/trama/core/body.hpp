#pragma once

#include <span>

#include "trama/core/codec.hpp"

namespace trama {

/// Bytes that field `I` of `m` takes when `left` bytes remain; the fields before it have been read.
template <class M, std::size_t I>
constexpr std::size_t measure(const M& m, std::size_t left) noexcept {
    using one = std::remove_cvref_t<decltype(field_of<M, I>)>;
    using wire_type = typename one::wire_type;
    if (!one::exists(m)) return 0;
    if constexpr (requires { wire_type::keep; }) return left >= wire_type::keep + wire_type::min ? left - wire_type::keep : left + 1;
    else if constexpr (wire::variable<wire_type>) return m.expected_count() * wire_type::element::size;
    else return wire_type::size;
}

/// Reads a layout with optional or variable fields. False when `n` is not the size that the fields ask for.
template <has_layout M>
constexpr bool load_variable(const std::uint8_t* p, std::size_t n, M& m) noexcept {
    std::size_t at = 0;
    bool fits = true;
    each_index<M>([&]<std::size_t I>() {
        if (!fits) return;
        using wire_type = typename decltype(field_of<M, I>)::wire_type;
        const std::size_t size = measure<M, I>(m, n - at);
        fits = size <= n - at;
        if (!fits || !field_of<M, I>.exists(m)) return;
        if constexpr (wire::variable<wire_type>) (void)wire_type::load(p + at, size, m.*field_of<M, I>.member);
        else (void)load_value<wire_type>(p + at, m.*field_of<M, I>.member);
        at += size;
    });
    return fits && at == n;
}

/// Bytes that the fields of `m` take on the wire.
template <has_layout M>
constexpr std::size_t body_size(const M& m) noexcept {
    if constexpr (M::layout.fixed) {
        return M::layout.size;
    } else {
        std::size_t total = 0;
        each_index<M>([&]<std::size_t I>() {
            using wire_type = typename decltype(field_of<M, I>)::wire_type;
            if (!field_of<M, I>.exists(m)) return;
            if constexpr (wire::variable<wire_type>) total += wire_type::length(m.*field_of<M, I>.member);
            else total += wire_type::size;
        });
        return total;
    }
}

/// Writes the fields of `m`, `body_size(m)` bytes. A view in `m` may lie in them or right before: it goes first.
template <has_layout M>
constexpr void store_body(std::uint8_t* p, const M& m) noexcept {
    if constexpr (M::layout.fixed) {
        store_fields(p, m);
    } else {
        const auto store = [&]<bool View>(std::bool_constant<View>) {
            std::size_t at = 0;
            each_index<M>([&]<std::size_t I>() {
                using wire_type = typename decltype(field_of<M, I>)::wire_type;
                if (!field_of<M, I>.exists(m)) return;
                if constexpr (requires { wire_type::keep; } == View) store_value<wire_type>(p + at, m.*field_of<M, I>.member);
                if constexpr (wire::variable<wire_type>) at += wire_type::length(m.*field_of<M, I>.member);
                else at += wire_type::size;
            });
        };
        store(std::true_type{});
        store(std::false_type{});
    }
}

/// Decodes the fields of `body` into `m`, which is unspecified on error: `bad_length`, or `bad_number` with its field.
template <has_layout M>
[[gnu::always_inline]] constexpr error load_body(std::span<const std::uint8_t> body, M& m) noexcept {
    if constexpr (M::layout.fixed) {
        if (body.size() != M::layout.size) [[unlikely]] return {errc::bad_length, {}};
        if (load_fields(body.data(), m) == 0) [[likely]] return {};
        return {errc::bad_number, locate_fields<M>(body.data())};
    } else {
        m = M{};
        return load_variable(body.data(), body.size(), m) ? error{} : error{errc::bad_length, {}};
    }
}

}  // namespace trama
