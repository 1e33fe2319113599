#pragma once

#include "trama/can/format.hpp"

namespace trama::can {

/// Messages that wait for the bus. Frames come out one at a time, each message's behind one another, and never between
/// two of them one of the same identifier: continuation frames carry no header, so a receiver could not tell them apart
/// [D7]. Messages of different identifiers may alternate; the lowest identifier goes first, as on the bus itself.
template <std::size_t Messages>
class transmit_queue {
public:
    /// Takes the frames of one message, 1..3 of one identifier. False, and nothing is taken, when the queue is full.
    constexpr bool push(std::span<const frame> message) noexcept {
        if (message.empty() || message.size() > max_frames || count_ == Messages) return false;
        entry& e = entries_[count_++];
        e = {};
        e.frames = static_cast<std::uint8_t>(message.size());
        for (std::size_t i = 0; i != message.size(); ++i) e.data[i] = message[i];
        return true;
    }
    /// As `push`, of a message that is encoded first; `out_of_range` or `buffer_too_small` when that failed or it is full.
    template <has_layout M>
    constexpr error push_message(const envelope& e, const M& m) noexcept {
        std::array<frame, max_frames> frames{};
        const auto n = encode(e, m, frames);
        if (!n) return n.error();
        return push(std::span<const frame>(frames).first(*n)) ? error{} : error{errc::buffer_too_small, {}};
    }

    /// The frame to be sent next, null when there is none. It stays the next one until `sent`, whatever is pushed in
    /// between: a driver may keep it in its mailbox and call `sent` when it has left. The pointer lives until the next call.
    constexpr const frame* front() noexcept {
        if (count_ == 0) return nullptr;
        const entry& e = entries_[choose()];
        return &e.data[e.done];
    }
    /// The frame that `front` gave is on its way: the one behind it is next.
    constexpr void sent() noexcept {
        if (count_ == 0) return;
        const std::size_t at = choose();
        chosen_ = nothing;
        if (++entries_[at].done != entries_[at].frames) return;
        for (std::size_t i = at + 1; i < count_; ++i) entries_[i - 1] = entries_[i];
        --count_;
    }
    /// Takes back the messages of `id` of which no frame has been sent or given by `front`, and returns how many.
    constexpr std::size_t withdraw(std::uint32_t id) noexcept {
        std::size_t kept = 0, chosen = nothing;
        const std::size_t before = count_;
        for (std::size_t i = 0; i != before; ++i) {
            const entry& e = entries_[i];
            if (e.data[0].id == id && e.done == 0 && i != chosen_) continue;
            if (i == chosen_) chosen = kept;
            if (kept != i) entries_[kept] = e;
            ++kept;
        }
        count_ = kept;
        chosen_ = chosen;
        return before - kept;
    }
    /// Messages that wait, one under way included.
    constexpr std::size_t size() const noexcept { return count_; }
    /// Whether one of them has this identifier.
    constexpr bool holds(std::uint32_t id) const noexcept {
        bool found = false;
        for (std::size_t i = 0; i != count_; ++i) found = found || entries_[i].data[0].id == id;
        return found;
    }
    constexpr void clear() noexcept {
        count_ = 0;
        chosen_ = nothing;
    }

private:
    struct entry {
        std::uint8_t frames = 0;
        std::uint8_t done = 0;
        std::array<frame, max_frames> data{};
    };
    static constexpr std::size_t nothing = Messages;

    /// The place of the message whose frame is next. If none has been chosen: the oldest message of the lowest identifier.
    /// Entries are in the order in which they came, so one that is under way comes before all others of its identifier.
    constexpr std::size_t choose() noexcept {
        if (chosen_ != nothing) return chosen_;
        chosen_ = 0;
        for (std::size_t i = 1; i < count_; ++i)
            if (entries_[i].data[0].id < entries_[chosen_].data[0].id) chosen_ = i;
        return chosen_;
    }

    std::array<entry, Messages> entries_{};
    std::size_t count_ = 0;
    std::size_t chosen_ = nothing;  ///< Whose frame `front` has given and `sent` has not been told of.
};

}  // namespace trama::can
