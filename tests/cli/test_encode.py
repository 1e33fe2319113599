"""trama encode: JSON lines to bytes and log lines, defaults, what it refuses and how it says so."""

import json
import resource
import unittest

from goldens import (CAN, DAISY, GATEWAY, ORDER_0, ORDER_1, ZEROS, can_line, can_text, columns, daisy_line, daisy_packet,
                     gateway_line, gateway_record)
from tool import ToolCase, can_log, octets, packet, record, trama


def daisy(message="common.ping", destination=16, source=0, kind="request", **fields):
    return {"protocol": "daisy", "destination": destination, "source": source, "message": message, "kind": kind,
            "fields": fields}


def can(message="read_sensors", number=129, **fields):
    return {"protocol": "can", "id": number, "message": message, "fields": fields}


def gateway(message="idle_processing", **fields):
    return {"protocol": "gateway", "message": message, "fields": fields}


class Messages(ToolCase):
    def test_every_daisy_message(self):
        for golden in DAISY:
            with self.subTest(golden):
                self.assertEqual(self.encode("daisy", daisy_line(golden))[0], daisy_packet(golden))

    def test_every_can_message(self):
        for golden in CAN:
            with self.subTest(golden):
                self.assertEqual(self.encode("can", can_line(golden))[0], can_text(golden))

    def test_every_gateway_message(self):
        for golden in GATEWAY:
            with self.subTest(golden):
                self.assertEqual(self.encode("gateway", gateway_line(golden))[0], gateway_record(golden))

    def test_can_lines_as_the_specification_shows_them(self):
        self.assertEqual(self.encode("can", can_line(CAN[0]))[0],
                         b"(0.000000) can0 081#0101464341000000\n" + b"(0.000000) can0 081#0000000000000000\n" * 2)

    def test_hex_output(self):
        out, _ = self.encode("daisy", daisy(), daisy("dc_motor.set_direction", 17, direction=1), options=["--hex"])
        self.assertEqual(out, b"04 10 00 03 17\n05 11 00 40 01 55\n")
        out, _ = self.encode("gateway", gateway(msg_id=12), options=["--hex"])
        self.assertEqual(out, b"02 20 35 30 20 20 20 31 32 03\n")

    def test_spaces_order_and_escapes_do_not_matter(self):
        line = ' { "fields" : { "direction" : "counter\\u005fclockwise" } , "kind":"request",\t"source":0 ,"destination":17,' \
               '"message" : "dc_motor.set_direction" } '
        self.assertEqual(self.encode("daisy", line)[0], octets("05 11 00 40 01 55"))

    def test_a_missing_kind_is_a_request(self):
        self.assertEqual(self.encode("daisy", '{"destination":16,"source":0,"message":"common.ping"}')[0], octets("04 10 00 03 17"))

    def test_what_is_ignored_may_hold_any_character(self):
        for ignored in ('{"\\u800d":1}', '"\\ud823"', '"\\ud83d\\ude00"', '"\U0001f600"', '{"\\u0161":1,"a":2}', '{"\\u00c4\\u0080":1,"\\u0100":2}'):
            with self.subTest(ignored):
                self.assertEqual(self.encode("daisy", '{"destination":16,"source":0,"message":"common.ping","violations":' + ignored + "}")[0],
                                 octets("04 10 00 03 17"))

    def test_a_name_with_another_character_is_another_name(self):
        # U+0170 and U+0173 end in the octets of "p" and "s".
        for line, told in (('{"destination":16,"source":0,"message":"common.\\u0170ing"}', "common.\u0170ing"),
                           ('{"destination":16,"\\u0173ource":0,"message":"common.ping"}', "\u0173ource"),
                           ('{"destination":16,"source":0,"message":"common.ping","kind":"reque\\u0173t"}', "kind"),
                           ('{"destination":16,"source":0,"message":"common.ping","\\u0170rotocol":"daisy"}', "\u0170rotocol"),
                           ('{"destination":17,"source":0,"message":"dc_motor.set_direction","fields":{"direction":"clockwi\\u0173e"}}', "clockwi\u0173e"),
                           ('{"destination":17,"source":0,"message":"dc_motor.set_direction","fields":{"direction\\u0100":1}}', "direction\u0100")):
            with self.subTest(told):
                run = trama("encode", "daisy", given=line.encode())
                self.assertEqual((run.status, run.out), (1, b""))
                self.assertIn(told, run.err)

    def test_one_name_in_two_spellings_stands_twice(self):
        run = trama("encode", "daisy", given='{"destination":16,"source":0,"message":"common.ping","violations":{"\U0001f600":1,"\\ud83d\\ude00":2}}'.encode())
        self.assertEqual((run.status, run.out), (1, b""))
        self.assertIn("stands twice", run.err)

    def test_broken_utf_8(self):
        for broken in (b"\xc0\x80", b"\xe0\x9f\xbf", b"\xed\xa0\x80", b"\xf0\x8f\xbf\xbf", b"\xf4\x90\x80\x80", b"\xf5\x80\x80\x80", b"\x80", b"\xc3", b"\xe2\x82"):
            with self.subTest(broken):
                run = trama("encode", "daisy", given=b'{"destination":16,"source":0,"message":"common.ping","violations":"' + broken + b'"}')
                self.assertEqual((run.status, run.out), (1, b""))
                self.assertIn("UTF-8", run.err)

    def test_last_line_without_its_end(self):
        run = trama("encode", "gateway", given=b'{"message":"idle_processing","fields":{"msg_id":12}}')
        self.assertEqual((run.status, run.out), (0, record(" 50   12")))

    def test_carriage_returns(self):
        run = trama("encode", "gateway", given=b'{"message":"idle_processing","fields":{"msg_id":12}}\r\n' * 2)
        self.assertEqual((run.status, run.out), (0, record(" 50   12") * 2))

    def test_nothing_in_nothing_out(self):
        for protocol in ("daisy", "can", "gateway"):
            self.assertEqual(self.encode(protocol), (b"", ""))


