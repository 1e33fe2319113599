// What the golden vectors of the DC motor boards prove, and the limits of their fields. [daisy §6]
#include "golden/daisy_limits.hpp"
#include "golden/vectors/daisy_dc_motor.hpp"

namespace trama::golden {
namespace {

using namespace daisy::dc_motor;
using daisy::direction;
using namespace golden::daisy_dc_motor;

static_assert(covers<daisy::dc_motor::messages>(rows));
static_assert(proven<rows>);

constexpr table limits{
    allowed(set_direction{direction::clockwise}), allowed(set_direction{direction::counter_clockwise}),
    refused(set_direction{static_cast<direction>(2)}, broken{"direction", 2, "clockwise|counter_clockwise"}),
    refused(set_direction{static_cast<direction>(255)}, broken{"direction", 255, "clockwise|counter_clockwise"}),
    allowed(set_dc_speed{direction::clockwise, -32768}), allowed(set_dc_speed{direction::counter_clockwise, 32767}),
    refused(set_dc_speed{static_cast<direction>(2), -32768}, broken{"direction", 2, "clockwise|counter_clockwise"}),
    allowed(set_encoder{-2147483647 - 1}), allowed(set_encoder{2147483647}), allowed(set_encoder{0}),
    allowed(get_encoder_reply{-2147483647 - 1}), allowed(get_encoder_reply{2147483647}),
    allowed(set_encoder_to_stop{-32768}), allowed(set_encoder_to_stop{32767}),
    allowed(get_encoder_to_stop_reply{-32768}), allowed(get_encoder_to_stop_reply{32767}),
    allowed(motor_consumption_reply{0}), allowed(motor_consumption_reply{0x3FF}),
    refused(motor_consumption_reply{0x400}, broken{"consumption", 1024, "0..1023"}),
    refused(motor_consumption_reply{0xFFFF}, broken{"consumption", 65535, "0..1023"}),
    allowed(motor_stress_alarm{0}), allowed(motor_stress_alarm{0x3FF}),
    refused(motor_stress_alarm{0x400}, broken{"consumption", 1024, "0..1023"}),
    allowed(motor_shut_down_alarm{0}), allowed(motor_shut_down_alarm{0x3FF}),
    refused(motor_shut_down_alarm{0x400}, broken{"consumption", 1024, "0..1023"}),
    allowed(get_dc_speed_reply{direction::clockwise, -32768}), allowed(get_dc_speed_reply{direction::counter_clockwise, 32767}),
    refused(get_dc_speed_reply{static_cast<direction>(2), 0}, broken{"direction", 2, "clockwise|counter_clockwise"}),
};
static_assert(limits_proven<limits>);

TEST(daisy_dc_motor, rows_hold) { check_rows(rows); }
TEST(daisy_dc_motor, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(daisy_dc_motor, one_damaged_byte_never_passes) { check_damage(rows, every_byte, never_same); }
TEST(daisy_dc_motor, limits) { check_limits(limits); }

}  // namespace
}  // namespace trama::golden
