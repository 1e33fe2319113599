#pragma once

#include <cstdint>

namespace trama::gateway {

/// Numbers the messages of one sender: 0..99999, then 0 again. The sequence goes on over reconnections, so that a late
/// reply to an old order is not taken for the reply to a new one.
class message_ids {
public:
    static constexpr std::uint32_t count = 100'000;

    constexpr explicit message_ids(std::uint32_t first = 0) noexcept : next_(first % count) {}

    /// The number that the next message gets.
    constexpr std::uint32_t peek() const noexcept { return next_; }
    /// That number is used.
    constexpr void advance() noexcept { next_ = next_ + 1 == count ? 0 : next_ + 1; }

private:
    std::uint32_t next_;
};

}  // namespace trama::gateway
