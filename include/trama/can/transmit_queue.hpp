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

    /// The frame to be sent next, null when there is none. It stays the next one until `sent`.
    constexpr const frame* front() const noexcept {
        const entry* e = first();
        return e == nullptr ? nullptr : &e->data[e->done];
    }
    /// The frame that `front` gave is on its way: the one behind it is next.
    constexpr void sent() noexcept {
        const entry* e = first();
        if (e == nullptr) return;
        const auto at = static_cast<std::size_t>(e - entries_.data());
        if (++entries_[at].done != entries_[at].frames) return;
        for (std::size_t i = at + 1; i < count_; ++i) entries_[i - 1] = entries_[i];
        --count_;
    }
    /// Messages that wait, one under way included.
    constexpr std::size_t size() const noexcept { return count_; }
    constexpr void clear() noexcept { count_ = 0; }

private:
    struct entry {
        std::uint8_t frames = 0;
        std::uint8_t done = 0;
        std::array<frame, max_frames> data{};
    };
    /// The oldest message of the lowest identifier; entries are in the order in which they came, so one that is under
    /// way comes before all others of its identifier.
    constexpr const entry* first() const noexcept {
        const entry* best = nullptr;
        for (std::size_t i = 0; i != count_; ++i)
            if (best == nullptr || entries_[i].data[0].id < best->data[0].id) best = &entries_[i];
        return best;
    }

    std::array<entry, Messages> entries_{};
    std::size_t count_ = 0;
};

}  // namespace trama::can
