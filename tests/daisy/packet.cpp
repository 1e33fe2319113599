#include "trama/daisy/packet.hpp"

#include <gtest/gtest.h>

#include "laws/daisy_subject.hpp"
#include "reference/daisy_table.hpp"

namespace trama::daisy {
namespace {

using test::octets;
using test::sealed;

/// What the reference's tables say of a header with its first data byte; `message` is theirs for it.
header right_judgement(const std::array<std::uint8_t, 5>& h, const trama_reference::message_form* message) {
    if (h[0] < 4) return header::impossible;
    if (message == nullptr) return header::open;
    const std::optional<std::uint8_t> first = h[0] > 4 ? std::optional(h[4]) : std::nullopt;
    if (!trama_reference::length_possible(*message, h[0], first)) return header::impossible;
    return trama_reference::documented_addresses(h[1], h[2], h[3]) ? header::documented : header::open;
}

/// Every group on both ends (and everyone), every command, every LEN that some message can have, first data bytes that matter.
TEST(daisy_packet, judges_every_header_as_the_tables_say) {
    std::vector<std::uint8_t> ends{0xFF};
    for (unsigned group = 0; group != 16; ++group) ends.push_back(static_cast<std::uint8_t>(group << 4 | 3));
    std::size_t wrong = 0, documented = 0;
    for (const std::uint8_t destination : ends)
        for (const std::uint8_t source : ends)
            for (unsigned command = 0; command != 256; ++command) {
                const auto* message = trama_reference::find_message(destination, source, static_cast<std::uint8_t>(command));
                for (unsigned len = 0; len < 256; len += len < 23 ? 1 : 29)
                    for (const unsigned first : {0x00U, 0x01U, 0x3FU}) {
                        const std::array<std::uint8_t, 5> h{static_cast<std::uint8_t>(len), destination, source, static_cast<std::uint8_t>(command), static_cast<std::uint8_t>(first)};
                        const header judged = judge_header(h, 0, 5);
                        documented += judged == header::documented ? 1U : 0U;
                        if (judged != right_judgement(h, message) && ++wrong < 10) ADD_FAILURE() << testing::PrintToString(h) << " judged " << static_cast<int>(judged);
                    }
            }
    EXPECT_EQ(wrong, 0U);
    EXPECT_GT(documented, 10000U);
}

TEST(daisy_packet, judges_the_front_of_a_header_never_more_harshly_than_all_of_it) {
    test::rng random(9);
    for (int i = 0; i != 200000; ++i) {
        std::array<std::uint8_t, 5> h{};
        for (auto& b : h) b = random.byte();
        if (random.one_in(2)) h[1] &= 0x6F;
        if (random.one_in(2)) h[2] &= 0x6F;
        const header whole = judge_header(h, 0, 5);
        for (std::size_t n = 0; n != 4; ++n) {
            const header part = judge_header(h, 0, n);
            if (whole == header::documented) { ASSERT_EQ(part, header::unclear) << testing::PrintToString(h) << ", " << n; }
            if (part == header::impossible) { ASSERT_EQ(whole, header::impossible); }
            if (part == header::open) { ASSERT_NE(whole, header::documented); }
        }
        if (whole == header::documented) { ASSERT_EQ(judge_header(h, 0, 4), header::documented); }
    }
}

TEST(daisy_packet, gives_its_parts) {
    const octets bytes = sealed(0x00, 0x62, 0x45, {0x6B, 0x03});
    const packet p(bytes, index_of(0x00, 0x62, 0x45));
    EXPECT_EQ(p.envelope(), (envelope{{0x00}, {0x62}}));
    EXPECT_EQ(p.command(), 0x45);
    EXPECT_FALSE(p.response());
    EXPECT_EQ(p.key(), battery_controller::battery_empty_alarm::key);
    EXPECT_EQ(p.body().size(), 2U);
    EXPECT_EQ(p.bytes().size(), 7U);
    EXPECT_EQ(checksum(p.bytes()), 0);
    const packet none;
    EXPECT_TRUE(none.body().empty());
    EXPECT_EQ(none.key(), key_of(family::none, 0));
}

}  // namespace
}  // namespace trama::daisy
