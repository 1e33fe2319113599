#pragma once

// How `daisy` finds its packets in a stream, and its footing after a fault.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace trama_reference {

/// A packet accepted, or a stretch of the stream that is none.
struct daisy_event {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string error = "";  ///< empty for a packet
  int expected = 0;        ///< of bad_checksum
  int received = 0;        ///< of bad_checksum
};

/// The events of the whole stream, with idle() called after so many bytes (ascending).
std::vector<daisy_event> daisy_events(std::span<const std::uint8_t> stream,
                                      std::span<const std::size_t> idle_at);

}  // namespace trama_reference
