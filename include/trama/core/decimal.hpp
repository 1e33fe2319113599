#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "trama/core/bytes.hpp"

namespace trama {

inline constexpr std::uint64_t all_spaces = 0x2020202020202020;

/// `Columns` characters in one word, first one lowest, the bytes above them filled with spaces.
/// Two overlapping loads: a partial memcpy would go through memory and stall on store forwarding.
template <std::size_t Columns>
constexpr std::uint64_t load_columns(const std::uint8_t* p) noexcept {
    static_assert(Columns >= 1 && Columns <= 8);
    if constexpr (Columns == 8) {
        return load_le<std::uint64_t>(p);
    } else {
        constexpr std::uint64_t fill = all_spaces << (8 * Columns);
        if constexpr (Columns >= 4)
            return fill | load_le<std::uint32_t>(p) | std::uint64_t{load_le<std::uint32_t>(p + Columns - 4)} << (8 * (Columns - 4));
        else if constexpr (Columns >= 2)
            return fill | load_le<std::uint16_t>(p) | std::uint64_t{load_le<std::uint16_t>(p + Columns - 2)} << (8 * (Columns - 2));
        else
            return fill | p[0];
    }
}

/// Up to eight columns, classified and summed without a branch.
struct column_run {
    std::uint64_t digits;  ///< 0xFF in the bytes that hold a digit.
    std::uint64_t bad;     ///< Nonzero when a byte is neither digit nor space, or spaces split the digits.
    std::uint32_t value;   ///< Of the digits; blank is zero.
};
constexpr column_run read_run(std::uint64_t word) noexcept {
    constexpr std::uint64_t tops = 0x8080808080808080;
    const std::uint64_t low = word ^ 0x3030303030303030;  // digits become 0..9
    const std::uint64_t digit_tops = ~(((low & ~tops) + 0x7676767676767676) | low) & tops;
    const std::uint64_t digits = (digit_tops >> 7) * 0xFF;
    const std::uint64_t split = digits & (digits + (digits & (0 - digits)));
    const std::uint64_t stray = (word ^ all_spaces) & ~digits;
    // Shift the last digit to the top byte, then add pairs, fours and eights.
    std::uint64_t v = (low & digits) << (std::countl_zero(digits | 1) & ~7);
    v = (v * 2561 >> 8) & 0x00FF00FF00FF00FF;
    v = (v * 6553601 >> 16) & 0x0000FFFF0000FFFF;
    v = v * 42949672960001 >> 32;
    return {digits, split | stray, static_cast<std::uint32_t>(v)};
}

/// Reads 1..8 columns holding one run of digits with spaces on either side; all spaces read as 0.
/// Returns nonzero when they do not. [gateway, "Tipos de mensajes"; D15]
template <std::size_t Columns>
constexpr std::uint64_t read_columns(const std::uint8_t* p, std::uint32_t& value) noexcept {
    if constexpr (Columns == 1) {
        const std::uint32_t digit = std::uint32_t{p[0]} - '0';
        const bool blank = p[0] == ' ';
        value = blank ? 0 : digit;
        return digit > 9 && !blank ? 1U : 0U;
    } else {
        const column_run run = read_run(load_columns<Columns>(p));
        value = run.value;
        return run.bad;
    }
}

/// As `read_columns`, with an optional '-' directly before the digits. [D16]
template <std::size_t Columns>
constexpr std::uint64_t read_signed_columns(const std::uint8_t* p, std::int32_t& value) noexcept {
    const std::uint64_t word = load_columns<Columns>(p);
    std::size_t dash = 0;
    while (dash != Columns && p[dash] == ' ') ++dash;
    const bool negative = dash != Columns && p[dash] == '-';
    if (!negative) {
        const column_run run = read_run(word);
        value = static_cast<std::int32_t>(run.value);
        return run.bad;
    }
    const std::uint64_t minus_to_space = std::uint64_t{'-' ^ ' '} << (8 * dash);
    const column_run run = read_run(word ^ minus_to_space);
    value = -static_cast<std::int32_t>(run.value);
    const bool adjacent = dash + 1 != Columns && (run.digits >> (8 * dash + 8) & 0xFF) != 0;
    return run.bad | (adjacent ? 0U : 1U);
}

/// Reads `xxx.x`: one to three digits, then optionally a point and one digit, spaces on either side; in tenths.
/// Returns nonzero when the columns hold anything else. [D15]
template <std::size_t Columns>
constexpr std::uint64_t read_tenths(const std::uint8_t* p, std::uint16_t& value) noexcept {
    std::size_t i = 0;
    const auto is_digit = [&] { return i != Columns && p[i] >= '0' && p[i] <= '9'; };
    while (i != Columns && p[i] == ' ') ++i;
    value = 0;
    if (i == Columns) return 0;
    unsigned whole = 0;
    std::size_t digits = 0;
    for (; is_digit() && digits != 4; ++i, ++digits) whole = whole * 10 + (p[i] - '0');
    bool good = digits >= 1 && digits <= 3;
    whole *= 10;
    if (i != Columns && p[i] == '.') {
        ++i;
        good = good && is_digit();
        if (good) whole += static_cast<unsigned>(p[i++] - '0');
    }
    while (i != Columns && p[i] == ' ') ++i;
    value = static_cast<std::uint16_t>(whole);
    return good && i == Columns ? 0U : 1U;
}

/// Writes `value` right-aligned in `columns` characters, spaces before it. Precondition: it fits.
constexpr void write_columns(std::uint8_t* p, std::size_t columns, std::uint64_t value) noexcept {
    std::size_t at = columns;
    do {
        p[--at] = static_cast<std::uint8_t>('0' + value % 10);
        value /= 10;
    } while (value != 0 && at != 0);
    std::fill(p, p + at, std::uint8_t{' '});
}

/// The digits of `value` in eight bytes, the first digit in the lowest one. Precondition: below 100000000.
constexpr std::uint64_t spread_digits(std::uint32_t value) noexcept {
    const std::uint32_t high = value / 10000;
    std::uint64_t v = high | std::uint64_t{value - high * 10000} << 32;  // two numbers of four digits
    const std::uint64_t hundreds = (v * 10486 >> 20) & 0x0000007F0000007F;
    v = hundreds | (v - hundreds * 100) << 16;  // four of two
    const std::uint64_t tens = (v * 103 >> 10) & 0x000F000F000F000F;
    return tens | (v - tens * 10) << 8;
}

/// The digits of `value` in four bytes, the first digit in the lowest one. Precondition: below 10000.
constexpr std::uint32_t spread_few_digits(std::uint32_t value) noexcept {
    const std::uint32_t hundreds = value * 5243 >> 19;
    const std::uint32_t v = hundreds | (value - hundreds * 100) << 16;
    const std::uint32_t tens = (v * 103 >> 10) & 0x000F000F;
    return tens | (v - tens * 10) << 8;
}

/// As `write_columns` does, for 1..7 columns that are known when this is compiled, without a branch.
template <std::size_t Columns>
constexpr void write_few_columns(std::uint8_t* p, std::uint32_t value) noexcept {
    if constexpr (Columns == 1) {
        p[0] = static_cast<std::uint8_t>('0' + value);
    } else {
        static_assert(Columns <= 7);
        constexpr std::size_t spread = Columns <= 4 ? 4 : 8;
        const std::uint64_t digits = (Columns <= 4 ? spread_few_digits(value) : spread_digits(value)) >> (8 * (spread - Columns));
        // Of the zeros before the first digit that counts, '0' becomes ' ' by losing one bit; the last digit always counts.
        const auto first = static_cast<unsigned>(std::countr_zero(digits | std::uint64_t{1} << (8 * (Columns - 1))) & ~7);
        const std::uint64_t leading = (std::uint64_t{1} << first) - 1;
        const std::uint64_t chars = (digits | 0x3030303030303030) ^ (leading & 0x1010101010101010);
        if constexpr (Columns >= 4) {
            store_le(p, static_cast<std::uint32_t>(chars));
            store_le(p + Columns - 4, static_cast<std::uint32_t>(chars >> (8 * (Columns - 4))));
        } else {
            store_le(p, static_cast<std::uint16_t>(chars));
            store_le(p + Columns - 2, static_cast<std::uint16_t>(chars >> (8 * (Columns - 2))));
        }
    }
}

/// Writes a number as `write_columns` does, with a '-' directly before a negative one.
constexpr void write_signed_columns(std::uint8_t* p, std::size_t columns, std::int32_t value) noexcept {
    const auto magnitude = static_cast<std::uint64_t>(value < 0 ? -std::int64_t{value} : std::int64_t{value});
    write_columns(p, columns, magnitude);
    if (value >= 0) return;
    std::size_t at = columns;
    while (at != 0 && p[at - 1] != ' ') --at;
    if (at != 0) p[at - 1] = '-';
}

/// Writes tenths as `xxx.x`, right-aligned.
constexpr void write_tenths(std::uint8_t* p, std::size_t columns, std::uint16_t tenths) noexcept {
    write_columns(p, columns - 2, tenths / 10);
    p[columns - 2] = '.';
    p[columns - 1] = static_cast<std::uint8_t>('0' + tenths % 10);
}

}  // namespace trama
