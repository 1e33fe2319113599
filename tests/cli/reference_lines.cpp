// The reference implementation as a program, for test_differential.py to compare the tool with.
//
//   reference_lines decode daisy|can|gateway [TIMEOUT]       standard input → the lines of trama decode
//   reference_lines encode daisy|can|gateway [unchecked]     JSON lines → hex pairs (can: log lines), or "refused"

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/reference.hpp"

namespace {

namespace reference = trama_reference;

constexpr std::string_view digits = "0123456789abcdef";

std::string all_input() { return {std::istreambuf_iterator<char>(std::cin), {}}; }

void print(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) std::cout << line << '\n';
}

void print(const std::optional<std::vector<std::uint8_t>>& packet) {
    if (!packet) std::cout << "refused";
    for (const std::uint8_t octet : packet.value_or(std::vector<std::uint8_t>{})) std::cout << digits[octet >> 4] << digits[octet & 15];
    std::cout << '\n';
}

void decode(std::string_view protocol, const std::string& input, double timeout) {
    const std::vector<std::uint8_t> bytes(input.begin(), input.end());
    if (protocol == "daisy") print(reference::daisy_lines(bytes));
    if (protocol == "gateway") print(reference::gateway_lines(bytes));
    if (protocol == "can") print(reference::can_lines(input, timeout));
}

void encode(std::string_view protocol, bool unchecked) {
    for (std::string line; std::getline(std::cin, line);) {
        if (protocol == "daisy") print(reference::daisy_encode(line, unchecked));
        if (protocol == "gateway") print(reference::gateway_encode(line, unchecked));
        if (protocol == "can") std::cout << reference::can_encode(line, unchecked).value_or("refused\n");
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 2) return 2;
    const std::string option = words.size() > 2 ? words[2] : "";
    if (words[0] == "decode") decode(words[1], all_input(), option.empty() ? 1.0 : std::strtod(option.c_str(), nullptr));
    if (words[0] == "encode") encode(words[1], option == "unchecked");
    return 0;
}
