#include "trama/core/error.hpp"

#include <gtest/gtest.h>

#include <set>
#include <type_traits>
#include <utility>

namespace trama {
namespace {

TEST(error, every_code_has_its_own_name) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i != errc_count; ++i) names.insert(name_of(static_cast<errc>(i)));
    EXPECT_EQ(names.size(), errc_count);
    EXPECT_FALSE(names.contains("?"));
    EXPECT_EQ(name_of(static_cast<errc>(errc_count)), "?");
    EXPECT_EQ(name_of(errc::bad_checksum), "bad_checksum");
    EXPECT_EQ(name_of(errc::buffer_too_small), "buffer_too_small");
}

TEST(error, is_true_when_something_failed) {
    EXPECT_FALSE(error{});
    EXPECT_TRUE((error{errc::noise, {}}));
}

TEST(error, a_result_is_a_value_or_an_error) {
    const result<int> good = 5;
    EXPECT_TRUE(good);
    EXPECT_EQ(*good, 5);
    EXPECT_EQ(good.code(), errc::ok);
    EXPECT_EQ(good.value_or(7), 5);
    const result<int> bad = errc::bad_number;
    EXPECT_FALSE(bad);
    EXPECT_EQ(bad.code(), errc::bad_number);
    EXPECT_EQ(bad.value_or(7), 7);
    const result<int> placed = error{errc::out_of_range, {3, 1}};
    EXPECT_EQ(placed.error().field.field, 3);
    EXPECT_EQ(placed.error().field.index, 1);
    EXPECT_EQ(placed.error().field.sub, field_ref::none);
    EXPECT_FALSE(good == bad);
    const result<std::array<int, 2>> pair = std::array{1, 2};
    EXPECT_EQ(pair->at(1), 2);
}

/// What one line reads out of a temporary; as a constant expression, in which the compiler refuses to read a dead object.
constexpr int kept_of_a_temporary() {
    const auto make = [] { return result<std::array<int, 2>>(std::array{3, 4}); };
    const std::array<int, 2>& kept = *make();
    return kept[1] + make()->at(0);
}

TEST(error, the_value_of_a_temporary_result_can_be_kept) {
    static_assert(kept_of_a_temporary() == 7);
    static_assert(std::is_same_v<decltype(*std::declval<result<int>>()), int>);
    static_assert(std::is_same_v<decltype(*std::declval<const result<int>>()), int>);
    static_assert(std::is_same_v<decltype(*std::declval<result<int>&>()), const int&>, "a result that stays is not copied");
    EXPECT_EQ(kept_of_a_temporary(), 7);
}

TEST(error, counters_count_by_code) {
    counters c;
    ++c.errors[static_cast<std::size_t>(errc::noise)];
    EXPECT_EQ(c.count(errc::noise), 1U);
    EXPECT_EQ(c.count(errc::truncated), 0U);
}

}  // namespace
}  // namespace trama
