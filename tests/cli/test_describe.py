"""trama describe: every message of every protocol, with the layout that the specification gives it."""

import json
import re
import unittest

from goldens import CAN, DAISY, GATEWAY, can_line, daisy_line, gateway_line
from tool import ToolCase, trama


def names(value):
    """Every name in an object, nested ones included."""
    if isinstance(value, dict):
        for name, inner in value.items():
            yield name
            yield from names(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from names(inner)


class Describe(ToolCase):
    def describe(self, *words):
        run = trama("describe", *words)
        self.assertEqual((run.status, run.err), (0, ""), words)
        return run.out.decode("utf-8")

    def row(self, text, name):
        """The cells of the first row about this field: columns are two spaces or more apart."""
        for line in text.splitlines():
            cells = re.split(r"  +", line.strip())
            if len(cells) > 2 and cells[2] in (name, "." + name) or len(cells) > 2 and cells[2].startswith(name + "["):
                return cells
        self.fail(f"no row for {name} in\n{text}")

    def test_everything(self):
        text = self.describe()
        for name in ["daisy", "can", "gateway"] + [golden[2] for golden in DAISY + CAN] + [golden[1] for golden in GATEWAY]:
            self.assertIn(name, text)

    def test_each_protocol(self):
        for protocol, all_names in (("daisy", {golden[2] for golden in DAISY}), ("can", {golden[2] for golden in CAN}),
                                    ("gateway", {golden[1] for golden in GATEWAY})):
            text = self.describe(protocol)
            for name in all_names:
                self.assertRegex(text, rf"\b{re.escape(name)}\b")

    def test_each_message_shows_all_its_fields(self):
        goldens = [("daisy", golden[2], daisy_line(golden)) for golden in DAISY]
        goldens += [("can", golden[2], can_line(golden)) for golden in CAN]
        goldens += [("gateway", golden[1], gateway_line(golden)) for golden in GATEWAY]
        for protocol, message, line in goldens:
            with self.subTest(message):
                text = self.describe(protocol, message)
                for word in ("offset", "size", "name", "type", "range", "meaning"):
                    self.assertIn(word, text)
                for name in names(json.loads(line)["fields"]):
                    self.assertRegex(text, rf"\b{name}\b")

    def test_rows_of_daisy(self):
        text = self.describe("daisy", "dc_motor.set_dc_speed")
        self.assertIn("0x41", text)
        self.assertIn("0xc1", text)  # the response too
        # LEN, DESTINATION, SOURCE and COMMAND come first
        self.assertEqual(self.row(text, "direction")[:2], ["4", "1"])
        self.assertEqual(self.row(text, "speed")[:2], ["5", "2"])
        self.assertIn("clockwise|counter_clockwise", self.row(text, "direction"))
        self.assertIn("0..180", self.row(self.describe("daisy", "servo_motor.set_position"), "position"))

    def test_rows_of_gateway(self):
        text = self.describe("gateway", "cart_state")
        at = 4  # STX and type come first
        for name, size in (("msg_id", 5), ("cart_id", 5), ("cart_status", 4), ("cart_phase", 1), ("ini_node", 5), ("rel_position", 3),
                           ("end_node", 5), ("next_node", 5), ("speed_mms", 5), ("cross_confirmation_needed", 1)):
            self.assertEqual(self.row(text, name)[:2], [str(at), str(size)])
            at += size
        for name, allowed in (("rel_position", "0..100"), ("cross_confirmation_needed", "0..1"), ("level", "0..15"),
                              ("use", "unused|previous|current|next")):
            self.assertIn(allowed, self.row(text, name))
        self.assertIn("200", text)

    def test_rows_of_can(self):
        text = self.describe("can", "define_function")
        for name, offset, size in (("node", 0, 1), ("message_id", 1, 1), ("function", 3, 2), ("sensor_count", 19, 1)):
            self.assertEqual(self.row(text, name)[:2], [str(offset), str(size)])
        # both are seven bytes, in two pieces each
        self.assertEqual(self.row(text, "start")[1], "4 + 3")
        self.assertEqual(self.row(text, "end")[1], "4 + 3")
        self.assertIn("0..200", self.row(text, "message_id"))
        # Of an interval month and day are not 0 either, which the meaning says.
        for name, allowed in (("month", "0..12"), ("day", "0..31"), ("hour", "0..23"), ("minute", "0..59")):
            self.assertIn(allowed, self.row(text, name))

    def test_unknown_ones(self):
        for words in (("modbus",), ("daisy", "fly"), ("can", "load"), ("gateway", "cart"), ("daisy", ""), ("",)):
            run = trama("describe", *words)
            self.assertEqual((run.status, run.out), (2, b""), words)
            self.assertNotEqual(run.err, "")


if __name__ == "__main__":
    unittest.main()
