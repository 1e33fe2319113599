"""What the tests share: running the tool, whose path comes in TRAMA, and putting packets together by hand."""

import json
import os
import subprocess
import unittest
from collections import namedtuple
from functools import reduce

TRAMA = os.environ["TRAMA"]
HANG = int(os.environ.get("CLI_HANG", "600"))  # seconds after which the tool counts as hung; nothing depends on its speed

Run = namedtuple("Run", "status out err")


def trama(*words, given=b"", **options):
    done = subprocess.run([TRAMA, *words], input=given, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          timeout=HANG, check=False, **options)
    return Run(done.returncode, done.stdout, done.stderr.decode("utf-8", "replace"))


def octets(text):
    """The bytes of hex pairs."""
    return bytes.fromhex(text)


def packet(head, data=b""):
    """A daisy packet: destination, source and command as hex pairs, then DATA; LEN and CRC are added."""
    body = octets(head) + data
    whole = bytes([len(body) + 1]) + body
    return whole + bytes([reduce(lambda a, b: a ^ b, whole)])


def record(payload):
    """A gateway record: STX, payload, ETX."""
    return b"\x02" + payload.encode("latin-1") + b"\x03"


def can_log(*frames, step=0.001, start=0.0, bus="can0"):
    """candump lines of frames written as `081#010203`."""
    return "".join(f"({start + step * i:.6f}) {bus} {frame}\n" for i, frame in enumerate(frames)).encode()


class ToolCase(unittest.TestCase):
    maxDiff = None

    def decode(self, protocol, given, *options, status=0):
        """The lines printed for this input, as text. A clean run has nothing to say on standard error."""
        run = trama("decode", protocol, *options, given=given)
        self.assertEqual((run.status, run.out[-200:] if run.status != status else b""),
                         (status, run.out[-200:] if run.status != status else b""), run.err)
        if status == 0:
            self.assertEqual(run.err, "")
        text = run.out.decode("ascii")
        self.assertTrue(text == "" or text.endswith("\n"))
        return text.splitlines()

    def decode_one(self, protocol, given, *options, status=0):
        lines = self.decode(protocol, given, *options, status=status)
        self.assertEqual(len(lines), 1, lines)
        return lines[0]

    def encode(self, protocol, *lines, options=(), status=0):
        """What encode writes for these lines, or objects, and what it says on standard error."""
        text = "".join((line if isinstance(line, str) else json.dumps(line)) + "\n" for line in lines)
        run = trama("encode", protocol, *options, given=text.encode())
        self.assertEqual(run.status, status, run.err)
        if status == 0:
            self.assertEqual(run.err, "")
        return run.out, run.err

    def encode_refuses(self, protocol, line, *named, options=()):
        """The line is refused with status 1 by a message that names each of the words, and nothing is written."""
        out, err = self.encode(protocol, line, options=options, status=1)
        self.assertEqual(out, b"")
        for word in named:
            self.assertIn(word, err)
        return err