class Ignored(ToolCase):
    def test_places_and_violations(self):
        line = {**daisy(), "offset": 99, "length": 1, "line": 1, "frames": 2, "violations": [{"field": "x", "value": 1, "allowed": "0"}]}
        self.assertEqual(self.encode("daisy", line)[0], packet("10 00 03"))
        line = {**gateway(msg_id=12), "offset": 99, "length": 1, "violations": []}
        self.assertEqual(self.encode("gateway", line)[0], record(" 50   12"))
        line = {**can(node=2, message_id=4), "line": 99, "frames": 3, "offset": 0, "length": 1, "violations": []}
        self.assertEqual(self.encode("can", line)[0], can_log("081#020452"))


class Defaults(ToolCase):
    def test_no_fields_at_all(self):
        line = daisy("dc_motor.set_dc_speed")
        del line["fields"]
        for each in (line, daisy("dc_motor.set_dc_speed")):
            self.assertEqual(self.encode("daisy", each)[0], packet("10 00 41", bytes(3)))

    def test_some_fields(self):
        self.assertEqual(self.encode("daisy", daisy("dc_motor.set_dc_speed", speed=-1))[0],
                         packet("10 00 41", octets("00 ff ff")))
        self.assertEqual(self.encode("daisy", daisy("servo_motor.set_all_positions", 32))[0],
                         packet("20 00 41", bytes(5)))
        self.assertEqual(self.encode("daisy", daisy("common.init", 0, 16, "response"))[0], packet("00 10 81"))

    def test_readings_none_for_an_empty_mask(self):
        self.assertEqual(self.encode("daisy", daisy("distance_sensor.get_value", 0, 48, "response"))[0],
                         packet("00 30 c4", b"\0"))

    def test_gateway(self):
        self.assertEqual(self.encode("gateway", gateway("load"))[0],
                         record(columns((3, 1), (5, 0), (5, 0), (5, 0), (5, 0), (2, 0), (10, ""), (10, ""), (10, ""))))
        self.assertEqual(self.encode("gateway", gateway("circuit_state"))[0],
                         record("201    0  0.0  0.0    0      000"))

    def test_gateway_nested(self):
        out, _ = self.encode("gateway", gateway("cart_state", orders=[{}, {"level": 3}]))
        head = columns((3, 200), (5, 0), (5, 0), (4, 0), (1, 0), (5, 0), (3, 0), (5, 0), (5, 0), (5, 0), (1, 0))
        self.assertEqual(out, record(head + ORDER_0 + ORDER_0[:19] + " 3" + ORDER_0[21:]))

    def test_can(self):
        self.assertEqual(self.encode("can", can())[0], can_log("081#000052"))
        self.assertEqual(self.encode("can", can("define_function", function="sleep"))[0],
                         can_log("081#0000465341000000", "081" + ZEROS, "081" + ZEROS, step=0))
        self.assertEqual(self.encode("can", can("set_clock", month=1, day=2))[0],
                         can_log("081#0000430000010200", "081#0000", step=0))


