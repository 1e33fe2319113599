#include "daisy_table.hpp"

#include <bit>
#include <map>
#include <utility>

namespace trama_reference {

namespace {

using fields = std::vector<number_field>;

number_field u8(const std::string& name, long long high) { return {name, 1, false, 0, high}; }

number_field ten_bits(const std::string& name) { return {name, 2, false, 0, 0x3FF}; }

number_field i16(const std::string& name) { return {name, 2, true, -32768, 32767}; }

number_field i32(const std::string& name) { return {name, 4, true, -2147483648LL, 2147483647LL}; }

number_field one_of(const std::string& name, std::vector<std::string> names) {
  const auto last = static_cast<long long>(names.size()) - 1;
  return {name, 1, false, 0, last, std::move(names)};
}

number_field direction() { return one_of("direction", {"clockwise", "counter_clockwise"}); }

number_field trigger() {
  return one_of("trigger", {"none", "rising_edge", "falling_edge", "any_change"});
}

number_field state() { return one_of("state", {"low", "high"}); }

number_field five(const std::string& name) { return {name, 1, false, 0, 180, {}, 5}; }

using table = std::map<std::pair<family, std::uint8_t>, message_form>;

struct table_builder {
  table messages = {};
  family owner = family::common;

  void request(int command, const std::string& name, shape form, const fields& list) {
    const auto code = static_cast<std::uint8_t>(command);
    messages[{owner, code}] = {owner, name, code, form, list};
  }

