// Golden vectors of the servo motor boards. [daisy §7]
// LEN counts what follows it: 4 and the data. CRC is the exclusive or of all bytes before it, LEN included.
#include "golden/daisy_row.hpp"

namespace trama::golden {
namespace {

using namespace daisy::servo_motor;
using daisy::state, daisy::trigger;

constexpr std::tuple rows{
    // LEN 4+2 = 06; 90 = 5A; CRC 06^21^00^40^03^5A = 3E
    daisy_row("servo_motor.set_position", octets("06 21 00 40 03 5A 3E"), 0x21, 0x00, set_position{3, 90}, R"({"servo_id":3,"position":90})"),
    // LEN 4+0 = 04; CRC 04^00^21^C0 = E5
    daisy_row("servo_motor.set_position", octets("04 00 21 C0 E5"), 0x00, 0x21, set_position_reply{}, "{}"),
    // LEN 4+5 = 09; 45 = 2D, 90 = 5A, 135 = 87, 180 = B4; CRC 09^21^00^41^00^2D^5A^87^B4 = 2D
    daisy_row("servo_motor.set_all_positions", octets("09 21 00 41 00 2D 5A 87 B4 2D"), 0x21, 0x00, set_all_positions{{0, 45, 90, 135, 180}}, R"({"positions":[0,45,90,135,180]})"),
    // LEN 4+0 = 04; CRC 04^00^21^C1 = E4
    daisy_row("servo_motor.set_all_positions", octets("04 00 21 C1 E4"), 0x00, 0x21, set_all_positions_reply{}, "{}"),
    // LEN 4+1 = 05; CRC 05^21^00^42^04 = 62
    daisy_row("servo_motor.get_position", octets("05 21 00 42 04 62"), 0x21, 0x00, get_position{4}, R"({"servo_id":4})"),
    // LEN 4+2 = 06; 180 = B4; CRC 06^00^21^C2^04^B4 = 55
    daisy_row("servo_motor.get_position", octets("06 00 21 C2 04 B4 55"), 0x00, 0x21, get_position_reply{4, 180}, R"({"servo_id":4,"position":180})"),
    // LEN 4+0 = 04; CRC 04^22^00^43 = 65
    daisy_row("servo_motor.get_all_positions", octets("04 22 00 43 65"), 0x22, 0x00, get_all_positions{}, "{}"),
    // LEN 4+5 = 09; CRC 09^00^22^C3^01^02^03^04^05 = E9
    daisy_row("servo_motor.get_all_positions", octets("09 00 22 C3 01 02 03 04 05 E9"), 0x00, 0x22, get_all_positions_reply{{1, 2, 3, 4, 5}}, R"({"positions":[1,2,3,4,5]})"),

    // LEN 4+2 = 06; 60 = 3C; CRC 06^22^00^44^02^3C = 5E
    daisy_row("servo_motor.set_servo_speed", octets("06 22 00 44 02 3C 5E"), 0x22, 0x00, set_servo_speed{2, 60}, R"({"servo_id":2,"speed":60})"),
    // LEN 4+0 = 04; CRC 04^00^22^C4 = E2
    daisy_row("servo_motor.set_servo_speed", octets("04 00 22 C4 E2"), 0x00, 0x22, set_servo_speed_reply{}, "{}"),
    // LEN 4+5 = 09; 10 = 0A, 20 = 14, 30 = 1E, 40 = 28, 50 = 32; CRC 09^22^00^45^0A^14^1E^28^32 = 74
    daisy_row("servo_motor.set_all_speeds", octets("09 22 00 45 0A 14 1E 28 32 74"), 0x22, 0x00, set_all_speeds{{10, 20, 30, 40, 50}}, R"({"speeds":[10,20,30,40,50]})"),
    // LEN 4+0 = 04; CRC 04^00^22^C5 = E3
    daisy_row("servo_motor.set_all_speeds", octets("04 00 22 C5 E3"), 0x00, 0x22, set_all_speeds_reply{}, "{}"),
    // LEN 4+1 = 05; CRC 05^23^00^46^01 = 61
    daisy_row("servo_motor.get_servo_speed", octets("05 23 00 46 01 61"), 0x23, 0x00, get_servo_speed{1}, R"({"servo_id":1})"),
    // LEN 4+2 = 06; 120 = 78; CRC 06^00^23^C6^01^78 = 9A
    daisy_row("servo_motor.get_servo_speed", octets("06 00 23 C6 01 78 9A"), 0x00, 0x23, get_servo_speed_reply{1, 120}, R"({"servo_id":1,"speed":120})"),
    // LEN 4+0 = 04; CRC 04^23^00^47 = 60
    daisy_row("servo_motor.get_all_speeds", octets("04 23 00 47 60"), 0x23, 0x00, get_all_speeds{}, "{}"),
    // LEN 4+5 = 09; 180 = B4 and down; CRC 09^00^23^C7^B4^B3^B2^B1^B0 = 59
    daisy_row("servo_motor.get_all_speeds", octets("09 00 23 C7 B4 B3 B2 B1 B0 59"), 0x00, 0x23, get_all_speeds_reply{{180, 179, 178, 177, 176}}, R"({"speeds":[180,179,178,177,176]})"),

    // LEN 4+1 = 05; CRC 05^2E^00^48^00 = 63
    daisy_row("servo_motor.free_servo", octets("05 2E 00 48 00 63"), 0x2E, 0x00, free_servo{0}, R"({"servo_id":0})"),
    // LEN 4+0 = 04; CRC 04^00^2E^C8 = E2
    daisy_row("servo_motor.free_servo", octets("04 00 2E C8 E2"), 0x00, 0x2E, free_servo_reply{}, "{}"),
    // LEN 4+0 = 04; 2F: every servo board; CRC 04^2F^00^49 = 62
    daisy_row("servo_motor.free_all_servos", octets("04 2F 00 49 62"), 0x2F, 0x00, free_all_servos{}, "{}"),
    // LEN 4+0 = 04; CRC 04^00^2E^C9 = E3
    daisy_row("servo_motor.free_all_servos", octets("04 00 2E C9 E3"), 0x00, 0x2E, free_all_servos_reply{}, "{}"),
    // LEN 4+0 = 04; CRC 04^21^00^4A = 6F
    daisy_row("servo_motor.get_status", octets("04 21 00 4A 6F"), 0x21, 0x00, get_status{}, "{}"),
    // LEN 4+1 = 05; switches 0 and 6: 2^0+2^6 = 41; CRC 05^00^21^CA^41 = AF
    daisy_row("servo_motor.get_status", octets("05 00 21 CA 41 AF"), 0x00, 0x21, get_status_reply{0x41}, R"({"switches":65})"),
    // LEN 4+2 = 06; CRC 06^21^00^4B^05^03 = 6A
    daisy_row("servo_motor.alarm_on_state", octets("06 21 00 4B 05 03 6A"), 0x21, 0x00, alarm_on_state{5, trigger::any_change}, R"({"switch_id":5,"trigger":"any_change"})"),
    // LEN 4+0 = 04; CRC 04^00^21^CB = EE
    daisy_row("servo_motor.alarm_on_state", octets("04 00 21 CB EE"), 0x00, 0x21, alarm_on_state_reply{}, "{}"),
    // Trigger and state are two bytes in that order [D4]; the alarm goes to the main controller [D3].
    // LEN 4+3 = 07; CRC 07^00^21^4C^02^01^01 = 68
    daisy_row("servo_motor.switch_alarm", octets("07 00 21 4C 02 01 01 68"), 0x00, 0x21, switch_alarm{2, trigger::rising_edge, state::high}, R"({"switch_id":2,"trigger":"rising_edge","state":"high"})"),
    // LEN 4+3 = 07; CRC 07^00^21^4C^03^02^00 = 6B
    daisy_row("servo_motor.switch_alarm", octets("07 00 21 4C 03 02 00 6B"), 0x00, 0x21, switch_alarm{3, trigger::falling_edge, state::low}, R"({"switch_id":3,"trigger":"falling_edge","state":"low"})"),
    // LEN 4+0 = 04; CRC 04^21^00^CC = E9
    daisy_row("servo_motor.switch_alarm", octets("04 21 00 CC E9"), 0x21, 0x00, switch_alarm_reply{}, "{}"),
};
static_assert(covers<daisy::servo_motor::messages>(rows));
static_assert(proven<rows>);

constexpr std::tuple limits{
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
