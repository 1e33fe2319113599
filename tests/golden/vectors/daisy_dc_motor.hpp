#pragma once
// Golden vectors of the DC motor boards. [daisy §6]
// LEN counts what follows it: 4 and the data. CRC is the exclusive or of all bytes before it, LEN included.
#include "golden/vectors/daisy_row.hpp"

namespace trama::golden::daisy_dc_motor {

using namespace daisy::dc_motor;
using daisy::direction;

inline constexpr table rows{
    // §12.1: from main controller 0:0 to board 1:1, counter-clockwise; the document prints CRC 55.
    // LEN 4+1 = 05; CRC 05^11^00^40^01 = 55
    daisy_row("dc_motor.set_direction", octets("05 11 00 40 01 55"), 0x11, 0x00, set_direction{direction::counter_clockwise}, R"({"direction":"counter_clockwise"})"),
    // LEN 4+1 = 05; 1F: every motor; CRC 05^1F^00^40^00 = 5A
    daisy_row("dc_motor.set_direction", octets("05 1F 00 40 00 5A"), 0x1F, 0x00, set_direction{direction::clockwise}, R"({"direction":"clockwise"})"),
    // LEN 4+0 = 04; CRC 04^00^11^C0 = D5
    daisy_row("dc_motor.set_direction", octets("04 00 11 C0 D5"), 0x00, 0x11, set_direction_reply{}, "{}"),

    // LEN 4+3 = 07; -1193 = 10000-04A9 = FB57, low byte first; CRC 07^11^00^41^01^57^FB = FA
    daisy_row("dc_motor.set_dc_speed", octets("07 11 00 41 01 57 FB FA"), 0x11, 0x00, set_dc_speed{direction::counter_clockwise, -1193}, R"({"direction":"counter_clockwise","speed":-1193})"),
    // LEN 4+0 = 04; CRC 04^00^11^C1 = D4
    daisy_row("dc_motor.set_dc_speed", octets("04 00 11 C1 D4"), 0x00, 0x11, set_dc_speed_reply{}, "{}"),

    // §11: 1193046 = 00123456 is sent as 56 34 12 00.
    // LEN 4+4 = 08; CRC 08^12^00^42^56^34^12^00 = 28
    daisy_row("dc_motor.set_encoder", octets("08 12 00 42 56 34 12 00 28"), 0x12, 0x00, set_encoder{1193046}, R"({"count":1193046})"),
    // LEN 4+0 = 04; CRC 04^00^12^C2 = D4
    daisy_row("dc_motor.set_encoder", octets("04 00 12 C2 D4"), 0x00, 0x12, set_encoder_reply{}, "{}"),

    // LEN 4+0 = 04; CRC 04^12^00^43 = 55
    daisy_row("dc_motor.get_encoder", octets("04 12 00 43 55"), 0x12, 0x00, get_encoder{}, "{}"),
    // LEN 4+4 = 08; -2 = FFFFFFFE; CRC 08^00^12^C3^FE^FF^FF^FF = D8
    daisy_row("dc_motor.get_encoder", octets("08 00 12 C3 FE FF FF FF D8"), 0x00, 0x12, get_encoder_reply{-2}, R"({"count":-2})"),

    // LEN 4+0 = 04; CRC 04^13^00^44 = 53
    daisy_row("dc_motor.reset_encoder", octets("04 13 00 44 53"), 0x13, 0x00, reset_encoder{}, "{}"),
    // LEN 4+0 = 04; CRC 04^00^13^C4 = D3
    daisy_row("dc_motor.reset_encoder", octets("04 00 13 C4 D3"), 0x00, 0x13, reset_encoder_reply{}, "{}"),

    // §11: 1023 = 03FF is sent as FF 03.
    // LEN 4+2 = 06; CRC 06^13^00^45^FF^03 = AC
    daisy_row("dc_motor.set_encoder_to_stop", octets("06 13 00 45 FF 03 AC"), 0x13, 0x00, set_encoder_to_stop{1023}, R"({"count":1023})"),
    // LEN 4+0 = 04; CRC 04^00^13^C5 = D2
    daisy_row("dc_motor.set_encoder_to_stop", octets("04 00 13 C5 D2"), 0x00, 0x13, set_encoder_to_stop_reply{}, "{}"),

    // LEN 4+0 = 04; CRC 04^14^00^46 = 56
    daisy_row("dc_motor.get_encoder_to_stop", octets("04 14 00 46 56"), 0x14, 0x00, get_encoder_to_stop{}, "{}"),
    // LEN 4+2 = 06; -300 = 10000-012C = FED4; CRC 06^00^14^C6^D4^FE = FE
    daisy_row("dc_motor.get_encoder_to_stop", octets("06 00 14 C6 D4 FE FE"), 0x00, 0x14, get_encoder_to_stop_reply{-300}, R"({"count":-300})"),

    // LEN 4+0 = 04; CRC 04^14^00^47 = 57
    daisy_row("dc_motor.dont_stop", octets("04 14 00 47 57"), 0x14, 0x00, dont_stop{}, "{}"),
    // LEN 4+0 = 04; CRC 04^00^14^C7 = D7
    daisy_row("dc_motor.dont_stop", octets("04 00 14 C7 D7"), 0x00, 0x14, dont_stop_reply{}, "{}"),

    // LEN 4+0 = 04; CRC 04^1E^00^48 = 52
    daisy_row("dc_motor.motor_consumption", octets("04 1E 00 48 52"), 0x1E, 0x00, motor_consumption{}, "{}"),
    // LEN 4+2 = 06; 512 = 0200; CRC 06^00^1E^C8^00^02 = D2
    daisy_row("dc_motor.motor_consumption", octets("06 00 1E C8 00 02 D2"), 0x00, 0x1E, motor_consumption_reply{512}, R"({"consumption":512})"),

    // Alarms go to the main controller, whose acknowledgement is a response from group 0: the other end's family [D3].
    // LEN 4+2 = 06; 677 = 02A5; CRC 06^00^12^49^A5^02 = FA
    daisy_row("dc_motor.motor_stress_alarm", octets("06 00 12 49 A5 02 FA"), 0x00, 0x12, motor_stress_alarm{677}, R"({"consumption":677})"),
    // LEN 4+0 = 04; CRC 04^12^00^C9 = DF
    daisy_row("dc_motor.motor_stress_alarm", octets("04 12 00 C9 DF"), 0x12, 0x00, motor_stress_alarm_reply{}, "{}"),
    // LEN 4+2 = 06; 341 = 0155; CRC 06^00^12^4A^55^01 = 0A
    daisy_row("dc_motor.motor_shut_down_alarm", octets("06 00 12 4A 55 01 0A"), 0x00, 0x12, motor_shut_down_alarm{341}, R"({"consumption":341})"),
    // LEN 4+0 = 04; CRC 04^12^00^CA = DC
    daisy_row("dc_motor.motor_shut_down_alarm", octets("04 12 00 CA DC"), 0x12, 0x00, motor_shut_down_alarm_reply{}, "{}"),

    // LEN 4+0 = 04; CRC 04^11^00^4B = 5E
    daisy_row("dc_motor.get_dc_speed", octets("04 11 00 4B 5E"), 0x11, 0x00, get_dc_speed{}, "{}"),
    // LEN 4+3 = 07; 256 = 0100; CRC 07^00^11^CB^00^00^01 = DC
    daisy_row("dc_motor.get_dc_speed", octets("07 00 11 CB 00 00 01 DC"), 0x00, 0x11, get_dc_speed_reply{direction::clockwise, 256}, R"({"direction":"clockwise","speed":256})"),
};

}  // namespace trama::golden::daisy_dc_motor
