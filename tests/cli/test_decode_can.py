"""trama decode can: candump logs, reassembly, time-outs, violations and errors."""

import unittest

from goldens import CAN, ZEROS, can_line, can_text
from tool import ToolCase, can_log

READ = "081#020452"
READINGS = ("081#02045204006401F0", "081#02140337")


def read_line(line, number=129):
    return (f'{{"protocol":"can","line":{line},"frames":1,"id":{number},"message":"read_sensors",'
            '"fields":{"node":2,"message_id":4}}')


def error(line, frames, number, code, data, rest=""):
    return (f'{{"protocol":"can","line":{line},"frames":{frames},"id":{number},"error":"{code}",'
            f'"bytes":"{data}"{rest}}}')


def bad_line(line):
    return f'{{"protocol":"can","line":{line},"error":"bad_line"}}'


class Messages(ToolCase):
    def test_each_message_alone(self):
        for golden in CAN:
            with self.subTest(golden):
                self.assertEqual(self.decode_one("can", can_text(golden)), can_line(golden))

    def test_all_messages_in_one_log_with_their_lines(self):
        log, expected, line = b"", [], 1
        for golden in CAN:
            expected.append(can_line(golden, line))
            log += can_text(golden)
            line += len(golden[0])
        self.assertEqual(self.decode("can", log), expected)

    def test_identifiers_interleave_and_messages_come_as_they_complete(self):
        first, second = CAN[0], CAN[6]  # three frames of 081, two of which are crossed by two of 082
        other = [frame.replace("081", "082") for frame in second[0]]
        log = can_log(first[0][0], other[0], first[0][1], other[1], first[0][2])
        self.assertEqual(self.decode("can", log),
                         [can_line((other, 130, second[2], second[3]), 2), can_line(first, 1)])

    def test_foreign_frames_are_left_alone(self):
        log = can_log("123#020452", "00000081#020452", "081#R", "081#R3", "081##0020452", "083#020452", "07F#020452", READ)
        self.assertEqual(self.decode("can", log), [read_line(8)])

    def test_foreign_frames_do_not_interrupt(self):
        log = can_log(READINGS[0], "123#00", "18DAF110#0102", READINGS[1])
        self.assertEqual(self.decode("can", log), [can_line(CAN[6])])

    def test_case_carriage_returns_and_the_last_line(self):
        log = b"(1.5) vcan1 081#02045204006401f0\r\n(1.600000000) can0 081#02140337"
        self.assertEqual(self.decode("can", log), [can_line(CAN[6])])


class Reassembly(ToolCase):
    def test_interrupted_by_a_frame_of_another_length(self):
        log = can_log(READINGS[0], READ, *READINGS)
        self.assertEqual(self.decode("can", log, status=1),
                         [error(1, 1, 129, "incomplete", "02045204006401f0"), read_line(2), can_line(CAN[6], 3)])

    def test_interrupted_after_two_frames(self):
        log = can_log("081#0101464341000000", "081" + ZEROS, READ)
        self.assertEqual(self.decode("can", log, status=1),
                         [error(1, 2, 129, "incomplete", "0101464341000000" + "00" * 8), read_line(3)])

    def test_end_of_the_log(self):
        self.assertEqual(self.decode("can", can_log(READ, READINGS[0]), status=1),
                         [read_line(1), error(2, 1, 129, "truncated", "02045204006401f0")])

    def test_unknown_letter_and_impossible_lengths(self):
        log = can_log("081#02045A", "080#0204", "080#", "082#02045200", READ)
        self.assertEqual(self.decode("can", log, status=1),
                         [error(1, 1, 129, "unknown_message", "02045a"), error(2, 1, 128, "bad_length", "0204"),
                          error(3, 1, 128, "bad_length", ""), error(4, 1, 130, "bad_length", "02045200"),
                          read_line(5)])

    def test_bad_number_of_a_year(self):
        # 100 = 64 in the year's second byte, then in the century of the end
        log = can_log("080#0A0943146404010C", "080#141E")
        self.assertEqual(self.decode("can", log, status=1),
                         [error(1, 2, 128, "bad_number", "0a0943146404010c141e", ',"field":"year"')])
        for first, second, field in (("080#0A03464953640B03", "080#0D140B030F090F0A", "start.year"),
                                     ("080#0A03464953140B03", "080#0D14FF030F090F0A", "end.year")):
            line = self.decode_one("can", can_log(first, second, "080#171E050400010203"), status=1)
            self.assertTrue(line.endswith(f'"field":"{field}"}}'), line)


class TimeOuts(ToolCase):
    def two(self, gap, *options, status):
        log = b"(100.000000) can0 081#02045204006401F0\n" + f"({100 + gap:.6f}) can0 081#02140337\n".encode()
        return self.decode("can", log, *options, status=status)

    # 02 14 03 37 as a first frame: its letter would be 03
    LATE = [error(1, 1, 129, "timed_out", "02045204006401f0"), error(2, 1, 129, "unknown_message", "02140337")]

    def test_default_is_one_second(self):
        self.assertEqual(self.two(1.0, status=0), [can_line(CAN[6])])
        self.assertEqual(self.two(1.000001, status=1), self.LATE)

    def test_option(self):
        self.assertEqual(self.two(2.5, "--timeout", "2.5", status=0), [can_line(CAN[6])])
        self.assertEqual(self.two(2.500001, "--timeout", "2.5", status=1), self.LATE)
        self.assertEqual(self.two(0.000001, "--timeout", "0", status=1), self.LATE)
        self.assertEqual(self.two(0, "--timeout", "0", status=0), [can_line(CAN[6])])
        self.assertEqual(self.two(86399, "--timeout", "86400", status=0), [can_line(CAN[6])])

    def test_any_frame_moves_the_clock(self):
        log = (b"(5.0) can0 081#02045204006401F0\n(6.5) can0 7FF#00\n(6.6) can0 082#020452\n")
        self.assertEqual(self.decode("can", log, status=1),
                         [error(1, 1, 129, "timed_out", "02045204006401f0"), read_line(3, 130)])

    def test_each_frame_starts_the_time_anew(self):
        log = can_log("081#0101464341000000", "081" + ZEROS, "081" + ZEROS, step=0.9)
        self.assertEqual(self.decode("can", log), [can_line(CAN[0])])

    def test_a_clock_that_goes_back_is_no_time_out(self):
        log = b"(100.0) can0 081#02045204006401F0\n(3.0) can0 081#02140337\n"
        self.assertEqual(self.decode("can", log), [can_line(CAN[6])])


