#include "trama/core/decimal.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace trama {
namespace {

/// Calls `f` with every string of `Columns` characters out of `alphabet`.
template <std::size_t Columns>
void every_field(std::string_view alphabet, auto&& f) {
    std::array<std::uint8_t, Columns> field{};
    std::size_t combinations = 1;
    for (std::size_t i = 0; i != Columns; ++i) combinations *= alphabet.size();
    for (std::size_t n = 0; n != combinations; ++n) {
        std::size_t rest = n;
        for (auto& c : field) {
            c = static_cast<std::uint8_t>(alphabet[rest % alphabet.size()]);
            rest /= alphabet.size();
        }
        f(field);
    }
}

std::string trimmed(std::span<const std::uint8_t> field) {
    std::string s(field.begin(), field.end());
    const auto first = s.find_first_not_of(' ');
    return first == std::string::npos ? "" : s.substr(first, s.find_last_not_of(' ') - first + 1);
}
bool all_digits(const std::string& s) {
    return std::all_of(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; });
}
/// [D15] read the slow way.
std::optional<long> number_in(std::span<const std::uint8_t> field) {
    const std::string s = trimmed(field);
    if (!all_digits(s)) return std::nullopt;
    return s.empty() ? 0 : std::stol(s);
}
/// [D16]
std::optional<long> signed_number_in(std::span<const std::uint8_t> field) {
    const std::string s = trimmed(field);
    if (s.empty() || s[0] != '-') return number_in(field);
    const std::string digits = s.substr(1);
    if (digits.empty() || !all_digits(digits)) return std::nullopt;
    return -std::stol(digits);
}
std::optional<long> tenths_in(std::span<const std::uint8_t> field) {
    const std::string s = trimmed(field);
    if (s.empty()) return 0;
    const auto point = s.find('.');
    const std::string whole = s.substr(0, point), tenth = point == std::string::npos ? "0" : s.substr(point + 1);
    if (whole.empty() || whole.size() > 3 || tenth.size() != 1 || !all_digits(whole) || !all_digits(tenth)) return std::nullopt;
    return std::stol(whole) * 10 + std::stol(tenth);
}

template <std::size_t Columns, class V>
void expect_reading(const std::array<std::uint8_t, Columns>& field, std::uint64_t bad, V value, std::optional<long> right) {
    const bool same = right ? bad == 0 && static_cast<long>(value) == *right : bad != 0;
    if (!same) ADD_FAILURE() << '"' << std::string(field.begin(), field.end()) << "\" reads as " << value << ", bad " << bad;
}

/// Every field of digits, spaces and one foreign character, which is also each neighbour of the digits in ASCII.
template <std::size_t Columns>
void expect_all_readings(std::string_view foreign) {
    for (const char c : foreign) {
        std::string alphabet = "0123456789 ";
        alphabet += c;
        every_field<Columns>(alphabet, [](const auto& field) {
            std::uint32_t value = 0;
            const auto bad = read_columns<Columns>(field.data(), value);
            expect_reading(field, bad, value, number_in(field));
        });
    }
}

TEST(decimal, reads_every_field_of_one_to_four_columns) {
    const std::string_view foreign = "/:-.A\x01\x7F\x80\xB0\xFF";
    expect_all_readings<1>(foreign);
    expect_all_readings<2>(foreign);
    expect_all_readings<3>(foreign);
    expect_all_readings<4>("/:\xB5");
}

TEST(decimal, reads_every_field_of_five_columns_of_digits_spaces_and_a_foreign_character) {
    expect_all_readings<5>("x");
}

TEST(decimal, reads_longer_fields) {
    every_field<7>("09 x", [](const auto& field) {
        std::uint32_t value = 0;
        const auto bad = read_columns<7>(field.data(), value);
        expect_reading(field, bad, value, number_in(field));
    });
    every_field<8>("19 ", [](const auto& field) {
        std::uint32_t value = 0;
        const auto bad = read_columns<8>(field.data(), value);
        expect_reading(field, bad, value, number_in(field));
    });
}

TEST(decimal, refuses_every_foreign_byte_in_every_column) {
    for (unsigned c = 0; c != 256; ++c)
        for (std::size_t at = 0; at != 5; ++at) {
            std::array<std::uint8_t, 5> field{'1', '2', '3', '4', '5'};
            field[at] = static_cast<std::uint8_t>(c);
            std::uint32_t value = 0;
            const auto bad = read_columns<5>(field.data(), value);
            expect_reading(field, bad, value, number_in(field));
        }
}

TEST(decimal, reads_every_signed_field_of_five_columns) {
    for (const std::string_view alphabet : {"01249 -x", "0-+ "})
        every_field<5>(alphabet, [](const auto& field) {
            std::int32_t value = 0;
            const auto bad = read_signed_columns<5>(field.data(), value);
            expect_reading(field, bad, value, signed_number_in(field));
        });
}

TEST(decimal, reads_every_field_of_tenths) {
    for (const std::string_view alphabet : {"01249 .x", "0-. "})
        every_field<5>(alphabet, [](const auto& field) {
            std::uint16_t value = 0;
            const auto bad = read_tenths<5>(field.data(), value);
            expect_reading(field, bad, value, tenths_in(field));
        });
}

TEST(decimal, writes_on_the_right_what_it_reads_back) {
    for (std::uint32_t v = 0; v != 100000; ++v) {
        std::array<std::uint8_t, 5> field{};
        write_columns(field.data(), 5, v);
        std::uint32_t back = 0;
        ASSERT_EQ(read_columns<5>(field.data(), back), 0U);
        ASSERT_EQ(back, v);
        ASSERT_EQ(trimmed(field), std::to_string(v));
        ASSERT_NE(field[4], ' ');
    }
}

TEST(decimal, writes_the_sign_directly_before_the_digits) {
    for (std::int32_t v = -9999; v != 100000; ++v) {
        std::array<std::uint8_t, 5> field{};
        write_signed_columns(field.data(), 5, v);
        std::int32_t back = 0;
        ASSERT_EQ(read_signed_columns<5>(field.data(), back), 0U);
        ASSERT_EQ(back, v);
        ASSERT_EQ(trimmed(field), std::to_string(v));
    }
}

TEST(decimal, writes_tenths_always_with_one_decimal) {
    for (std::uint16_t v = 0; v != 10000; ++v) {
        std::array<std::uint8_t, 5> field{};
        write_tenths(field.data(), 5, v);
        std::uint16_t back = 0;
        ASSERT_EQ(read_tenths<5>(field.data(), back), 0U);
        ASSERT_EQ(back, v);
        ASSERT_EQ(trimmed(field), std::to_string(v / 10) + '.' + std::to_string(v % 10));
    }
}

}  // namespace
}  // namespace trama
