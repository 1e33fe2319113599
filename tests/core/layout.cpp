#include "trama/core/layout.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "trama/trama.hpp"

namespace trama {
namespace {

TEST(layout, offsets_follow_from_the_sizes) {
    const auto& at = gateway::load::layout.offsets;
    EXPECT_EQ(std::vector<std::size_t>(at.begin(), at.end()), (std::vector<std::size_t>{0, 5, 10, 15, 20, 22, 32, 42, 52}));
    EXPECT_EQ(gateway::load::layout.size, 52U);
    EXPECT_TRUE(gateway::load::layout.fixed);
    EXPECT_EQ(gateway::transit_order::layout.size, 82U);
    EXPECT_EQ(can::define_function::layout.size, 24U);
}

TEST(layout, a_variable_message_has_a_largest_size) {
    EXPECT_FALSE(daisy::common::init_reply::layout.fixed);
    EXPECT_EQ(daisy::common::init_reply::layout.max_size, 251U);
    EXPECT_FALSE(daisy::common::error::layout.fixed);
    EXPECT_EQ(daisy::common::error::layout.max_size, 251U);
    EXPECT_EQ(daisy::distance_sensor::get_value_reply::layout.max_size, 17U);
    EXPECT_EQ(daisy::common::ping::layout.count, 0U);
    EXPECT_TRUE(daisy::common::ping::layout.fixed);
}

TEST(layout, for_each_field_gives_names_and_values_in_wire_order) {
    std::vector<std::string> names;
    for_each_field(gateway::go_node{1, 2, 3}, [&](std::string_view name, const auto& value) { names.push_back(std::string(name) + '=' + std::to_string(value)); });
    EXPECT_EQ(names, (std::vector<std::string>{"msg_id=1", "cart_id=2", "node=3"}));
}

TEST(layout, for_each_field_leaves_out_what_does_not_exist) {
    const auto count = [](const daisy::common::error& m) {
        int n = 0;
        for_each_field(m, [&](std::string_view, const auto&) { ++n; });
        return n;
    };
    EXPECT_EQ(count({1, {}, 0}), 1);
    EXPECT_EQ(count({0, {}, 0}), 3);
}

TEST(layout, a_field_is_found_by_its_member) {
    EXPECT_EQ((index_of<gateway::cart_state, &gateway::cart_state::orders>()), 10U);
    EXPECT_EQ((index_of<gateway::cart_state, &gateway::cart_state::msg_id>()), 0U);
    EXPECT_EQ((index_of<can::moment, &can::moment::second>()), 5U);
}

TEST(layout, every_field_has_a_name_of_its_own_and_a_meaning) {
    const auto check = []<class M>() {
        std::vector<std::string_view> names;
        each_index<M>([&]<std::size_t I>() {
            names.push_back(field_of<M, I>.name);
            EXPECT_NE((field_of<M, I>.name), "");
            EXPECT_NE((field_of<M, I>.meaning), "") << names.back();
        });
        std::sort(names.begin(), names.end());
        EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
    };
    daisy::messages::each(check);
    can::messages::each(check);
    gateway::messages::each(check);
    check.operator()<gateway::transit_order>();
    check.operator()<can::moment>();
    check.operator()<can::reading>();
}

}  // namespace
}  // namespace trama
