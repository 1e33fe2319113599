#pragma once
// Golden vectors of the distance sensor boards. [daisy §8]
// LEN counts what follows it: 4 and the data. CRC is the exclusive or of all bytes before it, LEN included.
#include "golden/vectors/daisy_row.hpp"

namespace trama::golden::daisy_distance_sensor {

using namespace daisy::distance_sensor;
using daisy::state, daisy::trigger;

inline constexpr table rows{
    // LEN 4+1 = 05; CRC 05^31^00^40^05 = 71
    daisy_row("distance_sensor.on_distance_sensor", octets("05 31 00 40 05 71"), 0x31, 0x00, on_distance_sensor{5}, R"({"sensor_id":5})"),
    // LEN 4+0 = 04; CRC 04^00^31^C0 = F5
    daisy_row("distance_sensor.on_distance_sensor", octets("04 00 31 C0 F5"), 0x00, 0x31, on_distance_sensor_reply{}, "{}"),
    // LEN 4+1 = 05; CRC 05^31^00^41^02 = 77
    daisy_row("distance_sensor.off_distance_sensor", octets("05 31 00 41 02 77"), 0x31, 0x00, off_distance_sensor{2}, R"({"sensor_id":2})"),
    // LEN 4+0 = 04; CRC 04^00^31^C1 = F4
    daisy_row("distance_sensor.off_distance_sensor", octets("04 00 31 C1 F4"), 0x00, 0x31, off_distance_sensor_reply{}, "{}"),
    // LEN 4+1 = 05; sensors 0, 2, 4: 1+4+16 = 15; CRC 05^31^00^42^15 = 63
    daisy_row("distance_sensor.set_distance_sensors_mask", octets("05 31 00 42 15 63"), 0x31, 0x00, set_distance_sensors_mask{0x15}, R"({"sensors":21})"),
    // LEN 4+0 = 04; CRC 04^00^31^C2 = F7
    daisy_row("distance_sensor.set_distance_sensors_mask", octets("04 00 31 C2 F7"), 0x00, 0x31, set_distance_sensors_mask_reply{}, "{}"),
    // LEN 4+0 = 04; CRC 04^32^00^43 = 75
    daisy_row("distance_sensor.get_distance_sensors_mask", octets("04 32 00 43 75"), 0x32, 0x00, get_distance_sensors_mask{}, "{}"),
    // LEN 4+1 = 05; CRC 05^00^32^C3^3F = CB
    daisy_row("distance_sensor.get_distance_sensors_mask", octets("05 00 32 C3 3F CB"), 0x00, 0x32, get_distance_sensors_mask_reply{0x3F}, R"({"sensors":63})"),

    // LEN 4+1 = 05; sensors 0, 2, 5: 1+4+20 = 25; CRC 05^32^00^44^25 = 56
    daisy_row("distance_sensor.get_value", octets("05 32 00 44 25 56"), 0x32, 0x00, get_value{0x25}, R"({"sensors":37})"),
    // Lowest bit first: sensor 0 reads 1023 = 03FF, sensor 2 reads 258 = 0102, sensor 5 (ultrasound) 30100 = 7594.
    // LEN 4+7 = 0B; 1+2*3 bytes; CRC 0B^00^32^C4^25^FF^03^02^01^94^75 = C6
    daisy_row("distance_sensor.get_value", octets("0B 00 32 C4 25 FF 03 02 01 94 75 C6"), 0x00, 0x32, get_value_reply{0x25, {1023, 258, 30100}}, R"({"sensors":37,"readings":[1023,258,30100]})"),
    // LEN 4+1 = 05; no sensor, no reading; CRC 05^00^32^C4^00 = F3
    daisy_row("distance_sensor.get_value", octets("05 00 32 C4 00 F3"), 0x00, 0x32, get_value_reply{}, R"({"sensors":0,"readings":[]})"),
    // LEN 4+13 = 11; 1+2*6 bytes, the switch is high; CRC 11^00^3E^C4^3F^01^00^02^00^03^00^04^00^05^00^FF^FF = D5
    daisy_row("distance_sensor.get_value", octets("11 00 3E C4 3F 01 00 02 00 03 00 04 00 05 00 FF FF D5"), 0x00, 0x3E, get_value_reply{0x3F, {1, 2, 3, 4, 5, 0xFFFF}}, R"({"sensors":63,"readings":[1,2,3,4,5,65535]})"),
    // LEN 4+1 = 05; sensor 3: 8; CRC 05^33^00^45^08 = 7B
    daisy_row("distance_sensor.get_one_value", octets("05 33 00 45 08 7B"), 0x33, 0x00, get_one_value{0x08}, R"({"sensors":8})"),
    // LEN 4+3 = 07; 300 = 012C; CRC 07^00^33^C5^08^2C^01 = D4
    daisy_row("distance_sensor.get_one_value", octets("07 00 33 C5 08 2C 01 D4"), 0x00, 0x33, get_one_value_reply{0x08, {300}}, R"({"sensors":8,"readings":[300]})"),
    // LEN 4+3 = 07; the switch on sensor 5 is low; CRC 07^00^33^C5^20^00^00 = D1
    daisy_row("distance_sensor.get_one_value", octets("07 00 33 C5 20 00 00 D1"), 0x00, 0x33, get_one_value_reply{0x20, {0}}, R"({"sensors":32,"readings":[0]})"),

    // LEN 4+1 = 05; CRC 05^33^00^46^02 = 72
    daisy_row("distance_sensor.alarm_on_state", octets("05 33 00 46 02 72"), 0x33, 0x00, alarm_on_state{trigger::falling_edge}, R"({"trigger":"falling_edge"})"),
    // LEN 4+1 = 05; CRC 05^33^00^46^00 = 70
    daisy_row("distance_sensor.alarm_on_state", octets("05 33 00 46 00 70"), 0x33, 0x00, alarm_on_state{trigger::none}, R"({"trigger":"none"})"),
    // LEN 4+0 = 04; CRC 04^00^33^C6 = F1
    daisy_row("distance_sensor.alarm_on_state", octets("04 00 33 C6 F1"), 0x00, 0x33, alarm_on_state_reply{}, "{}"),
    // Trigger and state are two bytes in that order [D4]; the alarm goes to the main controller [D3].
    // LEN 4+2 = 06; CRC 06^00^33^47^03^01 = 70
    daisy_row("distance_sensor.switch_alarm", octets("06 00 33 47 03 01 70"), 0x00, 0x33, switch_alarm{trigger::any_change, state::high}, R"({"trigger":"any_change","state":"high"})"),
    // LEN 4+0 = 04; CRC 04^33^00^C7 = F0
    daisy_row("distance_sensor.switch_alarm", octets("04 33 00 C7 F0"), 0x33, 0x00, switch_alarm_reply{}, "{}"),
};

}  // namespace trama::golden::daisy_distance_sensor