class Values(ToolCase):
    def test_numbers_for_names(self):
        self.assertEqual(self.encode("daisy", daisy("dc_motor.set_direction", direction=1))[0],
                         packet("10 00 40", b"\1"))
        self.assertEqual(self.encode("gateway", gateway("ack", src_type=50))[0], record("101    0    0 50    0"))
        self.assertEqual(self.encode("gateway", gateway("circuit_state", mode=5, target_mode="init"))[0],
                         record("201    0  0.0  0.0    0      025"))
        # CA = 43 41 = 17217
        self.assertEqual(self.encode("can", can("define_function", function=17217))[0],
                         can_log("081#0000464341000000", "081" + ZEROS, "081" + ZEROS, step=0))

    def test_bits_as_names_and_numbers(self):
        for status, number in ((["busy", "ready"], 192), ([64, 128], 192), (["cart_error", 4096], 4097), ([], 0)):
            out, _ = self.encode("gateway", gateway("cart_state", cart_status=status))
            self.assertEqual(out[14:18], f"{number:4}".encode())

    def test_bits_are_an_array_or_a_number(self):
        self.assertEqual(self.encode("gateway", gateway("cart_state", cart_status=192))[0][14:18], b" 192")
        self.encode_refuses("gateway", gateway("cart_state", cart_status="busy"), "cart_status: an array of names or a number is needed")

    def test_decimals(self):
        for number, column in (("48.2", b" 48.2"), ("48", b" 48.0"), ("0.5", b"  0.5"), ("999.9", b"999.9"), ("0", b"  0.0")):
            line = '{"message":"circuit_state","fields":{"circuit_voltage":' + number + "}}"
            self.assertEqual(self.encode("gateway", line)[0][9:14], column)

    def test_exponents(self):
        line = '{"message":"idle_processing","fields":{"msg_id":%s}}'
        long = 20000  # digits
        for number, column in (("12e0", "   12"), ("1.2e1", "   12"), ("120E-1", "   12"), ("0e99999999999999999999", "    0"),
                               ("1" + "0" * long + f"e-{long}", "    1"), ("0." + "0" * long + f"12e{long + 2}", "   12")):
            with self.subTest(number[:30]):
                self.assertEqual(self.encode("gateway", line % number)[0], record(" 50" + column))
        for number in ("12e-1", "1" + "0" * long + f"e-{long + 1}", "1e-99999999999999999999", "1e5", "1e99999999999999999999", "0." + "0" * long + f"1e{long + 6}"):
            with self.subTest(number[:30]):
                self.encode_refuses("gateway", line % number, "msg_id")

    def test_text_keeps_inner_and_leading_spaces(self):
        out, _ = self.encode("gateway", gateway("send_inputs", inputs=' a "\\b'))
        self.assertEqual(out[-11:-1], b' a "\\b    ')

    def test_description_of_any_bytes(self):
        text = "".join(map(chr, range(251)))
        line = daisy("common.reset", 0, 32, "response", description=text)
        self.assertEqual(self.encode("daisy", line)[0], packet("00 20 82", bytes(range(251))))

    def test_negative_speed(self):
        out, _ = self.encode("gateway", gateway("cart_state", speed_mms=-9999))
        self.assertEqual(out[37:42], b"-9999")

    def test_broadcast_destination(self):
        self.assertEqual(self.encode("daisy", daisy(destination=255))[0], packet("ff 00 03"))

    def test_largest_rejected_packet(self):
        line = daisy("common.error", code=0, rejected="ab" * 249, expected_crc=7)
        self.assertEqual(self.encode("daisy", line)[0], packet("10 00 04", b"\0" + b"\xab" * 249 + b"\7"))


