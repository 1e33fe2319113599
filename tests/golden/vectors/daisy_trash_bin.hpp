#pragma once
// Golden vectors of the trash bin boards. [daisy §10]
// LEN counts what follows it: 4 and the data. CRC is the exclusive or of all bytes before it, LEN included.
#include "golden/vectors/daisy_row.hpp"

namespace trama::golden::daisy_trash_bin {

using namespace daisy::trash_bin;

inline constexpr table rows{
    // LEN 4+0 = 04; CRC 04^51^00^40 = 15
    daisy_row("trash_bin.get_trash_bin_value", octets("04 51 00 40 15"), 0x51, 0x00, get_trash_bin_value{}, "{}"),
    // LEN 4+2 = 06; 567 = 0237; CRC 06^00^51^C0^37^02 = A2
    daisy_row("trash_bin.get_trash_bin_value", octets("06 00 51 C0 37 02 A2"), 0x00, 0x51, get_trash_bin_value_reply{567}, R"({"value":567})"),
    // LEN 4+0 = 04; CRC 04^00^51^41 = 14
    daisy_row("trash_bin.bin_full_alarm", octets("04 00 51 41 14"), 0x00, 0x51, bin_full_alarm{}, "{}"),
    // LEN 4+0 = 04; CRC 04^51^00^C1 = 94
    daisy_row("trash_bin.bin_full_alarm", octets("04 51 00 C1 94"), 0x51, 0x00, bin_full_alarm_reply{}, "{}"),
    // LEN 4+2 = 06; 900 = 0384; 5F: every bin; CRC 06^5F^00^42^84^03 = 9C
    daisy_row("trash_bin.set_full_bin_value", octets("06 5F 00 42 84 03 9C"), 0x5F, 0x00, set_full_bin_value{900}, R"({"value":900})"),
    // LEN 4+0 = 04; CRC 04^00^51^C2 = 97
    daisy_row("trash_bin.set_full_bin_value", octets("04 00 51 C2 97"), 0x00, 0x51, set_full_bin_value_reply{}, "{}"),
};

}  // namespace trama::golden::daisy_trash_bin
