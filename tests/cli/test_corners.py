"""Corners of the inputs that few files have: spellings of JSON, candump's rarer forms, the progress line on a terminal."""

import os
import pty
import re
import resource
import select
import subprocess
import tempfile
import unittest

from tool import HANG, TRAMA, ToolCase, can_log, octets, record, trama

READ = "081#020452"


def idle(msg_id):
    return ('{"message":"idle_processing","fields":{"msg_id":%s}}' % msg_id).encode()


def circuit(voltage):
    return ('{"message":"circuit_state","fields":{"circuit_voltage":%s}}' % voltage).encode()


class Json(ToolCase):
    def written(self, line):
        run = trama("encode", "gateway", given=line + b"\n")
        self.assertEqual((run.status, run.err), (0, ""), line)
        return run.out

    def refused(self, line, *words):
        run = trama("encode", "gateway", given=line + b"\n")
        self.assertEqual((run.status, run.out), (1, b""), line)
        for word in words:
            self.assertIn(word, run.err)

    def test_one_number_in_many_spellings(self):
        for spelling in ("120", "120.0", "12e1", "12E+1", "1.2e2", "1200e-1", "0.12e3", "120e0", "12000.00e-2", "12E0000000001", "120e-0000000", "120e+00000000000000000000"):
            self.assertEqual(self.written(idle(spelling)), record(" 50  120"), spelling)
        for spelling in ("0", "-0", "0.0", "0e9", "-0.0e-3", "0e99999999999"):
            self.assertEqual(self.written(idle(spelling)), record(" 50    0"), spelling)
        for spelling in ("48.2", "4.82e1", "482e-1", "48.20"):
            self.assertIn(b" 48.2", self.written(circuit(spelling)), spelling)

    def test_numbers_that_are_not_whole(self):
        for spelling in ("1.5", "15e-1", "1e-1", "1e-99999999999"):
            self.refused(idle(spelling), "msg_id", "whole number")
        for spelling in ("48.25", "4825e-2"):
            self.refused(circuit(spelling), "circuit_voltage", "one decimal")

    def test_numbers_of_any_size(self):
        for spelling in ("100000", "1e5", "1e18", "1e19", "1e99999999999", "123456789012345678901234567890", "-1", "-1e30"):
            self.refused(idle(spelling), "msg_id", "0..99999")

    def test_what_is_no_number(self):
        for spelling in ("01", "-", "+1", ".5", "1.", "1e", "1e+", "0x10", "NaN", "--1", "1 2"):
            self.refused(idle(spelling), "column")
        for spelling in ("true", "false", "null", '"1"', "[1]", "{}"):
            self.refused(idle(spelling), "msg_id", "whole number")

    def test_what_is_no_json(self):
        for line in (b"{", b'{"', b'{"message', b'{"message"', b'{"message":', b'{"message":"x"', b'{"message":"x",', b'{"message":"x"}}', b'{"message":"x",}',
                     b'{"a" 1}', b'{1:2}', b"[", b"[1", b"[1,", b"[1,]", b"tru", b"nul", b"falsy", b"'x'", b"\x00", b'"x"', b"[]", b"1",
                     b'{"a":"\x01"}', b'{"a":"x', b'{"a":"\\', b'{"a":"\\q"}', b'{"a":"\\u12"}', b'{"a":"\\u12g4"}', b'{"a":"\xff"}', b'{"a":"\xc3"}',
                     b'{"a":"\xe2\x82"}', b'{"a":"\xc3x"}', b'{"a":"\xf8\x88\x80\x80\x80"}', b'{"a":"\x80"}'):
            self.refused(line)

    def test_escapes_and_characters_beyond_latin_1(self):
        line = b'{"message":"send_command","fields":{"cart_id":1,"command":"%s"}}'
        expected = record(" 21    0    1" + " " * 10 + 'a"b\\/     ')
        self.assertEqual(self.written(line % b'a\\"b\\\\\\/'), expected)
        self.assertEqual(self.written(line % b'\\u0061\\u0022b\\u005C/'), expected)
        for text in (b"\\t", b"\\n", b"\\u0000", b"\\u00e9", b"\\u20ac", b"\xc3\xa9", b"\xe2\x82\xac", b"\xf0\x9f\x98\x80"):
            self.refused(line % text, "command")


