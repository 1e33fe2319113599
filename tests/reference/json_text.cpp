#include "json_text.hpp"

#include <algorithm>
#include <cstddef>

namespace trama_reference {

namespace {

const std::string hex_digits = "0123456789abcdef";

std::string hex_pair(std::uint8_t byte) {
  return {hex_digits[byte >> 4], hex_digits[byte & 0x0F]};
}

}  // namespace

std::string hex_text(std::span<const std::uint8_t> bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += hex_pair(byte);
  return text;
}

std::string quoted(std::span<const std::uint8_t> bytes) {
  std::string text = "\"";
  for (const std::uint8_t byte : bytes) {
    if (byte < 0x20 || byte >= 0x7F) {
      text += "\\u00";
      text += hex_pair(byte);
    } else {
      if (byte == '"' || byte == '\\') text += '\\';
      text += static_cast<char>(byte);
    }
  }
  return text + "\"";
}

std::string quoted(std::string_view text) {
  return quoted(octets(text.begin(), text.end()));
}

std::string bytes_member(std::span<const std::uint8_t> span) {
  const std::size_t shown = std::min<std::size_t>(256, span.size());
  return next_member("bytes", quoted(hex_text(span.first(shown))));
}

std::string violations_member(const std::vector<violation>& violations) {
  if (violations.empty()) return "";
  std::vector<std::string> parts;
  for (const violation& each : violations) {
    parts.push_back(object({member("field", quoted(each.field)), member("value", std::to_string(each.value)),
                            member("allowed", quoted(each.allowed))}));
  }
  return next_member("violations", list(parts));
}

std::string joined(const std::vector<std::string>& parts, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += separator;
    text += parts[i];
  }
  return text;
}

std::string concat(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text += part;
  return text;
}

std::string list(const std::vector<std::string>& items) { return concat({"[", joined(items, ","), "]"}); }

std::string object(const std::vector<std::string>& members) { return concat({"{", joined(members, ","), "}"}); }

std::string member(std::string_view name, std::string_view json) { return concat({"\"", name, "\":", json}); }

std::string next_member(std::string_view name, std::string_view json) { return concat({",", member(name, json)}); }

std::string next_member(std::string_view name, long long number) {
  return next_member(name, std::to_string(number));
}

std::string indexed(std::string_view name, std::size_t index) {
  return concat({name, "[", std::to_string(index), "]"});
}

std::string range_text(long long low, long long high) {
  return concat({std::to_string(low), "..", std::to_string(high)});
}

}  // namespace trama_reference