class Refusals(ToolCase):
    def test_unknown_fields_are_named(self):
        self.encode_refuses("daisy", daisy("dc_motor.set_direction", direction=1, speed=3), "speed", "1")
        self.encode_refuses("gateway", gateway(msg_id=1, cart_id=2), "cart_id", "1")
        self.encode_refuses("can", can(node=1, actuator=2), "actuator", "1")
        self.encode_refuses("gateway", gateway("cart_state", orders=[{}, {"levle": 3}]), "levle")
        self.encode_refuses("can", can("define_function", function="sleep", start={"months": 1}), "months")

    def test_unknown_keys_of_the_line(self):
        self.encode_refuses("gateway", {**gateway(), "msg_id": 1}, "msg_id")
        self.encode_refuses("daisy", {**daisy(), "speed": 1}, "speed")

    def test_arrays_of_the_wrong_length(self):
        self.encode_refuses("daisy", daisy("servo_motor.set_all_positions", 32, positions=[1, 2, 3, 4]), "positions")
        self.encode_refuses("daisy", daisy("servo_motor.set_all_positions", 32, positions=[1, 2, 3, 4, 5, 6]), "positions")
        self.encode_refuses("daisy", daisy("distance_sensor.get_value", 0, 48, "response", sensors=3, readings=[1]), "readings")
        self.encode_refuses("daisy", daisy("distance_sensor.get_value", 0, 48, "response", sensors=0, readings=[1]), "readings")
        self.encode_refuses("gateway", gateway("cart_state", orders=[{}]), "orders")
        self.encode_refuses("can", can("define_function", function="sleep", sensors=[]), "sensors")
        self.encode_refuses("can", can("sensor_readings", readings=[{}] * 5), "readings")

    def test_the_wrong_length_is_refused_unchecked_too(self):
        line = daisy("distance_sensor.get_value", 0, 48, "response", sensors=3, readings=[1])
        self.encode_refuses("daisy", line, "readings", options=["--unchecked"])
        self.encode_refuses("gateway", gateway("cart_state", orders=[{}]), "orders", options=["--unchecked"])

    def test_missing_addresses_and_ids(self):
        for name in ("destination", "source"):
            line = daisy()
            del line[name]
            self.encode_refuses("daisy", line, name, "1")
        line = can()
        del line["id"]
        self.encode_refuses("can", line, "id", "1")

    def test_addresses_out_of_range(self):
        self.encode_refuses("daisy", daisy(destination=256), "destination")
        self.encode_refuses("daisy", daisy(source=-1), "source")
        self.encode_refuses("can", can(number=0x800), "id")

    def test_addresses_of_another_family(self):
        self.encode_refuses("daisy", daisy("dc_motor.set_direction", 32), "destination")
        self.encode_refuses("daisy", daisy("dc_motor.set_direction", 32), "destination", options=["--unchecked"])

    def test_unknown_messages(self):
        self.encode_refuses("daisy", daisy("dc_motor.fly"), "dc_motor.fly")
        self.encode_refuses("daisy", daisy("common.error", kind="response"), "common.error")
        self.encode_refuses("gateway", gateway("none"), "none")
        self.encode_refuses("can", can("load"), "load")
        self.encode_refuses("gateway", {"protocol": "gateway", "fields": {}}, "message")

    def test_values_of_the_wrong_kind(self):
        for value in ("1", 1.5, None, True, [1], {"a": 1}, -1, 256, 10 ** 30):
            with self.subTest(value):
                self.encode_refuses("can", can(node=value), "node")
        for value in (1, None, ["x"]):
            self.encode_refuses("gateway", gateway("load", options=value), "options")
        for value in ("sideways", 1.5, -1, 256):
            self.encode_refuses("daisy", daisy("dc_motor.set_direction", direction=value), "direction")
        self.encode_refuses("gateway", gateway("cart_state", cart_status=["bysy"]), "cart_status")
        self.encode_refuses("gateway", gateway("circuit_state", circuit_voltage=48.25), "circuit_voltage")
        self.encode_refuses("gateway", gateway("circuit_state", circuit_voltage=1000), "circuit_voltage")
        self.encode_refuses("gateway", gateway("circuit_state", circuit_voltage=-1), "circuit_voltage")
        self.encode_refuses("daisy", daisy("common.error", code=0, rejected="0510004001", expected_crc=256), "expected_crc")
        for rejected in ("051000400", "05100040zz", "05100040", "ab" * 250):
            self.encode_refuses("daisy", daisy("common.error", code=0, rejected=rejected), "rejected")

    def test_fields_that_do_not_exist_for_this_code(self):
        for options in ([], ["--unchecked"]):
            self.encode_refuses("daisy", daisy("common.error", code=1, rejected="0510004001"), "rejected", options=options)
            self.encode_refuses("daisy", daisy("common.error", expected_crc=0, code=7), "expected_crc", options=options)

    def test_text_that_does_not_fit_or_breaks_the_framing(self):
        for options in ([], ["--unchecked"]):
            for value in ("12345678901", "a\x03b", "\x02", "é", "\x7f", "\n", "€"):
                with self.subTest(value):
                    self.encode_refuses("gateway", gateway("load", options=value), "options", options=options)
        self.encode_refuses("daisy", daisy("common.init", 0, 16, "response", description="x" * 252), "description")
        self.encode_refuses("daisy", daisy("common.init", 0, 16, "response", description="€"), "description")

    def test_no_json(self):
        for line in ("{", "[]", "1", "nul", '{"message":"idle_processing"} x', "{'message':1}", '{"message":"idle_processing",}',
                     '{"message":"idle_processing","fields":{"msg_id":01}}', '"', '{"message":"idle_processing","fields":[]}',
                     "[" * 100_000):
            with self.subTest(line[:60]):
                self.encode_refuses("gateway", line, "1")

    def test_another_protocol(self):
        self.encode_refuses("gateway", {**gateway(), "protocol": "can"}, "protocol")
        self.encode_refuses("gateway", daisy(), "line 1: protocol: it is daisy, not gateway")
        self.encode_refuses("daisy", {"protocol": "can", "line": 1, "error": "bad_line"}, "line 1: protocol: it is can, not daisy")


