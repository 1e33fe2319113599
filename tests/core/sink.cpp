#include "trama/core/sink.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

namespace trama {
namespace {

std::string written(auto&& print, std::size_t room = 256) {
    std::string buffer(room, '\0');
    text_sink out(buffer);
    print(out);
    EXPECT_FALSE(out.full());
    return std::string(out.view());
}

TEST(sink, writes_numbers_of_any_size) {
    EXPECT_EQ(written([](auto& out) { out << 0 << ' ' << -5 << ' ' << std::uint8_t{200} << ' ' << std::int16_t{-300}; }), "0 -5 200 -300");
    EXPECT_EQ(written([](auto& out) { out << std::numeric_limits<std::int64_t>::min(); }), "-9223372036854775808");
    EXPECT_EQ(written([](auto& out) { out << std::numeric_limits<std::uint64_t>::max(); }), "18446744073709551615");
}

TEST(sink, writes_tenths_with_one_decimal) {
    EXPECT_EQ(written([](auto& out) { out.tenths(482) << ' '; out.tenths(480) << ' '; out.tenths(5) << ' '; out.tenths(0) << ' '; out.tenths(9999); }), "48.2 48.0 0.5 0.0 999.9");
}

TEST(sink, writes_hex_in_lower_case_with_or_without_a_gap) {
    const std::array<std::uint8_t, 3> bytes{0x0A, 0xFF, 0x50};
    EXPECT_EQ(written([&](auto& out) { out.hex(bytes); }), "0aff50");
    EXPECT_EQ(written([&](auto& out) { out.hex(bytes, " "); }), "0a ff 50");
    EXPECT_EQ(written([&](auto& out) { out.hex({}, " "); }), "");
}

TEST(sink, quotes_every_byte_as_json) {
    for (unsigned c = 0; c != 256; ++c) {
        const auto byte = static_cast<std::uint8_t>(c);
        constexpr std::string_view digits = "0123456789abcdef";
        std::string expected = c < 0x20 || c >= 0x7F ? std::string("\\u00") + digits[c >> 4] + digits[c & 15] : std::string(1, static_cast<char>(c));
        if (c == '"' || c == '\\') expected = '\\' + expected;
        const char as_char = static_cast<char>(byte);
        EXPECT_EQ(written([&](auto& out) { out.quoted(std::span(&byte, 1)); }), '"' + expected + '"') << c;
        EXPECT_EQ(written([&](auto& out) { out.quoted(std::string_view(&as_char, 1)); }), '"' + expected + '"') << c;
    }
}

TEST(sink, writes_a_rule_as_range_number_names_or_words) {
    const std::array<std::string_view, 3> names{"low", "high", "none"};
    EXPECT_EQ(written([](auto& out) { out.allowed(between(0, 15)); }), "0..15");
    EXPECT_EQ(written([](auto& out) { out.allowed(between(-3, 0)); }), "-3..0");
    EXPECT_EQ(written([](auto& out) { out.allowed(between(0, 0)); }), "0");
    EXPECT_EQ(written([&](auto& out) { out.allowed({0, 0, 0, 0, names, {}}); }), "low|high|none");
    EXPECT_EQ(written([](auto& out) { out.allowed({0, 9, 0, 0, {}, "no such sensor"}); }), "no such sensor");
}

TEST(sink, that_is_too_small_keeps_what_fits_and_says_so) {
    const std::string all = "abc12345ff\"x\\\"\"";
    for (std::size_t room = 0; room <= all.size(); ++room) {
        std::string buffer(room + 4, '#');
        text_sink out({buffer.data(), room});
        const std::array<std::uint8_t, 1> byte{0xFF};
        out << "abc" << 12345;
        out.hex(byte);
        out.quoted("x\"");
        EXPECT_EQ(out.full(), room != all.size());
        EXPECT_EQ(out.view(), all.substr(0, room));
        EXPECT_EQ(buffer.substr(room), "####") << "written behind the end";
        out.clear();
        EXPECT_FALSE(out.full());
        EXPECT_EQ(out.size(), 0U);
    }
}

}  // namespace
}  // namespace trama
