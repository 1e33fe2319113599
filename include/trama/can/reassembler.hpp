#pragma once

#include <algorithm>
#include <limits>

#include "trama/can/shape.hpp"

namespace trama::can {

/// What `reassembler::next` reports: `offset` counts frames as they came in, `length` is the frames of the message
/// or error, `bytes` their data run together. Views live until the next call, and no longer than the frames given to it.
struct event : basic_event<packet> {
    std::uint32_t id = 0;  ///< Identifier of the frames.
};

inline constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

/// Puts the messages of up to `Ids` identifiers together, each by itself. Continuation frames carry no header [D7], so
/// only their order and their DLC tell what they belong to. Messages come out in the order in which they complete.
template <std::size_t Ids>
class basic_reassembler {
    static_assert(Ids != 0);

public:
    /// Follows the document's three identifiers, without a time-out.
    constexpr basic_reassembler() noexcept
        requires(Ids == 3)
        : basic_reassembler({central_master, master_1, master_2}) {}
    /// Follows `ids`; a partial message whose last frame is older than `timeout`, in units of `frame::time`, is given up.
    constexpr explicit basic_reassembler(const std::array<std::uint32_t, Ids>& ids, std::uint64_t timeout = never) noexcept : timeout_(timeout) {
        for (std::size_t i = 0; i != Ids; ++i) slots_[i].id = ids_[i] = ids[i];
    }

    /// Takes frames from the front of `in` and reports one message or error, or `need_more` with `in` empty.
    /// Frames of other protocols are counted as foreign and left alone.
    [[gnu::always_inline]] constexpr event next(std::span<const frame>& in) noexcept {
        while (!overdue_ && !in.empty()) {  // frames that end or continue a message as they should
            const frame& f = in.front();
            const std::size_t place = place_of(f.id);
            slot& s = slots_[place];
            const std::size_t seen = s.seen;
            const std::size_t first = known.first[known.rows[f.data[2]]][f.length & 15];
            const std::size_t index = seen != 0 ? s.index : first;
            const bool late = seen != 0 && is_late(s, f.time);
            if (ids_[place] != f.id || !f.classic() || f.length != known.lengths[index][seen] || late) [[unlikely]] break;
            copy_bytes(s.data.data() + 8 * seen, f.data.data(), 8);
            s.last = f.time;
            s.offset = seen != 0 ? s.offset : offset_;
            s.index = static_cast<std::uint8_t>(index);
            const bool complete = seen + 1 == known.shapes[index].frames;
            s.seen = static_cast<std::uint8_t>(complete ? 0 : seen + 1);
            ++offset_;
            in = in.subspan(1);
            if (complete) return deliver({s.data.data(), 8 * seen + f.length}, f.id, index, s.offset);
        }
        auto slow = advance(in);  // not const: g++ 12 keeps const objects of this size in memory, on the quick path too
        in = slow.rest;
        return slow.event;
    }
    /// Time went on to `now`: `next` then reports the partial messages that are overdue.
    constexpr void tick(std::uint64_t now) noexcept { now_ = now; overdue_ = true; }
    /// The input ends here: partial messages are `truncated`. Call `next` until it needs more.
    constexpr void finish() noexcept { overdue_ = draining_ = true; }
    /// Forgets the partial messages and starts at offset 0; identifiers, time-out and counters stay.
    constexpr void reset() noexcept {
        for (slot& s : slots_) s.seen = 0;
        overdue_ = draining_ = false;
        offset_ = 0;
    }
    /// The offset of the next frame, for callers that number frames in their own way, such as the lines of a log.
    constexpr void seek(std::uint64_t offset) noexcept { offset_ = offset; }
    /// Frames consumed and not yet reported.
    constexpr std::size_t pending() const noexcept {
        std::size_t n = 0;
        for (const slot& s : slots_) n += s.seen;
        return n;
    }
    constexpr const trama::counters& counters() const noexcept { return counters_; }

private:
    struct slot {
        std::uint32_t id = 0;
        std::uint8_t seen = 0;   ///< Frames of the message in progress; 0 when there is none.
        std::uint8_t index = 0;  ///< The message, by its first frame.
        std::uint64_t offset = 0;
        std::uint64_t last = 0;  ///< Time of the latest frame.
        std::array<std::uint8_t, 8 * max_frames> data{};
    };