class Violations(ToolCase):
    LINES = (
        ("daisy", daisy(source=31), packet("10 1f 03"), "source"),
        ("daisy", daisy("dc_motor.set_direction", direction=7), packet("10 00 40", b"\7"), "direction"),
        ("daisy", daisy("servo_motor.set_all_positions", 32, positions=[0, 0, 181, 0, 0]),
         packet("20 00 41", octets("00 00 b5 00 00")), "positions[2]"),
        ("gateway", gateway("load", level=17), record("  1" + "    0" * 4 + "17" + " " * 30), "level"),
        ("gateway", gateway("ack", src_type="ack"), record("101    0    0101    0"), "src_type"),
        ("can", can(message_id=201), can_log("081#00C952"), "message_id"),
    )

    def test_are_refused_by_name(self):
        for protocol, line, _, field in self.LINES:
            with self.subTest(line):
                self.encode_refuses(protocol, line, field, "1")

    def test_are_written_unchecked(self):
        for protocol, line, written, _ in self.LINES:
            with self.subTest(line):
                self.assertEqual(self.encode(protocol, line, options=["--unchecked"])[0], written)

    def test_nested_ones_are_named(self):
        self.encode_refuses("gateway", gateway("cart_state", orders=[{}, {"level": 16}]), "orders[1].level")
        self.encode_refuses("can", can("define_function", function="interval_all"), "start.month")
        self.encode_refuses("can", can("sensor_readings", readings=[{"sensor": 1}, {}, {}, {}]), "readings[0].sensor")

    def test_unchecked_does_not_write_what_the_wire_cannot_carry(self):
        self.encode_refuses("gateway", gateway("load", level=100), "level", options=["--unchecked"])
        self.encode_refuses("gateway", gateway(msg_id=100000), "msg_id", options=["--unchecked"])
        self.encode_refuses("daisy", daisy("dc_motor.set_direction", direction=256), "direction", options=["--unchecked"])
        self.encode_refuses("can", can("set_clock", year=10000), "year", options=["--unchecked"])


