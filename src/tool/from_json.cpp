#include "tool/from_json.hpp"

#include <charconv>

namespace trama::tool {

std::optional<std::int64_t> whole_number(const json_value& v) {
    std::int64_t n = 0;
    if (v.type != json_value::kind::number) return std::nullopt;
    const char* end = v.text.data() + v.text.size();
    const auto [rest, code] = std::from_chars(v.text.data(), end, n);
    if (rest != end || code != std::errc{}) return std::nullopt;
    return n;
}

std::optional<std::int64_t> number_in_tenths(const json_value& v) {
    if (v.type != json_value::kind::number) return std::nullopt;
    json_value shifted = v;
    const std::size_t point = v.text.find('.');
    if (point == v.text.npos) {
        shifted.text += '0';
    } else {
        if (point + 2 != v.text.size()) return std::nullopt;
        shifted.text.erase(point, 1);
    }
    return whole_number(shifted);
}

bool message_reader::from_hex(std::vector<std::uint8_t>& text) {
    if (text.size() % 2 != 0) return false;
    for (std::size_t i = 0; i != text.size(); i += 2) {
        const int high = hex_value(static_cast<char>(text[i])), low = hex_value(static_cast<char>(text[i + 1]));
        if (high < 0 || low < 0) return false;
        text[i / 2] = static_cast<std::uint8_t>(high << 4 | low);
    }
    text.resize(text.size() / 2);
    return true;
}

}  // namespace trama::tool
