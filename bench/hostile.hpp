#pragma once
// Streams that make decoders work hardest for each byte, as far as known; without intact messages but for chance hits of daisy's.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dice.hpp"
#include "trama/can/frame.hpp"

namespace trama::bench {

/// daisy: headers of the longest texts, one after the other. `chance`: with LEN 251 and 255, of which one in 128 begins a packet that is intact, so that
/// the decoder is in step now and then. Without them bit 7 of the exclusive or is always set. Each is the dearer one in some way of feeding it.
inline std::vector<std::uint8_t> hostile_daisy(std::size_t bytes, bool chance = true) {
    std::vector<std::uint8_t> s;
    dice d(6);
    while (s.size() < bytes) {
        const int length = chance ? static_cast<int>(250 + d.below(6)) : std::array{250, 252, 253, 254}[d.below(4)];
        const std::array<std::uint8_t, 4> header{static_cast<std::uint8_t>(length), 0x00, static_cast<std::uint8_t>(d.below(0x60)), static_cast<std::uint8_t>(0x81 + d.below(2))};
        s.insert(s.end(), header.begin(), header.end());
    }
    return s;
}

/// can: first frames of messages that never go on; each breaks off the one before it, on three identifiers in turn.
inline std::vector<can::frame> hostile_can(std::size_t frames) {
    std::vector<can::frame> s(frames);
    dice d(26);
    for (std::size_t i = 0; i != s.size(); ++i) {
        can::frame& f = s[i];
        f.id = static_cast<std::uint32_t>(0x80 + i % 3);
        f.length = 8;
        for (std::uint8_t& b : f.data) b = static_cast<std::uint8_t>(d.next());
        f.data[2] = d.one_in(2) ? 'R' : 'C';  // which are followed by 4 and by 2 bytes
    }
    return s;
}

/// gateway: records that begin over and over and never end.
inline std::vector<std::uint8_t> hostile_gateway(std::size_t bytes) {
    std::vector<std::uint8_t> s(bytes);
    for (std::size_t i = 0; i != bytes; ++i) s[i] = static_cast<std::uint8_t>("\002200"[i % 4]);
    return s;
}

}  // namespace trama::bench
