"""trama decode daisy: the lines of every message, of violations and of errors."""

import unittest

from goldens import DAISY, daisy_line, daisy_packet
from tool import ToolCase, octets, packet

PING = packet("10 00 03")  # 04 10 00 03 17
POLL = packet("10 00 43")


def ping_line(offset):
    return (f'{{"protocol":"daisy","offset":{offset},"length":5,"destination":16,"source":0,'
            '"message":"common.ping","kind":"request","fields":{}}')


class Messages(ToolCase):
    def test_each_message_alone(self):
        for golden in DAISY:
            with self.subTest(golden):
                self.assertEqual(self.decode_one("daisy", daisy_packet(golden)), daisy_line(golden))

    def test_all_messages_in_one_stream_with_their_offsets(self):
        stream, expected = b"", []
        for golden in DAISY:
            expected.append(daisy_line(golden, len(stream)))
            stream += daisy_packet(golden)
        self.assertEqual(self.decode("daisy", stream), expected)

    def test_the_packet_of_the_specification(self):
        # LEN 05, CRC 05^11^00^40^01 = 55
        self.assertEqual(
            self.decode_one("daisy", octets("05 11 00 40 01 55")),
            '{"protocol":"daisy","offset":0,"length":6,"destination":17,"source":0,'
            '"message":"dc_motor.set_direction","kind":"request","fields":{"direction":"counter_clockwise"}}')

    def test_extremes_of_numbers(self):
        for data, count in (("00 00 00 80", -2147483648), ("ff ff ff 7f", 2147483647), ("00 00 00 00", 0)):
            self.assertIn(f'"fields":{{"count":{count}}}}}', self.decode_one("daisy", packet("11 00 42", octets(data))))

    def test_description_is_a_json_string(self):
        data = b'a"b\\c/' + bytes([0x00, 0x1F, 0x0A, 0x7F, 0x80, 0xFF]) + b" "
        self.assertIn('"fields":{"description":"a\\"b\\\\c/\\u0000\\u001f\\u000a\\u007f\\u0080\\u00ff "}}',
                      self.decode_one("daisy", packet("00 10 81", data)))

    def test_longest_description(self):
        self.assertEqual(
            self.decode_one("daisy", packet("00 10 81", b"x" * 251)),
            '{"protocol":"daisy","offset":0,"length":256,"destination":0,"source":16,"message":"common.init",'
            '"kind":"response","fields":{"description":"' + "x" * 251 + '"}}')

    def test_broadcast_to_everyone_is_no_violation(self):
        self.assertNotIn("violations", self.decode_one("daisy", packet("ff 00 03")))

    def test_nothing_in_nothing_out(self):
        self.assertEqual(self.decode("daisy", b""), [])


class Violations(ToolCase):
    def check(self, head, data, *violations):
        line = self.decode_one("daisy", packet(head, octets(data)), status=1)
        listed = ",".join(f'{{"field":"{f}","value":{v},"allowed":"{a}"}}' for f, v, a in violations)
        self.assertTrue(line.endswith('},"violations":[' + listed + "]}"), line)
        return line

    def test_source_that_is_a_whole_group(self):
        line = self.check("00 1f 83", "", ("source", 31, "id 0..14"))
        self.assertEqual(
            line, '{"protocol":"daisy","offset":0,"length":5,"destination":0,"source":31,"message":"common.ping",'
                  '"kind":"response","fields":{},"violations":[{"field":"source","value":31,"allowed":"id 0..14"}]}')

    def test_named_values_without_a_name(self):
        line = self.check("11 00 40", "07", ("direction", 7, "clockwise|counter_clockwise"))
        self.assertIn('"fields":{"direction":7}', line)
        self.check("20 00 4b", "00 04", ("trigger", 4, "none|rising_edge|falling_edge|any_change"))
        self.check("00 3e 47", "01 02", ("state", 2, "low|high"))

    def test_ranges(self):
        self.check("20 00 40", "05 b5", ("servo_id", 5, "0..4"), ("position", 181, "0..180"))
        self.check("20 00 41", "00 b5 00 ff 00", ("positions[1]", 181, "0..180"), ("positions[3]", 255, "0..180"))
        self.check("00 20 ca", "80", ("switches", 128, "0..127"))
        self.check("20 00 4b", "06 00", ("switch_id", 6, "0..5"))
        self.check("3e 00 40", "06", ("sensor_id", 6, "0..5"))
        self.check("3e 00 42", "40", ("sensors", 64, "0..63"))
        self.check("00 11 c8", "00 04", ("consumption", 1024, "0..1023"))
        self.check("00 40 c2", "ff ff", ("value", 65535, "0..1023"))
        self.check("50 00 42", "00 04", ("value", 1024, "0..1023"))

    def test_readings_by_sensor(self):
        # bits 4 and 5: 1024 is too much for sensor 4, 30101 for sensor 5
        self.check("00 3e c4", "30 00 04 95 75", ("readings[0]", 1024, "0..1023"),
                   ("readings[1]", 30101, "0..30100|65535"))
        # bits 6 and 7 belong to no sensor, whatever they say; the mask is too big as well
        self.check("00 3e c4", "c0 00 00 01 00", ("sensors", 192, "0..63"), ("readings[0]", 0, "no such sensor"),
                   ("readings[1]", 1, "no such sensor"))

    def test_source_comes_first(self):
        self.check("00 1f 49", "00 04", ("source", 31, "id 0..14"), ("consumption", 1024, "0..1023"))


