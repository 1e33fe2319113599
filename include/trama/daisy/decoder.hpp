#pragma once

#include <utility>

#include "trama/daisy/phase.hpp"

namespace trama::daisy {

/// What `decoder::next` reports. Views live until the decoder's next call, and no longer than the chunk given to it.
struct event : basic_event<packet> {
    std::span<const std::uint8_t> rejected{};  ///< Of bad_checksum: the packet as its LEN delimits it, to be sent back in an ERROR.
    std::uint8_t expected = 0;                 ///< Of bad_checksum: the CRC that `rejected` should have.
    std::uint8_t received = 0;                 ///< Of bad_checksum: the CRC that it has.
};

/// Cuts a serial stream into packets and finds its footing again after every fault. [daisy §2]
///
/// It begins by hunting: until a packet with a documented header and a good CRC turns up, all else is noise. In step
/// it takes every packet with a good CRC, undocumented ones as `unknown_message`, as long as nothing speaks for another
/// phase. A fault is one event, which covers everything up to the next packet accepted.
///
/// Bound: an intact documented packet that begins 256 bytes or more after the last damaged byte is delivered. Where the
/// bytes after the damage read as packets in another phase as well, docs/daisy.md says what holds.
class decoder {
public:
    /// Takes bytes from the front of `in` and reports one packet or error, or `need_more` with `in` empty.
    /// A packet lying whole in `in` is viewed in place, one that straddles chunks in the decoder's own memory.
    [[gnu::always_inline]] constexpr event next(std::span<const std::uint8_t>& in) noexcept {
        if (const auto front = look(in); front.whole) [[likely]] {
            const auto packet = in.first(front.size);
            in = in.subspan(front.size);
            return deliver(packet, front.index);
        }
        auto slow = advance(in);  // not const: g++ 12 keeps const objects of this size in memory, on the quick path too
        in = slow.rest;
        return slow.event;
    }

    /// Calls `f(const event&)` for everything that `in` completes. See `trama::read_ahead`.
    [[gnu::always_inline]] constexpr void read_ahead(std::span<const std::uint8_t> in, auto&& f) {
        for (;;) {
            for (auto front = look(in); front.whole && settled();) {
                const auto packet = in.first(std::size_t{in[0]} + 1);  // rather than from memory or a register
                in = in.subspan(packet.size());
                const std::size_t index = front.index;
                front = look(in);
                f(deliver(packet, index));
            }
            auto slow = advance(in);
            if (slow.event.code == errc::need_more) return;
            in = slow.rest;
            f(slow.event);
        }
    }

    /// The line fell silent: a partial packet is `truncated`, the next byte is a packet's first. Call `next` until it
    /// needs more, with an empty span or the bytes that follow.
    constexpr void idle() noexcept { draining_ = true; quick_from_ = never_quick; }
    /// The input ends here. As `idle`.
    constexpr void finish() noexcept { idle(); }
    /// As a new decoder, hunting at offset 0; only the counters stay.
    constexpr void reset() noexcept {
        const trama::counters kept = counters_;
        *this = decoder{};
        counters_ = kept;
    }
    /// Bytes consumed and not yet reported.
    constexpr std::uint64_t pending() const noexcept { return held() - release_ + skipped_; }
    constexpr const trama::counters& counters() const noexcept { return counters_; }
    /// Offset of the first byte not yet reported.
    constexpr std::uint64_t offset() const noexcept { return offset_; }
    /// The offset of the next byte, for callers that begin inside a stream.
    constexpr void seek(std::uint64_t offset) noexcept { offset_ = offset - pending(); }
    /// In step beyond doubt and with nothing kept: from here on two settled decoders report the same of the same bytes.
    constexpr bool settled() const noexcept { return quick_from_ != never_quick; }

private:
    using bytes_in = std::span<const std::uint8_t>;

    struct quick_look {
        bool whole = false;  ///< The quick path knows that a packet begins here and that its last byte is in.
        std::size_t size = 0, index = 0;
    };
    [[gnu::always_inline]] constexpr quick_look look(bytes_in in) const noexcept {
        quick_look front;
        if (in.size() < quick_from_) [[unlikely]] return front;
        const auto low = load_le<std::uint64_t>(in.data());
        const unsigned found = known.find(static_cast<std::uint32_t>(low), in.data());
        const std::size_t len = in[0];  // a load of its own: the next packet waits for this one only
        front.size = len + 1;
        front.index = catalogue::index_in(found);
        if (known.is_sized(found, in.data())) [[likely]] front.whole = known.fold(low, in.data(), len) == 0;
        else front.whole = is_variable_landmark(in, front.index);
        return front;
    }

