#pragma once
// Mutations for `text`: lines come, go, double and change places, and in a line of JSON or of a log one part becomes something else.
#include "edit.hpp"
#include "json_members.hpp"
#include "text.hpp"
#include "tool/candump.hpp"

namespace trama::fuzz {

using strings = std::vector<std::string>;

inline strings lines_in(std::string_view text) {
    strings lines;
    while (!text.empty()) {
        lines.emplace_back(text.substr(0, text.find('\n')));
        text.remove_prefix(std::min(text.size(), lines.back().size() + 1));
    }
    return lines;
}
inline std::string text_of(const strings& lines) {
    std::string text;
    for (const auto& line : lines) text += line + "\n";
    return text;
}

/// A line of JSON for some message; now and then with a value that the document does not allow.
template <wire_format F>
std::string random_line(dice& d) {
    std::string line;
    const octets wire = random_wire<F>(d);
    const auto units = traits<F>::units_from(wire);
    typename F::decoder decoder;
    read<F>(decoder, units, [&](const typename F::event& e) { line = line_of<F>(e); });
    return line;
}

/// Numbers at the edges of what JSON and the formats can hold.
inline constexpr std::string_view odd_numbers[] = {"0", "-0", "-1", "1.0", "1e2", "1E+1", "0.05", "127", "128", "255", "256", "32767", "-32768", "32768", "65535", "65536",
    "2147483647", "-2147483649", "4294967296", "9223372036854775807", "-9223372036854775808", "18446744073709551616", "00", "01", "1.", ".5", "48.2", "48.25", "99999", "100000", "null", "true", "\"1\"", "[]", "{}"};

/// The number at some place, or the next one behind it, becomes an odd one; false when there is none.
inline bool change_number(std::string& line, dice& d) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto from = std::find_if(line.begin() + static_cast<std::ptrdiff_t>(d.below(line.size() + 1)), line.end(), is_digit);
    if (from == line.end()) return false;
    line.replace(from, std::find_if_not(from, line.end(), is_digit), odd_numbers[d.below(std::size(odd_numbers))]);
    return true;
}

/// One member of a line goes, doubles, gets another name or another's value; names and values come from `other`, a line of the schema.
inline void change_member(std::string& line, const std::string& other, dice& d) {
    const auto members = members_of(line), more = members_of(other);
    if (members.empty() || more.empty()) return;
    const member m = members[d.below(members.size())], n = more[d.below(more.size())];
    const std::string key(m.key_in(line)), value(m.value_in(line));
    switch (d.below(6)) {
        case 0: {
            const bool comma = m.end < line.size() && line[m.end] == ',', before = !comma && m.begin != 0 && line[m.begin - 1] == ',';
            line.erase(m.begin - before, m.end - m.begin + before + comma);
            break;
        }
        case 1: line.insert(m.end, "," + key + ":" + (d.one_in(2) ? value : std::string(n.value_in(other)))); break;
        case 2: line.insert(m.begin, std::string(n.key_in(other)) + ":" + std::string(n.value_in(other)) + ","); break;
        case 3: line.replace(m.begin, key.size(), n.key_in(other)); break;
        case 4: line[m.begin + d.below(key.size())] = static_cast<char>(d.one_in(4) ? '"' : random_character(d)); break;
        default: {
            const auto same = std::find_if(more.begin(), more.end(), [&](const member& x) { return x.key_in(other) == key; });
            line.replace(m.value, value.size(), same != more.end() && d.one_in(2) ? same->value_in(other) : n.value_in(other));
        }
    }
}

/// Lines of a log for the frames of some message: behind `now`, in microseconds, with gaps around the tool's time-out, now and then with frames altered.
inline strings random_log(dice& d, std::uint64_t now) {
    using F = can::format;
    octets wire = random_wire<F>(d);
    if (d.one_in(3)) shuffle_units<F>(wire, d);
    strings lines;
    for (auto f : traits<F>::units_from(wire)) {
        constexpr std::uint64_t second = 1'000'000;
        const std::uint64_t gaps[] = {0, 1, second / 100, second - 1, second, second + 1, 2 * second};
        f.time = now += gaps[d.one_in(2) ? 2 : d.below(std::size(gaps))];
        f.length = std::min<std::uint8_t>(f.length, 8);
        lines.push_back(traits<F>::log_line(f));
    }
    return lines;
}

