"""The command line itself: options, files, exit statuses, and where messages go."""

import json
import os
import subprocess
import tempfile
import unittest

from goldens import GATEWAY, gateway_line, gateway_record
from tool import HANG, TRAMA, ToolCase, can_log, octets, packet, record, trama

PING = packet("10 00 03")


class Usage(ToolCase):
    def refused(self, *words):
        run = trama(*words)
        self.assertEqual((run.status, run.out), (2, b""), words)
        self.assertNotEqual(run.err.strip(), "", words)
        return run.err

    def test_errors(self):
        for words in ((), ("frobnicate",), ("decode",), ("encode",), ("decode", "modbus"), ("encode", "Daisy"), ("describe", "modbus"),
                      ("describe", "daisy", "fly"), ("describe", "can", "load"), ("describe", "gateway", "load", "x"),
                      ("decode", "daisy", "a", "b"), ("encode", "daisy", "a", "b"),
                      ("decode", "daisy", "--format"), ("decode", "daisy", "--format", "xml"),
                      ("decode", "can", "--timeout"), ("decode", "can", "--timeout", "soon"), ("decode", "can", "--timeout", "-1"),
                      ("decode", "can", "--timeout", ""), ("decode", "can", "--timeout", "1s"), ("decode", "can", "--timeout", "nan")):
            with self.subTest(words):
                self.refused(*words)

    def test_the_longest_time_out_is_told(self):
        most = 18_000_000_000
        self.assertEqual(trama("decode", "can", "--timeout", str(most)).status, 0)
        for wrong in (str(most + 1), "1" + "0" * 12, "9" * 40):
            self.assertIn(f"up to {most}, not {wrong}", self.refused("decode", "can", "--timeout", wrong))

    def test_unknown_options(self):
        for command in ("decode", "encode"):
            for option in ("--hexx", "-x", "--unknown=1"):
                with self.subTest(command, option=option):
                    self.assertIn(option.split("=")[0], self.refused(command, "daisy", option))
        self.refused("decode", "daisy", "--unchecked")
        self.refused("encode", "daisy", "--format", "json")
        self.refused("encode", "can", "--timeout", "1")
        self.refused("--frobnicate")

    def test_hex_does_not_go_with_can(self):
        for command in ("decode", "encode"):
            self.assertIn("--hex", self.refused(command, "can", "--hex"))
            self.assertIn("--hex", self.refused(command, "--hex", "can"))

    def test_options_before_and_behind_the_names(self):
        expected = trama("decode", "daisy", "--hex", given=PING.hex().encode()).out
        self.assertNotEqual(expected, b"")
        with tempfile.NamedTemporaryFile() as file:
            file.write(PING.hex().encode())
            file.flush()
            for words in (("--hex", "daisy", file.name), ("daisy", "--hex", file.name), ("daisy", file.name, "--hex"),
                          ("daisy", "--format", "json", file.name, "--hex")):
                with self.subTest(words):
                    self.assertEqual(trama("decode", *words), (0, expected, ""))

    def test_help(self):
        run = trama("--help")
        self.assertEqual((run.status, run.err), (0, ""))
        text = run.out.decode()
        for word in ("decode", "encode", "describe", "daisy", "can", "gateway", "--hex", "--format", "--timeout", "--unchecked",
                     "--version", "0", "1", "2"):
            self.assertIn(word, text)

    def test_help_is_an_option_of_every_command(self):
        text, version = trama("--help").out, trama("--version").out
        for words in (("-h",), ("decode", "--help"), ("decode", "daisy", "-h", "/no/such/file"), ("encode", "--help"), ("describe", "daisy", "--help")):
            self.assertEqual(trama(*words), (0, text, ""), words)
        for words in (("decode", "--version"), ("encode", "can", "--version"), ("describe", "--version")):
            self.assertEqual(trama(*words), (0, version, ""), words)

    def test_help_is_no_option_behind_two_dashes_nor_in_an_option_s_place(self):
        for word in ("--help", "-h", "--version"):
            for command in ("decode", "encode"):
                self.assertIn(f"{word}: No such file", self.refused(command, "gateway", "--", word))
            self.assertIn(f"no message {word}", self.refused("describe", "gateway", "--", word))
            self.assertIn(f"unknown protocol {word}", self.refused("describe", "--", word))
            for option in ("--format", "--timeout", "--jobs", "--range"):
                self.assertIn(f", not {word}", self.refused("decode", "can", option, word))
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "--help"), "wb") as file:
                file.write(record(" 50   12"))
            self.assertEqual(trama("decode", "gateway", "--", "--help", cwd=folder), trama("decode", "gateway", given=record(" 50   12")))

    def test_describe_takes_two_dashes_and_no_other_options(self):
        expected = trama("describe", "gateway", "load")
        for words in (("--", "gateway", "load"), ("gateway", "--", "load"), ("gateway", "load", "--")):
            self.assertEqual(trama("describe", *words), expected, words)
        self.assertEqual(trama("describe", "--"), trama("describe"))
        for option in ("--hex", "--format", "--jobs=2", "-x"):
            self.assertIn(f"unknown option {option}", self.refused("describe", option))
            self.assertIn(f"unknown option {option}", self.refused("describe", "daisy", option))

    def test_version(self):
        run = trama("--version")
        self.assertEqual((run.status, run.err), (0, ""))
        self.assertRegex(run.out.decode(), r"\A(trama )?\d+\.\d+\.\d+\n\Z")


