#include "tool/from_json.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "tool/lines.hpp"

namespace trama::tool {

namespace {

/// More digits than a line has.
constexpr int far = 1'000'000;
static_assert(line_reader::longest < far / 2);

/// The number that `text`, a JSON number, is after moving its point by `shift` digits: nothing if that is no whole
/// number; what does not fit becomes the largest or smallest there is.
std::optional<std::int64_t> shifted_number(std::string_view text, int shift) {
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    const bool negative = text.starts_with('-');
    std::string digits;
    int exponent = 0;
    const std::size_t power = text.find_first_of("eE"), point = text.find('.');
    if (power != text.npos) {
        const std::string_view written = text.substr(power + (text[power + 1] == '+' ? 2 : 1));
        if (std::from_chars(written.data(), written.data() + written.size(), exponent).ec != std::errc{}) exponent = written.front() == '-' ? -far : far;
    }
    for (const char c : text.substr(0, power))
        if (c >= '0' && c <= '9') digits += c;
    const std::size_t decimals = point == text.npos ? 0 : std::min(power, text.size()) - point - 1;
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
    if (digits.empty()) return 0;
    int zeros = std::clamp(exponent, -far, far) + shift - static_cast<int>(decimals);
    for (; zeros < 0; ++zeros) {
        if (digits.empty() || digits.back() != '0') return std::nullopt;
        digits.pop_back();
    }
    if (digits.size() + static_cast<std::size_t>(zeros) > 18) return negative ? -most : most;
    digits.append(static_cast<std::size_t>(zeros), '0');
    std::int64_t n = 0;
    (void)std::from_chars(digits.data(), digits.data() + digits.size(), n);
    return negative ? -n : n;
}

/// The characters of valid UTF-8 as one byte each; false if one lies beyond U+00FF.
bool as_bytes(std::string_view text, std::vector<std::uint8_t>& out) {
    for (std::size_t i = 0; i != text.size(); ++i) {
        const auto c = static_cast<std::uint8_t>(text[i]);
        if (c > 0xC3) return false;
        out.push_back(c < 0x80 ? c : static_cast<std::uint8_t>(c << 6 | (static_cast<std::uint8_t>(text[++i]) & 0x3F)));
    }
    return true;
}

}  // namespace

std::optional<std::int64_t> whole_number(const json_value& v) {
    return v.type == json_value::kind::number ? shifted_number(v.text, 0) : std::nullopt;
}

std::optional<std::int64_t> number_in_tenths(const json_value& v) {
    return v.type == json_value::kind::number ? shifted_number(v.text, 1) : std::nullopt;
}

bool message_reader::fail(std::string_view what) {
    error_ = path_.empty() ? "fields" : path_;
    error_.append(": ").append(what);
    return false;
}

bool message_reader::fail_count(std::size_t needed, std::size_t given) {
    return fail(std::to_string(needed) + " values are needed, not " + std::to_string(given));
}

bool message_reader::fail_too_many(std::size_t most, std::size_t given) {
    return fail("at most " + std::to_string(most) + " values are possible, not " + std::to_string(given));
}

std::size_t message_reader::enter(std::string_view name) {
    const std::size_t before = path_.size();
    if (!path_.empty()) path_ += '.';
    path_ += name;
    return before;
}

std::size_t message_reader::enter(std::size_t index) {
    const std::size_t before = path_.size();
    path_.append("[").append(std::to_string(index)).append("]");
    return before;
}

bool message_reader::read_number(const json_value& v, wire::print printed, const rule& range, const rule& told, std::int64_t& out) {
    const bool tenths = printed == wire::print::tenths;
    const auto n = tenths ? number_in_tenths(v) : whole_number(v);
    if (!n) return fail(tenths ? "a number with at most one decimal is needed" : "a whole number is needed");
    if (!range.allows(*n)) {
        std::array<char, 1024> memory;
        text_sink allowed(memory);
        allowed.allowed(told);
        return fail(v.text + " is not allowed (" + std::string{allowed.view()} + ")");
    }
    out = *n;
    return true;
}

bool message_reader::read_name(const json_value& v, std::span<const std::string_view> names, std::size_t& out) {
    if (v.type != json_value::kind::string) return fail("a name or a number is needed");
    for (out = 0; out != names.size(); ++out)
        if (v.text == names[out]) return true;
    return fail("there is no value called " + v.text);
}

bool message_reader::check_text(const json_value& v, std::size_t columns) {
    if (v.type != json_value::kind::string) return fail("a string is needed");
    const bool printable = std::all_of(v.text.begin(), v.text.end(), [](char c) { return c >= 0x20 && c <= 0x7E; });
    if (!printable) return fail("only printable ASCII is possible");
    return v.text.size() <= columns || fail("at most " + std::to_string(columns) + " characters fit");
}

bool message_reader::read_bytes(const json_value& v, wire::print printed, byte_view& out) {
    if (v.type != json_value::kind::string) return fail("a string is needed");
    std::vector<std::uint8_t>& kept = bytes_.emplace_back();
    if (!as_bytes(v.text, kept)) return fail("a character does not fit a byte");
    if (printed == wire::print::hex && !from_hex(kept)) return fail("pairs of hex digits are needed");
    out = byte_view(std::span<const std::uint8_t>{kept});
    return true;
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
