#include "trama/gateway/footing.hpp"

#include <gtest/gtest.h>

#include "laws/gateway_subject.hpp"
#include "laws/joining.hpp"

namespace trama::gateway {
namespace {

using test::octets;

TEST(gateway_footing, is_the_next_stx) {
    constexpr std::array<std::uint8_t, 7> stream{'x', stx, ' ', etx, 'y', stx, '5'};
    static_assert(footing(stream, 1) == 1 && footing(stream, 2) == 5 && footing(stream, 5) == 5);
    static_assert(footing_lead == 0);
    EXPECT_EQ(footing(stream, 1), 1U);
    EXPECT_EQ(footing(stream, 4), 5U);
}

TEST(gateway_footing, of_the_beginning_is_the_beginning) {
    const octets noise(9, 'x');
    EXPECT_EQ(footing(noise, 0), 0U);
    EXPECT_EQ(footing({}, 0), 0U);
}

TEST(gateway_footing, is_the_end_where_no_record_begins) {
    const octets stream{stx, '5', etx, 'x'};
    for (const std::size_t from : {1U, 3U, 4U, 5U, 100U}) EXPECT_EQ(footing(stream, from), stream.size());
}

TEST(gateway_footing, who_joins_there_reports_what_the_whole_does) {
    std::size_t found = 0;
    test::for_many_cuts<format>(900, 40, [&](const octets& stream, std::size_t cut) {
        const std::size_t place = footing(stream, cut);
        ASSERT_GE(place, cut);
        if (place == stream.size()) return;
        ++found;
        EXPECT_EQ(test::reports_from<format>(stream, place, place), test::reports_from<format>(stream, 0, place)) << "cut at " << cut;
    });
    EXPECT_GT(found, 1000U);
}

TEST(gateway_footing, ends_what_comes_before) {
    test::for_many_cuts<format>(900, 40, [&](const octets& stream, std::size_t cut) {
        const std::size_t place = footing(stream, cut);
        const octets before(stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(place));
        auto parts = test::reports_from<format>(before, 0, 0);
        for (auto& one : test::reports_from<format>(stream, place, place)) parts.push_back(std::move(one));
        EXPECT_EQ(parts, test::reports_from<format>(stream, 0, 0)) << "cut at " << cut;
    });
}

}  // namespace
}  // namespace trama::gateway