class Files(ToolCase):
    def test_missing_files_and_directories(self):
        with tempfile.TemporaryDirectory() as folder:
            for command in ("decode", "encode"):
                for name in (folder, os.path.join(folder, "absent"), os.path.join(folder, "absent", "deeper")):
                    for protocol in ("daisy", "can", "gateway"):
                        run = trama(command, protocol, name)
                        self.assertEqual((run.status, run.out), (2, b""))
                        self.assertIn(name, run.err)

    def test_directory_as_standard_input(self):
        with tempfile.TemporaryDirectory() as folder:
            handle = os.open(folder, os.O_RDONLY)
            try:
                run = subprocess.run([TRAMA, "decode", "daisy"], stdin=handle, capture_output=True, timeout=HANG, check=False)
            finally:
                os.close(handle)
            self.assertEqual((run.returncode, run.stdout), (2, b""))

    def test_standard_input_by_its_names(self):
        expected = trama("decode", "gateway", given=record(" 50   12"))
        self.assertEqual(expected.status, 0)
        self.assertEqual(trama("decode", "gateway", "-", given=record(" 50   12")), expected)
        line = b'{"message":"idle_processing","fields":{"msg_id":12}}\n'
        self.assertEqual(trama("encode", "gateway", "-", given=line), (0, record(" 50   12"), ""))

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, protocol, given in (("a.daisy", "daisy", PING), ("b.gateway", "gateway", record(" 50   12")),
                                          ("c.can", "can", can_log("081#020452"))):
                path = os.path.join(folder, name)
                with open(path, "wb") as file:
                    file.write(given)
                self.assertEqual(trama("decode", protocol, path), trama("decode", protocol, given=given))

    def test_a_file_without_a_name(self):
        for words in (("decode", "daisy", ""), ("decode", "can", ""), ("encode", "gateway", "")):
            run = trama(*words)
            self.assertEqual((run.status, run.out), (2, b""), words)
            self.assertNotEqual(run.err, "")

    def test_an_empty_file(self):
        for protocol in ("daisy", "can", "gateway"):
            self.assertEqual(trama("decode", protocol, "/dev/null"), (0, b"", ""))
            self.assertEqual(trama("encode", protocol, "/dev/null"), (0, b"", ""))

    def test_output_that_cannot_be_written(self):
        with open("/dev/full", "wb") as full:
            for words, given in ((["decode", "daisy"], PING), (["describe"], b""), (["--help"], b""),
                                 (["encode", "daisy"], b'{"destination":1,"source":0,"message":"common.ping"}')):
                run = subprocess.run([TRAMA, *words], input=given, stdout=full, stderr=subprocess.PIPE, timeout=HANG, check=False)
                self.assertEqual(run.returncode, 2, words)
                self.assertNotEqual(run.stderr, b"")


