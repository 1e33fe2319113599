#pragma once

// One line of a candump log: `(seconds.fraction) interface id#data`.

#include <cstdint>
#include <optional>
#include <string_view>

#include "json_text.hpp"

namespace trama_reference {

/// A time of the log, exact to the nanosecond.
struct log_time {
  std::uint64_t seconds = 0;
  std::uint64_t nanoseconds = 0;
  auto operator<=>(const log_time&) const = default;
};

struct log_frame {
  log_time time;
  std::uint32_t id = 0;
  octets data = {};
  bool standard = true;  ///< false: extended, remote, error or FD, never of this protocol
};

/// The frame of a line without its line end; nothing for a line that is no candump line.
std::optional<log_frame> parse_candump(std::string_view line);

}  // namespace trama_reference
