#include "gateway_table.hpp"

#include <utility>

#include "json_text.hpp"

namespace trama_reference {

namespace {

using fields = std::vector<gateway_field>;

gateway_field number(const std::string& name, std::size_t width = 5) { return {name, width}; }

gateway_field ranged(const std::string& name, std::size_t width, long long high) {
  return {name, width, content::number, 0, high};
}

gateway_field text(const std::string& name, std::size_t width = 10) { return {name, width, content::text}; }

gateway_field tenths(const std::string& name) { return {name, 5, content::tenths}; }

gateway_field named(const std::string& name, std::vector<std::string> names) {
  return {name, 1, content::named, 0, -1, std::move(names)};
}

gateway_field bits(const std::string& name, std::size_t width, std::vector<std::string> names) {
  return {name, width, content::bits, 0, -1, std::move(names)};
}

gateway_field order_type(const std::string& name, std::vector<int> allowed) {
  return {name, 3, content::order_type, 0, -1, {}, std::move(allowed)};
}

gateway_field src_type() {
  return order_type("src_type", {1, 2, 3, 10, 15, 20, 21, 22, 23, 30, 50});
}

gateway_field circuit_mode(const std::string& name) {
  return named(name, {"no_power_freezing", "no_power_frozen", "init", "manual", "semi_automatic", "automatic",
                      "shutdown_ready", "shutting_down"});
}

gateway_field cart_phase() {
  return named("cart_phase", {"none", "go_load", "loading", "go_transit", "transiting", "transit_done",
                              "go_unload", "unloading", "go_parking", "go_node"});
}

gateway_field cart_status() {
  return bits("cart_status", 4,
              {"cart_error", "hook_error", "warning", "paused", "manual_mode", "maintenance", "busy", "ready",
               "parking", "loaded", "house_keeping", "shutdown_ready"});
}

gateway_field circuit_check() {
  return bits("check", 7,
              {"cart_lost", "cart_wrong_platform_version", "cart_wrong_program_version",
               "cart_wrong_firmware_version", "cart_wrong_map", "emergency_armed", "door_opening",
               "all_carts_no_power_frozen", "cart_emergency", "cart_unlocated", "cart_traffic_check_failed",
               "door_open", "transport_interrupted", "overvoltage", "undervoltage", "overcurrent",
               "cart_wrong_powerboard_version", "power_supplies_fail", "battery_fault", "shutting_down",
               "circuit_breaker_48v", "all_carts_shutdown_ready"});
}

fields transit_command() {
  return {number("msg_id"),     number("cart_id"), number("station_id"),   number("station_type"),
          ranged("level", 2, 15), text("options"), text("initial_inputs"), text("cargo_id")};
}

fields for_node(const std::string& node) { return {number("msg_id"), number("cart_id"), number(node)}; }

fields for_transit(const std::string& last) {
  return {number("msg_id"), number("cart_id"), text("transit_id"), text(last)};
}

fields reply() { return {number("msg_id"), number("cart_id"), src_type(), number("src_msg_id")}; }

fields reply_with(const gateway_field& last) {
  fields all = reply();
  all.push_back(last);
  return all;
}

fields cart_state() {
  return {number("msg_id"),
          number("cart_id"),
          cart_status(),
          cart_phase(),
          number("ini_node"),
          ranged("rel_position", 3, 100),
          number("end_node"),
          number("next_node"),
          {"speed_mms", 5, content::signed_number},
          ranged("cross_confirmation_needed", 1, 1)};
}

fields circuit_state() {
  return {number("msg_id"),        tenths("circuit_voltage"), tenths("circuit_current"),
          number("working_carts"), circuit_check(),           circuit_mode("target_mode"),
          circuit_mode("mode")};
}

std::vector<gateway_message> build() {
  return {{1, "load", transit_command()},
          {2, "transit", transit_command()},
          {3, "unload", transit_command()},
          {10, "go_parking", for_node("parking_node")},
          {15, "go_node", for_node("node")},
          {20, "cancel_transits", {number("msg_id"), number("cart_id")}},
          {21, "send_command", for_transit("command")},
          {22, "send_inputs", for_transit("inputs")},
          {23, "send_cargo_id", for_transit("cargo_id")},
          {30, "cross_granted", for_node("node")},
          {50, "idle_processing", {number("msg_id")}},
          {100, "transit_ack", reply_with(text("transit_id"))},
          {101, "ack", reply()},
          {102, "nack", reply_with(text("error_message", 80))},
          {200, "cart_state", cart_state(), 2},
          {201, "circuit_state", circuit_state()}};
}

std::size_t width_of(const fields& list) {
  std::size_t width = 0;
  for (const gateway_field& each : list) width += each.width;
  return width;
}

}  // namespace

std::size_t gateway_message::payload() const {
  return 3 + width_of(fields) + orders * width_of(transit_order_fields());
}

const std::vector<gateway_message>& gateway_messages() {
  static const std::vector<gateway_message> all = build();
  return all;
}

const std::vector<gateway_field>& transit_order_fields() {
  static const fields all = {
      named("use", {"unused", "previous", "current", "next"}),
      order_type("type", {0, 1, 2, 3, 10, 15}),
      number("node"),
      number("station_id"),
      number("station_type"),
      ranged("level", 2, 15),
      text("options"),
      text("transit_id"),
      text("cargo_id"),
      named("phase", {"none", "go_transit", "transiting", "transit_done"}),
      text("inputs"),
      text("outputs"),
      text("last_command"),
  };
  return all;
}

std::string order_type_name(long long type) {
  if (type == 0) return "none";
  for (const gateway_message& each : gateway_messages()) {
    if (each.type == type) return each.name;
  }
  return "";
}

std::string order_type_names(const std::vector<int>& types) {
  std::vector<std::string> names;
  for (const int type : types) names.push_back(order_type_name(type));
  return joined(names, "|");
}

}  // namespace trama_reference
