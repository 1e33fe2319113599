#include <algorithm>
#include <string>

#include "can_message.hpp"
#include "can_table.hpp"
#include "json_value.hpp"
#include "reference.hpp"

namespace trama_reference {

namespace {

using kind = json_value::kind;

json_value empty_object() {
  json_value object;
  object.type = kind::object;
  return object;
}

json_value member_or_empty(const json_value& object, const std::string& name) {
  const json_value* given = object.find(name);
  return given == nullptr ? empty_object() : *given;
}

std::uint8_t byte(const json_value& object, const std::string& name) {
  const json_value* given = object.find(name);
  return static_cast<std::uint8_t>(given == nullptr ? 0 : integer(*given, 0, 255));
}

void append_year(octets& data, const json_value& object) {
  const json_value* given = object.find("year");
  const long long year = given == nullptr ? 0 : integer(*given, 0, 9999);
  data.push_back(static_cast<std::uint8_t>(year / 100));
  data.push_back(static_cast<std::uint8_t>(year % 100));
}

void append_bytes(octets& data, const json_value& object, const std::vector<std::string>& names) {
  for (const std::string& name : names) data.push_back(byte(object, name));
}

long long function_value(const json_value& fields) {
  const json_value* given = fields.find("function");
  if (given == nullptr) return 0;
  if (given->type != kind::string) return integer(*given, 0, 0xFFFF);
  const std::string name = string(*given);
  for (const can_function& each : can_functions()) {
    if (each.name == name) return each.value;
  }
  throw refused("unknown function " + name);
}

void append_define_function(octets& data, const json_value& fields) {
  expect_members(fields, {"node", "message_id", "function", "start", "end", "sensor_count", "sensors"});
  const long long function = function_value(fields);
  data.push_back(static_cast<std::uint8_t>(function / 256));
  data.push_back(static_cast<std::uint8_t>(function % 256));
  const json_value start = member_or_empty(fields, "start");
  const json_value end = member_or_empty(fields, "end");
  for (const json_value& date : {start, end}) {
    expect_members(date, {"year", "month", "day", "hour", "minute", "second"});
    append_year(data, date);
    append_bytes(data, date, {"month", "day"});
  }
  for (const json_value& time : {start, end}) append_bytes(data, time, {"hour", "minute", "second"});
  data.push_back(byte(fields, "sensor_count"));
  const json_value* sensors = fields.find("sensors");
  if (sensors == nullptr) {
    data.resize(data.size() + 4);
  } else {
    for (const json_value& item : array(*sensors, 4)) data.push_back(static_cast<std::uint8_t>(integer(item, 0, 255)));
  }
}

void append_sensor_readings(octets& data, const json_value& fields) {
  expect_members(fields, {"node", "message_id", "sensor_count", "readings"});
  data.push_back(byte(fields, "sensor_count"));
  const json_value* readings = fields.find("readings");
  if (readings == nullptr) {
    data.resize(data.size() + 8);
    return;
  }
  for (const json_value& reading : array(*readings, 4)) {
    expect_members(reading, {"sensor", "value"});
    append_bytes(data, reading, {"sensor", "value"});
  }
}

void append_set_clock(octets& data, const json_value& fields) {
  expect_members(fields, {"node", "message_id", "year", "month", "day", "hour", "minute", "second"});
  append_year(data, fields);
  append_bytes(data, fields, {"month", "day", "hour", "minute", "second"});
}

octets message_data(const can_form& form, const json_value& fields) {
  octets data = {byte(fields, "node"), byte(fields, "message_id"), static_cast<std::uint8_t>(form.letter)};
  if (form.name == "define_function") {
    append_define_function(data, fields);
  } else if (form.name == "sensor_readings") {
    append_sensor_readings(data, fields);
  } else if (form.name == "set_clock") {
    append_set_clock(data, fields);
  } else if (form.name == "read_sensors") {
    expect_members(fields, {"node", "message_id"});
  } else if (form.name == "read_actuator") {
    expect_members(fields, {"node", "message_id", "actuator"});
    append_bytes(data, fields, {"actuator"});
  } else {
    expect_members(fields, {"node", "message_id", "actuator", "state"});
    append_bytes(data, fields, {"actuator", "state"});
  }
  return data;
}

std::string upper_hex(std::span<const std::uint8_t> bytes) {
  std::string text = hex_text(bytes);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

std::string encode(std::string_view text, bool unchecked) {
  const json_value line = parse_line(text, "can", {"id"});
  const json_value* given_id = line.find("id");
  if (given_id == nullptr) throw refused("no id");
  const long long id = integer(*given_id, 0, 0x7FF);
  const std::string name = string(*line.find("message"));
  const auto& forms = can_forms();
  const auto form = std::find_if(forms.begin(), forms.end(), [&](const can_form& each) { return each.name == name; });
  if (form == forms.end()) throw refused("unknown message");
  const octets data = message_data(*form, member_or_empty(line, "fields"));
  if (!unchecked && !read_can_message(*form, data).violations.empty()) throw refused("violation");

  const octets id_bytes = {static_cast<std::uint8_t>(id / 256), static_cast<std::uint8_t>(id % 256)};
  const std::string id_text = upper_hex(id_bytes).substr(1);
  std::string log;
  std::size_t at = 0;
  for (const std::size_t length : form->lengths) {
    log += "(0.000000) can0 " + id_text + "#" + upper_hex(std::span(data).subspan(at, length)) + "\n";
    at += length;
  }
  return log;
}

}  // namespace

std::optional<std::string> can_encode(std::string_view json_line, bool unchecked) {
  try {
    return encode(json_line, unchecked);
  } catch (const refused&) {
    return std::nullopt;
  }
}

}  // namespace trama_reference
