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
      text += "\\u00" + hex_pair(byte);
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
  return ",\"bytes\":\"" + hex_text(span.first(shown)) + "\"";
}

std::string violations_member(const std::vector<violation>& violations) {
  if (violations.empty()) return "";
  std::vector<std::string> parts;
  for (const violation& each : violations) {
    parts.push_back("{\"field\":" + quoted(each.field) + ",\"value\":" + std::to_string(each.value) +
                    ",\"allowed\":" + quoted(each.allowed) + "}");
  }
  return ",\"violations\":[" + joined(parts, ",") + "]";
}

std::string joined(const std::vector<std::string>& parts, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += separator;
    text += parts[i];
  }
  return text;
}

std::string range_text(long long low, long long high) {
  return std::to_string(low) + ".." + std::to_string(high);
}

}  // namespace trama_reference
