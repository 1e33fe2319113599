#pragma once
// JSON in and out. The input is text: lines of JSON for `trama encode`, and for can also lines of a candump log.
#include "lines.hpp"

namespace trama::fuzz {

/// Units that `encode` made of a line, printed by `decode` and encoded again, are the same units.
template <wire_format F>
void check_there_and_back(std::string_view line) {
    const auto made = tool::encode_line<F>(line, true);
    if (!made.error.empty()) return;
    typename F::decoder decoder;
    std::size_t packets = 0;
    read<F>(decoder, made.units, [&](const typename F::event& e) {
        ++packets;
        if (e.code != errc::ok || e.length != made.units.size()) return;  // a text of noise, in daisy, need not bring a decoder into step
        const auto again = tool::encode_line<F>(line_of<F>(e), true);
        require(again.error.empty(), "encode reads what decode prints");
        require(again.units == made.units, "what encode made comes back from decode and encode");
    });
    // In can, an identifier that nobody follows is foreign.
    if constexpr (!std::is_same_v<F, daisy::format>) require(packets == 1 || decoder.counters().foreign == made.units.size(), "what encode made is one packet");
}

template <wire_format F>
int text(std::span<const std::uint8_t> input) {
    const exact<char> copy(std::span<const char>(reinterpret_cast<const char*>(input.data()), input.size()));
    std::string_view all(copy.all().data(), copy.all().size());
    if constexpr (std::is_same_v<F, can::format>) {
        if (all.starts_with('(')) {
            require_same(library_can_lines(all, tool::per_second), trama_reference::can_lines(all, 1.0), "library and reference say the same about a log");
            return 0;
        }
    }
    for (int lines = 0; !all.empty() && lines != 8; ++lines) {
        const std::string_view line = all.substr(0, all.find('\n'));
        all.remove_prefix(std::min(all.size(), line.size() + 1));
        check_encoders<F>(line);
        check_there_and_back<F>(line);
    }
    return 0;
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

template <wire_format F>
std::size_t mutate_text(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
    dice d(seed);
    if (plain_octets() || d.one_in(3)) return LLVMFuzzerMutate(data, size, max_size);
    std::string input(data, data + size);
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::size_t digit = static_cast<std::size_t>(std::find_if(input.begin() + static_cast<std::ptrdiff_t>(d.below(size + 1)), input.end(), is_digit) - input.begin());
    if (digit != size && d.one_in(2)) {
        std::size_t end = digit;
        while (end != size && is_digit(input[end])) ++end;
        input.replace(digit, end - digit, odd_numbers[d.below(std::size(odd_numbers))]);
    } else if (d.one_in(2)) {
        input = random_line<F>(d);
    } else {
        input.insert(0, random_line<F>(d) + "\n");
    }
    input.resize(std::min(input.size(), max_size));
    std::copy(input.begin(), input.end(), data);
    return input.size();
}

}  // namespace trama::fuzz
