#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace trama {

/// Sums up what happened within the last `window` units of time, in eight steps. No clock: the caller says when.
class rate_meter {
public:
    static constexpr std::size_t steps = 8;

    /// `window` in the caller's unit of time, rounded down to a multiple of 8, at least 8; 1 s makes the sum a rate per second.
    constexpr explicit rate_meter(std::uint64_t window) noexcept : step_(std::max<std::uint64_t>(1, window / steps)) {}

    constexpr void add(std::uint64_t amount, std::uint64_t now) noexcept {
        move_to(now / step_);
        sums_[last_ % steps] += amount;
    }
    /// The sum of what was added within the window that ends at `now`; the oldest eighth may be cut short.
    constexpr std::uint64_t sum(std::uint64_t now) const noexcept {
        const std::uint64_t at = now / step_;
        std::uint64_t total = 0;
        for (std::uint64_t i = 0; i != steps && i <= last_; ++i) {
            const std::uint64_t step = last_ - i;
            if (step + steps > at) total += sums_[step % steps];
        }
        return total;
    }

private:
    /// Clocks that go backwards count into the latest step.
    constexpr void move_to(std::uint64_t at) noexcept {
        if (at <= last_) return;
        const std::uint64_t stale = std::min<std::uint64_t>(at - last_, steps);
        for (std::uint64_t i = 0; i != stale; ++i) sums_[(at - i) % steps] = 0;
        last_ = at;
    }

    std::uint64_t step_;
    std::uint64_t last_ = 0;  ///< The latest step.
    std::array<std::uint64_t, steps> sums_{};
};

/// Times between a request and its reply, in the caller's unit.
struct round_trips {
    std::uint64_t count = 0;
    std::uint64_t last = 0;
    std::uint64_t least = 0;
    std::uint64_t most = 0;
    std::uint64_t total = 0;

    constexpr std::uint64_t mean() const noexcept { return count == 0 ? 0 : total / count; }
    constexpr void add(std::uint64_t time) noexcept {
        least = count == 0 ? time : std::min(least, time);
        most = std::max(most, time);
        last = time;
        total += time;
        ++count;
    }
};

/// What an operator wants to know about one peer or one line; readable at any time. Whoever drives the link counts.
class link_quality {
public:
    /// Rates are sums over the last `window` units of time.
    constexpr explicit link_quality(std::uint64_t window = 1000) noexcept : good_(window) {}

    std::uint64_t packets_sent = 0;        ///< Repeats included. Of a can bus its frames.
    std::uint64_t bytes_sent = 0;          ///< In can all members that count bytes count frames.
    std::uint64_t packets_received = 0;    ///< Intact ones.
    std::uint64_t bytes_received = 0;      ///< Of intact packets.
    std::uint64_t bytes_skipped = 0;       ///< Received, yet of no use.
    std::uint64_t resynchronisations = 0;  ///< Faults after which the receiver had to find its footing again.
    std::uint64_t rejections = 0;          ///< Packets that the peer reported as damaged.
    std::uint64_t retries = 0;
    std::uint64_t timeouts = 0;
    std::uint64_t failures = 0;            ///< Requests given up.
    round_trips round_trip{};

    constexpr void sent(std::size_t bytes, std::size_t packets = 1) noexcept {
        packets_sent += packets;
        bytes_sent += bytes;
    }
    constexpr void received(std::size_t bytes, std::uint64_t now) noexcept {
        ++packets_received;
        bytes_received += bytes;
        good_.add(bytes, now);
    }
    constexpr void lost_step(std::uint64_t bytes) noexcept {
        ++resynchronisations;
        bytes_skipped += bytes;
    }
    /// Bytes of intact packets received within the last window.
    constexpr std::uint64_t goodput(std::uint64_t now) const noexcept { return good_.sum(now); }

private:
    rate_meter good_;
};

}  // namespace trama
