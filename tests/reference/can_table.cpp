#include "can_table.hpp"

#include "json_text.hpp"

namespace trama_reference {

namespace {

constexpr long long letters(char first, char second) { return first * 256LL + second; }

constexpr long long continuous_all = letters('C', 'A');
constexpr long long continuous_specific = letters('C', 'S');
constexpr long long sleep = letters('S', 'A');
constexpr long long interval_all = letters('I', 'A');
constexpr long long interval_specific = letters('I', 'S');

}  // namespace

std::string can_range::text() const { return low == high ? std::to_string(low) : range_text(low, high); }

const std::vector<can_form>& can_forms() {
  static const std::vector<can_form> all = {
      {"define_function", 'F', {8, 8, 8}}, {"read_sensors", 'R', {3}},   {"sensor_readings", 'R', {8, 4}},
      {"read_actuator", 'A', {4}},         {"actuator_state", 'A', {5}}, {"set_actuator", 'M', {5}},
      {"set_clock", 'C', {8, 2}},
  };
  return all;
}

const can_form* find_can_form(std::uint8_t letter, std::size_t length) {
  for (const can_form& each : can_forms()) {
    if (static_cast<std::uint8_t>(each.letter) == letter && each.lengths[0] == length) return &each;
  }
  return nullptr;
}

bool known_can_letter(std::uint8_t letter) {
  for (const can_form& each : can_forms()) {
    if (static_cast<std::uint8_t>(each.letter) == letter) return true;
  }
  return false;
}

const std::vector<can_function>& can_functions() {
  static const std::vector<can_function> all = {{"continuous_all", continuous_all},
                                                {"continuous_specific", continuous_specific},
                                                {"sleep", sleep},
                                                {"interval_all", interval_all},
                                                {"interval_specific", interval_specific}};
  return all;
}

std::optional<can_range> date_range(const std::string& part) {
  if (part == "month") return can_range{1, 12};
  if (part == "day") return can_range{1, 31};
  if (part == "hour") return can_range{0, 23};
  if (part == "minute" || part == "second") return can_range{0, 59};
  return std::nullopt;
}

std::optional<can_range> start_end_range(long long function, const std::string& part) {
  if (function == interval_all || function == interval_specific) return date_range(part);
  return can_range{0, 0};
}

can_range sensor_count_range(long long function) {
  if (function == continuous_all || function == interval_all || function == sleep) return {0, 0};
  if (function == continuous_specific || function == interval_specific) return {1, 4};
  return {0, 4};
}

}  // namespace trama_reference
