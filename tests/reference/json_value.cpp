#include "json_value.hpp"

#include <algorithm>
#include <cstdint>

namespace trama_reference {

namespace {

constexpr int deepest = 16;

class parser {
 public:
  explicit parser(std::string_view text) : text_(text) {}

  json_value whole() {
    json_value result = value(0);
    skip_space();
    if (at_ != text_.size()) throw refused("text after the value");
    return result;
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  void skip_space() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) ++at_;
  }

  bool take(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  void need(std::string_view word) {
    skip_space();
    if (!take(word)) throw refused("expected " + std::string(word));
  }

  json_value value(int depth) {
    if (depth > deepest) throw refused("nested too deeply");
    skip_space();
    json_value result;
    if (peek() == '{') return object(depth);
    if (peek() == '[') return list(depth);
    if (peek() == '"') {
      result.type = json_value::kind::string;
      result.characters = characters();
    } else if (take("true") || take("false")) {
      result.type = json_value::kind::boolean;
    } else if (!take("null")) {
      result.type = json_value::kind::number;
      result.number_text = number();
    }
    return result;
  }

  json_value object(int depth) {
    json_value result;
    result.type = json_value::kind::object;
    need("{");
    skip_space();
    if (take("}")) return result;
    do {
      skip_space();
      const std::u32string name = characters();
      need(":");
      if (std::find(result.names.begin(), result.names.end(), name) != result.names.end()) throw refused("member given twice");
      result.names.push_back(name);
      result.items.push_back(value(depth + 1));
      skip_space();
    } while (take(","));
    need("}");
    return result;
  }

  json_value list(int depth) {
    json_value result;
    result.type = json_value::kind::array;
    need("[");
    skip_space();
    if (take("]")) return result;
    do {
      result.items.push_back(value(depth + 1));
      skip_space();
    } while (take(","));
    need("]");
    return result;
  }

  std::string digits() {
    const std::size_t start = at_;
    while (peek() >= '0' && peek() <= '9') ++at_;
    if (at_ == start) throw refused("digits expected");
    return std::string(text_.substr(start, at_ - start));
  }

  std::string number() {
    const std::size_t start = at_;
    take("-");
    const std::string whole_part = digits();
    if (whole_part.size() > 1 && whole_part[0] == '0') throw refused("leading zero");
    if (take(".")) digits();
    if (take("e") || take("E")) {
      if (!take("+")) take("-");
      digits();
    }
    return std::string(text_.substr(start, at_ - start));
  }

  std::u32string characters() {
    need("\"");
    std::u32string result;
    while (peek() != '"') result.push_back(take("\\") ? escaped() : plain());
    take("\"");
    return result;
  }

  // UTF-8 as RFC 3629 has it: nothing overlong, no surrogates, at most U+10FFFF.
  char32_t plain() {
    const std::uint32_t first = octet();
    if (first < 0x20) throw refused("control character in a string");
    if (first < 0x80) return first;
    if (first >= 0xC2 && first <= 0xDF) return (first - 0xC0) * 64 + continuation();
    if (first >= 0xE0 && first <= 0xEF) {
      std::uint32_t code = (first - 0xE0) * 64 + continuation();
      code = code * 64 + continuation();
      if (code < 0x800 || is_surrogate(code)) throw refused("broken UTF-8");
      return code;
    }
    if (first < 0xF0 || first > 0xF4) throw refused("broken UTF-8");
    std::uint32_t code = (first - 0xF0) * 64 + continuation();
    code = code * 64 + continuation();
    code = code * 64 + continuation();
    if (code < 0x10000 || code > 0x10FFFF) throw refused("broken UTF-8");
    return code;
  }

  std::uint32_t octet() {
    if (at_ >= text_.size()) throw refused("string not closed");
    return static_cast<std::uint8_t>(text_[at_++]);
  }

  std::uint32_t continuation() {
    const std::uint32_t value = octet();
    if (value < 0x80 || value > 0xBF) throw refused("broken UTF-8");
    return value - 0x80;
  }

  static bool is_surrogate(std::uint32_t code) { return code >= 0xD800 && code <= 0xDFFF; }

  char32_t escaped() {
    const char letter = peek();
    ++at_;
    switch (letter) {
      case '"': case '\\': case '/': return static_cast<char32_t>(letter);
      case 'b': return 0x08;
      case 'f': return 0x0C;
      case 'n': return 0x0A;
      case 'r': return 0x0D;
      case 't': return 0x09;
      case 'u': break;
      default: throw refused("unknown escape");
    }
    const std::uint32_t code = hex_number();
    // Two escapes that are the halves of one character; a half alone stands for itself.
    if (code >= 0xD800 && code <= 0xDBFF && take("\\u")) {
      const std::uint32_t second = hex_number();
      if (second >= 0xDC00 && second <= 0xDFFF) return 0x10000 + (code - 0xD800) * 0x400 + (second - 0xDC00);
      at_ -= 6;
    }
    return code;
  }

  std::uint32_t hex_number() {
    std::uint32_t code = 0;
    for (int i = 0; i < 4; ++i, ++at_) code = code * 16 + hex_digit(peek());
    return code;
  }

  static std::uint32_t hex_digit(char digit) {
    if (digit >= '0' && digit <= '9') return static_cast<std::uint32_t>(digit - '0');
    if (digit >= 'a' && digit <= 'f') return static_cast<std::uint32_t>(digit - 'a' + 10);
    if (digit >= 'A' && digit <= 'F') return static_cast<std::uint32_t>(digit - 'A' + 10);
    throw refused("hex digit expected");
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

bool same(const std::u32string& characters, std::string_view ascii) {
  return std::equal(characters.begin(), characters.end(), ascii.begin(), ascii.end());
}

bool contains(const std::vector<std::string>& names, const std::u32string& name) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& each) { return same(name, each); });
}

}  // namespace