class RefusalsInWords(ToolCase):
    """`line N: FIELD: …`, with what the document allows, or unchecked what the wire carries."""
    MODES = "no_power_freezing|no_power_frozen|init|manual|semi_automatic|automatic|shutdown_ready|shutting_down"
    TRANSITS = "none|load|transit|unload|go_parking|go_node"
    LINES = (  # the field, the value, what the document allows, what the wire carries
        (gateway("cart_state", orders=[{"level": 100}, {}]), "orders[0].level", 100, "0..15", "0..99"),
        (gateway("cart_state", orders=[{}, {"type": 1000}]), "orders[1].type", 1000, TRANSITS, "0..999"),
        (gateway("cart_state", rel_position=1000), "rel_position", 1000, "0..100", "0..999"),
        (gateway("cart_state", cart_status=[1, 16384]), "cart_status", 16384, "0..9999", "0..9999"),
        (gateway("cart_state", speed_mms=-10000), "speed_mms", -10000, "-9999..99999", "-9999..99999"),
        (gateway("circuit_state", mode=10), "mode", 10, MODES, "0..9"),
        (gateway("circuit_state", circuit_voltage=1000), "circuit_voltage", 1000, "0.0..999.9", "0.0..999.9"),
        (gateway("ack", src_type=1000), "src_type", 1000,
         "load|transit|unload|go_parking|go_node|cancel_transits|send_command|send_inputs|send_cargo_id|cross_granted|idle_processing",
         "0..999"),
        (daisy("servo_motor.set_all_positions", 32, positions=[0, 256, 0, 0, 0]), "positions[1]", 256, "0..180", "0..255"),
        (daisy("dc_motor.set_direction", direction=256), "direction", 256, "clockwise|counter_clockwise", "0..255"),
        (can("set_clock", month=256), "month", 256, "1..12", "0..255"),
    )

    def said(self, line, options=()):
        protocol = line["protocol"]
        return self.encode_refuses(protocol, line, options=options)

    def test_state_the_rule_of_the_document_and_unchecked_the_range_of_the_wire(self):
        for line, field, value, documented, carried in self.LINES:
            with self.subTest(field):
                self.assertEqual(self.said(line), f"trama: encode: line 1: {field}: {value} is not allowed ({documented})\n")
                self.assertEqual(self.said(line, ["--unchecked"]), f"trama: encode: line 1: {field}: {value} is not allowed ({carried})\n")

    def test_are_the_same_whether_the_wire_carries_the_value_or_not(self):
        for carried, not_carried in ((gateway("load", level=99), gateway("load", level=100)),
                                     (gateway("circuit_state", mode=9), gateway("circuit_state", mode=10)),
                                     (daisy("dc_motor.set_direction", direction=255), daisy("dc_motor.set_direction", direction=256))):
            self.assertEqual(*(self.said(line).split("is not allowed")[1] for line in (carried, not_carried)))

    def test_count_what_there_are_too_many_or_too_few_of(self):
        readings = [{"destination": 0, "source": 49, "protocol": "daisy", "kind": "response", "message": "distance_sensor.get_value",
                     "fields": {"sensors": 3, "readings": [1] * n}} for n in (1, 9)]
        for line, words in ((readings[0], "readings: 1 value is not allowed (as many values as the message announces)"), (readings[1], "readings: at most 8 values are possible, not 9"),
                            (daisy("servo_motor.set_all_positions", 32, positions=[0] * 4), "positions: 5 values are needed, not 4"),
                            (daisy("common.error", code=0), "rejected: 0 bytes are not allowed (5..249 bytes)"),
                            (daisy("common.reset", 0, 32, "response", description="x" * 252), "description: 252 bytes are not allowed (0..251 bytes)")):
            with self.subTest(words):
                self.assertEqual(self.said(line), f"trama: encode: line 1: {words}\n")

    def test_begin_with_the_field(self):
        no_source, no_message = daisy(), gateway()
        del no_source["source"], no_message["message"]
        for line, beginning in ((gateway(msg_id="x"), "msg_id: "), (gateway("load", level=16), "level: "), (no_source, "source: "),
                                (no_message, "message: "), ({**gateway(), "fields": 1}, "fields: "), (gateway(levl=1), "levl: "),
                                (daisy("dc_motor.set_direction", 32), "destination: 32 is not allowed ("), (daisy(kind=1), "kind: ")):
            with self.subTest(beginning):
                self.assertTrue(self.said(line).startswith("trama: encode: line 1: " + beginning), self.said(line))

    def test_of_what_should_be_a_string(self):
        for value in (["go_node"], {"a": 1}, 1, True, None):
            for name in ("message", "protocol"):
                self.encode_refuses("gateway", {**gateway(), name: value}, f"line 1: {name}: a string is needed")

    def test_show_no_control_character(self):
        """Nor do other complaints: a newline would forge a line, an escape would steer the terminal."""
        for character, shown in (("\n", "\\u000a"), ("\x1b", "\\u001b"), ("\x7f", "\\u007f"), ("\x00", "\\u0000"), ("\x9b", "\\u009b"), ("\u0131", "\u0131"), ("\xa0", "\xa0")):
            evil = f"a{character}b"
            twice = json.dumps({**gateway(), "violations": {evil: 1}})[:-2] + "," + json.dumps(evil) + ":2}}"
            for line in ({**gateway(), "message": evil}, {**gateway(), "protocol": evil}, {"error": evil}, {**gateway(), evil: 1}, gateway(**{evil: 1}),
                         gateway("ack", src_type=evil), gateway("cart_state", orders=[{}, {evil: 1}]), twice):
                with self.subTest(line):
                    err = self.encode_refuses("gateway", line, f"a{shown}b")
                    self.assertEqual((err.count("\n"), character in err[:-1]), (1, character == shown))
        for character, shown in (("\n", "\\u000a"), ("\x1b", "\\u001b")):
            self.assertEqual(trama("encode", "gateway", f"/no/a{character}b").err, f"trama: encode: /no/a{shown}b: No such file or directory\n")

    def test_name_what_stands_twice(self):
        line = '{"message":"load","fields":{"level":1,"msg_id":1,"level":2}}'
        self.encode_refuses("gateway", line, "line 1: column 57: level: it stands twice")