/// One word of a log's line, or a character, becomes something else.
inline void change_log_line(std::string& line, dice& d) {
    constexpr std::string_view odd[] = {"(", ")", "(0)", "(0.0)", "(1.)", "(.5)", "(1.0000000001)", "(18000000000.0)", "(18446744073.709551616)", "can0", "vcan1", " ", "  ", "\t", "080#", "081#", "082#", "083#",
        "00000081#", "20000081#", "800#", "81#", "#", "##", "##0", "#R", "#R8", "#R9", "_9", "_F", "_8", "0", "00", "0102030405060708", "F", "g"};
    const std::size_t at = d.below(line.size() + 1);
    const std::size_t end = d.one_in(2) ? at : std::min(line.size(), line.find_first_of(" #", at + (at != line.size())));
    line.replace(at, end - at, d.one_in(4) ? std::string_view{} : odd[d.below(std::size(odd))]);
}

/// New lines for the place behind `before`: of a log or of JSON, as the input is.
template <wire_format F>
strings new_lines(bool log, const std::string& before, dice& d) {
    if constexpr (std::is_same_v<F, can::format>) {
        if (log) {
            const auto last = tool::parse_candump(before);
            return random_log(d, last ? last->time / 1000 : d.below(3) * 1'000'000);
        }
    }
    return {random_line<F>(d)};
}

template <wire_format F>
void change_line(std::string& line, dice& d) {
    if (std::is_same_v<F, can::format> && line.starts_with('(')) change_log_line(line, d);
    else if (!d.one_in(3) || !change_number(line, d)) change_member(line, random_line<F>(d), d);
}

template <wire_format F>
std::size_t mutate_text(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
    dice d(seed);
    if (plain_octets() || d.one_in(3)) return LLVMFuzzerMutate(data, size, max_size);
    const std::string input(data, data + size);
    strings lines = d.one_in(16) ? strings{} : lines_in(input);
    const bool log = std::is_same_v<F, can::format> && (lines.empty() ? d.one_in(2) : input.starts_with('('));
    const std::size_t at = d.below(lines.size() + 1), action = at == lines.size() ? 0 : d.below(12);
    const auto place = lines.begin() + static_cast<std::ptrdiff_t>(at);
    if (action < 2) {
        const strings more = new_lines<F>(log, at == 0 ? "" : lines[at - 1], d);
        lines.insert(place, more.begin(), more.end());
    } else if (action == 2) {
        lines.erase(place);
    } else if (action == 3) {
        lines.insert(place, std::string(*place));
    } else if (action == 4) {
        std::swap(*place, lines[d.below(lines.size())]);
    } else {
        change_line<F>(*place, d);
    }
    const std::string text = text_of(lines);
    return hand_over(octets(text.begin(), text.end()), data, max_size);
}

/// The first lines of one input and the last of another, or a line of one with members of the other's.
inline std::size_t cross_text(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::uint8_t* out, std::size_t max_size, unsigned seed) {
    dice d(seed);
    if (plain_octets()) {
        octets spliced(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(d.below(a.size() + 1)));
        spliced.insert(spliced.end(), b.begin() + static_cast<std::ptrdiff_t>(d.below(b.size() + 1)), b.end());
        return hand_over(spliced, out, max_size);
    }
    strings front = lines_in({reinterpret_cast<const char*>(a.data()), a.size()});
    const strings back = lines_in({reinterpret_cast<const char*>(b.data()), b.size()});
    if (!front.empty() && !back.empty() && d.one_in(2)) {
        change_member(front[d.below(front.size())], back[d.below(back.size())], d);
    } else {
        front.resize(d.below(front.size() + 1));
        front.insert(front.end(), back.begin() + static_cast<std::ptrdiff_t>(d.below(back.size() + 1)), back.end());
    }
    const std::string text = text_of(front);
    return hand_over(octets(text.begin(), text.end()), out, max_size);
}

}  // namespace trama::fuzz
