#include <algorithm>
#include <optional>

#include "gateway_table.hpp"
#include "json_text.hpp"
#include "reference.hpp"

namespace trama_reference {

namespace {

using bytes_view = std::span<const std::uint8_t>;

constexpr std::uint8_t stx = 0x02;
constexpr std::uint8_t etx = 0x03;
constexpr std::size_t longest_payload = 206;

std::string line_head(std::size_t offset, std::size_t length) {
  return concat({"{", member("protocol", quoted("gateway")), next_member("offset", static_cast<long long>(offset)),
                 next_member("length", static_cast<long long>(length))});
}

/// `rest` is what follows the bytes, with its comma.
std::string error_line(std::size_t offset, bytes_view span, const std::string& code, const std::string& rest = "") {
  return concat({line_head(offset, span.size()), next_member("error", quoted(code)),
                 code == "noise" ? "" : bytes_member(span), rest, "}"});
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string without_spaces_around(const std::string& field) {
  const std::size_t first = field.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return field.substr(first, field.find_last_not_of(' ') - first + 1);
}

/// [D15] A field of spaces only gives 0.
std::optional<long long> read_number(const std::string& field) {
  const std::string digits = without_spaces_around(field);
  if (!std::all_of(digits.begin(), digits.end(), is_digit)) return std::nullopt;
  return digits.empty() ? 0 : std::stoll(digits);
}

/// [D16] A number that may have a minus before its first digit.
std::optional<long long> read_signed(const std::string& field) {
  const std::string number = without_spaces_around(field);
  if (number.empty() || number[0] != '-') return read_number(field);
  const std::string digits = number.substr(1);
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), is_digit)) return std::nullopt;
  return -std::stoll(digits);
}

/// Up to three digits, optionally a point and one digit; in tenths.
std::optional<long long> read_tenths(const std::string& field) {
  std::string number = without_spaces_around(field);
  if (number.empty()) return 0;
  if (number.find('.') == std::string::npos) number += ".0";
  const std::size_t point = number.find('.');
  const std::string digits = number.substr(0, point) + number.substr(point + 1);
  if (point < 1 || point > 3 || digits.size() != point + 1) return std::nullopt;
  if (!std::all_of(digits.begin(), digits.end(), is_digit)) return std::nullopt;
  return std::stoll(digits);
}

std::optional<long long> read_value(const gateway_field& field, const std::string& characters) {
  switch (field.kind) {
    case content::text: return 0;
    case content::signed_number: return read_signed(characters);
    case content::tenths: return read_tenths(characters);
    default: return read_number(characters);
  }
}

std::string bit_names(const gateway_field& field, long long value) {
  std::vector<std::string> items;
  for (std::size_t bit = 0; bit < 62; ++bit) {
    const long long worth = 1LL << bit;
    if ((value & worth) == 0) continue;
    items.push_back(bit < field.names.size() ? quoted(field.names[bit]) : std::to_string(worth));
  }
  return list(items);
}

std::string name_or_number(const std::string& name, long long value) {
  return name.empty() ? std::to_string(value) : quoted(name);
}

// The JSON fields and the violations of one payload; or the field that is no number.
class payload_printer {
 public:
  explicit payload_printer(const std::string& payload) : payload_(payload) {}

  void print(const gateway_message& message) {
    std::vector<std::string> members = print_fields(message.fields, "");
    std::vector<std::string> orders;
    for (std::size_t i = 0; i < message.orders; ++i) {
      orders.push_back(object(print_fields(transit_order_fields(), indexed("orders", i) + ".")));
    }
    if (!orders.empty()) members.push_back(member("orders", list(orders)));
    json_ = object(members);
  }

  const std::string& bad_number() const { return bad_number_; }
  std::string text() const { return concat({next_member("fields", json_), violations_member(violations_)}); }

 private:
  std::vector<std::string> print_fields(const std::vector<gateway_field>& fields, const std::string& prefix) {
    std::vector<std::string> members;
    for (const gateway_field& field : fields) {
      const std::string characters = payload_.substr(at_, field.width);
      at_ += field.width;
      const std::optional<long long> value = read_value(field, characters);
      if (!value && bad_number_.empty()) bad_number_ = prefix + field.name;
      if (!value) continue;
      check(field, prefix + field.name, *value);
      members.push_back(member(field.name, json(field, characters, *value)));
    }
    return members;
  }