class Errors(ToolCase):
    def test_noise_at_the_start_has_no_bytes(self):
        self.assertEqual(self.decode("daisy", octets("00 ff 13") + PING, status=1),
                         ['{"protocol":"daisy","offset":0,"length":3,"error":"noise"}', ping_line(3)])

    def test_bad_checksum(self):
        # 05 11 00 40 01: the CRC is 55 = 85, 54 = 84 came
        self.assertEqual(
            self.decode("daisy", PING + octets("05 11 00 40 01 54") + PING, status=1),
            [ping_line(0),
             '{"protocol":"daisy","offset":5,"length":6,"error":"bad_checksum","bytes":"051100400154",'
             '"expected":85,"received":84}',
             ping_line(11)])

    def test_bad_length_below_four(self):
        self.assertEqual(self.decode("daisy", PING + octets("03 07 07") + PING, status=1),
                         [ping_line(0), '{"protocol":"daisy","offset":5,"length":3,"error":"bad_length","bytes":"030707"}',
                          ping_line(8)])

    def test_bad_length_for_the_command(self):
        # set_direction has one byte of DATA, never two
        bad = packet("11 00 40", octets("01 01"))
        self.assertEqual(
            self.decode("daisy", PING + bad + PING, status=1),
            [ping_line(0), f'{{"protocol":"daisy","offset":5,"length":7,"error":"bad_length","bytes":"{bad.hex()}"}}',
             ping_line(12)])

    def test_error_0_without_a_whole_rejected_packet(self):
        bad = packet("10 00 04", octets("00 04 10 00 03 16"))  # five bytes behind the code, one too few
        self.assertIn('"error":"bad_length"', self.decode("daisy", PING + bad + PING, status=1)[1])

    def test_truncated(self):
        self.assertEqual(self.decode("daisy", PING + PING[:3], status=1),
                         [ping_line(0), '{"protocol":"daisy","offset":5,"length":3,"error":"truncated","bytes":"041000"}'])

    def test_unknown_command(self):
        # 0x5A is no command of dc_motor: 06 11 00 5a 01 02 4e; destination 17, source 0, command 90
        unknown = octets("06 11 00 5a 01 02 4e")
        self.assertEqual(
            self.decode("daisy", PING + unknown + PING, status=1),
            [ping_line(0),
             '{"protocol":"daisy","offset":5,"length":7,"error":"unknown_message","bytes":"0611005a01024e",'
             '"destination":17,"source":0,"command":90}',
             ping_line(12)])

    def test_response_to_error_is_unknown(self):
        line = self.decode("daisy", PING + packet("00 10 84"), status=1)[1]
        self.assertTrue(line.endswith('"destination":0,"source":16,"command":132}'), line)

    def test_group_without_a_family_is_unknown(self):
        line = self.decode("daisy", PING + packet("91 00 40"), status=1)[1]
        self.assertIn('"error":"unknown_message"', line)
        self.assertTrue(line.endswith('"destination":145,"source":0,"command":64}'), line)

    def test_unknown_command_while_hunting_is_noise(self):
        self.assertEqual(self.decode("daisy", packet("11 00 5a"), status=1),
                         ['{"protocol":"daisy","offset":0,"length":5,"error":"noise"}'])

    def test_at_most_256_bytes_are_shown(self):
        junk = bytes([2]) * 300
        self.assertEqual(
            self.decode("daisy", PING + junk + PING, status=1),
            [ping_line(0), f'{{"protocol":"daisy","offset":5,"length":300,"error":"bad_length","bytes":"{"02" * 256}"}}',
             ping_line(305)])

    def test_status_1_for_an_error_or_a_violation_alone(self):
        self.decode("daisy", PING + POLL, status=0)
        self.decode("daisy", PING + POLL[:2], status=1)


class Hex(ToolCase):
    def test_pairs_in_any_spacing_and_case(self):
        text = b" 05 1100\n40\t0155\r\n0410 00 03 17\n"
        self.assertEqual(self.decode("daisy", text, "--hex"),
                         self.decode("daisy", octets("05 11 00 40 01 55") + PING))
        self.assertEqual(self.decode("daisy", b"04 3E 00 03 39", "--hex"), self.decode("daisy", packet("3e 00 03")))

    def test_offsets_count_bytes(self):
        line = self.decode("daisy", PING.hex(" ").encode() + b"\n" + PING.hex(" ").encode(), "--hex")[1]
        self.assertEqual(line, ping_line(5))


if __name__ == "__main__":
    unittest.main()
