#pragma once
// What the machine could do at best, whatever the code: copying, reading, checking that all bytes are printable.
#include <span>
#include <vector>

#include "harness.hpp"

namespace trama::bench {

/// Copies the stream.
tally copy_all(std::span<const std::uint8_t> in, std::vector<std::uint8_t>& out);
/// Reads the stream once in words; compilers make vector code of it.
tally read_all(std::span<const std::uint8_t> in);
/// Checks that every byte is printable, STX or ETX, in vectors where the machine has them, and nothing else.
tally check_printable(std::span<const std::uint8_t> in);

/// Adds memcpy and the vector pass, for a stream made of so many messages.
void add_memory_limits(race& r, std::span<const std::uint8_t> in, std::uint64_t messages);

}  // namespace trama::bench
