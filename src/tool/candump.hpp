#pragma once

#include <optional>
#include <string_view>

#include "trama/can/frame.hpp"
#include "trama/core/sink.hpp"

namespace trama::tool {

/// Nanoseconds, the unit of the frames' times that `parse_candump` gives.
inline constexpr std::uint64_t per_second = 1'000'000'000;

/// A line of a candump log, `(seconds.fraction) interface id#data`, as a frame; nothing if it is none.
/// 3 hex digits are an 11-bit identifier, 8 a 29-bit one; `#R` is a remote frame, `##` an FD frame, whose data are left out.
std::optional<can::frame> parse_candump(std::string_view line) noexcept;

/// Writes a frame as such a line, with its end.
void print_candump(text_sink& out, const can::frame& f) noexcept;

/// The most seconds that `parse_seconds` takes.
inline constexpr std::uint64_t most_seconds = 18'000'000'000;
/// A decimal number of seconds in nanoseconds; nothing if `text` is no such number or too large.
std::optional<std::uint64_t> parse_seconds(std::string_view text) noexcept;

}  // namespace trama::tool
