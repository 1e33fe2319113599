#include "trama/daisy/footing.hpp"

#include <gtest/gtest.h>

#include <map>

#include "laws/daisy_subject.hpp"
#include "laws/joining.hpp"

namespace trama::daisy {
namespace {

using test::octets;

const octets ping{0x04, 0x11, 0x00, 0x03, 0x16}, odd = test::sealed(0x10, 0x00, 0x7E, {});

octets operator*(const octets& one, std::size_t times) { return test::repeated(one, times); }
octets operator+(octets a, const octets& b) {
    test::append(a, b);
    return a;
}
std::size_t join_of(std::size_t cut) { return cut - std::min(cut, footing_lead); }

TEST(daisy_footing, is_a_packet_at_or_behind_the_cut) {
    const octets stream = ping * 1000;
    for (std::size_t cut = 600; cut != 620; ++cut) EXPECT_EQ(footing(stream, cut), (cut + 4) / 5 * 5);
}

TEST(daisy_footing, of_the_beginning_is_the_beginning) {
    EXPECT_EQ(footing(ping, 0), 0U);
    EXPECT_EQ(footing({}, 0), 0U);
}

TEST(daisy_footing, takes_bytes_without_a_fault) {
    const octets stream = octets(700, 0) + ping * 400;
    EXPECT_EQ(footing(stream, 1), 700U + (footing_clean + 4) / 5 * 5);
    EXPECT_EQ(footing(ping * 400, 1), (footing_clean + 4) / 5 * 5);
}

TEST(daisy_footing, takes_an_undocumented_packet_for_no_fault) {
    ASSERT_EQ(odd.size(), 5U);
    EXPECT_EQ(footing(ping * 60 + odd + ping * 200, 1), (footing_clean + 4) / 5 * 5);
}

TEST(daisy_footing, is_the_end_where_there_is_none) {
    for (const octets& stream : {octets(5000, 0), ping * 50, odd * 1000, ping * 4 + odd * 1000})
        for (const std::size_t cut : {1U, 249U, 2000U}) EXPECT_EQ(footing(stream, cut), stream.size());
    EXPECT_EQ(footing(ping * 400, 5000), 2000U) << "behind the end";
}

/// Where a decoder that read the stream from its beginning was settled, behind an event.
std::map<std::size_t, bool> settled_places(const octets& stream) {
    std::map<std::size_t, bool> places;
    (void)test::reports_from<format>(stream, 0, 0, [&](const decoder& d, std::size_t place) { places[place] = d.settled(); });
    return places;
}

TEST(daisy_footing, who_joins_before_it_reports_what_a_decoder_settled_there_does) {
    std::size_t shared = 0;
    test::for_many_cuts<format>(2000, 150, [&](const octets& stream, std::size_t cut) {
        const std::size_t place = footing(stream, cut);
        ASSERT_GE(place, cut);
        if (place == 0 || place == stream.size()) return;
        bool joined = false;
        const auto there = test::reports_from<format>(stream, join_of(cut), place, [&](const decoder& d, std::size_t at) { joined = joined || (at == place && d.settled()); });
        EXPECT_TRUE(joined) << "cut at " << cut;
        if (!settled_places(stream)[place]) return;
        ++shared;
        EXPECT_EQ(there, test::reports_from<format>(stream, 0, place)) << "cut at " << cut;
    });
    EXPECT_GT(shared, 1000U);
}

/// Each of the two texts is a reply behind a ping and holds the other reading's ping: whoever joins hears them both.
TEST(daisy_footing, is_the_end_where_the_stream_contradicts_itself) {
    const octets text = test::sealed(0x00, 0x11, 0x81, octets{0x80} + ping + octets{0x0E, 0x00, 0x11, 0x81});
    ASSERT_EQ(text.back(), 0x80);
    const octets stream = (ping + text) * 400;
    for (std::size_t cut = 1025; cut != 1045; ++cut) EXPECT_EQ(footing(stream, cut), stream.size());
}

/// 18 bytes are six readings or, from byte 5 on, two replies of an encoder. Nothing tells them apart but what came before,
/// which who joins later does not know.
TEST(daisy_footing, is_no_seam_where_the_decoder_before_it_is_not_settled) {
    octets stream = ping * 60;
    for (std::uint8_t i = 0; i != 250; ++i) {
        octets readings{0x11, 0x00, 0x30, 0xC4, 0x3F, 0x08, 0x00, 0x11, 0xC3, i, 1, 2, 3};
        readings.push_back(xor_of(std::span(readings).subspan(5)));
        stream = stream + readings + octets{0x08, 0x00, 0x11, 0xC3};
    }
    ASSERT_EQ(xor_of(std::span(stream).subspan(300, 18)), 0);
    ASSERT_EQ(xor_of(std::span(stream).subspan(305, 9)), 0);
    ASSERT_EQ(xor_of(std::span(stream).subspan(314, 9)), 0);
    auto places = settled_places(stream);
    EXPECT_TRUE(places[300 + 18 * 100]);
    std::size_t others = 0;
    for (std::size_t cut = 1325; cut != 1345; ++cut) {
        const std::size_t place = footing(stream, cut);
        if (place == stream.size()) continue;
        const bool same = test::reports_from<format>(stream, join_of(cut), place) == test::reports_from<format>(stream, 0, place);
        EXPECT_EQ(same, places[place]) << "cut at " << cut;
        others += same ? 0 : 1;
    }
    EXPECT_GT(others, 0U);
}

}  // namespace
}  // namespace trama::daisy