    /// Where the slot of `id` is, if it has one. No branch: which identifier comes next cannot be predicted.
    [[gnu::always_inline]] constexpr std::size_t place_of(std::uint32_t id) const noexcept {
        std::size_t place = 0;
        for (std::size_t i = 1; i < Ids; ++i) place = ids_[i] == id ? i : place;
        return place;
    }
    constexpr slot* slot_of(std::uint32_t id) noexcept {
        slot& s = slots_[place_of(id)];
        return s.id == id ? &s : nullptr;
    }
    constexpr bool is_late(const slot& s, std::uint64_t now) const noexcept { return now > s.last && now - s.last > timeout_; }
    /// The partial message that stalled first, of those that are overdue.
    constexpr slot* find_overdue() noexcept {
        slot* found = nullptr;
        for (slot& s : slots_) {
            if (s.seen == 0 || !(draining_ || is_late(s, now_))) continue;
            const bool earlier = found == nullptr || (draining_ || s.last == found->last ? s.offset < found->offset : s.last < found->last);
            if (earlier) found = &s;
        }
        return found;
    }

    [[gnu::noinline]] constexpr stepped<event, frame> advance(std::span<const frame> in) noexcept { return {in, [this](auto& rest) { return slow_next(rest); }}; }
    /// Everything but the frames that `next` deals with itself.
    constexpr event slow_next(std::span<const frame>& in) noexcept {
        if (overdue_) {
            if (slot* late = find_overdue()) return interrupt(*late, draining_ ? errc::truncated : errc::timed_out);
            overdue_ = draining_ = false;
        }
        for (; !in.empty(); in = in.subspan(1)) {
            const frame& f = in.front();
            slot* s = f.classic() ? slot_of(f.id) : nullptr;
            if (s == nullptr) {
                ++counters_.foreign;
                ++offset_;
            } else if (s->seen != 0 && is_late(*s, f.time)) {
                return interrupt(*s, errc::timed_out);
            } else if (s->seen != 0 && f.length != known.shapes[s->index].lengths[s->seen]) {
                return interrupt(*s, errc::incomplete);
            } else if (const event e = take(*s, f); e.code != errc::need_more) {
                in = in.subspan(1);
                return e;
            }
        }
        return {};
    }

    /// `f` is the frame that its slot waits for, or the first of a message.
    constexpr event take(slot& s, const frame& f) noexcept {
        if (s.seen == 0) {
            const opening first = open_message(f);
            const std::size_t length = std::min<std::size_t>(f.length, f.data.size());
            if (first.code != errc::ok) return report(first.code, {f.data.data(), length}, s.id, offset_++, 1);
            s.index = static_cast<std::uint8_t>(first.index);
            s.offset = offset_;
        }
        copy_bytes(s.data.data() + 8 * s.seen, f.data.data(), 8);
        const std::size_t size = std::size_t{8} * s.seen + f.length;
        s.last = f.time;
        ++offset_;
        if (++s.seen != known.shapes[s.index].frames) return {};
        s.seen = 0;
        return deliver({s.data.data(), size}, s.id, s.index, s.offset);
    }
    constexpr event deliver(std::span<const std::uint8_t> body, std::uint32_t id, std::size_t index, std::uint64_t offset) noexcept {
        event e{};
        e.code = errc::ok;
        e.packet = packet({id}, body, index);
        e.offset = offset;
        e.length = known.shapes[index].frames;
        e.bytes = body;
        e.id = id;
        ++counters_.packets;
        return e;
    }
    constexpr event interrupt(slot& s, errc code) noexcept {
        const std::size_t frames = s.seen;
        s.seen = 0;
        return report(code, {s.data.data(), 8 * frames}, s.id, s.offset, frames);
    }
    constexpr event report(errc code, std::span<const std::uint8_t> bytes, std::uint32_t id, std::uint64_t offset, std::size_t frames) noexcept {
        event e{};
        e.code = code;
        if (code == errc::unknown_message) e.packet = packet({id}, bytes, unknown);
        e.offset = offset;
        e.length = frames;
        e.bytes = bytes;
        e.id = id;
        ++counters_.errors[static_cast<std::size_t>(code)];
        if (code != errc::unknown_message) counters_.skipped += frames;
        return e;
    }

    std::array<std::uint32_t, Ids> ids_{};
    std::array<slot, Ids> slots_{};
    std::uint64_t timeout_ = never;
    std::uint64_t now_ = 0;
    std::uint64_t offset_ = 0;
    bool overdue_ = false;   ///< The partial messages are to be looked through.
    bool draining_ = false;  ///< All of them are to be given up.
    trama::counters counters_{};
};

/// For the document's three identifiers.
using reassembler = basic_reassembler<3>;

}  // namespace trama::can
