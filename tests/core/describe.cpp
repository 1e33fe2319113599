#include "trama/core/describe.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "trama/daisy/format.hpp"
#include "trama/gateway/format.hpp"

namespace trama {
namespace {

template <has_layout M>
std::map<std::string, layout_row> rows_of() {
    std::map<std::string, layout_row> rows;
    for_each_row<M>([&](const layout_row& row) { rows[std::string(row.name)] = row; });
    return rows;
}

TEST(describe, a_field_behind_one_of_varying_size_counts_from_the_end) {
    const auto rows = rows_of<daisy::common::error>();
    EXPECT_EQ(rows.at("code").offset, 0U);
    EXPECT_EQ(rows.at("rejected").offset, 1U);
    EXPECT_EQ(rows.at("rejected").size, 0U);
    EXPECT_FALSE(rows.at("rejected").from_end);
    EXPECT_EQ(rows.at("expected_crc").offset, 1U);
    EXPECT_TRUE(rows.at("expected_crc").from_end);
}

TEST(describe, what_is_allowed_is_the_rule_the_names_or_what_the_wire_carries) {
    const auto load = rows_of<gateway::load>();
    ASSERT_NE(load.at("level").allowed, nullptr);
    EXPECT_EQ(load.at("level").allowed->high, 15) << "the field's own rule";
    EXPECT_EQ(load.at("cart_id").allowed->high, 99999) << "five columns";
    EXPECT_EQ(load.at("options").allowed, nullptr) << "any text";
    const auto speed = rows_of<daisy::dc_motor::set_dc_speed>();
    EXPECT_EQ(speed.at("direction").allowed->names.size(), 2U);
    const auto circuit = rows_of<gateway::circuit_state>();
    EXPECT_EQ(circuit.at("circuit_voltage").allowed->words, "0.0..999.9");
    EXPECT_EQ(circuit.at("check").allowed, nullptr) << "any flags";
    EXPECT_EQ(circuit.at("check").flags.size(), 22U);
}

TEST(describe, a_row_says_nothing_before_it_is_filled) {
    const layout_row row{};
    EXPECT_FALSE(row.optional);
    EXPECT_FALSE(row.from_end);
    EXPECT_EQ(row.count, 1U) << "no array";
    EXPECT_EQ(row.allowed, nullptr);
    EXPECT_EQ(row.constant, '\0');
    EXPECT_TRUE(row.flags.empty());
}

TEST(describe, all_others_count_from_the_first_field) {
    daisy::messages::each([]<class M>() {
        if constexpr (M::layout.fixed) {
            std::size_t at = 0;
            for_each_row<M>([&](const layout_row& row) {
                EXPECT_FALSE(row.from_end) << M::name;
                EXPECT_EQ(row.offset, at) << M::name << ' ' << row.name;
                at += row.size * row.count;
            });
            EXPECT_EQ(at, M::layout.size);
        }
    });
}

}  // namespace
}  // namespace trama
