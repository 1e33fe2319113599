#include <bit>

#include "daisy_table.hpp"
#include "json_value.hpp"
#include "reference.hpp"

namespace trama_reference {

namespace {

void append_little_endian(octets& data, long long value, std::size_t size) {
  const auto bits = static_cast<unsigned long long>(value);
  for (std::size_t i = 0; i < size; ++i) data.push_back(static_cast<std::uint8_t>(bits >> (8 * i) & 0xFF));
}

std::uint8_t from_hex_digit(char digit) {
  const std::string lower = "0123456789abcdef";
  const std::string upper = "0123456789ABCDEF";
  std::size_t value = lower.find(digit);
  if (value == std::string::npos) value = upper.find(digit);
  if (value == std::string::npos) throw refused("hex digit expected");
  return static_cast<std::uint8_t>(value);
}

octets from_hex(const std::string& text) {
  if (text.size() % 2 != 0) throw refused("odd number of hex digits");
  octets bytes;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(from_hex_digit(text[i]) * 16 + from_hex_digit(text[i + 1])));
  }
  return bytes;
}

// DATA of one message, from its fields in JSON.
class data_writer {
 public:
  data_writer(const json_value& fields, bool unchecked) : fields_(fields), unchecked_(unchecked) {}

  octets write(const message_form& message) {
    switch (message.form) {
      case shape::text: write_text(); break;
      case shape::readings: write_readings(); break;
      case shape::error: write_error(); break;
      case shape::fixed: write_fixed(message); break;
    }
    return data_;
  }

 private:
  void write_fixed(const message_form& message) {
    std::vector<std::string> names;
    for (const number_field& each : message.fields) names.push_back(each.name);
    expect_members(fields_, names);
    for (const number_field& each : message.fields) write_numbers(each);
  }

  void write_numbers(const number_field& field) {
    const json_value* given = fields_.find(field.name);
    if (given == nullptr) {
      data_.resize(data_.size() + field.size * field.count);
    } else if (field.count == 1) {
      write_number(field, *given);
    } else {
      for (const json_value& item : array(*given, field.count)) write_number(field, item);
    }
  }

  void write_number(const number_field& field, const json_value& given) {
    if (!field.names.empty() && given.type == json_value::kind::string) {
      return append_little_endian(data_, named(field, string(given)), field.size);
    }
    const long long all = 1LL << (8 * field.size);
    const long long value =
        field.is_signed ? integer(given, -all / 2, all / 2 - 1) : integer(given, 0, all - 1);
    check(value >= field.low && value <= field.high);
    append_little_endian(data_, value, field.size);
  }

  static long long named(const number_field& field, const std::string& name) {
    for (std::size_t i = 0; i < field.names.size(); ++i) {
      if (field.names[i] == name) return static_cast<long long>(i);
    }
    throw refused("unknown name " + name);
  }

  void check(bool allowed) const {
    if (!allowed && !unchecked_) throw refused("violation");
  }

  void write_text() {
    expect_members(fields_, {"description"});
    const json_value* given = fields_.find("description");
    if (given == nullptr) return;
    const std::string text = string(*given);
    if (text.size() > 251) throw refused("description too long");
    data_.assign(text.begin(), text.end());
  }

  void write_readings() {
    expect_members(fields_, {"sensors", "readings"});
    write_numbers(sensor_mask());
    const std::uint8_t mask = data_[0];
    const auto size = static_cast<std::size_t>(std::popcount(mask));
    const json_value* given = fields_.find("readings");
    const std::vector<json_value> none;
    const std::vector<json_value>& items = given == nullptr ? none : array(*given, size);
    std::size_t next = 0;
    for (int sensor = 0; sensor < 8; ++sensor) {
      if ((mask >> sensor & 1) == 0) continue;
      const long long value = given == nullptr ? 0 : integer(items[next++], 0, 0xFFFF);
      check(reading_allowed(sensor, value));
      append_little_endian(data_, value, 2);
    }
  }

  static bool reading_allowed(int sensor, long long value) {
    if (sensor <= 4) return value <= 0x3FF;
    return sensor == 5 && (value <= 0x7594 || value == 0xFFFF);
  }

  void write_error() {
    expect_members(fields_, {"code", "rejected", "expected_crc"});
    const json_value* code = fields_.find("code");
    data_.push_back(static_cast<std::uint8_t>(code == nullptr ? 0 : integer(*code, 0, 255)));
    const json_value* rejected = fields_.find("rejected");
    const json_value* expected = fields_.find("expected_crc");
    if (data_[0] != 0) {
      if (rejected != nullptr || expected != nullptr) throw refused("only code 0 has a rejected packet");
      return;
    }
    const octets packet = rejected == nullptr ? octets() : from_hex(string(*rejected));
    if (packet.size() < 5 || packet.size() > 249) throw refused("rejected packet does not fit");  // [D5]
    data_.insert(data_.end(), packet.begin(), packet.end());
    data_.push_back(static_cast<std::uint8_t>(expected == nullptr ? 0 : integer(*expected, 0, 255)));
  }

  const json_value& fields_;
  bool unchecked_;
  octets data_ = {};
};

std::uint8_t address(const json_value& line, const std::string& name) {
  const json_value* given = line.find(name);
  if (given == nullptr) throw refused("no " + name);
  return static_cast<std::uint8_t>(integer(*given, 0, 255));
}

bool is_response(const json_value& line) {
  const json_value* kind = line.find("kind");
  if (kind == nullptr) return false;  // a default, as for missing fields
  const std::string text = string(*kind);
  if (text != "request" && text != "response") throw refused("unknown kind");
  return text == "response";
}

octets encode(std::string_view text, bool unchecked) {
  const json_value line = parse_line(text, "daisy", {"destination", "source", "kind"});
  const std::uint8_t destination = address(line, "destination");
  const std::uint8_t source = address(line, "source");
  const message_form* message = find_message(string(*line.find("message")), is_response(line));
  if (message == nullptr) throw refused("unknown message");
  if (find_message(destination, source, message->command) != message) {
    throw refused("destination: another family");  // [D3]
  }
  if ((source & 0x0F) == 0x0F && !unchecked) throw refused("violation of source");

  json_value none;
  none.type = json_value::kind::object;
  const json_value* fields = line.find("fields");
  const octets data = data_writer(fields == nullptr ? none : *fields, unchecked).write(*message);

  octets packet;
  packet.push_back(static_cast<std::uint8_t>(data.size() + 4));
  packet.push_back(destination);
  packet.push_back(source);
  packet.push_back(message->command);
  for (const std::uint8_t byte : data) packet.push_back(byte);
  std::uint8_t crc = 0;
  for (const std::uint8_t byte : packet) crc = static_cast<std::uint8_t>(crc ^ byte);
  packet.push_back(crc);
  return packet;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> daisy_encode(std::string_view json_line, bool unchecked) {
  try {
    return encode(json_line, unchecked);
  } catch (const refused&) {
    return std::nullopt;
  }
}

}  // namespace trama_reference
