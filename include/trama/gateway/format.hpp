#pragma once

#include "trama/gateway/decoder.hpp"

/// Fixed-width ASCII records over TCP between warehouse systems and the gateway of a circuit of carts. [gateway]
namespace trama::gateway {

/// On which side of a number an encoder puts the spaces that fill its columns. The document does not say. [D15]
enum class justify : std::uint8_t { right, left };

namespace detail {

/// Moves the number in each numeric field of a stored layout to the left of its columns.
template <has_layout M>
constexpr void justify_left(std::uint8_t* p) noexcept;

template <class W>
constexpr void justify_value_left(std::uint8_t* p) noexcept {
    if constexpr (requires { typename W::element; }) {
        for (std::size_t i = 0; i != W::count; ++i) justify_value_left<typename W::element>(p + i * W::element::size);
    } else if constexpr (requires { W::value::layout; }) {
        justify_left<typename W::value>(p);
    } else if constexpr (requires { W::decimal; }) {
        std::size_t blanks = 0;
        while (blanks != W::size && p[blanks] == ' ') ++blanks;
        for (std::size_t i = 0; i != W::size; ++i) p[i] = i + blanks < W::size ? p[i + blanks] : std::uint8_t{' '};
    }
}
template <has_layout M>
constexpr void justify_left(std::uint8_t* p) noexcept {
    each_index<M>([&]<std::size_t I>() { justify_value_left<typename decltype(field_of<M, I>)::wire_type>(p + M::layout.offsets[I]); });
}

}  // namespace detail

/// The gateway's format as the generic harnesses see it.
struct format {
    using unit = std::uint8_t;
    using packet = gateway::packet;
    using event = gateway::event;
    using envelope = gateway::envelope;
    using decoder = gateway::decoder;
    using messages = gateway::messages;
    static constexpr std::string_view name = "gateway";
    static constexpr std::size_t max_units = max_record;

    /// Bytes that an `M` takes as a record, STX and ETX included.
    template <has_layout M>
        requires(messages::contains<M>)
    static constexpr std::size_t encoded_size(const M&) noexcept { return type_size + M::layout.size + 2; }

    template <has_layout M>
    static constexpr void for_each_violation(const gateway::envelope&, const M&, auto&&) noexcept {}

    /// Writes `m` as a record to `out`: the bytes written; `buffer_too_small`; or `out_of_range` with the field of the
    /// first violation of `validate(m)`. Nothing is written on error.
    template <has_layout M>
        requires(messages::contains<M>)
    static constexpr result<std::size_t> encode(const gateway::envelope& e, const M& m, std::span<unit> out, justify side = justify::right) noexcept {
        if (!is_valid(m)) [[unlikely]] return refusal(m);
        return write(e, m, out, side);
    }
    /// As `encode`, for values that the document does not allow yet the columns can carry. Text that would break the
    /// framing is refused all the same.
    template <has_layout M>
        requires(messages::contains<M>)
    static constexpr result<std::size_t> encode_unchecked(const gateway::envelope& e, const M& m, std::span<unit> out, justify side = justify::right) noexcept {
        if (!fits_wire(m)) [[unlikely]] return unfit(m);
        return write(e, m, out, side);
    }

private:
    template <has_layout M>
    static constexpr result<std::size_t> write(const gateway::envelope&, const M& m, std::span<unit> out, justify side) noexcept {
        constexpr std::size_t size = type_size + M::layout.size + 2;
        if (out.size() < size) return errc::buffer_too_small;
        out[0] = stx;
        write_few_columns<type_size>(out.data() + 1, static_cast<std::uint32_t>(M::key));
        store_fields(out.data() + 1 + type_size, m);
        if (side == justify::left) {
            std::uint8_t* type = out.data() + 1;
            detail::justify_value_left<wire::dec<type_size>>(type);
            detail::justify_left<M>(type + type_size);
        }
        out[size - 1] = etx;
        return size;
    }
};
static_assert(wire_format<format>);

/// Writes `m` as a record. As `format::encode`.
template <has_layout M>
    requires(messages::contains<M>)
constexpr result<std::size_t> encode(const M& m, std::span<std::uint8_t> out, justify side = justify::right) noexcept {
    return format::encode({}, m, out, side);
}

/// As `encode`, for values that the document does not allow yet the columns can carry. As `format::encode_unchecked`.
template <has_layout M>
    requires(messages::contains<M>)
constexpr result<std::size_t> encode_unchecked(const M& m, std::span<std::uint8_t> out, justify side = justify::right) noexcept {
    return format::encode_unchecked({}, m, out, side);
}

}  // namespace trama::gateway
