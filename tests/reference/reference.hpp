#pragma once

// The reference: a second, independent implementation of the three wire formats, in plain slow C++.
// It shares nothing with the library, so that the two do not share their mistakes. It is right by
// reading, not fast, and serves differential tests and fuzzing only.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trama_reference {

/// What `trama decode daisy` prints for this stream, one JSON object per element, end of input included.
std::vector<std::string> daisy_lines(std::span<const std::uint8_t> stream);

/// The same, with idle() called after so many bytes of the stream (ascending, may repeat).
std::vector<std::string> daisy_lines(std::span<const std::uint8_t> stream,
                                     std::span<const std::size_t> idle_at);

/// What `trama decode gateway` prints for this stream.
std::vector<std::string> gateway_lines(std::span<const std::uint8_t> stream);

/// What `trama decode can --timeout timeout_seconds` prints for this candump log.
std::vector<std::string> can_lines(std::string_view candump_log, double timeout_seconds = 1.0);

/// What `trama encode daisy` writes for one JSON line; nothing if it refuses the line.
/// `unchecked` stands for --unchecked: violations are written, all else is refused as before.
std::optional<std::vector<std::uint8_t>> daisy_encode(std::string_view json_line, bool unchecked = false);

/// What `trama encode gateway` writes for one JSON line; nothing if it refuses the line.
std::optional<std::vector<std::uint8_t>> gateway_encode(std::string_view json_line, bool unchecked = false);

/// What `trama encode can` writes for one JSON line, candump log lines that each end in a line feed.
std::optional<std::string> can_encode(std::string_view json_line, bool unchecked = false);

}  // namespace trama_reference
