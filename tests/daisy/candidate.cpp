#include "trama/daisy/candidate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "laws/rng.hpp"

namespace trama::daisy {
namespace {

using test::octets;

constexpr auto any = [](std::size_t) { return true; };

/// Bytes that look like headers often: groups, commands and lengths as the tables have them.
octets likely_headers(test::rng& random, std::size_t n) {
    octets bytes(n);
    for (auto& b : bytes) {
        const std::uint8_t choices[] = {static_cast<std::uint8_t>(random.within(3, 9)), static_cast<std::uint8_t>(random.below(0x70)),
                                        static_cast<std::uint8_t>(0x40 + random.below(16)), static_cast<std::uint8_t>(0x81 + random.below(3)), 0xFF, random.byte()};
        b = choices[random.below(6)];
    }
    return bytes;
}

TEST(daisy_candidate, vector_and_scalar_find_the_same_places) {
    std::size_t found = 0;
    for (std::uint64_t seed = 1; seed != 301; ++seed) {
        SCOPED_TRACE(seed);
        test::rng random(seed);
        const octets bytes = random.one_in(3) ? random.bytes(random.below(90)) : likely_headers(random, random.below(90));
        for (std::size_t from = 0; from <= bytes.size(); ++from) {
            const std::size_t place = recovery::find_candidate_scalar(bytes.data(), bytes.size(), from, any);
            ASSERT_EQ(recovery::find_candidate_vector(bytes.data(), bytes.size(), from, any), place) << from;
            found += place + min_packet <= bytes.size() ? 1 : 0;
        }
        octets asked_scalar, asked_vector;
        (void)recovery::find_candidate_scalar(bytes.data(), bytes.size(), 0, [&](std::size_t i) { return asked_scalar.push_back(static_cast<std::uint8_t>(i)), false; });
        (void)recovery::find_candidate_vector(bytes.data(), bytes.size(), 0, [&](std::size_t i) { return asked_vector.push_back(static_cast<std::uint8_t>(i)), false; });
        ASSERT_EQ(asked_vector, asked_scalar);
    }
    EXPECT_GT(found, 1000U);
}

#if defined(__SSE2__) || (defined(__ARM_NEON) && defined(__aarch64__))
TEST(daisy_candidate, the_sieve_lets_through_what_has_the_outline_of_a_header) {
    for (std::uint64_t seed = 1; seed != 2001; ++seed) {
        test::rng random(seed);
        const octets bytes = random.one_in(2) ? random.bytes(19) : likely_headers(random, 19);
        std::uint64_t expected = 0;
        for (unsigned i = 0; i != 16; ++i) {
            const unsigned destination = bytes[i + 1], source = bytes[i + 2], command = bytes[i + 3];
            if ((destination < 0x70 || destination == 0xFF) && source < 0x70 && (command & 0x30) == 0) expected |= std::uint64_t{1} << (i * recovery::bits_per_place);
        }
        ASSERT_EQ(recovery::plausible_headers(bytes.data()), expected) << seed;
    }
}
#endif

TEST(daisy_candidate, no_documented_header_is_passed_over) {
    test::rng random(7);
    std::size_t documented = 0;
    for (unsigned destination = 0; destination != 256; ++destination)
        for (unsigned source = 0; source < 256; source += 5)
            for (unsigned command = 0; command != 256; ++command) {
                const std::size_t index = index_of(destination, source, command);
                const unsigned len = known.fixed_len[index] != variable ? known.fixed_len[index] : static_cast<unsigned>(random.within(4, 22));
                const std::uint8_t header[] = {static_cast<std::uint8_t>(len), static_cast<std::uint8_t>(destination), static_cast<std::uint8_t>(source),
                                               static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(random.below(64))};
                if (judge_header(header, 0, 5) != header::documented) continue;
                ++documented;
                ASSERT_TRUE(may_be_documented(header)) << destination << ", " << source << ", " << command;
            }
    EXPECT_GT(documented, 10000U);
}

TEST(daisy_candidate, a_rolling_xor_is_the_xor_of_each_packet) {
    for (std::uint64_t seed = 1; seed != 101; ++seed) {
        SCOPED_TRACE(seed);
        test::rng random(seed);
        const octets bytes = random.bytes(600);
        recovery::rolling_xor sums(bytes);
        for (std::size_t at = random.below(20); at < bytes.size(); at += random.below(random.one_in(4) ? 100 : 12)) {
            const std::size_t n = std::min(bytes.size() - at, random.one_in(4) ? random.within(1, 256) : random.within(200, 212));
            ASSERT_EQ(sums.over(at, n), xor_of_scalar(bytes.data() + at, n)) << at << ", " << n;
        }
    }
}

/// What lets the decoder take a packet at once.
TEST(daisy_candidate, a_sized_header_is_documented_and_as_long_as_it_says) {
    test::rng random(9);
    std::size_t sized = 0;
    for (unsigned len = 0; len != 256; ++len)
        for (unsigned destination = 0; destination < 256; destination += 3)
            for (unsigned source = 0; source < 256; source += 7)
                for (unsigned command = 0; command != 256; ++command) {
                    std::uint8_t p[16] = {static_cast<std::uint8_t>(len), static_cast<std::uint8_t>(destination), static_cast<std::uint8_t>(source),
                                          static_cast<std::uint8_t>(command), random.byte()};
                    const unsigned found = known.find(load_le<std::uint32_t>(p), p);
                    if (!known.is_sized(found, p)) continue;
                    std::generate(p + header_size + 1, std::end(p), [&] { return random.byte(); });
                    const auto low = load_le<std::uint64_t>(p);
                    if (len == catalogue::not_sized) {
                        ASSERT_NE(known.fold(low, p, len), 0);
                        continue;
                    }
                    ++sized;
                    ASSERT_EQ(judge_header(p, 0, 5), header::documented) << len << ", " << destination << ", " << source << ", " << command;
                    ASSERT_EQ(catalogue::index_in(found), index_of(destination, source, command));
                    ASSERT_LE(len, longest_fixed);
                    ASSERT_EQ(known.fold(low, p, len), xor_of_scalar(p, len + 1));
                }
    EXPECT_GT(sized, 10000U);
}

}  // namespace
}  // namespace trama::daisy
