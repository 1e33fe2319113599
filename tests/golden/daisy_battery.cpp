// What the golden vectors of the battery controllers prove, and the limits of their fields. [daisy §9]
#include "golden/daisy_limits.hpp"
#include "golden/vectors/daisy_battery.hpp"

namespace trama::golden {
namespace {

using namespace daisy::battery_controller;
using namespace golden::daisy_battery;

static_assert(covers<daisy::battery_controller::messages>(rows));
static_assert(proven<rows>);

constexpr table limits{
    allowed(get_battery_value_reply{0}), allowed(get_battery_value_reply{0x3FF}),
    refused(get_battery_value_reply{0x400}, broken{"value", 1024, "0..1023"}), refused(get_battery_value_reply{0xFFFF}, broken{"value", 65535, "0..1023"}),
    allowed(set_battery_empty_value{0}), allowed(set_battery_empty_value{0x3FF}),
    refused(set_battery_empty_value{0x400}, broken{"value", 1024, "0..1023"}), refused(set_battery_empty_value{0xFFFF}, broken{"value", 65535, "0..1023"}),
    allowed(battery_empty_alarm{0}), allowed(battery_empty_alarm{0x3FF}),
    refused(battery_empty_alarm{0x400}, broken{"value", 1024, "0..1023"}), refused(battery_empty_alarm{0xFFFF}, broken{"value", 65535, "0..1023"}),
    allowed(set_full_battery_value{0}), allowed(set_full_battery_value{0x3FF}),
    refused(set_full_battery_value{0x400}, broken{"value", 1024, "0..1023"}), refused(set_full_battery_value{0xFFFF}, broken{"value", 65535, "0..1023"}),
};
static_assert(limits_proven<limits>);

TEST(daisy_battery, rows_hold) { check_rows(rows); }
TEST(daisy_battery, any_chunking_gives_the_same_events) { check_stream(rows); }
TEST(daisy_battery, one_damaged_byte_never_passes) { check_damage(rows, every_byte, never_same); }
TEST(daisy_battery, limits) { check_limits(limits); }

}  // namespace
}  // namespace trama::golden
