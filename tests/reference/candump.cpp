#include "candump.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace trama_reference {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_hex(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

bool all_digits(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

bool all_hex(const std::string& text) { return std::all_of(text.begin(), text.end(), is_hex); }

std::vector<std::string> words(std::string_view line) {
  std::vector<std::string> found;
  std::string word;
  for (const char c : line) {
    if (c != ' ' && c != '\t') {
      word += c;
    } else if (!word.empty()) {
      found.push_back(word);
      word.clear();
    }
  }
  if (!word.empty()) found.push_back(word);
  return found;
}

// "(12.345678)"; digits behind the ninth are dropped. 18000000001 seconds or more are too many, as the tool's page says.
std::optional<log_time> parse_time(const std::string& word) {
  if (word.size() < 2 || word.front() != '(' || word.back() != ')') return std::nullopt;
  const std::string inner = word.substr(1, word.size() - 2);
  const std::size_t point = inner.find('.');
  if (point == std::string::npos) return std::nullopt;
  std::string seconds = inner.substr(0, point);
  std::string fraction = inner.substr(point + 1);
  if (!all_digits(seconds) || !all_digits(fraction)) return std::nullopt;
  seconds.erase(0, std::min(seconds.find_first_not_of('0'), seconds.size() - 1));
  if (seconds.size() > 11 || std::stoull(seconds) > 18000000000ULL) return std::nullopt;
  fraction.resize(9, '0');
  return log_time{std::stoull(seconds), std::stoull(fraction)};
}

// "R", or R and the length asked for.
bool remote_request(const std::string& data) {
  if (data.empty() || data[0] != 'R' || data.size() > 2) return false;
  return data.size() == 1 || (data[1] >= '0' && data[1] <= '8');
}

// "#" and the flags, then up to 64 bytes.
bool fd_frame(const std::string& data) {
  return data.size() >= 2 && data[0] == '#' && all_hex(data.substr(1)) && data.size() % 2 == 0 &&
         data.size() <= 2 + 2 * 64;
}

octets bytes_of(const std::string& hex) {
  octets bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

}  // namespace

std::optional<log_frame> parse_candump(std::string_view line) {
  const std::vector<std::string> parts = words(line);
  if (parts.size() != 3 && parts.size() != 4) return std::nullopt;
  if (parts.size() == 4 && parts[3] != "R" && parts[3] != "T") return std::nullopt;
  const std::optional<log_time> time = parse_time(parts[0]);
  const std::size_t sharp = parts[2].find('#');
  if (!time || sharp == std::string::npos) return std::nullopt;
  const std::string id = parts[2].substr(0, sharp);
  std::string data = parts[2].substr(sharp + 1);
  // A DLC of 9 to 15 stands behind the eight bytes that it means, or behind "R8"; FD frames have none.
  const std::size_t n = data.size();
  const bool eight = (n == 18 && data[0] != '#') || (n == 4 && data[0] == 'R' && data[1] == '8');
  if (eight && data[n - 2] == '_' && is_hex(data[n - 1]) && (data[n - 1] == '9' || !is_digit(data[n - 1]))) data.resize(n - 2);
  if ((id.size() != 3 && id.size() != 8) || !all_hex(id)) return std::nullopt;

  log_frame frame;
  frame.time = *time;
  frame.id = static_cast<std::uint32_t>(std::stoul(id, nullptr, 16));
  if (id.size() == 3 && frame.id > 0x7FF) return std::nullopt;
  frame.standard = id.size() == 3;
  if (remote_request(data) || fd_frame(data)) {
    frame.standard = false;
    return frame;
  }
  if (!all_hex(data) || data.size() % 2 != 0 || data.size() > 16) return std::nullopt;
  frame.data = bytes_of(data);
  return frame;
}

}  // namespace trama_reference
