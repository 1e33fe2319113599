#include "trama/core/names.hpp"

#include <gtest/gtest.h>

#include "trama/trama.hpp"

namespace trama {
namespace {

/// As wide as an own format's may be, and wider than std::size_t on a microcontroller.
enum class wide : std::int64_t { zero, one };
consteval auto names(wide) { return std::array{named{wide::zero, "zero"}, named{wide::one, "one"}}; }

TEST(names, tell_of_values_wider_than_a_machine_word) {
    for (const std::int64_t v : {std::int64_t{1} << 32, (std::int64_t{1} << 32) + 1, std::int64_t{-1}, std::int64_t{2}}) EXPECT_FALSE(is_listed(static_cast<wide>(v))) << v;
    EXPECT_TRUE(is_listed(wide::zero));
    EXPECT_TRUE(is_listed(wide::one));
}

TEST(names, are_found_by_value) {
    EXPECT_EQ(name_of(daisy::trigger::falling_edge), "falling_edge");
    EXPECT_EQ(name_of(gateway::order_type::cross_granted), "cross_granted");
    EXPECT_EQ(name_of(can::function::sleep), "sleep");
    EXPECT_EQ(name_of(static_cast<daisy::state>(2)), "");
    EXPECT_EQ(name_of(gateway::cart_status::none), "") << "no bit has no name";
}

TEST(names, end_in_nul_so_that_printf_takes_them) {
    EXPECT_STREQ(name_of(daisy::trigger::falling_edge).data(), "falling_edge");
    EXPECT_STREQ(name_of(static_cast<daisy::state>(2)).data(), "") << "no null pointer";
    EXPECT_STREQ(name_of(errc::bad_number).data(), "bad_number");
    EXPECT_STREQ(name_of(static_cast<errc>(errc_count)).data(), "?");
}

TEST(names, tell_whether_a_value_is_listed) {
    for (unsigned v = 0; v != 256; ++v) {
        EXPECT_EQ(is_listed(static_cast<daisy::direction>(v)), v < 2);
        EXPECT_EQ(is_listed(static_cast<gateway::cart_phase>(v)), v < 10);
        EXPECT_EQ(is_listed(static_cast<gateway::circuit_mode>(v)), v < 8);
    }
    unsigned listed = 0;
    for (unsigned v = 0; v != 0x10000; ++v) listed += is_listed(static_cast<can::function>(v)) ? 1U : 0U;
    EXPECT_EQ(listed, 5U);
    EXPECT_TRUE(is_listed(static_cast<gateway::cart_status>(0x8000))) << "any union of bits is fine";
}

TEST(names, come_in_the_order_of_their_declaration) {
    EXPECT_EQ(name_list<daisy::trigger>.size(), 4U);
    EXPECT_EQ(name_list<daisy::trigger>[3], "any_change");
    EXPECT_EQ(name_list<gateway::order_type>[0], "none");
    EXPECT_EQ(name_list<gateway::order_type>.size(), 17U);
    EXPECT_EQ(name_list<gateway::circuit_check>.size(), 22U);
}

TEST(names, of_flags_are_single_bits_lowest_first) {
    std::uint64_t bit = 1;
    for (const auto& e : names(gateway::circuit_check{})) {
        EXPECT_EQ(static_cast<std::uint64_t>(e.value), bit) << e.name;
        bit <<= 1;
    }
    bit = 1;
    for (const auto& e : names(gateway::cart_status{})) {
        EXPECT_EQ(static_cast<std::uint64_t>(e.value), bit) << e.name;
        bit <<= 1;
    }
}

}  // namespace
}  // namespace trama
