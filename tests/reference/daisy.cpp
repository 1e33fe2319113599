#include "daisy_recovery.hpp"
#include "daisy_table.hpp"
#include "json_text.hpp"
#include "reference.hpp"

namespace trama_reference {

namespace {

using bytes_view = std::span<const std::uint8_t>;

long long little_endian(bytes_view bytes, bool is_signed) {
  long long value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) value += static_cast<long long>(bytes[i]) << (8 * i);
  const long long modulus = 1LL << (8 * bytes.size());
  return is_signed && value >= modulus / 2 ? value - modulus : value;
}

std::string line_head(std::size_t offset, std::size_t length) {
  return concat({"{", member("protocol", quoted("daisy")), next_member("offset", static_cast<long long>(offset)),
                 next_member("length", static_cast<long long>(length))});
}

// The JSON fields and the violations of one packet.
class packet_printer {
 public:
  explicit packet_printer(bytes_view packet) : packet_(packet), data_(packet.subspan(4, packet.size() - 5)) {
    const std::uint8_t source = packet[2];
    if ((source & 0x0F) == 0x0F) violations_.push_back({"source", source, "id 0..14"});
  }

  std::string print(std::size_t offset, const message_form& message) {
    print_fields(message);
    const std::string name = concat({family_name(message.owner), ".", message.name});
    const std::string kind = (message.command & 0x80) != 0 ? "response" : "request";
    return concat({line_head(offset, packet_.size()), addresses(), next_member("message", quoted(name)),
                   next_member("kind", quoted(kind)), next_member("fields", object(fields_)),
                   violations_member(violations_), "}"});
  }

  std::string print_unknown(std::size_t offset) const {
    return concat({line_head(offset, packet_.size()), next_member("error", quoted("unknown_message")),
                   bytes_member(packet_), addresses(), next_member("command", packet_[3]), "}"});
  }

 private:
  std::string addresses() const {
    return concat({next_member("destination", packet_[1]), next_member("source", packet_[2])});
  }

  void print_fields(const message_form& message) {
    switch (message.form) {
      case shape::text: add("description", quoted(data_)); break;
      case shape::readings: print_readings(); break;
      case shape::error: print_error(); break;
      case shape::fixed:
        for (const number_field& each : message.fields) print_numbers(each);
        break;
    }
  }

  void add(const std::string& name, const std::string& json) { fields_.push_back(member(name, json)); }

  long long take(std::size_t size, bool is_signed) {
    const long long value = little_endian(data_.subspan(at_, size), is_signed);
    at_ += size;
    return value;
  }

  void print_numbers(const number_field& field) {
    if (field.count == 1) return add(field.name, print_number(field, field.name));
    std::vector<std::string> items;
    for (std::size_t i = 0; i < field.count; ++i) {
      items.push_back(print_number(field, indexed(field.name, i)));
    }
    add(field.name, list(items));
  }

  std::string print_number(const number_field& field, const std::string& full_name) {
    const long long value = take(field.size, field.is_signed);
    if (value < field.low || value > field.high) {
      const bool named = !field.names.empty();
      violations_.push_back({full_name, value, named ? joined(field.names, "|") : range_text(field.low, field.high)});
    } else if (!field.names.empty()) {
      return quoted(field.names[static_cast<std::size_t>(value)]);
    }
    return std::to_string(value);
  }

  void print_readings() {
    const std::uint8_t mask = data_[0];
    print_numbers(sensor_mask());
    std::vector<std::string> items;
    for (int sensor = 0; sensor < 8; ++sensor) {
      if ((mask >> sensor & 1) == 0) continue;
      const long long value = take(2, false);
      check_reading(sensor, value, indexed("readings", items.size()));
      items.push_back(std::to_string(value));
    }
    add("readings", list(items));
  }

  void check_reading(int sensor, long long value, const std::string& name) {
    if (sensor <= 4) {
      if (value > 0x3FF) violations_.push_back({name, value, "0..1023"});
    } else if (sensor == 5) {
      if (value > 0x7594 && value != 0xFFFF) violations_.push_back({name, value, "0..30100|65535"});
    } else {
      violations_.push_back({name, value, "no such sensor"});
    }
  }

  void print_error() {
    add("code", std::to_string(data_[0]));
    if (data_[0] != 0) return;
    add("rejected", quoted(hex_text(data_.subspan(1, data_.size() - 2))));
    add("expected_crc", std::to_string(data_.back()));
  }

  bytes_view packet_;
  bytes_view data_;
  std::size_t at_ = 0;
  std::vector<std::string> fields_ = {};
  std::vector<violation> violations_ = {};
};

std::string error_line(const daisy_event& event, bytes_view span) {
  std::string line = concat({line_head(event.offset, event.length), next_member("error", quoted(event.error))});
  if (event.error != "noise") line += bytes_member(span);
  if (event.error == "bad_checksum") {
    line += next_member("expected", event.expected);
    line += next_member("received", event.received);
  }
  return line + "}";
}

}  // namespace

std::vector<std::string> daisy_lines(bytes_view stream, std::span<const std::size_t> idle_at) {
  std::vector<std::string> lines;
  for (const daisy_event& event : daisy_events(stream, idle_at)) {
    const bytes_view span = stream.subspan(event.offset, event.length);
    if (!event.error.empty()) {
      lines.push_back(error_line(event, span));
      continue;
    }
    packet_printer printer(span);
    const message_form* message = find_message(span[1], span[2], span[3]);
    lines.push_back(message != nullptr ? printer.print(event.offset, *message) : printer.print_unknown(event.offset));
  }
  return lines;
}

std::vector<std::string> daisy_lines(bytes_view stream) { return daisy_lines(stream, {}); }

}  // namespace trama_reference
