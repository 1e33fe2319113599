#pragma once
// Golden vectors of the commands that every board has. [daisy §3]
// LEN counts what follows it: 4 and the data. CRC is the exclusive or of all bytes before it, LEN included.
#include "golden/vectors/daisy_row.hpp"

namespace trama::golden::daisy_common {

using namespace daisy::common;
using daisy::common::error;

inline constexpr auto dc_motor_text = characters("DC MOTOR");
inline constexpr auto quoted_text = characters("\"\\\t\n\r");
inline constexpr auto foreign_text = characters("B\xE9\x7F\0");
inline constexpr auto servo_text = characters("SERVO v2");
inline constexpr auto tilde_text = characters("~");
inline constexpr auto rejected_direction = octets("05 11 00 40 01 54");
inline constexpr auto rejected_ping = octets("04 11 00 03 00");
inline constexpr auto rejected_anything = octets("FF FE FD FC FB");
inline constexpr std::array<std::uint8_t, 252> long_bytes = [] {
    std::array<std::uint8_t, 252> all{};
    all.fill('x');
    return all;
}();
constexpr byte_view first(std::size_t n) { return byte_view{std::span(long_bytes).first(n)}; }

inline constexpr table rows{
    // LEN 4+0 = 04; CRC 04^11^00^01 = 14
    daisy_row("common.init", octets("04 11 00 01 14"), 0x11, 0x00, init{}, "{}"),
    // LEN 4+0 = 04; FF: every board; CRC 04^FF^00^01 = FA
    daisy_row("common.init", octets("04 FF 00 01 FA"), 0xFF, 0x00, init{}, "{}"),
    // LEN 4+0 = 04; 2F: every board of group 2; CRC 04^2F^00^01 = 2A
    daisy_row("common.init", octets("04 2F 00 01 2A"), 0x2F, 0x00, init{}, "{}"),
    // LEN 4+0 = 04; who sends a request is not judged; CRC 04^00^31^01 = 34
    daisy_row("common.init", octets("04 00 31 01 34"), 0x00, 0x31, init{}, "{}"),
    // LEN 4+0 = 04; CRC 04^53^12^01 = 44
    daisy_row("common.init", octets("04 53 12 01 44"), 0x53, 0x12, init{}, "{}"),
    // LEN 4+0 = 04; 6E: the last group and board [D2]; CRC 04^6E^0E^01 = 65
    daisy_row("common.init", octets("04 6E 0E 01 65"), 0x6E, 0x0E, init{}, "{}"),
    // LEN 4+0 = 04; CRC 04^0E^6E^01 = 65
    daisy_row("common.init", octets("04 0E 6E 01 65"), 0x0E, 0x6E, init{}, "{}"),
    // LEN 4+0 = 04; CRC 04^00^00^01 = 05
    daisy_row("common.init", octets("04 00 00 01 05"), 0x00, 0x00, init{}, "{}"),

    // LEN 4+8 = 0C; "DC MOTOR"; CRC 0C^00^11^81^44^43^20^4D^4F^54^4F^52 = F0
    daisy_row("common.init", octets("0C 00 11 81 44 43 20 4D 4F 54 4F 52 F0"), 0x00, 0x11, init_reply{byte_view{dc_motor_text}}, R"({"description":"DC MOTOR"})"),
    // LEN 4+0 = 04; an empty text; CRC 04^00^31^81 = B4
    daisy_row("common.init", octets("04 00 31 81 B4"), 0x00, 0x31, init_reply{}, R"({"description":""})"),
    // LEN 4+5 = 09; quote, backslash, tab, LF, CR; CRC 09^00^23^81^22^5C^09^0A^0D = DB
    daisy_row("common.init", octets("09 00 23 81 22 5C 09 0A 0D DB"), 0x00, 0x23, init_reply{byte_view{quoted_text}}, R"({"description":"\"\\\u0009\u000a\u000d"})"),
    // LEN 4+4 = 08; text as it comes, not plain; CRC 08^00^41^81^42^E9^7F^00 = 1C
    daisy_row("common.init", octets("08 00 41 81 42 E9 7F 00 1C"), 0x00, 0x41, init_reply{byte_view{foreign_text}}, R"({"description":"B\u00e9\u007f\u0000"})"),