  void both(int command, const std::string& name, const fields& asked, const fields& answered) {
    request(command, name, shape::fixed, asked);
    request(command | 0x80, name, shape::fixed, answered);
  }
};

void add_common(table_builder& t) {
  t.owner = family::common;
  t.request(0x01, "init", shape::fixed, {});
  t.request(0x81, "init", shape::text, {});
  t.request(0x02, "reset", shape::fixed, {});
  t.request(0x82, "reset", shape::text, {});
  t.both(0x03, "ping", {}, {});
  t.request(0x04, "error", shape::error, {});
}

void add_dc_motor(table_builder& t) {
  t.owner = family::dc_motor;
  t.both(0x40, "set_direction", {direction()}, {});
  t.both(0x41, "set_dc_speed", {direction(), i16("speed")}, {});
  t.both(0x42, "set_encoder", {i32("count")}, {});
  t.both(0x43, "get_encoder", {}, {i32("count")});
  t.both(0x44, "reset_encoder", {}, {});
  t.both(0x45, "set_encoder_to_stop", {i16("count")}, {});
  t.both(0x46, "get_encoder_to_stop", {}, {i16("count")});
  t.both(0x47, "dont_stop", {}, {});
  t.both(0x48, "motor_consumption", {}, {ten_bits("consumption")});
  t.both(0x49, "motor_stress_alarm", {ten_bits("consumption")}, {});
  t.both(0x4A, "motor_shut_down_alarm", {ten_bits("consumption")}, {});
  t.both(0x4B, "get_dc_speed", {}, {direction(), i16("speed")});
}

void add_servo_motor(table_builder& t) {
  t.owner = family::servo_motor;
  const number_field servo = u8("servo_id", 4);
  t.both(0x40, "set_position", {servo, u8("position", 180)}, {});
  t.both(0x41, "set_all_positions", {five("positions")}, {});
  t.both(0x42, "get_position", {servo}, {servo, u8("position", 180)});
  t.both(0x43, "get_all_positions", {}, {five("positions")});
  t.both(0x44, "set_servo_speed", {servo, u8("speed", 180)}, {});
  t.both(0x45, "set_all_speeds", {five("speeds")}, {});
  t.both(0x46, "get_servo_speed", {servo}, {servo, u8("speed", 180)});
  t.both(0x47, "get_all_speeds", {}, {five("speeds")});
  t.both(0x48, "free_servo", {servo}, {});
  t.both(0x49, "free_all_servos", {}, {});
  t.both(0x4A, "get_status", {}, {u8("switches", 0x7F)});
  t.both(0x4B, "alarm_on_state", {u8("switch_id", 5), trigger()}, {});
  t.both(0x4C, "switch_alarm", {u8("switch_id", 5), trigger(), state()}, {});
}

void add_distance_sensor(table_builder& t) {
  t.owner = family::distance_sensor;
  t.both(0x40, "on_distance_sensor", {u8("sensor_id", 5)}, {});
  t.both(0x41, "off_distance_sensor", {u8("sensor_id", 5)}, {});
  t.both(0x42, "set_distance_sensors_mask", {sensor_mask()}, {});
  t.both(0x43, "get_distance_sensors_mask", {}, {sensor_mask()});
  t.request(0x44, "get_value", shape::fixed, {sensor_mask()});
  t.request(0xC4, "get_value", shape::readings, {});
  t.request(0x45, "get_one_value", shape::fixed, {sensor_mask()});
  t.request(0xC5, "get_one_value", shape::readings, {});
  t.both(0x46, "alarm_on_state", {trigger()}, {});
  t.both(0x47, "switch_alarm", {trigger(), state()}, {});
}

void add_battery_controller(table_builder& t) {
  t.owner = family::battery_controller;
  t.both(0x40, "enable", {}, {});
  t.both(0x41, "disable", {}, {});
  t.both(0x42, "get_battery_value", {}, {ten_bits("value")});
  t.both(0x43, "battery_full_alarm", {}, {});
  t.both(0x44, "set_battery_empty_value", {ten_bits("value")}, {});
  t.both(0x45, "battery_empty_alarm", {ten_bits("value")}, {});
  t.both(0x46, "set_full_battery_value", {ten_bits("value")}, {});
}

void add_trash_bin(table_builder& t) {
  t.owner = family::trash_bin;
  t.both(0x40, "get_trash_bin_value", {}, {ten_bits("value")});
  t.both(0x41, "bin_full_alarm", {}, {});
  t.both(0x42, "set_full_bin_value", {ten_bits("value")}, {});
}

table build() {
  table_builder t;
  add_common(t);
  add_dc_motor(t);
  add_servo_motor(t);
  add_distance_sensor(t);
  add_battery_controller(t);
  add_trash_bin(t);
  return t.messages;
}

const table& messages() {
  static const table all = build();
  return all;
}

family family_of_group(int group) {
  switch (group) {
    case 1: return family::dc_motor;
    case 2: return family::servo_motor;
    case 3: return family::distance_sensor;
    case 4: return family::battery_controller;
    case 5: return family::trash_bin;
    case 6: return family::battery_controller;  // [D2]
    default: return family::none;
  }
}

}  // namespace

number_field sensor_mask() { return u8("sensors", 0x3F); }

std::string family_name(family owner) {
  switch (owner) {
    case family::common: return "common";
    case family::dc_motor: return "dc_motor";
    case family::servo_motor: return "servo_motor";
    case family::distance_sensor: return "distance_sensor";
    case family::battery_controller: return "battery_controller";
    case family::trash_bin: return "trash_bin";
    case family::none: break;
  }
  return "none";
}

const message_form* find_message(std::uint8_t destination, std::uint8_t source, std::uint8_t command) {
  family owner = family::common;
  if ((command & 0x7F) >= 0x40) {
    const bool response = (command & 0x80) != 0;
    const int first = (response ? source : destination) >> 4;
    const int other = (response ? destination : source) >> 4;
    owner = family_of_group(first != 0 ? first : other);
  }
  const auto found = messages().find({owner, command});
  return found == messages().end() ? nullptr : &found->second;
}

const message_form* find_message(std::string_view printed_name, bool response) {
  for (const auto& [key, message] : messages()) {
    const bool is_response = (message.command & 0x80) != 0;
    if (is_response == response && family_name(message.owner) + "." + message.name == printed_name) {
      return &message;
    }
  }
  return nullptr;
}

bool documented_addresses(std::uint8_t destination, std::uint8_t source, std::uint8_t command) {
  const bool everybody = destination == 0xFF && (command & 0x7F) < 0x40;
  return ((destination >> 4) <= 6 || everybody) && (source >> 4) <= 6;
}

bool length_possible(const message_form& message, std::uint8_t len, std::optional<std::uint8_t> first_data) {
  if (len < 4) return false;
  switch (message.form) {
    case shape::text: return true;
    case shape::readings:
      if (first_data) return len == 5 + 2 * std::popcount(*first_data);
      return len >= 5 && len <= 21 && len % 2 == 1;
    case shape::error:
      if (first_data) return *first_data == 0 ? len >= 11 : len == 5;
      return len == 5 || len >= 11;
    case shape::fixed: break;
  }
  std::size_t size = 0;
  for (const number_field& each : message.fields) size += each.size * each.count;
  return len == 4 + size;
}

}  // namespace trama_reference
