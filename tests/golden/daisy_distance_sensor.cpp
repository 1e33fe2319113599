// What the golden vectors of the distance sensor boards prove, and the limits of their fields. [daisy §8]
#include "golden/daisy_limits.hpp"
#include "golden/vectors/daisy_distance_sensor.hpp"

namespace trama::golden {
namespace {

using namespace daisy::distance_sensor;
using daisy::state, daisy::trigger;
using namespace golden::daisy_distance_sensor;

static_assert(covers<daisy::distance_sensor::messages>(rows));
static_assert(proven<rows>);

constexpr table limits{
    allowed(on_distance_sensor{0}), allowed(on_distance_sensor{5}),
    refused(on_distance_sensor{6}, broken{"sensor_id", 6, "0..5"}), refused(on_distance_sensor{255}, broken{"sensor_id", 255, "0..5"}),
    allowed(off_distance_sensor{0}), allowed(off_distance_sensor{5}),
    refused(off_distance_sensor{6}, broken{"sensor_id", 6, "0..5"}), refused(off_distance_sensor{255}, broken{"sensor_id", 255, "0..5"}),
    allowed(set_distance_sensors_mask{0}), allowed(set_distance_sensors_mask{63}),
    refused(set_distance_sensors_mask{64}, broken{"sensors", 64, "0..63"}), refused(set_distance_sensors_mask{255}, broken{"sensors", 255, "0..63"}),
    allowed(get_distance_sensors_mask_reply{0}), allowed(get_distance_sensors_mask_reply{63}),
    refused(get_distance_sensors_mask_reply{64}, broken{"sensors", 64, "0..63"}), refused(get_distance_sensors_mask_reply{255}, broken{"sensors", 255, "0..63"}),
    allowed(get_value{0}), allowed(get_value{63}),
    refused(get_value{64}, broken{"sensors", 64, "0..63"}), refused(get_value{255}, broken{"sensors", 255, "0..63"}),
    allowed(get_one_value{0}), allowed(get_one_value{63}),
    refused(get_one_value{64}, broken{"sensors", 64, "0..63"}), refused(get_one_value{255}, broken{"sensors", 255, "0..63"}),
    allowed(get_value_reply{}), allowed(get_value_reply{0x01, {0}}), allowed(get_value_reply{0x1F, {1023, 1023, 1023, 1023, 1023}}),
    refused(get_value_reply{0x01, {1024}}, broken{"readings[0]", 1024, "0..1023"}), refused(get_value_reply{0x10, {65535}}, broken{"readings[0]", 65535, "0..1023"}),
    allowed(get_value_reply{0x20, {0}}), allowed(get_value_reply{0x20, {0x7594}}), allowed(get_value_reply{0x20, {0xFFFF}}),
    refused(get_value_reply{0x20, {0x7595}}, broken{"readings[0]", 30101, "0..30100|65535"}), refused(get_value_reply{0x20, {0xFFFE}}, broken{"readings[0]", 65534, "0..30100|65535"}),
    // The position in the list names a reading, the bit says which sensor it is: here sensors 1, 3 and 5.
    refused(get_value_reply{0x2A, {1023, 1024, 30101}}, broken{"readings[1]", 1024, "0..1023"}, broken{"readings[2]", 30101, "0..30100|65535"}),
    // The count follows all eight bits; there are no sensors 6 and 7.
    refused(get_value_reply{0x40, {0}}, broken{"sensors", 64, "0..63"}, broken{"readings[0]", 0, "no such sensor"}),
    refused(get_value_reply{0xFF, {1, 2, 3, 4, 5, 6, 7, 8}}, broken{"sensors", 255, "0..63"}, broken{"readings[6]", 7, "no such sensor"}, broken{"readings[7]", 8, "no such sensor"}),
    allowed(get_one_value_reply{}), allowed(get_one_value_reply{0x01, {0}}), allowed(get_one_value_reply{0x1F, {1023, 1023, 1023, 1023, 1023}}),
    refused(get_one_value_reply{0x01, {1024}}, broken{"readings[0]", 1024, "0..1023"}), refused(get_one_value_reply{0x10, {65535}}, broken{"readings[0]", 65535, "0..1023"}),
    allowed(get_one_value_reply{0x20, {0}}), allowed(get_one_value_reply{0x20, {0x7594}}), allowed(get_one_value_reply{0x20, {0xFFFF}}),
    refused(get_one_value_reply{0x20, {0x7595}}, broken{"readings[0]", 30101, "0..30100|65535"}), refused(get_one_value_reply{0x20, {0xFFFE}}, broken{"readings[0]", 65534, "0..30100|65535"}),
    // The position in the list names a reading, the bit says which sensor it is: here sensors 1, 3 and 5.
    refused(get_one_value_reply{0x2A, {1023, 1024, 30101}}, broken{"readings[1]", 1024, "0..1023"}, broken{"readings[2]", 30101, "0..30100|65535"}),
    // The count follows all eight bits; there are no sensors 6 and 7.
    refused(get_one_value_reply{0x40, {0}}, broken{"sensors", 64, "0..63"}, broken{"readings[0]", 0, "no such sensor"}),
    refused(get_one_value_reply{0xFF, {1, 2, 3, 4, 5, 6, 7, 8}}, broken{"sensors", 255, "0..63"}, broken{"readings[6]", 7, "no such sensor"}, broken{"readings[7]", 8, "no such sensor"}),
    allowed(alarm_on_state{trigger::none}), allowed(alarm_on_state{trigger::any_change}),
    refused(alarm_on_state{static_cast<trigger>(4)}, broken{"trigger", 4, "none|rising_edge|falling_edge|any_change"}),
    allowed(switch_alarm{trigger::none, state::low}), allowed(switch_alarm{trigger::any_change, state::high}),
    refused(switch_alarm{static_cast<trigger>(4), state::low}, broken{"trigger", 4, "none|rising_edge|falling_edge|any_change"}),
    refused(switch_alarm{trigger::none, static_cast<state>(2)}, broken{"state", 2, "low|high"}),
    refused(switch_alarm{static_cast<trigger>(255), static_cast<state>(255)}, broken{"trigger", 255, "none|rising_edge|falling_edge|any_change"}, broken{"state", 255, "low|high"}),
};
static_assert(limits_proven<limits>);

TEST(daisy_distance_sensor, rows_hold) { check_rows(rows); }
TEST(daisy_distance_sensor, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(daisy_distance_sensor, one_damaged_byte_never_passes) { check_damage(rows, every_byte, never_same); }
TEST(daisy_distance_sensor, limits) { check_limits(limits); }

}  // namespace
}  // namespace trama::golden