class Candump(ToolCase):
    def test_a_raw_dlc_behind_eight_bytes(self):
        frame = "081#0207410000000000"
        plain = self.decode("can", can_log(frame), status=1)
        for dlc in "9abcdefABCDEF":
            self.assertEqual(self.decode("can", can_log(frame + "_" + dlc), status=1), plain, dlc)

    def test_a_remote_frame_is_foreign_whatever_it_asks_for(self):
        for request in ("R", "R0", "R8", "R8_9", "R8_A", "R8_f"):
            self.assertEqual(self.decode("can", can_log("081#" + request)), [], request)
        for bad in ("R9", "R7_9", "R8_8", "R8_", "R8_9A", "R_9", "R8_g"):
            self.assertEqual(self.decode("can", can_log("081#" + bad), status=1), ['{"protocol":"can","line":1,"error":"bad_line"}'], bad)

    def test_what_is_no_frame(self):
        good = can_log(READ).decode().strip()
        self.assertEqual(len(self.decode("can", good.encode())), 1)
        for bad in ("081#0207410000000000_8", "081#0207410000000000_", "081#0207410000000000_9x", "081#0207_9", "081#020", "081#02074", "081#0g", "081#g0",
                    "081#020741000000000000", "081", "81#02", "0811#02", "081##", "081##g", "081##0020", "081##102030405060708_F", "081#R9", "081#RR", "08g#02", "#02", "800#02", "000000811#02"):
            self.assertEqual(self.decode("can", can_log(bad), status=1), ['{"protocol":"can","line":1,"error":"bad_line"}'], bad)
        for line in ("", "x", "(1.0)", "(1.0) can0", "(1.0) can0 " + READ + " Q", "(1.0) can0 " + READ + " R x", "1.0 can0 " + READ, "(1) can0 " + READ,
                     "(.5) can0 " + READ, "(1.) can0 " + READ, "(1.0x) can0 " + READ, "(-1.0) can0 " + READ, "() can0 " + READ, "(1.0 can0 " + READ):
            self.assertEqual(self.decode("can", line.encode() + b"\n", status=1), ['{"protocol":"can","line":1,"error":"bad_line"}'], line)
        for tail in (" R", " T", "\r", "  "):
            self.assertEqual(len(self.decode("can", good.encode() + tail.encode() + b"\n")), 1, tail)


class Progress(ToolCase):
    def shown(self, folder, content, *words, status=0, limit=resource.RLIM_INFINITY):
        """What the tool says on a terminal while it decodes a large file into one that is none, of at most `limit` bytes."""
        path = os.path.join(folder, "large")
        with open(path, "wb") as f:
            f.write(content)
        terminal, inner = pty.openpty()
        into = os.devnull if limit == resource.RLIM_INFINITY else os.path.join(folder, "out")
        with open(into, "wb") as nowhere, subprocess.Popen([TRAMA, "decode", *words, path], stdout=nowhere, stderr=inner,
                                                           preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))) as tool:
            os.close(inner)
            said = b""
            while select.select([terminal], [], [], HANG)[0]:
                try:
                    part = os.read(terminal, 65536)
                except OSError:  # the other end is closed
                    break
                if not part:
                    break
                said += part
            self.assertEqual(tool.wait(HANG), status)
        os.close(terminal)
        return said.decode()

    def test_is_a_line_that_is_redrawn_and_goes(self):
        ring, log = octets("0400108397") * (4 << 20), can_log(READ) * (1 << 20)
        for content, size, *words in ((ring, 21, "daisy"), (ring, 21, "daisy", "--jobs", "2"), (ring, 20, "daisy", "--range", "1000000:99999999"),
                                      (log, 28, "can")):
            with tempfile.TemporaryDirectory() as folder:
                said = self.shown(folder, content, *words)
            self.assertRegex(said, r"^\r\x1b\[K\d+ of %d MB, \d+ MB/s, \d+ s left" % size, words)
            self.assertTrue(said.endswith("\r\x1b[K"), said[-40:])
            places = [int(place) for place in re.findall(r"K(\d+) of", said)]
            self.assertEqual(places, sorted(places))

    def test_goes_before_a_complaint(self):
        ring = octets("0400108397") * (1 << 20)
        with tempfile.TemporaryDirectory() as folder:
            said = self.shown(folder, ring.hex().encode() + b"x", "daisy", "--hex", status=1)
        self.assertRegex(said, r"left\r\x1b\[Ktrama: decode: line 1, column %d: no hex digit\r\n$" % (2 * len(ring) + 1))

    def test_a_file_that_may_not_grow_is_told_of(self):
        with tempfile.TemporaryDirectory() as folder:
            said = self.shown(folder, octets("0400108397") * 10000, "daisy", status=2, limit=1 << 17)
        self.assertTrue(said.endswith("trama: cannot write: File too large\r\n"), said)

    def test_is_silent_where_nobody_looks(self):
        run = trama("decode", "daisy", given=octets("0400108397") * 1000)
        self.assertEqual((run.status, run.err), (0, ""))


if __name__ == "__main__":
    unittest.main()