    constexpr std::size_t held() const noexcept { return end_ - begin_; }
    constexpr window bytes(std::span<const std::uint8_t> in) const noexcept { return {{stash_.data() + begin_, held()}, in}; }

    constexpr event deliver(std::span<const std::uint8_t> whole, std::size_t index) noexcept {
        event e{};
        e.code = errc::ok;
        e.packet = packet(whole, index);
        e.offset = offset_;
        e.length = whole.size();
        ++counters_.packets;
        offset_ += whole.size();
        return e;
    }

    /// True when a landmark of variable length lies whole at the front of `in`, which is the message at `index`.
    [[gnu::noinline]] static constexpr bool is_variable_landmark(std::span<const std::uint8_t> in, std::size_t index) noexcept {
        const std::size_t size = std::size_t{in[0]} + 1;
        if (size < min_packet || size > in.size()) return false;
        if (!known.fits[known.variable_at[index]](size - min_packet, &in[header_size])) return false;
        const bool few = size <= few_bytes && in.size() >= header_size + few_bytes;
        if ((few ? xor_of_few(in.data(), size) : xor_of(in.first(size))) != 0) return false;
        if (!known.carries_bytes[index]) return true;
        if (known.texts[index] && few && few_printable_bytes(&in[header_size], size - min_packet)) return true;  // see is_landmark
        return recovery::is_landmark(in.first(size), index);
    }

    constexpr event deliver_unknown(std::span<const std::uint8_t> whole) noexcept {
        event e = deliver(whole, unknown);
        e.code = errc::unknown_message;
        e.bytes = whole;
        --counters_.packets;
        ++counters_.errors[static_cast<std::size_t>(errc::unknown_message)];
        return e;
    }

    [[gnu::noinline]] constexpr stepped<event, std::uint8_t> advance(bytes_in in) noexcept { return {in, [this](auto& rest) { return slow_next(rest); }}; }
    // decoder_recovery.hpp holds these.
    constexpr event slow_next(bytes_in& in) noexcept;
    static constexpr bytes_in short_landmark(bytes_in& in) noexcept;
    constexpr bytes_in joined_landmark(bytes_in& in) noexcept;
    constexpr event step(bytes_in& in) noexcept;
    constexpr event rest() noexcept;
    constexpr event wait(bytes_in& in) noexcept;
    constexpr event fault(errc code, bytes_in& in) noexcept;
    constexpr event hunt(bytes_in& in) noexcept;
    constexpr event drain(bytes_in& in) noexcept;
    constexpr event report() noexcept;
    constexpr std::span<const std::uint8_t> gather(std::size_t size, bytes_in& in) noexcept;
    constexpr void keep(std::size_t n, bytes_in& in) noexcept;
    constexpr void skip(std::size_t n, bytes_in& in) noexcept;

    static constexpr std::size_t readable = longest_fixed + 1, never_quick = std::numeric_limits<std::size_t>::max();
    static_assert(std::all_of(known.fixed_len.begin(), known.fixed_len.end(), [](auto len) { return len <= longest_fixed || len == variable; }));

    /// How many bytes the quick path needs: `readable` while in step and behind a landmark, with nothing kept or announced.
    std::size_t quick_from_ = never_quick;
    bool hunting_ = true;
    bool draining_ = false;  ///< The input ended: what is kept is all there is.
    bool certain_ = false;   ///< The hunt has accepted the packet at the front.
    bool resumed_ = false;   ///< The hunt is where a promise led.
    errc code_ = errc::noise;
    phase_judge phase_{};
    std::size_t begin_ = 0, end_ = 0;  ///< The kept bytes in the stash.
    std::size_t release_ = 0;          ///< Of them, those that the packet reported last views.
    std::uint64_t skipped_ = 0;  ///< Bytes of the loss of step so far.
    std::size_t rejected_ = 0;   ///< Size of the packet with the bad CRC.
    std::size_t probe_ = 0;
    phase_judge::verdict promise_{};  ///< Where the hunt may begin.
    std::uint64_t offset_ = 0;
    trama::counters counters_{};
    std::array<std::uint8_t, max_packet> stash_{};
    std::array<std::uint8_t, max_packet> scratch_{};  ///< Skipped bytes while hunting, the shadow's past while in step.
};

}  // namespace trama::daisy

#include "trama/daisy/decoder_recovery.hpp"
