#include "trama/core/bytes.hpp"

#include <gtest/gtest.h>

#include <array>

#include "laws/rng.hpp"

namespace trama {
namespace {

using test::octets;

std::uint8_t slow_xor(std::span<const std::uint8_t> bytes) {
    std::uint8_t x = 0;
    for (const std::uint8_t b : bytes) x = static_cast<std::uint8_t>(x ^ b);
    return x;
}

TEST(bytes, loads_and_stores_the_least_significant_byte_first) {
    const std::array<std::uint8_t, 8> wire{0x56, 0x34, 0x12, 0x00, 0xFF, 0xFE, 0xFD, 0xFC};
    EXPECT_EQ(load_le<std::uint8_t>(wire.data()), 0x56);
    EXPECT_EQ(load_le<std::uint16_t>(wire.data()), 0x3456);
    EXPECT_EQ(load_le<std::uint32_t>(wire.data()), 0x00123456U);
    EXPECT_EQ(load_le<std::uint64_t>(wire.data()), 0xFCFDFEFF00123456U);
    std::array<std::uint8_t, 8> out{};
    store_le(out.data(), std::uint64_t{0xFCFDFEFF00123456});
    EXPECT_EQ(out, wire);
}

constexpr auto stored_at_compile_time = [] {
    std::array<std::uint8_t, 4> out{};
    store_le(out.data(), std::uint32_t{0x00123456});
    return out;
}();
static_assert(stored_at_compile_time == std::array<std::uint8_t, 4>{0x56, 0x34, 0x12, 0x00});
static_assert(load_le<std::uint32_t>(stored_at_compile_time.data()) == 0x00123456);
static_assert(xor_of(stored_at_compile_time) == (0x56 ^ 0x34 ^ 0x12));

TEST(bytes, xor_of_any_length_and_alignment_is_the_xor_byte_by_byte) {
    test::rng random(1);
    const octets bytes = random.bytes(400);
    for (std::size_t at = 0; at != 9; ++at)
        for (std::size_t n = 0; n + at <= bytes.size(); ++n) {
            const auto part = std::span(bytes).subspan(at, n);
            ASSERT_EQ(xor_of(part), slow_xor(part)) << at << ", " << n;
        }
}

TEST(bytes, the_vector_code_folds_what_the_scalar_reference_folds) {
    test::rng random(2);
    const octets bytes = random.bytes(600);
    for (std::size_t at = 0; at != 17; ++at)
        for (std::size_t n = 16; n + at <= bytes.size(); ++n)
            ASSERT_EQ(xor_of_vector(bytes.data() + at, n), xor_of_scalar(bytes.data() + at, n)) << at << ", " << n;
}

TEST(bytes, xor_of_few_is_the_xor_of_the_first_of_64_or_16_bytes) {
    test::rng random(3);
    for (int round = 0; round != 50; ++round) {
        const octets bytes = random.bytes(few_bytes);
        for (std::size_t n = 0; n <= few_bytes; ++n) ASSERT_EQ(xor_of_few(bytes.data(), n), xor_of_scalar(bytes.data(), n)) << n;
        for (std::size_t n = 0; n <= 16; ++n) ASSERT_EQ(fold_xor(word_of_few<16>(bytes.data(), n)), xor_of_scalar(bytes.data(), n)) << n;
    }
}

TEST(bytes, copies_nothing_from_nowhere) {
    copy_bytes(nullptr, nullptr, 0);
    std::array<std::uint8_t, 3> to{};
    const std::array<std::uint8_t, 3> from{1, 2, 3};
    copy_bytes(to.data(), from.data(), 2);
    EXPECT_EQ(to, (std::array<std::uint8_t, 3>{1, 2, 0}));
}

}  // namespace
}  // namespace trama
