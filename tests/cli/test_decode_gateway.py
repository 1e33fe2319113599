"""trama decode gateway: the lines of every message, of violations and of errors."""

import unittest

from goldens import GATEWAY, ORDER_0, ORDER_1, columns, gateway_line, gateway_record
from tool import ToolCase, record

IDLE = record(" 50   12")


def idle_line(offset):
    return (f'{{"protocol":"gateway","offset":{offset},"length":10,"message":"idle_processing",'
            '"fields":{"msg_id":12}}')


def load(**changed):
    fields = {"type": (3, 1), "msg_id": (5, 1), "cart_id": (5, 2), "station_id": (5, 3), "station_type": (5, 4),
              "level": (2, 5), "options": (10, ""), "initial_inputs": (10, ""), "cargo_id": (10, "")}
    for name, content in changed.items():
        fields[name] = (fields[name][0], content)
    return record(columns(*fields.values()))


def cart_state(first=ORDER_0, second=ORDER_0, **changed):
    fields = {"type": (3, 200), "msg_id": (5, 1), "cart_id": (5, 2), "cart_status": (4, 0), "cart_phase": (1, 0),
              "ini_node": (5, 0), "rel_position": (3, 0), "end_node": (5, 0), "next_node": (5, 0),
              "speed_mms": (5, 0), "cross_confirmation_needed": (1, 0)}
    for name, content in changed.items():
        fields[name] = (fields[name][0], content)
    return record(columns(*fields.values()) + first + second)


def circuit_state(voltage="  0.0", current="  0.0", check=0, mode=0):
    return record("201    1" + voltage + current + columns((5, 0), (7, check), (1, 0), (1, mode)))


class Messages(ToolCase):
    def test_each_message_alone(self):
        for golden in GATEWAY:
            with self.subTest(golden):
                self.assertEqual(self.decode_one("gateway", gateway_record(golden)), gateway_line(golden))

    def test_all_messages_in_one_stream_with_their_offsets(self):
        stream, expected = b"", []
        for golden in GATEWAY:
            expected.append(gateway_line(golden, len(stream)))
            stream += gateway_record(golden)
        self.assertEqual(self.decode("gateway", stream), expected)

    def test_numbers_on_either_side_of_their_columns(self):
        expected = '"fields":{"msg_id":7,"cart_id":3}}'
        for payload in (" 20    7    3", "20 7    3    ", "20   7    3  ", "0200000700003", " 20 007  03  "):
            with self.subTest(payload):
                self.assertTrue(self.decode_one("gateway", record(payload)).endswith(expected))

    def test_blank_number_is_zero(self):
        self.assertIn('"fields":{"msg_id":0,"cart_id":0}}', self.decode_one("gateway", record(" 20          ")))

    def test_ack_of_idle_processing_may_leave_the_cart_blank(self):
        line = self.decode_one("gateway", record("101    1      50   12"))
        self.assertIn('"cart_id":0,"src_type":"idle_processing","src_msg_id":12}', line)

    def test_speed_may_be_negative(self):
        for content, value in (("-9999", -9999), ("   -0", 0), (" -1  ", -1), ("99999", 99999)):
            self.assertIn(f'"speed_mms":{value},', self.decode_one("gateway", cart_state(speed_mms=content)))

    def test_decimals_always_have_one_decimal(self):
        for content, value in ((" 48.2", "48.2"), ("48   ", "48.0"), ("  7.0", "7.0"), ("999.9", "999.9"),
                               ("00.5 ", "0.5"), ("     ", "0.0")):
            self.assertIn(f'"circuit_voltage":{value},', self.decode_one("gateway", circuit_state(voltage=content)))

    def test_bits_lowest_first_and_unnamed_ones_as_numbers(self):
        # cart_status 4096 + 2048 + 1: bit 12 has no name
        line = self.decode_one("gateway", cart_state(cart_status=6145))
        self.assertIn('"cart_status":["cart_error","shutdown_ready",4096]', line)
        self.assertNotIn("violations", line)
        # 4194304 = 2^22, the first without a name; 2097152 = 2^21
        line = self.decode_one("gateway", circuit_state(check=6291457))
        self.assertIn('"check":["cart_lost","all_carts_shutdown_ready",4194304]', line)

    def test_all_names_of_cart_status(self):
        self.assertIn('"cart_status":["cart_error","hook_error","warning","paused","manual_mode","maintenance",'
                      '"busy","ready","parking","loaded","house_keeping","shutdown_ready"]',
                      self.decode_one("gateway", cart_state(cart_status=4095)))

    def test_all_names_of_check(self):
        self.assertIn('"check":["cart_lost","cart_wrong_platform_version","cart_wrong_program_version",'
                      '"cart_wrong_firmware_version","cart_wrong_map","emergency_armed","door_opening",'
                      '"all_carts_no_power_frozen","cart_emergency","cart_unlocated","cart_traffic_check_failed",'
                      '"door_open","transport_interrupted","overvoltage","undervoltage","overcurrent",'
                      '"cart_wrong_powerboard_version","power_supplies_fail","battery_fault","shutting_down",'
                      '"circuit_breaker_48v","all_carts_shutdown_ready"]',
                      self.decode_one("gateway", circuit_state(check=4194303)))

    def test_all_modes_and_phases(self):
        modes = ("no_power_freezing", "no_power_frozen", "init", "manual", "semi_automatic", "automatic",
                 "shutdown_ready", "shutting_down")
        for number, name in enumerate(modes):
            self.assertIn(f'"mode":"{name}"}}}}', self.decode_one("gateway", circuit_state(mode=number)))
        phases = ("none", "go_load", "loading", "go_transit", "transiting", "transit_done", "go_unload", "unloading",
                  "go_parking", "go_node")
        for number, name in enumerate(phases):
            self.assertIn(f'"cart_phase":"{name}",', self.decode_one("gateway", cart_state(cart_phase=number)))

    def test_texts_lose_trailing_spaces_only(self):
        line = self.decode_one("gateway", load(options='  a "b" ', cargo_id="\\"))
        self.assertIn('"options":"  a \\"b\\"","initial_inputs":"","cargo_id":"\\\\"', line)