class Violations(ToolCase):
    def check(self, frames, *violations):
        line = self.decode_one("can", can_log(*frames), status=1)
        listed = ",".join(f'{{"field":"{f}","value":{v},"allowed":"{a}"}}' for f, v, a in violations)
        self.assertTrue(line.endswith('},"violations":[' + listed + "]}"), line)
        return line

    def test_message_id(self):
        self.assertEqual(
            self.check(["081#02C952"], ("message_id", 201, "0..200")),
            '{"protocol":"can","line":1,"frames":1,"id":129,"message":"read_sensors","fields":{"node":2,"message_id":201},'
            '"violations":[{"field":"message_id","value":201,"allowed":"0..200"}]}')

    def test_clock(self):
        # 20, 11, month 13, day 32, hour 24 | minute 60, second 60
        self.check(["080#0A0943140B0D2018", "080#3C3C"], ("month", 13, "1..12"), ("day", 32, "1..31"),
                   ("hour", 24, "0..23"), ("minute", 60, "0..59"), ("second", 60, "0..59"))
        self.check(["080#0A0943140B000000", "080#0000"], ("month", 0, "1..12"), ("day", 0, "1..31"))

    def test_function_without_a_name(self):
        # X = 58, Y = 59: 0x5859 = 22617
        line = self.check(["081#0101465859000000", "081" + ZEROS, "081" + ZEROS],
                          ("function", 22617, "continuous_all|continuous_specific|sleep|interval_all|interval_specific"))
        self.assertIn('"function":22617,', line)

    def test_interval_without_dates(self):
        self.check(["081#0101464941000000", "081" + ZEROS, "081" + ZEROS],
                   ("start.month", 0, "1..12"), ("start.day", 0, "1..31"),
                   ("end.month", 0, "1..12"), ("end.day", 0, "1..31"))

    def test_dates_where_none_belong(self):
        # continuous_all with start 2011-03-13 and end second 5
        self.check(["081#0101464341140B03", "081#0D00000000000000", "081#0000050000000000"],
                   ("start.year", 2011, "0"), ("start.month", 3, "0"), ("start.day", 13, "0"), ("end.second", 5, "0"))

    def test_sensor_counts(self):
        self.check(["081#0101464341000000", "081" + ZEROS, "081#0000000100000000"], ("sensor_count", 1, "0"))
        self.check(["081#0101464353000000", "081" + ZEROS, "081#0000000000000000"], ("sensor_count", 0, "1..4"))
        self.check(["081#0101464353000000", "081" + ZEROS, "081#0000000600010203"], ("sensor_count", 6, "1..4"))
        self.check(["081#0204520500000000", "081#00000000"], ("sensor_count", 5, "0..4"))

    def test_slots_past_the_count(self):
        self.check(["081#0101464353000000", "081" + ZEROS, "081#0000000200010203"],
                   ("sensors[2]", 2, "0"), ("sensors[3]", 3, "0"))
        self.check(["081#0204520100640007", "081#00000908"],
                   ("readings[1].value", 7, "0"), ("readings[3].sensor", 9, "0"), ("readings[3].value", 8, "0"))


class BadLines(ToolCase):
    def test_what_is_no_candump_line(self):
        bad = ["", "garbage", "(1.0) can0", "(1.0) can0 081", "1.0 can0 081#00", "(x) can0 081#020452", "(1.0) can0 081#02045",
               "(1.0) can0 081#0204XX", "(1.0) can0 81#020452", "(1.0) can0 081#000000000000000000", "(1.0) 081#020452",
               "(1.0) can0 0081#020452", "(1.0) can0 G81#020452", "(1.0) can0 881#020452", "(1) can0 081#020452",
               "(1.) can0 081#020452", "(.5) can0 081#020452", "(-1.0) can0 081#020452", "(1.0) can0 081#020452 x"]
        for text in bad:
            with self.subTest(text):
                log = can_log(READ) + text.encode() + b"\n" + can_log(READ)
                self.assertEqual(self.decode("can", log, status=1), [read_line(1), bad_line(2), read_line(3)])

    def test_a_bad_line_does_not_interrupt(self):
        log = can_log(READINGS[0]) + b"oops\n" + can_log(READINGS[1])
        self.assertEqual(self.decode("can", log, status=1), [bad_line(2), can_line(CAN[6])])

    def test_a_very_long_line_is_one_bad_line(self):
        log = can_log(READ) + b"(1.0) can0 081#" + b"0" * 1_000_000 + b"\n" + can_log(READ)
        self.assertEqual(self.decode("can", log, status=1), [read_line(1), bad_line(2), read_line(3)])

    def test_binary_junk(self):
        log = b"\x00\xff\x80\n" + can_log(READ)
        self.assertEqual(self.decode("can", log, status=1), [bad_line(1), read_line(2)])


if __name__ == "__main__":
    unittest.main()
