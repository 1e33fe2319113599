"""The sample traffic in examples/: what the tool makes of it is what went into it."""

import json
import os
import pathlib
import subprocess
import unittest
from collections import Counter

from tool import HANG, ToolCase, trama

TRAFFIC = pathlib.Path(__file__).resolve().parents[2] / "examples" / "traffic"
SAMPLES = {"daisy": "robot.daisy", "can": "greenhouse.can", "gateway": "warehouse.gateway"}


class Samples(ToolCase):
    def lines(self, protocol):
        run = trama("decode", protocol, str(TRAFFIC / SAMPLES[protocol]))
        self.assertEqual((run.status, run.err), (1, ""))
        return run.out.decode("ascii").splitlines()

    def errors(self, protocol):
        return [line["error"] for line in map(json.loads, self.lines(protocol)) if "error" in line]

    def test_the_damage_and_nothing_else_is_reported(self):
        self.assertEqual(self.errors("daisy"), ["noise", "bad_checksum", "unknown_message", "bad_checksum", "truncated"])
        self.assertEqual(self.errors("can"), ["incomplete", "bad_line", "timed_out", "unknown_message", "bad_length"])
        self.assertEqual(self.errors("gateway"), ["truncated", "noise", "unknown_message", "bad_number", "bad_character", "bad_length"])

    def test_one_violation_each(self):
        for protocol in SAMPLES:
            self.assertEqual(sum('"violations":' in line for line in self.lines(protocol)), 1)

    def test_the_rejected_packet_comes_back_in_the_error_to_its_source(self):
        lines = [json.loads(line) for line in self.lines("daisy")]
        at = next(index for index, line in enumerate(lines) if line.get("error") == "bad_checksum")
        self.assertEqual(lines[at + 1]["fields"], {"code": 0, "rejected": lines[at]["bytes"], "expected_crc": lines[at]["expected"]})
        self.assertEqual(lines[at + 1]["message"], "common.error")

    def test_every_byte_is_accounted_for(self):
        for protocol in ("daisy", "gateway"):
            end = 0
            for line in map(json.loads, self.lines(protocol)):
                self.assertEqual(line["offset"], end)
                end += line["length"]
            self.assertEqual(end, (TRAFFIC / SAMPLES[protocol]).stat().st_size)

    def test_sessions_are_rich(self):
        for protocol, least in (("daisy", 30), ("can", 7), ("gateway", 16)):
            kinds = Counter(line.get("message") for line in map(json.loads, self.lines(protocol)))
            del kinds[None]
            self.assertGreaterEqual(len(kinds), least, kinds)

    def test_what_is_whole_can_be_encoded_again(self):
        for protocol in SAMPLES:
            whole = [line for line in self.lines(protocol) if '"error":' not in line]
            encoded = trama("encode", protocol, "--unchecked", given="\n".join(whole).encode())
            self.assertEqual((encoded.status, encoded.err), (0, ""))
            again = trama("decode", protocol, given=encoded.out).out.decode("ascii").splitlines()
            places = ("offset", "line")
            without = [{name: value for name, value in json.loads(line).items() if name not in places} for line in whole]
            self.assertEqual([{name: value for name, value in json.loads(line).items() if name not in places} for line in again],
                             without)

    def test_the_reference_reads_them_alike(self):
        for protocol in SAMPLES:
            run = subprocess.run([os.environ["REFERENCE_LINES"], "decode", protocol], input=(TRAFFIC / SAMPLES[protocol]).read_bytes(),
                                 capture_output=True, timeout=HANG, check=True)
            self.assertEqual(self.lines(protocol), run.stdout.decode("ascii").splitlines())


if __name__ == "__main__":
    unittest.main()