  static std::string json(const gateway_field& field, const std::string& characters, long long value) {
    const auto index = static_cast<std::size_t>(value);
    switch (field.kind) {
      case content::text: return quoted(characters.substr(0, characters.find_last_not_of(' ') + 1));
      case content::tenths: return concat({std::to_string(value / 10), ".", std::to_string(value % 10)});
      case content::bits: return bit_names(field, value);
      case content::order_type: return name_or_number(order_type_name(value), value);
      case content::named: return name_or_number(index < field.names.size() ? field.names[index] : "", value);
      default: return std::to_string(value);
    }
  }

  void check(const gateway_field& field, const std::string& name, long long value) {
    const std::vector<int>& types = field.allowed_types;
    if (field.kind == content::named && value >= static_cast<long long>(field.names.size())) {
      violations_.push_back({name, value, joined(field.names, "|")});
    }
    if (field.kind == content::order_type && std::find(types.begin(), types.end(), value) == types.end()) {
      violations_.push_back({name, value, order_type_names(types)});
    }
    if (field.kind == content::number && field.low <= field.high && (value < field.low || value > field.high)) {
      violations_.push_back({name, value, range_text(field.low, field.high)});
    }
  }

  const std::string& payload_;
  std::size_t at_ = 0;
  std::string json_ = "";
  std::string bad_number_ = "";
  std::vector<violation> violations_ = {};
};

// A record that reached ETX with 0…206 printable characters.
std::string whole_record(std::size_t offset, bytes_view record) {
  const std::string payload(record.begin() + 1, record.end() - 1);
  if (payload.size() < 3) return error_line(offset, record, "bad_length");
  const std::string type_field = payload.substr(0, 3);
  const std::optional<long long> type = read_number(type_field);
  if (type_field == "   " || !type) {
    return error_line(offset, record, "bad_number", next_member("field", quoted("type")));
  }

  const auto& all = gateway_messages();
  const auto message = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.type == *type; });
  if (message == all.end()) {
    return error_line(offset, record, "unknown_message", next_member("type", *type));
  }
  if (payload.size() != message->payload()) return error_line(offset, record, "bad_length");

  const std::string body = payload.substr(3);
  payload_printer printer(body);
  printer.print(*message);
  if (!printer.bad_number().empty()) {
    return error_line(offset, record, "bad_number", next_member("field", quoted(printer.bad_number())));
  }
  const std::string name = next_member("message", quoted(message->name));
  return concat({line_head(offset, record.size()), name, printer.text(), "}"});
}

// The record whose STX is at `start`: its one line, and one past its end.
std::string record_line(bytes_view stream, std::size_t start, std::size_t& end) {
  bool bad_character = false;
  std::size_t characters = 0;
  std::size_t at = start + 1;
  for (; at < stream.size() && stream[at] != stx && stream[at] != etx; ++at) {
    if (stream[at] < 0x20 || stream[at] > 0x7E) bad_character = true;
    ++characters;
  }
  const bool whole = at < stream.size() && stream[at] == etx;
  end = whole ? at + 1 : at;
  const bytes_view span = stream.subspan(start, end - start);
  if (bad_character) return error_line(start, span, "bad_character");
  if (characters > longest_payload) return error_line(start, span, "bad_length");
  if (!whole) return error_line(start, span, "truncated");
  return whole_record(start, span);
}

}  // namespace

std::vector<std::string> gateway_lines(bytes_view stream) {
  std::vector<std::string> lines;
  std::size_t at = 0;
  while (at < stream.size()) {
    std::size_t end = at;
    if (stream[at] == stx) {
      lines.push_back(record_line(stream, at, end));
    } else {
      while (end < stream.size() && stream[end] != stx) ++end;
      lines.push_back(error_line(at, stream.subspan(at, end - at), "noise"));
    }
    at = end;
  }
  return lines;
}

}  // namespace trama_reference