class Violations(ToolCase):
    def check(self, given, *violations):
        line = self.decode_one("gateway", given, status=1)
        listed = ",".join(f'{{"field":"{f}","value":{v},"allowed":"{a}"}}' for f, v, a in violations)
        self.assertTrue(line.endswith('},"violations":[' + listed + "]}"), line)
        return line

    def test_level_of_an_order(self):
        line = self.check(load(level=17), ("level", 17, "0..15"))
        self.assertIn('"level":17,', line)

    def test_fields_of_a_cart_state(self):
        self.check(cart_state(rel_position=101, cross_confirmation_needed=2), ("rel_position", 101, "0..100"),
                   ("cross_confirmation_needed", 2, "0..1"))

    def test_nested_fields(self):
        # level stands at 19..20 of an order: use 1, type 3, node 5, station 5 + 5
        bad = ORDER_1[:19] + "17" + ORDER_1[21:]
        self.check(cart_state(first=bad), ("orders[0].level", 17, "0..15"))
        self.check(cart_state(second=bad), ("orders[1].level", 17, "0..15"))

    def test_open_enumerations(self):
        use = "9" + ORDER_1[1:]
        self.check(cart_state(first=use), ("orders[0].use", 9, "unused|previous|current|next"))
        phase = ORDER_1[:51] + "7" + ORDER_1[52:]
        line = self.check(cart_state(second=phase),
                          ("orders[1].phase", 7, "none|go_transit|transiting|transit_done"))
        self.assertIn('"phase":7,', line)
        self.check(circuit_state(mode=8), ("mode", 8, "no_power_freezing|no_power_frozen|init|manual|semi_automatic|"
                                                      "automatic|shutdown_ready|shutting_down"))

    def test_source_types(self):
        allowed = ("load|transit|unload|go_parking|go_node|cancel_transits|send_command|send_inputs|send_cargo_id|"
                   "cross_granted|idle_processing")
        line = self.check(record("101    1    2  4    3"), ("src_type", 4, allowed))
        self.assertIn('"src_type":4,', line)
        line = self.check(record("101    1    2101    3"), ("src_type", 101, allowed))
        self.assertIn('"src_type":"ack",', line)
        line = self.check(record("101    1    2       3"), ("src_type", 0, allowed))
        self.assertIn('"src_type":"none",', line)

    def test_type_of_a_transit_order(self):
        bad = ORDER_1[0] + " 20" + ORDER_1[4:]
        line = self.check(cart_state(first=bad),
                          ("orders[0].type", 20, "none|load|transit|unload|go_parking|go_node"))
        self.assertIn('"type":"cancel_transits"', line)


