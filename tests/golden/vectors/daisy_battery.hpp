#pragma once
// Golden vectors of the battery controllers. [daisy §9]
// LEN counts what follows it: 4 and the data. CRC is the exclusive or of all bytes before it, LEN included.
#include "golden/vectors/daisy_row.hpp"

namespace trama::golden::daisy_battery {

using namespace daisy::battery_controller;

inline constexpr table rows{
    // LEN 4+0 = 04; CRC 04^41^00^40 = 05
    daisy_row("battery_controller.enable", octets("04 41 00 40 05"), 0x41, 0x00, enable{}, "{}"),
    // LEN 4+0 = 04; CRC 04^00^41^C0 = 85
    daisy_row("battery_controller.enable", octets("04 00 41 C0 85"), 0x00, 0x41, enable_reply{}, "{}"),
    // LEN 4+0 = 04; CRC 04^41^00^41 = 04
    daisy_row("battery_controller.disable", octets("04 41 00 41 04"), 0x41, 0x00, disable{}, "{}"),
    // LEN 4+0 = 04; CRC 04^00^41^C1 = 84
    daisy_row("battery_controller.disable", octets("04 00 41 C1 84"), 0x00, 0x41, disable_reply{}, "{}"),
    // LEN 4+0 = 04; 4F: every battery; CRC 04^4F^00^42 = 09
    daisy_row("battery_controller.get_battery_value", octets("04 4F 00 42 09"), 0x4F, 0x00, get_battery_value{}, "{}"),
    // LEN 4+2 = 06; 769 = 0301; CRC 06^00^41^C2^01^03 = 87
    daisy_row("battery_controller.get_battery_value", octets("06 00 41 C2 01 03 87"), 0x00, 0x41, get_battery_value_reply{769}, R"({"value":769})"),
    // LEN 4+0 = 04; CRC 04^00^41^43 = 06
    daisy_row("battery_controller.battery_full_alarm", octets("04 00 41 43 06"), 0x00, 0x41, battery_full_alarm{}, "{}"),
    // LEN 4+0 = 04; CRC 04^41^00^C3 = 86
    daisy_row("battery_controller.battery_full_alarm", octets("04 41 00 C3 86"), 0x41, 0x00, battery_full_alarm_reply{}, "{}"),
    // LEN 4+2 = 06; 400 = 0190; CRC 06^42^00^44^90^01 = 91
    daisy_row("battery_controller.set_battery_empty_value", octets("06 42 00 44 90 01 91"), 0x42, 0x00, set_battery_empty_value{400}, R"({"value":400})"),
    // LEN 4+0 = 04; CRC 04^00^42^C4 = 82
    daisy_row("battery_controller.set_battery_empty_value", octets("04 00 42 C4 82"), 0x00, 0x42, set_battery_empty_value_reply{}, "{}"),
    // §12.2: from board 6:2 to main controller 0:0, critical value 036B; the document prints CRC 49. Group 6 is [D2].
    // LEN 4+2 = 06; 036B = 875; CRC 06^00^62^45^6B^03 = 49
    daisy_row("battery_controller.battery_empty_alarm", octets("06 00 62 45 6B 03 49"), 0x00, 0x62, battery_empty_alarm{0x036B}, R"({"value":875})"),
    // LEN 4+2 = 06; the same from group 4; CRC 06^00^42^45^6B^03 = 69
    daisy_row("battery_controller.battery_empty_alarm", octets("06 00 42 45 6B 03 69"), 0x00, 0x42, battery_empty_alarm{0x036B}, R"({"value":875})"),
    // LEN 4+0 = 04; CRC 04^62^00^C5 = A3
    daisy_row("battery_controller.battery_empty_alarm", octets("04 62 00 C5 A3"), 0x62, 0x00, battery_empty_alarm_reply{}, "{}"),
    // LEN 4+2 = 06; 950 = 03B6; CRC 06^62^00^46^B6^03 = 97
    daisy_row("battery_controller.set_full_battery_value", octets("06 62 00 46 B6 03 97"), 0x62, 0x00, set_full_battery_value{950}, R"({"value":950})"),
    // LEN 4+0 = 04; CRC 04^00^62^C6 = A0
    daisy_row("battery_controller.set_full_battery_value", octets("04 00 62 C6 A0"), 0x00, 0x62, set_full_battery_value_reply{}, "{}"),
};

}  // namespace trama::golden::daisy_battery
