#pragma once

#include <array>
#include <cstdint>

namespace trama::can {

/// One frame as a CAN controller delivers it.
struct frame {
    std::uint32_t id = 0;                 ///< 11-bit identifier, or 29-bit if `extended`. [can, preamble]
    std::uint8_t length = 0;              ///< DLC, 0..8.
    std::array<std::uint8_t, 8> data{};
    std::uint64_t time = 0;               ///< When it came, in any monotonic unit; the unit of the reassembler's time-out.
    bool extended = false;
    bool remote = false;
    bool error = false;
    bool fd = false;

    /// True for a classic data frame with an 11-bit identifier, the only kind that the protocol uses.
    constexpr bool classic() const noexcept { return !extended && !remote && !error && !fd; }
    friend constexpr bool operator==(const frame&, const frame&) = default;
};

inline constexpr std::uint32_t central_master = 0x80;  ///< [can, preamble]
inline constexpr std::uint32_t master_1 = 0x81;
inline constexpr std::uint32_t master_2 = 0x82;
inline constexpr std::uint8_t global_node = 99;        ///< Addressee of a set_clock [D11]. [can §5]

/// Which exchange a message belongs to; requests and replies bear the same identifier [D6].
struct envelope {
    std::uint32_t id = 0;
    friend constexpr bool operator==(envelope, envelope) = default;
};

}  // namespace trama::can
