#include "trama/core/wire.hpp"

#include <gtest/gtest.h>

#include "trama/core/wire_ascii.hpp"

namespace trama::wire {
namespace {

/// Every value of `low..high` in steps is stored and loaded again; those just outside are not carried.
template <class W>
void expect_carried(std::int64_t low, std::int64_t high, std::int64_t step = 1) {
    EXPECT_EQ(W::low, low) << W::type_name;
    EXPECT_EQ(W::high, high) << W::type_name;
    EXPECT_FALSE(W::carries(low - 1));
    EXPECT_FALSE(W::carries(high + 1));
    for (std::int64_t v = low; v <= high; v += step) {
        ASSERT_TRUE(W::carries(v));
        std::array<std::uint8_t, W::size> wire{};
        W::store(wire.data(), static_cast<typename W::value>(v));
        typename W::value back{};
        ASSERT_EQ(W::load(wire.data(), back), 0U) << W::type_name << ' ' << v;
        ASSERT_EQ(static_cast<std::int64_t>(back), v) << W::type_name;
    }
}

TEST(wire, numbers_come_back_within_their_range) {
    expect_carried<u8>(0, 255);
    expect_carried<u16>(0, 65535);
    expect_carried<i16>(-32768, 32767);
    expect_carried<i32>(-2147483648LL, 2147483647LL, 65521);
    expect_carried<century_year>(0, 9999);
    expect_carried<letter_pair>(0, 65535);
    expect_carried<dec<1>>(0, 9);
    expect_carried<dec<2>>(0, 99);
    expect_carried<dec<3>>(0, 999);
    expect_carried<dec<4>>(0, 9999);
    expect_carried<dec<5>>(0, 99999);
    expect_carried<dec<7>>(0, 9999999, 997);
    expect_carried<dec<8>>(0, 99999999, 9973);  // no field is so wide; a format of one's own may have one
    expect_carried<signed_dec<5>>(-9999, 99999);
    expect_carried<tenths<5>>(0, 9999);
}

/// By which a format knows that columns are digits.
static_assert(dec<5>::decimal && signed_dec<5>::decimal && tenths<5>::decimal);

TEST(wire, little_endian_is_two_s_complement) {
    std::array<std::uint8_t, 4> b{};
    i32::store(b.data(), 1193046);
    EXPECT_EQ(b, (std::array<std::uint8_t, 4>{0x56, 0x34, 0x12, 0x00}));
    i32::store(b.data(), -2);
    EXPECT_EQ(b, (std::array<std::uint8_t, 4>{0xFE, 0xFF, 0xFF, 0xFF}));
    i16::store(b.data(), -32768);
    EXPECT_EQ(b[0], 0x00);
    EXPECT_EQ(b[1], 0x80);
}

TEST(wire, a_year_is_century_then_year) {
    std::array<std::uint8_t, 2> b{};
    century_year::store(b.data(), 2011);
    EXPECT_EQ(b, (std::array<std::uint8_t, 2>{20, 11}));
    for (unsigned hi = 0; hi != 256; ++hi)
        for (unsigned lo = 0; lo != 256; ++lo) {
            b = {static_cast<std::uint8_t>(hi), static_cast<std::uint8_t>(lo)};
            std::uint16_t v = 0;
            EXPECT_EQ(century_year::load(b.data(), v) == 0, hi <= 99 && lo <= 99);
        }
}

TEST(wire, letters_are_first_times_256_and_second) {
    std::array<std::uint8_t, 2> b{};
    letter_pair::store(b.data(), 'I' * 256 + 'S');
    EXPECT_EQ(b, (std::array<std::uint8_t, 2>{'I', 'S'}));
}

TEST(wire, a_constant_byte_follows_and_is_not_read) {
    using with_letter = followed_by<u8, 'F'>;
    std::array<std::uint8_t, 2> b{};
    with_letter::store(b.data(), 7);
    EXPECT_EQ(b, (std::array<std::uint8_t, 2>{7, 'F'}));
    EXPECT_EQ(with_letter::size, 2U);
}

TEST(wire, rest_and_counted_know_their_lengths) {
    using text_rest = rest<print::text, 0, 0, 251>;
    using rejected_rest = rest<print::hex, 1, 5, 249>;
    const std::array<std::uint8_t, 252> bytes{};
    EXPECT_TRUE(text_rest::carries(byte_view(std::span(bytes).first(251))));
    EXPECT_FALSE(text_rest::carries(byte_view(bytes)));
    EXPECT_FALSE(rejected_rest::carries(byte_view(std::span(bytes).first(4))));
    EXPECT_TRUE(rejected_rest::carries(byte_view(std::span(bytes).first(5))));
    EXPECT_FALSE(rejected_rest::carries(byte_view(std::span(bytes).first(250))));
    using list = counted<u16, 8>;
    list::value v;
    const std::array<std::uint8_t, 5> wire{1, 0, 2, 1, 9};
    EXPECT_EQ(list::load(wire.data(), 5, v), 0U);
    EXPECT_EQ(v, (list::value{1, 258})) << "a byte too few for a value is left over";
    EXPECT_EQ(list::length(v), 4U);
}

TEST(wire, text_columns_hold_what_was_written) {
    using column = chars<5>;
    std::array<std::uint8_t, 5> b{};
    column::store(b.data(), "a b");
    EXPECT_EQ(b, (std::array<std::uint8_t, 5>{'a', ' ', 'b', ' ', ' '}));
    text<5> back;
    EXPECT_EQ(column::load(b.data(), back), 0U);
    EXPECT_EQ(back, text<5>("a b"));
    EXPECT_FALSE(column::carries("a\x03"));
}

}  // namespace
}  // namespace trama::wire
