#pragma once
// Golden vectors of the servo motor boards. [daisy §7]
// LEN counts what follows it: 4 and the data. CRC is the exclusive or of all bytes before it, LEN included.
#include "golden/vectors/daisy_row.hpp"

namespace trama::golden::daisy_servo_motor {

using namespace daisy::servo_motor;
using daisy::state, daisy::trigger;

inline constexpr table rows{
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

}  // namespace trama::golden::daisy_servo_motor
