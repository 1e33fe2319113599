#pragma once

#include "trama/daisy/decoder.hpp"

/// Binary packets on an RS-232 daisy chain of robot boards. [daisy]
namespace trama::daisy {

inline constexpr rule source_rule{0, -1, -1, 0, {}, "id 0..14"};
inline constexpr rule destination_rule{0, -1, -1, 0, {}, "an address of the family that defines the command"};

/// The daisy-chain format as the generic harnesses see it.
struct format {
    using unit = std::uint8_t;
    using packet = daisy::packet;
    using event = daisy::event;
    using envelope = daisy::envelope;
    using decoder = daisy::decoder;
    using messages = daisy::messages;
    static constexpr std::string_view name = "daisy";
    static constexpr std::size_t max_units = max_packet;

    /// Bytes that `m` takes as a packet.
    template <has_layout M>
        requires(messages::contains<M>)
    static constexpr std::size_t encoded_size(const M& m) noexcept { return min_packet + body_size(m); }

    /// Calls `f(const violation&)` for what the document does not allow in the addresses.
    template <has_layout M>
    static constexpr void for_each_violation(const daisy::envelope& e, const M&, auto&& f) {
        if (e.source.broadcast()) f(violation{{field_ref::source}, e.source.octet, &source_rule});
        if (!fits<M>(e)) f(violation{{field_ref::destination}, e.destination.octet, &destination_rule});
    }

    /// Writes `m` as a packet to `out`: the bytes written; `buffer_too_small`; or `out_of_range` with `source` if its
    /// id is 15, else with the field of the first violation of `validate(m)`, else with `destination` if the addresses imply another family [D3].
    /// Nothing is written on error.
    /// Views in `m` may lie in `out`: a board reports a packet from the buffer that it came in.
    template <has_layout M>
        requires(messages::contains<M>)
    static constexpr result<std::size_t> encode(const daisy::envelope& e, const M& m, std::span<unit> out) noexcept {
        if (e.source.broadcast()) return trama::error{errc::out_of_range, {field_ref::source}};
        if (!is_valid(m)) return refusal(m);
        return encode_unchecked(e, m, out);
    }
    /// As `encode`, for values that the document does not allow yet the wire can carry.
    template <has_layout M>
        requires(messages::contains<M>)
    static constexpr result<std::size_t> encode_unchecked(const daisy::envelope& e, const M& m, std::span<unit> out) noexcept {
        if (!fits<M>(e)) return trama::error{errc::out_of_range, {field_ref::destination}};
        if (!fits_wire(m)) return unfit(m);
        const std::size_t size = encoded_size(m);
        if (out.size() < size) return errc::buffer_too_small;
        const std::uint32_t head = static_cast<std::uint32_t>(size - 1) | std::uint32_t{e.destination.octet} << 8 |
                                   std::uint32_t{e.source.octet} << 16 | std::uint32_t{command_of(M::key)} << 24;
        if constexpr (!M::layout.fixed) store_body(out.data() + header_size, m);  // before the head, where what is viewed may lie
        store_le(out.data(), head);
        if constexpr (M::layout.fixed) store_body(out.data() + header_size, m);
        std::uint8_t crc = fold_xor(head);
        // Short bodies byte by byte: a word read over bytes that were just written one by one would have to wait for them.
        if constexpr (M::layout.fixed) for (std::size_t i = 0; i != M::layout.size; ++i) crc ^= out[header_size + i];
        else crc ^= checksum(out.subspan(header_size, size - min_packet));
        out[size - 1] = crc;
        return size;
    }

private:
    /// True when the addresses imply the family that defines `M`. [D3]
    template <has_layout M>
    static constexpr bool fits(const daisy::envelope& e) noexcept { return family_of(e, command_of(M::key)) == family_of(M::key); }
};
static_assert(wire_format<format>);

/// Writes `m` from `e.source` to `e.destination`. As `format::encode`.
template <has_layout M>
    requires(messages::contains<M>)
constexpr result<std::size_t> encode(const envelope& e, const M& m, std::span<std::uint8_t> out) noexcept { return format::encode(e, m, out); }

/// As `encode`, for values that the document does not allow yet the wire can carry. As `format::encode_unchecked`.
template <has_layout M>
    requires(messages::contains<M>)
constexpr result<std::size_t> encode_unchecked(const envelope& e, const M& m, std::span<std::uint8_t> out) noexcept {
    return format::encode_unchecked(e, m, out);
}

using trama::validate;
/// Every violation of `m` between the addresses `e`, those of the addresses first: what makes `encode` refuse it.
template <has_layout M>
    requires(messages::contains<M>)
constexpr auto validate(const envelope& e, const M& m) noexcept {
    violation_list<leaf_count<M> + 2> all;
    const auto note = [&](const violation& v) { all.push_back(v); };
    format::for_each_violation(e, m, note);
    for_each_violation(m, note);
    return all;
}

}  // namespace trama::daisy