    // LEN 4+0 = 04; CRC 04^21^00^02 = 27
    daisy_row("common.reset", octets("04 21 00 02 27"), 0x21, 0x00, reset{}, "{}"),
    // LEN 4+0 = 04; CRC 04^FF^0E^02 = F7
    daisy_row("common.reset", octets("04 FF 0E 02 F7"), 0xFF, 0x0E, reset{}, "{}"),
    // LEN 4+8 = 0C; "SERVO v2"; CRC 0C^00^21^82^53^45^52^56^4F^20^76^32 = 96
    daisy_row("common.reset", octets("0C 00 21 82 53 45 52 56 4F 20 76 32 96"), 0x00, 0x21, reset_reply{byte_view{servo_text}}, R"({"description":"SERVO v2"})"),
    // LEN 4+1 = 05; "~"; CRC 05^00^62^82^7E = 9B
    daisy_row("common.reset", octets("05 00 62 82 7E 9B"), 0x00, 0x62, reset_reply{byte_view{tilde_text}}, R"({"description":"~"})"),

    // LEN 4+0 = 04; CRC 04^31^00^03 = 36
    daisy_row("common.ping", octets("04 31 00 03 36"), 0x31, 0x00, ping{}, "{}"),
    // LEN 4+0 = 04; CRC 04^FF^00^03 = F8
    daisy_row("common.ping", octets("04 FF 00 03 F8"), 0xFF, 0x00, ping{}, "{}"),
    // LEN 4+0 = 04; CRC 04^00^31^83 = B6
    daisy_row("common.ping", octets("04 00 31 83 B6"), 0x00, 0x31, ping_reply{}, "{}"),
    // LEN 4+0 = 04; CRC 04^00^5E^83 = D9
    daisy_row("common.ping", octets("04 00 5E 83 D9"), 0x00, 0x5E, ping_reply{}, "{}"),

    // LEN 4+1 = 05; 01: unknown command; CRC 05^00^11^04^01 = 11
    daisy_row("common.error", octets("05 00 11 04 01 11"), 0x00, 0x11, error{1}, R"({"code":1})"),
    // LEN 4+1 = 05; other codes belong to the board; CRC 05^00^11^04^02 = 12
    daisy_row("common.error", octets("05 00 11 04 02 12"), 0x00, 0x11, error{2}, R"({"code":2})"),
    // LEN 4+1 = 05; CRC 05^11^00^04^FF = EF
    daisy_row("common.error", octets("05 11 00 04 FF EF"), 0x11, 0x00, error{255}, R"({"code":255})"),
    // Code 0: the packet of §12.1 as it was received, with CRC 54 instead of 05^11^00^40^01 = 55, then the 55.
    // LEN 4+8 = 0C; 00, six bytes, 55; CRC 0C^00^11^04^00^05^11^00^40^01^54^55 = 4D
    daisy_row("common.error", octets("0C 00 11 04 00 05 11 00 40 01 54 55 4D"), 0x00, 0x11, error{0, byte_view{rejected_direction}, 0x55}, R"({"code":0,"rejected":"051100400154","expected_crc":85})"),
    // The shortest rejected packet: a ping 04 11 00 03 whose CRC should be 04^11^00^03 = 16.
    // LEN 4+7 = 0B; 00, five bytes, 16; CRC 0B^00^11^04^00^04^11^00^03^00^16 = 1E
    daisy_row("common.error", octets("0B 00 11 04 00 04 11 00 03 00 16 1E"), 0x00, 0x11, error{0, byte_view{rejected_ping}, 0x16}, R"({"code":0,"rejected":"0411000300","expected_crc":22})"),
    // Whether the LEN inside makes sense is not judged.
    // LEN 4+7 = 0B; CRC 0B^00^11^04^00^FF^FE^FD^FC^FB^00 = E5
    daisy_row("common.error", octets("0B 00 11 04 00 FF FE FD FC FB 00 E5"), 0x00, 0x11, error{0, byte_view{rejected_anything}, 0}, R"({"code":0,"rejected":"fffefdfcfb","expected_crc":0})"),
};

}  // namespace trama::golden::daisy_common