const json_value* json_value::find(std::string_view name) const {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (same(names[i], name)) return &items[i];
  }
  return nullptr;
}

json_value parse_json(std::string_view line) { return parser(line).whole(); }

std::string plain_number(const json_value& value) {
  if (value.type != json_value::kind::number) throw refused("a number expected");
  std::string text = value.number_text;
  const bool negative = text[0] == '-';
  if (negative) text.erase(0, 1);
  long exponent = 0;
  const std::size_t e = text.find_first_of("eE");
  if (e != std::string::npos) {
    std::string written = text.substr(e + 1);
    const bool shrinks = written[0] == '-';
    written.erase(0, std::min(written.find_first_of("123456789"), written.size()));
    exponent = written.empty() ? 0 : written.size() > 6 ? 1000000 : std::stol(written);
    if (shrinks) exponent = -exponent;
    text.resize(e);
  }
  const std::size_t point = text.find('.');
  std::string whole = text.substr(0, point);
  std::string fraction = point == std::string::npos ? "" : text.substr(point + 1);
  if ((whole + fraction).find_first_not_of('0') == std::string::npos) return "0";
  // Beyond these no digit of the text is left near the point.
  if (exponent > static_cast<long>(fraction.size()) + 500 || exponent < -static_cast<long>(whole.size()) - 500) throw refused("number out of range");
  for (; exponent > 0; --exponent) {
    whole += fraction.empty() ? '0' : fraction[0];
    if (!fraction.empty()) fraction.erase(0, 1);
  }
  for (; exponent < 0; ++exponent) {
    fraction.insert(0, 1, whole.empty() ? '0' : whole.back());
    if (!whole.empty()) whole.pop_back();
  }
  while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
  while (!whole.empty() && whole.front() == '0') whole.erase(0, 1);
  std::string plain = negative ? "-" : "";
  plain += whole.empty() ? "0" : whole;
  if (!fraction.empty()) plain += '.';
  return plain += fraction;
}

long long integer(const json_value& value, long long low, long long high) {
  const std::string text = plain_number(value);
  if (text.find('.') != std::string::npos) throw refused("an integer expected");
  if (text.size() > 18) throw refused("number too large");
  const long long number = std::stoll(text);
  if (number < low || number > high) throw refused("number out of range");
  return number;
}

std::string string(const json_value& value) {
  if (value.type != json_value::kind::string) throw refused("a string expected");
  std::string bytes;
  for (const char32_t character : value.characters) {
    if (character > 0xFF) throw refused("a character that is no byte");
    bytes.push_back(static_cast<char>(character));
  }
  return bytes;
}

const std::vector<json_value>& array(const json_value& value, std::size_t size) {
  if (value.type != json_value::kind::array) throw refused("an array expected");
  if (value.items.size() != size) throw refused("an array of the wrong length");
  return value.items;
}

void expect_members(const json_value& object, const std::vector<std::string>& known,
                    const std::vector<std::string>& ignored) {
  if (object.type != json_value::kind::object) throw refused("an object expected");
  for (const std::u32string& name : object.names) {
    if (!contains(known, name) && !contains(ignored, name)) throw refused("unknown field");
  }
}

json_value parse_line(std::string_view line, std::string_view protocol, std::vector<std::string> own) {
  json_value object = parse_json(line);
  own.insert(own.end(), {"protocol", "message", "fields"});
  expect_members(object, own, {"offset", "length", "line", "frames", "violations"});
  const json_value* given = object.find("protocol");
  if (given != nullptr && string(*given) != protocol) throw refused("another protocol");
  if (object.find("message") == nullptr) throw refused("no message");
  return object;
}

}  // namespace trama_reference
