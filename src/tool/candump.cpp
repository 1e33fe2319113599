#include "tool/candump.hpp"

#include <algorithm>

#include "tool/hex.hpp"

namespace trama::tool {

namespace {

constexpr std::uint32_t error_flag = 0x20000000;  // as SocketCAN marks error frames

bool is_space(char c) noexcept { return c == ' ' || c == '\t'; }

/// The next word, taken from the front of `line`.
std::string_view word(std::string_view& line) noexcept {
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    const auto end = std::find_if(line.begin(), line.end(), is_space);
    const std::string_view found = line.substr(0, static_cast<std::size_t>(end - line.begin()));
    line.remove_prefix(found.size());
    return found;
}

bool parse_id(std::string_view digits, can::frame& f) noexcept {
    if (digits.size() != 3 && digits.size() != 8) return false;
    for (const char c : digits) {
        const int value = hex_value(c);
        if (value < 0) return false;
        f.id = f.id << 4 | static_cast<std::uint32_t>(value);
    }
    f.extended = digits.size() == 8;
    f.error = f.extended && (f.id & error_flag) != 0;
    return f.extended || f.id < 0x800;
}

/// Pairs of hex digits; at most `most` bytes, of which the first 8 are kept.
bool parse_data(std::string_view text, std::size_t most, can::frame& f) noexcept {
    std::size_t count = 0;
    while (!text.empty()) {
        if (text.size() < 2 || count == most) return false;
        const int high = hex_value(text[0]), low = hex_value(text[1]);
        if (high < 0 || low < 0) return false;
        if (count < f.data.size()) f.data[count] = static_cast<std::uint8_t>(high << 4 | low);
        ++count;
        text.remove_prefix(2);
    }
    f.length = static_cast<std::uint8_t>(std::min<std::size_t>(count, f.data.size()));
    return true;
}

bool parse_payload(std::string_view text, can::frame& f) noexcept {
    if (!text.empty() && text.front() == '#') {
        f.fd = true;
        return text.size() >= 2 && hex_value(text[1]) >= 0 && parse_data(text.substr(2), 64, f);
    }
    // Behind a length of 8 may stand the DLC itself, one of 9..15, which mean 8 as well.
    const std::size_t mark = text.find('_');
    const bool raw = mark != text.npos;
    if (raw && (mark + 2 != text.size() || hex_value(text[mark + 1]) < 9)) return false;
    text = text.substr(0, mark);
    if (!text.empty() && text.front() == 'R') {
        f.remote = true;
        if (text.size() == 1) return !raw;
        return text.size() == 2 && (text[1] == '8' || (!raw && text[1] >= '0' && text[1] < '8'));
    }
    return parse_data(text, 8, f) && (!raw || f.length == 8);
}

}  // namespace

std::optional<std::uint64_t> parse_seconds(std::string_view text) noexcept {
    std::uint64_t seconds = 0, fraction = 0, unit = per_second;
    const auto digit = [&] { return !text.empty() && text.front() >= '0' && text.front() <= '9'; };
    const auto take = [&] { const auto d = static_cast<std::uint64_t>(text.front() - '0'); text.remove_prefix(1); return d; };
    if (!digit()) return std::nullopt;
    while (digit())
        if (seconds = seconds * 10 + take(); seconds > most_seconds) return std::nullopt;
    if (!text.empty() && text.front() == '.') {
        text.remove_prefix(1);
        if (!digit()) return std::nullopt;
        while (digit()) fraction += take() * (unit /= 10);
    }
    if (!text.empty()) return std::nullopt;
    return seconds * per_second + fraction;
}

std::optional<can::frame> parse_candump(std::string_view line) noexcept {
    if (line.ends_with('\r')) line.remove_suffix(1);
    const std::string_view stamp = word(line), interface = word(line), content = word(line), direction = word(line);
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    const bool known_direction = direction.empty() || direction == "R" || direction == "T";
    if (!line.empty() || interface.empty() || !known_direction) return std::nullopt;
    if (stamp.size() < 3 || stamp.front() != '(' || stamp.back() != ')' || stamp.find('.') == stamp.npos) return std::nullopt;
    const auto time = parse_seconds(stamp.substr(1, stamp.size() - 2));
    const std::size_t hash = content.find('#');
    can::frame f{};
    if (!time || hash == content.npos || !parse_id(content.substr(0, hash), f) || !parse_payload(content.substr(hash + 1), f)) return std::nullopt;
    f.time = *time;
    return f;
}

void print_candump(text_sink& out, const can::frame& f) noexcept {
    constexpr std::string_view digits = "0123456789ABCDEF";
    out << "(0.000000) can0 ";
    for (int shift = 8; shift >= 0; shift -= 4) out << digits[f.id >> shift & 15];
    out << '#';
    for (std::size_t i = 0; i != f.length; ++i) out << digits[f.data[i] >> 4] << digits[f.data[i] & 15];
    out << '\n';
}

}  // namespace trama::tool
