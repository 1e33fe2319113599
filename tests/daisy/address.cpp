#include "trama/daisy/address.hpp"

#include <gtest/gtest.h>

#include "trama/daisy/catalogue.hpp"

namespace trama::daisy {
namespace {

TEST(daisy_address, is_group_and_board) {
    EXPECT_EQ(board(1, 1).octet, 0x11);
    EXPECT_EQ(board(6, 2).group(), 6U);
    EXPECT_EQ(board(6, 2).id(), 2U);
    EXPECT_FALSE(board(6, 14).broadcast());
    EXPECT_TRUE(board(6, 15).broadcast());
    EXPECT_TRUE(everyone.broadcast());
}

TEST(daisy_address, group_6_is_a_second_battery_group_D2) {
    constexpr std::array right{family::main_controller, family::dc_motor, family::servo_motor, family::distance_sensor, family::battery_controller, family::trash_bin, family::battery_controller};
    for (unsigned group = 0; group != 16; ++group) EXPECT_EQ(family_of(group), group < right.size() ? right[group] : family::none) << group;
}

TEST(daisy_address, the_family_comes_from_destination_of_requests_and_source_of_responses_D3) {
    const envelope to_motor{board(1, 1), board(2, 1)}, from_motor{board(2, 1), board(1, 1)};
    EXPECT_EQ(family_of(to_motor, 0x43), family::dc_motor);
    EXPECT_EQ(family_of(to_motor, 0xC3), family::servo_motor);
    EXPECT_EQ(family_of(from_motor, 0xC3), family::dc_motor);
    EXPECT_EQ(family_of(from_motor, 0x03), family::common);
    EXPECT_EQ(family_of(from_motor, 0x83), family::common);
}

TEST(daisy_address, where_that_is_the_main_controller_the_other_end_decides_D3) {
    const envelope alarm{board(0, 0), board(6, 2)}, confirmation{board(6, 2), board(0, 0)}, between_controllers{board(0, 0), board(0, 1)};
    EXPECT_EQ(family_of(alarm, 0x45), family::battery_controller);
    EXPECT_EQ(family_of(confirmation, 0xC5), family::battery_controller);
    EXPECT_EQ(family_of(between_controllers, 0x45), family::main_controller);
    EXPECT_EQ(family_of({board(9, 0), board(1, 0)}, 0x45), family::none);
}

TEST(daisy_address, a_key_is_family_and_command) {
    const key k = key_of(family::trash_bin, 0xC0);
    EXPECT_EQ(family_of(k), family::trash_bin);
    EXPECT_EQ(command_of(k), 0xC0);
}

TEST(daisy_address, documented_addresses_are_groups_0_to_6_and_everyone_for_common_commands) {
    for (unsigned destination = 0; destination != 256; ++destination)
        for (unsigned source = 0; source != 256; ++source) {
            const bool groups = destination < 0x70 && source < 0x70;
            EXPECT_EQ(documented_addresses(destination, source, 0x43), groups);
            EXPECT_EQ(documented_addresses(destination, source, 0xC3), groups);
            EXPECT_EQ(documented_addresses(destination, source, 0x03), groups || (destination == 0xFF && source < 0x70));
            EXPECT_EQ(documented_addresses(destination, source, 0x83), groups || (destination == 0xFF && source < 0x70));
        }
}

}  // namespace
}  // namespace trama::daisy
