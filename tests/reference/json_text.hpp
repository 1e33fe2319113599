#pragma once

// Writing JSON: the few pieces that all three formats print.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
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

/// The parts one after another.
std::string concat(std::initializer_list<std::string_view> parts);

/// `[item,item]`
std::string list(const std::vector<std::string>& items);

/// `{member,member}`
std::string object(const std::vector<std::string>& members);

/// `"name":value`, or with the comma before it.
std::string member(std::string_view name, std::string_view json);
std::string next_member(std::string_view name, std::string_view json);
std::string next_member(std::string_view name, long long number);

/// `name[index]`
std::string indexed(std::string_view name, std::size_t index);

/// `low..high`.
std::string range_text(long long low, long long high);

}  // namespace trama_reference
