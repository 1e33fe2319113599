// What the golden vectors of the servo motor boards prove, and the limits of their fields. [daisy §7]
#include "golden/daisy_limits.hpp"
#include "golden/vectors/daisy_servo_motor.hpp"

namespace trama::golden {
namespace {

using namespace daisy::servo_motor;
using daisy::state, daisy::trigger;
using namespace golden::daisy_servo_motor;

static_assert(covers<daisy::servo_motor::messages>(rows));
static_assert(proven<rows>);

constexpr table limits{
    allowed(set_position{0, 0}), allowed(set_position{4, 180}),
    refused(set_position{5, 0}, broken{"servo_id", 5, "0..4"}), refused(set_position{0, 181}, broken{"position", 181, "0..180"}),
    refused(set_position{255, 255}, broken{"servo_id", 255, "0..4"}, broken{"position", 255, "0..180"}),
    allowed(set_all_positions{{0, 0, 0, 0, 0}}), allowed(set_all_positions{{180, 180, 180, 180, 180}}),
    refused(set_all_positions{{181, 0, 0, 0, 0}}, broken{"positions[0]", 181, "0..180"}),
    refused(set_all_positions{{0, 181, 0, 0, 0}}, broken{"positions[1]", 181, "0..180"}),
    refused(set_all_positions{{0, 0, 181, 0, 0}}, broken{"positions[2]", 181, "0..180"}),
    refused(set_all_positions{{0, 0, 0, 181, 0}}, broken{"positions[3]", 181, "0..180"}),
    refused(set_all_positions{{0, 0, 0, 0, 181}}, broken{"positions[4]", 181, "0..180"}),
    refused(set_all_positions{{255, 180, 181, 0, 200}}, broken{"positions[0]", 255, "0..180"}, broken{"positions[2]", 181, "0..180"}, broken{"positions[4]", 200, "0..180"}),
    allowed(get_position{0}), allowed(get_position{4}),
    refused(get_position{5}, broken{"servo_id", 5, "0..4"}), refused(get_position{255}, broken{"servo_id", 255, "0..4"}),
    allowed(get_position_reply{0, 0}), allowed(get_position_reply{4, 180}),
    refused(get_position_reply{5, 0}, broken{"servo_id", 5, "0..4"}), refused(get_position_reply{0, 181}, broken{"position", 181, "0..180"}),
    refused(get_position_reply{255, 255}, broken{"servo_id", 255, "0..4"}, broken{"position", 255, "0..180"}),
    allowed(get_all_positions_reply{{0, 0, 0, 0, 0}}), allowed(get_all_positions_reply{{180, 180, 180, 180, 180}}),
    refused(get_all_positions_reply{{181, 0, 0, 0, 0}}, broken{"positions[0]", 181, "0..180"}),
    refused(get_all_positions_reply{{0, 181, 0, 0, 0}}, broken{"positions[1]", 181, "0..180"}),
    refused(get_all_positions_reply{{0, 0, 181, 0, 0}}, broken{"positions[2]", 181, "0..180"}),
    refused(get_all_positions_reply{{0, 0, 0, 181, 0}}, broken{"positions[3]", 181, "0..180"}),
    refused(get_all_positions_reply{{0, 0, 0, 0, 181}}, broken{"positions[4]", 181, "0..180"}),
    refused(get_all_positions_reply{{255, 180, 181, 0, 200}}, broken{"positions[0]", 255, "0..180"}, broken{"positions[2]", 181, "0..180"}, broken{"positions[4]", 200, "0..180"}),
    allowed(set_servo_speed{0, 0}), allowed(set_servo_speed{4, 180}),
    refused(set_servo_speed{5, 0}, broken{"servo_id", 5, "0..4"}), refused(set_servo_speed{0, 181}, broken{"speed", 181, "0..180"}),
    refused(set_servo_speed{255, 255}, broken{"servo_id", 255, "0..4"}, broken{"speed", 255, "0..180"}),
    allowed(set_all_speeds{{0, 0, 0, 0, 0}}), allowed(set_all_speeds{{180, 180, 180, 180, 180}}),
    refused(set_all_speeds{{181, 0, 0, 0, 0}}, broken{"speeds[0]", 181, "0..180"}),
    refused(set_all_speeds{{0, 181, 0, 0, 0}}, broken{"speeds[1]", 181, "0..180"}),
    refused(set_all_speeds{{0, 0, 181, 0, 0}}, broken{"speeds[2]", 181, "0..180"}),
    refused(set_all_speeds{{0, 0, 0, 181, 0}}, broken{"speeds[3]", 181, "0..180"}),
    refused(set_all_speeds{{0, 0, 0, 0, 181}}, broken{"speeds[4]", 181, "0..180"}),
    refused(set_all_speeds{{255, 180, 181, 0, 200}}, broken{"speeds[0]", 255, "0..180"}, broken{"speeds[2]", 181, "0..180"}, broken{"speeds[4]", 200, "0..180"}),
    allowed(get_servo_speed{0}), allowed(get_servo_speed{4}),
    refused(get_servo_speed{5}, broken{"servo_id", 5, "0..4"}), refused(get_servo_speed{255}, broken{"servo_id", 255, "0..4"}),
    allowed(get_servo_speed_reply{0, 0}), allowed(get_servo_speed_reply{4, 180}),
    refused(get_servo_speed_reply{5, 0}, broken{"servo_id", 5, "0..4"}), refused(get_servo_speed_reply{0, 181}, broken{"speed", 181, "0..180"}),
    refused(get_servo_speed_reply{255, 255}, broken{"servo_id", 255, "0..4"}, broken{"speed", 255, "0..180"}),
    allowed(get_all_speeds_reply{{0, 0, 0, 0, 0}}), allowed(get_all_speeds_reply{{180, 180, 180, 180, 180}}),
    refused(get_all_speeds_reply{{181, 0, 0, 0, 0}}, broken{"speeds[0]", 181, "0..180"}),
    refused(get_all_speeds_reply{{0, 181, 0, 0, 0}}, broken{"speeds[1]", 181, "0..180"}),
    refused(get_all_speeds_reply{{0, 0, 181, 0, 0}}, broken{"speeds[2]", 181, "0..180"}),
    refused(get_all_speeds_reply{{0, 0, 0, 181, 0}}, broken{"speeds[3]", 181, "0..180"}),
    refused(get_all_speeds_reply{{0, 0, 0, 0, 181}}, broken{"speeds[4]", 181, "0..180"}),
    refused(get_all_speeds_reply{{255, 180, 181, 0, 200}}, broken{"speeds[0]", 255, "0..180"}, broken{"speeds[2]", 181, "0..180"}, broken{"speeds[4]", 200, "0..180"}),
    allowed(free_servo{0}), allowed(free_servo{4}),
    refused(free_servo{5}, broken{"servo_id", 5, "0..4"}), refused(free_servo{255}, broken{"servo_id", 255, "0..4"}),
    allowed(get_status_reply{0}), allowed(get_status_reply{127}),
    refused(get_status_reply{128}, broken{"switches", 128, "0..127"}), refused(get_status_reply{255}, broken{"switches", 255, "0..127"}),
    allowed(alarm_on_state{0, trigger::none}), allowed(alarm_on_state{5, trigger::any_change}),
    refused(alarm_on_state{6, trigger::none}, broken{"switch_id", 6, "0..5"}),
    refused(alarm_on_state{0, static_cast<trigger>(4)}, broken{"trigger", 4, "none|rising_edge|falling_edge|any_change"}),
    allowed(switch_alarm{0, trigger::none, state::low}), allowed(switch_alarm{5, trigger::any_change, state::high}),
    refused(switch_alarm{6, trigger::none, state::low}, broken{"switch_id", 6, "0..5"}),
    refused(switch_alarm{0, static_cast<trigger>(4), state::low}, broken{"trigger", 4, "none|rising_edge|falling_edge|any_change"}),
    refused(switch_alarm{0, trigger::none, static_cast<state>(2)}, broken{"state", 2, "low|high"}),
    refused(switch_alarm{255, static_cast<trigger>(255), static_cast<state>(255)}, broken{"switch_id", 255, "0..5"}, broken{"trigger", 255, "none|rising_edge|falling_edge|any_change"}, broken{"state", 255, "low|high"}),
};
static_assert(limits_proven<limits>);

TEST(daisy_servo_motor, rows_hold) { check_rows(rows); }
TEST(daisy_servo_motor, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(daisy_servo_motor, one_damaged_byte_never_passes) { check_damage(rows, every_byte, never_same); }
TEST(daisy_servo_motor, limits) { check_limits(limits); }

}  // namespace
}  // namespace trama::golden
