#include "can_message.hpp"

#include <algorithm>

namespace trama_reference {

namespace {

class reader {
 public:
  explicit reader(const octets& data) : data_(data) {}

  can_meaning read(const can_form& form) {
    plain("node");
    ranged("message_id", {0, 200});
    at_ = 3;  // behind the letter
    if (form.name == "define_function") define_function();
    if (form.name == "sensor_readings") sensor_readings();
    if (form.name == "read_actuator") plain("actuator");
    if (form.name == "actuator_state" || form.name == "set_actuator") {
      plain("actuator");
      plain("state");
    }
    if (form.name == "set_clock") set_clock();
    meaning_.fields = object(members_);
    return meaning_;
  }

 private:
  std::uint8_t byte() { return data_[at_++]; }

  void add(const std::string& name, const std::string& json) { members_.push_back(member(name, json)); }

  void check(const std::string& name, long long value, const std::optional<can_range>& range) {
    if (!range || (value >= range->low && value <= range->high)) return;
    meaning_.violations.push_back({name, value, range->text()});
  }

  void plain(const std::string& name) { add(name, std::to_string(byte())); }

  long long ranged(const std::string& name, const can_range& range) {
    const long long value = byte();
    check(name, value, range);
    add(name, std::to_string(value));
    return value;
  }

  // Century, then year.
  long long year(const std::string& name) {
    const long long century = byte();
    const long long rest = byte();
    if ((century > 99 || rest > 99) && meaning_.bad_number.empty()) meaning_.bad_number = name;
    return century * 100 + rest;
  }

  long long function() {
    const long long first = byte();
    const long long value = first * 256 + byte();
    std::vector<std::string> names;
    for (const can_function& each : can_functions()) {
      names.push_back(each.name);
      if (each.value != value) continue;
      add("function", quoted(each.name));
      return value;
    }
    add("function", std::to_string(value));
    meaning_.violations.push_back({"function", value, joined(names, "|")});
    return value;
  }

  void start_or_end(const std::string& name, long long function_value) {
    std::vector<std::string> parts;
    for (const std::string part : {"year", "month", "day", "hour", "minute", "second"}) {
      const std::string full_name = name + "." + part;
      const long long value = part == "year" ? year(full_name) : byte();
      check(full_name, value, start_end_range(function_value, part));
      parts.push_back(member(part, std::to_string(value)));
    }
    add(name, object(parts));
  }

  // On the wire: both dates, then both times.
  void define_function() {
    const long long value = function();
    const octets wire(data_.begin() + 5, data_.end());
    octets in_field_order(wire.begin(), wire.begin() + 4);                                // start's date
    in_field_order.insert(in_field_order.end(), wire.begin() + 8, wire.begin() + 11);     // start's time
    in_field_order.insert(in_field_order.end(), wire.begin() + 4, wire.begin() + 8);      // end's date
    in_field_order.insert(in_field_order.end(), wire.begin() + 11, wire.end());           // end's time and the rest
    data_ = in_field_order;
    at_ = 0;
    start_or_end("start", value);
    start_or_end("end", value);
    const long long count = ranged("sensor_count", sensor_count_range(value));
    std::vector<std::string> sensors;
    for (std::size_t i = 0; i < 4; ++i) sensors.push_back(slot(indexed("sensors", i), i, count));
    add("sensors", list(sensors));
  }

  // A byte that must be zero at or past the count.
  std::string slot(const std::string& name, std::size_t index, long long count) {
    const long long value = byte();
    if (static_cast<long long>(index) >= count) check(name, value, can_range{0, 0});
    return std::to_string(value);
  }

  void sensor_readings() {
    const long long count = ranged("sensor_count", {0, 4});
    std::vector<std::string> readings;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::string name = indexed("readings", i);
      const std::string sensor = slot(name + ".sensor", i, count);
      const std::string value = slot(name + ".value", i, count);
      readings.push_back(object({member("sensor", sensor), member("value", value)}));
    }
    add("readings", list(readings));
  }

  void set_clock() {
    add("year", std::to_string(year("year")));
    for (const std::string part : {"month", "day", "hour", "minute", "second"}) ranged(part, *date_range(part));
  }

  octets data_;
  std::size_t at_ = 0;
  std::vector<std::string> members_ = {};
  can_meaning meaning_ = {};
};

}  // namespace

can_meaning read_can_message(const can_form& form, const octets& data) { return reader(data).read(form); }

}  // namespace trama_reference