class HexInput(ToolCase):
    def faulty(self, given, *places, lines=1):
        """An input error that names its place; the rest is decoded all the same."""
        run = trama("decode", "daisy", "--hex", given=given)
        self.assertEqual(run.status, 1, run)
        self.assertEqual(sum('"message"' in line for line in run.out.decode().splitlines()), lines)
        for place in places:
            self.assertIn(place, run.err)

    def test_foreign_characters(self):
        self.faulty(b"04 10 00 03 17\n04 1g", "line 2", "column 5")
        self.faulty(b"x", "line 1", "column 1", lines=0)
        self.faulty(b"04 10 00 03 17 0x04", "line 1", "column 17")
        self.faulty(b"0410000317,0410000317", "line 1", "column 11", lines=2)
        self.faulty(b"0x04 0x10 0x00 0x03 0x17", "column 2", "column 22")
        self.faulty(b"04 1zzz 10 00 03 17", "line 1", "column 5")
        self.faulty(b"04 10 00 03 17\n\xff", "line 2", "column 1")

    def test_an_odd_digit(self):
        self.faulty(b"04 10 00 03 17 0", "line 1", "column 16")
        self.faulty(b"04 10 00 03 17\n04 1\n\n", "line 2", "column 4")

    def test_an_odd_digit_before_a_foreign_character(self):
        self.faulty(b"04 10 00 03 17\n04 1 zz 03", "line 2, column 4: the hex digit has no partner", "line 2, column 6: no hex digit")
        self.faulty(b"0x04 0x10 0x00 0x03 0x17", "line 1, column 1: the hex digit", "line 1, column 2: no hex digit")
        run = trama("decode", "daisy", "--hex", given=b"02 3 zz 03")
        self.assertEqual(run.err, "trama: decode: line 1, column 4: the hex digit has no partner\ntrama: decode: line 1, column 6: no hex digit\n")

    def test_many_places(self):
        for count in (19, 20, 21, 1000):
            said = trama("decode", "daisy", "--hex", given=b"!\n" * count).err.splitlines()
            self.assertEqual(said[:20], [f"trama: decode: line {i + 1}, column 1: no hex digit" for i in range(min(count, 20))])
            self.assertEqual(said[20:], ["trama: decode: further places are not told"] if count > 20 else [])

    def test_far_into_the_input(self):
        self.faulty(b"04 10 00 03 17\n" * 10_000 + b"0!", "line 10001", "column 2", lines=10_000)

    def test_gateway(self):
        run = trama("decode", "gateway", "--hex", given=record(" 50   12").hex().encode() + b" 0")
        self.assertEqual(run.status, 1)
        self.assertEqual(run.out.count(b"\n"), 1)
        self.assertNotEqual(run.err, "")


class Text(ToolCase):
    def test_json_is_the_default(self):
        self.assertEqual(trama("decode", "gateway", "--format", "json", given=record(" 50   12")),
                         trama("decode", "gateway", given=record(" 50   12")))

    def test_text_tells_the_same(self):
        for golden in GATEWAY:
            run = trama("decode", "gateway", "--format", "text", given=gateway_record(golden))
            self.assertEqual((run.status, run.err), (0, ""))
            text = run.out.decode()
            self.assertEqual(text.count("\n"), 1)
            self.assertIn(golden[1], text)
            for name, value in json.loads(gateway_line(golden))["fields"].items():
                self.assertIn(name, text)
                if isinstance(value, (int, str)):
                    self.assertIn(str(value).replace("\\", "\\\\").replace('"', '\\"'), text)

    def test_bytes_that_people_know_in_hex_are_marked_as_such(self):
        given = packet("11 00 43") + packet("11 00 7E") + octets("05 11 00 40 01 54")
        unknown, checksum = self.decode("daisy", given, "--format", "text", status=1)[1:]
        self.assertIn(" destination=0x11 source=0x00 message=dc_motor.get_encoder ", self.decode("daisy", given, "--format", "text", status=1)[0])
        self.assertTrue(unknown.endswith(" bytes=0411007e6b destination=0x11 source=0x00 command=0x7e"), unknown)
        self.assertTrue(checksum.endswith(" expected=0x55 received=0x54"), checksum)

    def test_every_kind_of_event_has_a_line(self):
        for protocol, given, words in (
                ("daisy", b"\0" + PING + octets("05 11 00 40 01 54") + PING + packet("10 1f 03"),
                 ("noise", "common.ping", "bad_checksum", "violation", "id 0..14")),
                ("can", b"oops\n" + can_log("081#02045204006401F0", "081#020452", "081#02C952"),
                 ("bad_line", "incomplete", "read_sensors", "0..200")),
                ("gateway", b"x" + record("210") + record(" 50   1x"), ("noise", "unknown_message", "210", "bad_number", "msg_id"))):
            json_lines = self.decode(protocol, given, status=1)
            text = self.decode(protocol, given, "--format", "text", status=1)
            self.assertEqual(len(text), len(json_lines))
            for word in words:
                self.assertIn(word, "\n".join(text))


if __name__ == "__main__":
    unittest.main()
