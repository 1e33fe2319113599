#pragma once

// Writing JSON: the few pieces that all three formats print.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trama_reference {

using octets = std::vector<std::uint8_t>;

/// A value outside what the document allows.
struct violation {
  std::string field;
  long long value = 0;
  std::string allowed;
};

/// Lower-case hex pairs without spaces or quotes.
std::string hex_text(std::span<const std::uint8_t> bytes);

/// The bytes as a JSON string: `"` and `\` escaped, controls and bytes from 0x7F on as \u00xx.
std::string quoted(std::span<const std::uint8_t> bytes);
std::string quoted(std::string_view text);

/// `,"bytes":"…"` with at most the first 256 bytes of an error's span.
std::string bytes_member(std::span<const std::uint8_t> span);

/// `,"violations":[…]`, or nothing if there are none.
std::string violations_member(const std::vector<violation>& violations);

/// The parts with a separator between them.
std::string joined(const std::vector<std::string>& parts, std::string_view separator);

/// `low..high`.
std::string range_text(long long low, long long high);

}  // namespace trama_reference