class Limits(ToolCase):
    LINE = '{"message":"idle_processing","fields":{"msg_id":12},"violations":%s}'

    def test_of_a_line_s_length(self):
        line = self.LINE % "0"
        self.assertEqual(self.encode("gateway", line.ljust(65535))[0], record(" 50   12"))
        out, err = self.encode("gateway", line.ljust(65536), line, status=1)
        self.assertEqual((out, err), (record(" 50   12"), "trama: encode: line 1: the line is too long\n"))

    def test_of_a_line_that_begins_with_more_space_than_fits(self):
        for space in (" ", "\t", "\r"):
            self.encode_refuses("gateway", space * 65536 + self.LINE % "0", "line 1: the line is too long")
        self.assertEqual(self.encode("gateway", " " * 65535), (b"", ""))

    def test_the_time_for_an_ignored_object_does_not_grow_with_its_square(self):
        def seconds(members, lines):
            """Processor time for so many lines with so many members each."""
            line = self.LINE % ("{" + ",".join(f'"{i}":0' for i in range(members)) + "}") + "\n"
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            run = trama("encode", "gateway", given=line.encode() * lines)
            self.assertEqual((run.status, run.out), (0, record(" 50   12") * lines))
            return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        few, many = seconds(500, 160), seconds(6000, 13)
        self.assertLess(many, 4 * few)

    def test_of_nesting(self):
        for depth, good in ((15, True), (16, False)):  # the line itself is one more
            line = self.LINE % ("[" * depth + "0" + "]" * depth)
            if good:
                self.assertEqual(self.encode("gateway", line)[0], record(" 50   12"))
            else:
                self.encode_refuses("gateway", line, "nested too deeply")


class BadLines(ToolCase):
    GOOD = '{"message":"idle_processing","fields":{"msg_id":12}}'

    def test_goes_on_after_a_bad_line_and_names_each(self):
        out, err = self.encode("gateway", self.GOOD, "oops", self.GOOD, '{"message":"load","fields":{"levl":1}}', self.GOOD,
                               status=1)
        self.assertEqual(out, record(" 50   12") * 3)
        said = err.splitlines()
        self.assertEqual(len(said), 2)
        self.assertIn("2", said[0])
        self.assertIn("4", said[1])
        self.assertIn("levl", said[1])

    def test_a_refused_line_leaves_no_line_in_hex(self):
        out, _ = self.encode("gateway", self.GOOD, "oops", self.GOOD, options=["--hex"], status=1)
        self.assertEqual(out, b"02 20 35 30 20 20 20 31 32 03\n" * 2)

    def test_error_lines_are_reported_and_skipped(self):
        error = '{"protocol":"gateway","offset":0,"length":12,"error":"bad_length","bytes":"0220"}'
        out, err = self.encode("gateway", self.GOOD, error, self.GOOD, status=1)
        self.assertEqual(out, record(" 50   12") * 2)
        self.assertIn("2", err)
        self.assertIn("bad_length", err)

    def test_error_lines_are_skipped_unchecked_too(self):
        out, _ = self.encode("can", '{"protocol":"can","line":7,"error":"bad_line"}', options=["--unchecked"], status=1)
        self.assertEqual(out, b"")

    def test_binary_junk(self):
        run = trama("encode", "gateway", given=b"\x00\xff\n" + self.GOOD.encode() + b"\n")
        self.assertEqual((run.status, run.out), (1, record(" 50   12")))


if __name__ == "__main__":
    unittest.main()
