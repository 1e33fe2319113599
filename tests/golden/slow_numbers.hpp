#pragma once
/// Numbers in columns, read the slow and obvious way, from the written rules alone. [gateway; D15, D16]

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trama::golden {

inline std::string without_outer_spaces(std::string_view s) {
    while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
    while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
    return std::string(s);
}
inline bool digits_only(std::string_view s) {
    for (const char c : s)
        if (c < '0' || c > '9') return false;
    return !s.empty();
}

/// Digits with spaces on either side; blank is 0; nothing else is a number.
inline std::optional<std::int64_t> slow_number(std::string_view columns) {
    const std::string s = without_outer_spaces(columns);
    if (s.empty()) return 0;
    if (!digits_only(s)) return std::nullopt;
    return std::stoll(s);
}
/// As `slow_number`, with one '-' directly before the digits allowed.
inline std::optional<std::int64_t> slow_signed(std::string_view columns) {
    const std::string s = without_outer_spaces(columns);
    if (s.empty() || s[0] != '-') return slow_number(columns);
    if (!digits_only(s.substr(1))) return std::nullopt;
    return -std::stoll(s.substr(1));
}
/// Up to three digits, then nothing or a point and one digit; in tenths.
inline std::optional<std::int64_t> slow_tenths(std::string_view columns) {
    const std::string s = without_outer_spaces(columns);
    if (s.empty()) return 0;
    const std::size_t point = s.find('.');
    const std::string whole = s.substr(0, point);
    if (!digits_only(whole) || whole.size() > 3) return std::nullopt;
    if (point == std::string::npos) return std::stoll(whole) * 10;
    const std::string tenth = s.substr(point + 1);
    if (!digits_only(tenth) || tenth.size() != 1) return std::nullopt;
    return std::stoll(whole) * 10 + std::stoll(tenth);
}

/// One field of a shape: `n` number, `s` signed number, `d` decimal xxx.x, `t` text.
inline std::optional<std::int64_t> slow_field(char kind, std::string_view columns) {
    return kind == 's' ? slow_signed(columns) : kind == 'd' ? slow_tenths(columns) : slow_number(columns);
}

}  // namespace trama::golden
