#pragma once

#include "trama/can/reassembler.hpp"

/// Messages of one to three CAN frames between greenhouse masters and sensor nodes. [can]
namespace trama::can {

inline constexpr std::uint32_t last_id = 0x7FF;  ///< Of a classic frame.
inline constexpr rule id_rule = between(0, last_id);

/// The CAN format as the generic harnesses see it.
struct format {
    using unit = frame;
    using packet = can::packet;
    using event = can::event;
    using envelope = can::envelope;
    using decoder = reassembler;
    using messages = can::messages;
    static constexpr std::string_view name = "can";
    static constexpr std::size_t max_units = max_frames;

    /// Frames that an `M` takes.
    template <has_layout M>
        requires(messages::contains<M>)
    static constexpr std::size_t encoded_size(const M&) noexcept { return M::frame_lengths.size(); }

    /// Calls `f(const violation&)` when the identifier has more than 11 bits.
    template <has_layout M>
    static constexpr void for_each_violation(const can::envelope& e, const M&, auto&& f) {
        if (e.id > last_id) f(violation{{field_ref::id}, e.id, &id_rule});
    }

    /// Writes `m` as frames to `out`: the frames written; `buffer_too_small`; or `out_of_range` with `id` for an
    /// identifier of more than 11 bits, else with the field of the first violation of `validate(m)`. Nothing is written
    /// on error. Send the frames of one message without others of its identifier between.
    template <has_layout M>
        requires(messages::contains<M>)
    static constexpr result<std::size_t> encode(const can::envelope& e, const M& m, std::span<unit> out) noexcept {
        if (e.id <= last_id && !is_valid(m)) [[unlikely]] return refusal(m);
        return encode_unchecked(e, m, out);
    }
    /// As `encode`, for values that the document does not allow yet the wire can carry.
    template <has_layout M>
        requires(messages::contains<M>)
    static constexpr result<std::size_t> encode_unchecked(const can::envelope& e, const M& m, std::span<unit> out) noexcept {
        if (e.id > last_id) [[unlikely]] return trama::error{errc::out_of_range, {field_ref::id}};
        if (!fits_wire(m)) [[unlikely]] return unfit(m);
        if (out.size() < M::frame_lengths.size()) return errc::buffer_too_small;
        std::array<std::uint8_t, M::layout.size> body{};
        store_fields(body.data(), m);
        std::size_t at = 0;
        for (std::size_t i = 0; i != M::frame_lengths.size(); ++i) {
            out[i] = frame{};
            out[i].id = e.id;
            out[i].length = M::frame_lengths[i];
            copy_bytes(out[i].data.data(), body.data() + at, M::frame_lengths[i]);
            at += M::frame_lengths[i];
        }
        return M::frame_lengths.size();
    }
};
static_assert(wire_format<format>);

/// Writes `m` as frames of `e.id`. As `format::encode`.
template <has_layout M>
    requires(messages::contains<M>)
constexpr result<std::size_t> encode(const envelope& e, const M& m, std::span<frame> out) noexcept { return format::encode(e, m, out); }

/// As `encode`, for values that the document does not allow yet the wire can carry. As `format::encode_unchecked`.
template <has_layout M>
    requires(messages::contains<M>)
constexpr result<std::size_t> encode_unchecked(const envelope& e, const M& m, std::span<frame> out) noexcept { return format::encode_unchecked(e, m, out); }

}  // namespace trama::can
