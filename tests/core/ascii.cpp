#include "trama/core/ascii.hpp"

#include <gtest/gtest.h>

#include "laws/rng.hpp"

namespace trama {
namespace {

using test::octets;

TEST(ascii, printable_is_space_to_tilde) {
    for (unsigned c = 0; c != 256; ++c) EXPECT_EQ(is_printable(static_cast<std::uint8_t>(c)), c >= 0x20 && c <= 0x7E) << c;
}

TEST(ascii, finds_every_byte_at_every_place_of_every_length) {
    for (std::size_t n = 0; n != 70; ++n)
        for (std::size_t at = 0; at != n; ++at)
            for (const unsigned c : {0x00U, 0x01U, 0x1FU, 0x20U, 0x7EU, 0x7FU, 0x80U, 0x9FU, 0xA0U, 0xFFU}) {
                octets bytes(n, '~');
                bytes[at] = static_cast<std::uint8_t>(c);
                const std::size_t run = c >= 0x20 && c <= 0x7E ? n : at;
                ASSERT_EQ(printable_run_scalar(bytes.data(), n), run) << n << ", " << at << ", " << c;
                ASSERT_EQ(printable_run_vector(bytes.data(), n), run) << n << ", " << at << ", " << c;
                ASSERT_EQ(all_printable_scalar(bytes.data(), n), run == n);
                ASSERT_EQ(all_printable_vector(bytes.data(), n), run == n);
            }
}

TEST(ascii, every_byte_value_is_judged_alike_in_every_lane) {
    for (unsigned c = 0; c != 256; ++c)
        for (std::size_t lane = 0; lane != 32; ++lane) {
            octets bytes(32, ' ');
            bytes[lane] = static_cast<std::uint8_t>(c);
            const bool good = is_printable(static_cast<std::uint8_t>(c));
            ASSERT_EQ(all_printable_vector(bytes.data(), 32), good);
            ASSERT_EQ(printable_run_vector(bytes.data(), 32), good ? 32 : lane);
            ASSERT_EQ(printable_run_scalar(bytes.data(), 32), good ? 32 : lane);
        }
}

TEST(ascii, vector_and_scalar_agree_on_random_bytes_at_every_alignment) {
    for (std::uint64_t seed = 1; seed != 2001; ++seed) {
        test::rng random(seed);
        SCOPED_TRACE(seed);
        octets bytes(random.below(300) + 16);
        for (auto& b : bytes) b = static_cast<std::uint8_t>(random.within(0x20, 0x7E));
        for (std::size_t n = random.below(4); n != 0; --n) bytes[random.below(bytes.size())] = random.byte();
        for (std::size_t skip = 0; skip != 16; ++skip) {
            const std::uint8_t* p = bytes.data() + skip;
            const std::size_t n = bytes.size() - skip;
            std::size_t run = 0;
            while (run != n && p[run] >= 0x20 && p[run] <= 0x7E) ++run;
            ASSERT_EQ(printable_run_scalar(p, n), run);
            ASSERT_EQ(printable_run_vector(p, n), run);
            ASSERT_EQ(printable_run(p, n), run);
            ASSERT_EQ(all_printable_scalar(p, n), run == n);
            ASSERT_EQ(all_printable_vector(p, n), run == n);
            ASSERT_EQ(all_printable(p, n), run == n);
        }
    }
}

TEST(ascii, few_bytes_are_judged_as_far_as_they_go) {
    test::rng random(4);
    for (int round = 0; round != 200; ++round) {
        octets bytes = random.bytes(few_bytes);
        const std::size_t good = random.below(few_bytes + 1);
        for (std::size_t i = 0; i != good; ++i) bytes[i] = static_cast<std::uint8_t>(random.within(0x20, 0x7E));
        for (std::size_t n = 0; n <= few_bytes; ++n) ASSERT_EQ(few_printable_bytes(bytes.data(), n), all_printable_scalar(bytes.data(), n)) << n;
    }
}

constexpr std::uint8_t line[]{'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i', 0x03, 'k'};
static_assert(printable_run(line, 11) == 9);
static_assert(all_printable(line, 9) && !all_printable(line, 10));

}  // namespace
}  // namespace trama
