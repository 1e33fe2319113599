#include <algorithm>

#include "gateway_table.hpp"
#include "json_value.hpp"
#include "reference.hpp"

namespace trama_reference {

namespace {

using kind = json_value::kind;

/// Right-justified; refuses what does not fit.
std::string right(const std::string& characters, std::size_t width) {
  if (characters.size() > width) throw refused("does not fit its field");
  return std::string(width - characters.size(), ' ') + characters;
}

long long largest(std::size_t width) { return std::stoll(std::string(width, '9')); }

std::string default_characters(const gateway_field& field) {
  if (field.kind == content::text) return std::string(field.width, ' ');
  return right(field.kind == content::tenths ? "0.0" : "0", field.width);
}

std::string text_characters(const gateway_field& field, const json_value& given) {
  const std::string text = string(given);
  const bool printable = std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c <= 0x7E; });
  if (!printable) throw refused("text outside printable ASCII");
  if (text.size() > field.width) throw refused("text too long");
  return text + std::string(field.width - text.size(), ' ');
}

/// 48.2 and 48 as "48.2" and "48.0"; at most three digits before the point and one behind it.
std::string tenths_characters(const gateway_field& field, const json_value& given) {
  std::string number = plain_number(given);
  if (number[0] == '-') throw refused("a decimal expected");
  if (number.find('.') == std::string::npos) number += ".0";
  if (number.find('.') > 3 || number.size() != number.find('.') + 2) throw refused("decimal out of range");
  return right(number, field.width);
}

long long bit_value(const gateway_field& field, const json_value& item) {
  if (item.type != kind::string) return integer(item, 0, largest(field.width));
  const std::string name = string(item);
  for (std::size_t bit = 0; bit < field.names.size(); ++bit) {
    if (field.names[bit] == name) return 1LL << bit;
  }
  throw refused("unknown bit " + name);
}

long long bits_value(const gateway_field& field, const json_value& given) {
  if (given.type != kind::array) return integer(given, 0, largest(field.width));
  long long value = 0;
  for (const json_value& item : given.items) value |= bit_value(field, item);
  return value;
}

long long order_type_value(const json_value& given, long long highest) {
  if (given.type != kind::string) return integer(given, 0, highest);
  const std::string name = string(given);
  for (long long type = 0; type <= highest; ++type) {
    if (!name.empty() && order_type_name(type) == name) return type;
  }
  throw refused("unknown order type " + name);
}

long long named_value(const gateway_field& field, const json_value& given) {
  if (given.type != kind::string) return integer(given, 0, largest(field.width));
  const auto found = std::find(field.names.begin(), field.names.end(), string(given));
  if (found == field.names.end()) throw refused("unknown name");
  return found - field.names.begin();
}

bool allowed(const gateway_field& field, long long value) {
  const std::vector<int>& types = field.allowed_types;
  if (field.kind == content::named) return value < static_cast<long long>(field.names.size());
  if (field.kind == content::order_type) return std::find(types.begin(), types.end(), value) != types.end();
  if (field.kind == content::number && field.low <= field.high) return value >= field.low && value <= field.high;
  return true;
}

long long number_value(const gateway_field& field, const json_value& given) {
  const long long highest = largest(field.width);
  switch (field.kind) {
    case content::bits: return bits_value(field, given);
    case content::order_type: return order_type_value(given, highest);
    case content::named: return named_value(field, given);
    case content::signed_number: return integer(given, -(highest / 10), highest);
    default: return integer(given, 0, highest);
  }
}

std::string field_characters(const gateway_field& field, const json_value& object, bool unchecked) {
  const json_value* given = object.find(field.name);
  if (field.kind == content::text && given != nullptr) return text_characters(field, *given);
  if (field.kind == content::tenths && given != nullptr) return tenths_characters(field, *given);
  if (field.kind == content::text || field.kind == content::tenths) return default_characters(field);
  const long long value = given == nullptr ? 0 : number_value(field, *given);
  if (!unchecked && !allowed(field, value)) throw refused("violation of " + field.name);
  return right(std::to_string(value), field.width);
}

std::string fields_characters(const std::vector<gateway_field>& fields, const json_value& object, bool unchecked) {
  std::string characters;
  for (const gateway_field& field : fields) characters += field_characters(field, object, unchecked);
  return characters;
}

std::vector<std::string> names_of(const std::vector<gateway_field>& fields) {
  std::vector<std::string> names;
  for (const gateway_field& field : fields) names.push_back(field.name);
  return names;
}

json_value empty_object() {
  json_value object;
  object.type = kind::object;
  return object;
}

std::string payload(const gateway_message& message, const json_value& fields, bool unchecked) {
  std::vector<std::string> names = names_of(message.fields);
  if (message.orders > 0) names.push_back("orders");
  expect_members(fields, names);
  std::string characters = right(std::to_string(message.type), 3);
  characters += fields_characters(message.fields, fields, unchecked);

  std::vector<json_value> orders(message.orders, empty_object());
  const json_value* given = fields.find("orders");
  if (given != nullptr) orders = array(*given, message.orders);
  for (const json_value& order : orders) {
    expect_members(order, names_of(transit_order_fields()));
    characters += fields_characters(transit_order_fields(), order, unchecked);
  }
  return characters;
}

octets encode(std::string_view text, bool unchecked) {
  const json_value line = parse_line(text, "gateway", {});
  const std::string name = string(*line.find("message"));
  for (const gateway_message& message : gateway_messages()) {
    if (message.name != name) continue;
    const json_value* fields = line.find("fields");
    const std::string characters = payload(message, fields == nullptr ? empty_object() : *fields, unchecked);
    const std::string record = "\x02" + characters + "\x03";
    return {record.begin(), record.end()};
  }
  throw refused("unknown message");
}

}  // namespace

std::optional<std::vector<std::uint8_t>> gateway_encode(std::string_view json_line, bool unchecked) {
  try {
    return encode(json_line, unchecked);
  } catch (const refused&) {
    return std::nullopt;
  }
}

}  // namespace trama_reference