class Errors(ToolCase):
    def between(self, bad, *expected):
        """The record stands between two good ones; what is printed for it is `expected`."""
        lines = self.decode("gateway", IDLE + bad + IDLE, status=1)
        self.assertEqual(lines, [idle_line(0), *expected, idle_line(10 + len(bad))])

    def error(self, bad, code, rest="", offset=10):
        return (f'{{"protocol":"gateway","offset":{offset},"length":{len(bad)},"error":"{code}",'
                f'"bytes":"{bad[:256].hex()}"{rest}}}')

    def test_noise_has_no_bytes(self):
        self.between(b"\r\nhello\x03", '{"protocol":"gateway","offset":10,"length":8,"error":"noise"}')

    def test_truncated_by_the_next_record(self):
        bad = b"\x02 10    1"
        self.between(bad, self.error(bad, "truncated"))

    def test_truncated_by_the_end(self):
        self.assertEqual(self.decode("gateway", IDLE + b"\x02 50", status=1),
                         [idle_line(0), '{"protocol":"gateway","offset":10,"length":4,"error":"truncated","bytes":"02203530"}'])

    def test_bad_length(self):
        for payload in ("", "50", " 50   1", " 50   123", "200   12"):
            bad = record(payload)
            with self.subTest(payload):
                self.between(bad, self.error(bad, "bad_length"))

    def test_overlong_record_ends_with_its_etx(self):
        bad = record("1" * 300)
        self.between(bad, self.error(bad, "bad_length"))

    def test_overlong_record_ends_before_the_next_stx(self):
        bad = b"\x02" + b"1" * 300
        self.between(bad, self.error(bad, "bad_length"))

    def test_bad_character(self):
        for payload in (" 50   1\x07", "\x80", " 50   1\n", "é"):
            bad = record(payload)
            with self.subTest(payload):
                self.between(bad, self.error(bad, "bad_character"))

    def test_bad_character_wins(self):
        for bad in (b"\x02 50\x00", b"\x02" + b"1" * 300 + b"\x00\x03", b"\x02\x00" + b"1" * 300):
            with self.subTest(bad):
                self.between(bad, self.error(bad, "bad_character"))

    def test_bad_number_names_the_field(self):
        for payload, field in ((" 20   1x    3", "msg_id"), (" 20    7  1 3", "cart_id"), (" 20    7   -3", "cart_id"),
                               ("  20   7    3", "type"), ("x20    7    3", "type"), ("   ", "type"),
                               ("   " + "1" * 10, "type"), ("1 0" + "1" * 15, "type")):
            bad = record(payload)
            with self.subTest(payload):
                if payload.startswith("  20"):  # type "  2": a transit with the wrong length
                    self.between(bad, self.error(bad, "bad_length"))
                else:
                    self.between(bad, self.error(bad, "bad_number", f',"field":"{field}"'))

    def test_bad_number_in_a_nested_field(self):
        bad = cart_state(second=ORDER_1[:19] + "1x" + ORDER_1[21:])
        self.between(bad, self.error(bad, "bad_number", ',"field":"orders[1].level"'))

    def test_bad_decimals(self):
        for content in (" .5  ", " 48. ", "48.25", "1000 ", "4 8.2", "-48.2", "+48.2"):
            bad = circuit_state(voltage=content)
            with self.subTest(content):
                self.between(bad, self.error(bad, "bad_number", ',"field":"circuit_voltage"'))

    def test_unknown_type(self):
        bad = record("210    1    3SOMETHING")
        self.between(bad, self.error(bad, "unknown_message", ',"type":210'))

    def test_unknown_type_of_any_length(self):
        for payload, number in (("999", 999), ("  0", 0), (" 4 ", 4), ("210" + "x" * 203, 210)):
            bad = record(payload)
            with self.subTest(payload):
                self.between(bad, self.error(bad, "unknown_message", f',"type":{number}'))

    def test_no_fault_costs_an_intact_record(self):
        faults = (b"\x02", b"\x02\x02\x02", b"\x03", b"junk", b"\x02 50\xff", b"\x02" + b"9" * 500)
        stream = b"".join(fault + IDLE for fault in faults)
        lines = self.decode("gateway", stream, status=1)
        self.assertEqual(sum('"message":"idle_processing"' in line for line in lines), len(faults))


class Hex(ToolCase):
    def test_hex_input(self):
        self.assertEqual(self.decode("gateway", IDLE.hex(" ").encode(), "--hex"), [idle_line(0)])


if __name__ == "__main__":
    unittest.main()
