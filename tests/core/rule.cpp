#include "trama/core/rule.hpp"

#include <gtest/gtest.h>

namespace trama {
namespace {

TEST(rule, without_bounds_allows_anything) {
    EXPECT_TRUE(rule{}.any());
    EXPECT_TRUE(rule{}.allows(std::numeric_limits<std::int64_t>::min()));
    EXPECT_TRUE(rule{}.allows(std::numeric_limits<std::int64_t>::max()));
    EXPECT_FALSE(between(0, 1).any());
}

TEST(rule, bounds_are_included) {
    const rule r = between(1, 12);
    EXPECT_FALSE(r.allows(0));
    EXPECT_TRUE(r.allows(1));
    EXPECT_TRUE(r.allows(12));
    EXPECT_FALSE(r.allows(13));
}

TEST(rule, one_more_value_may_be_allowed_beside_the_range) {
    const rule r{0, 30100, 65535, 0, {}, {}};
    EXPECT_TRUE(r.allows(30100));
    EXPECT_FALSE(r.allows(30101));
    EXPECT_FALSE(r.allows(65534));
    EXPECT_TRUE(r.allows(65535));
}

TEST(rule, a_set_allows_its_members_only) {
    const rule r{0, 0, 0, std::uint64_t{1} << 63 | 1 << 15 | 1, {}, {}};
    for (std::int64_t v = -70; v != 200; ++v) EXPECT_EQ(r.allows(v), v == 0 || v == 15 || v == 63) << v;
    EXPECT_FALSE(r.any());
}

TEST(rule, says_nothing_only_if_no_part_of_it_says_anything) {
    constexpr rule nothing{};
    EXPECT_TRUE(nothing.any());
    rule r = nothing;
    r.low = 0;
    EXPECT_FALSE(r.any());
    r = nothing;
    r.high = 9;
    EXPECT_FALSE(r.any());
    r = nothing;
    r.set = 1;
    EXPECT_FALSE(r.any());
    r = nothing;
    r.words = "an even number";
    EXPECT_FALSE(r.any());
}

TEST(rule, an_empty_range_allows_nothing_but_the_extra_value) {
    const rule r{0, -1, -1, 0, {}, "no such sensor"};
    EXPECT_FALSE(r.allows(0));
    EXPECT_FALSE(r.allows(65535));
}

TEST(rule, a_violation_list_keeps_as_many_as_it_can) {
    violation_list<2> list;
    EXPECT_TRUE(list.empty());
    for (std::int64_t v = 1; v != 4; ++v) list.push_back({{}, v, nullptr});
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(list[1].value, 2);
    EXPECT_EQ(list.end() - list.begin(), 2);
}

}  // namespace
}  // namespace trama
