"""Random streams and lines, decoded and encoded by the tool, against the reference in tests/reference.

Every failure names the seed of its stream. CLI_SEEDS sets how many streams are tried, CLI_FIRST_SEED where to begin.
"""

import copy
import json
import os
import random
import re
import subprocess
import unittest

from goldens import CAN, DAISY, GATEWAY, can_line, can_text, daisy_line, daisy_packet, gateway_line, gateway_record
from tool import HANG, TRAMA, ToolCase, packet, trama

REFERENCE = os.environ["REFERENCE_LINES"]
SEEDS = range(int(os.environ.get("CLI_FIRST_SEED", "1")), int(os.environ.get("CLI_FIRST_SEED", "1")) + int(os.environ.get("CLI_SEEDS", "150")))


def reference(*words, given):
    run = subprocess.run([REFERENCE, *words], input=given, capture_output=True, timeout=HANG, check=True)
    return run.stdout.decode("ascii").splitlines()


def damaged(dice, data):
    """The bytes with one fault: a byte changed, lost, doubled or inserted, or a piece cut out."""
    if not data:
        return data
    at = dice.randrange(len(data))
    fault = dice.randrange(5)
    if fault == 0:
        return data[:at] + bytes([data[at] ^ 1 << dice.randrange(8)]) + data[at + 1:]
    if fault == 1:
        return data[:at] + data[at + 1:]
    if fault == 2:
        return data[:at + 1] + data[at:]
    if fault == 3:
        return data[:at] + bytes([dice.randrange(256)]) + data[at:]
    return data[:at] + data[at + dice.randrange(40):]


def daisy_stream(dice):
    stream = b""
    for _ in range(dice.randrange(60)):
        pick = dice.random()
        if pick < 0.6:
            piece = daisy_packet(dice.choice(DAISY))
        elif pick < 0.8:  # any addresses, any command, any data
            head = bytes([dice.choice((0, 16, 17, 32, 48, 64, 80, 98, 112, 255, dice.randrange(256))), dice.choice((0, 16, 48, 31, dice.randrange(256))),
                          dice.choice((1, 4, 0x40, 0x44, 0x81, 0xC4, dice.randrange(256)))])
            piece = packet(head.hex(), dice.randbytes(dice.choice((0, 1, 2, 3, 4, 5, 7, dice.randrange(252)))))
        else:
            piece = dice.randbytes(dice.randrange(12))
        stream += damaged(dice, piece) if dice.random() < 0.15 else piece
    return stream


def gateway_stream(dice):
    stream = b""
    for _ in range(dice.randrange(40)):
        pick = dice.random()
        if pick < 0.5:
            piece = gateway_record(dice.choice(GATEWAY))
        elif pick < 0.75:  # the characters of a record shuffled about, or replaced by digits and spaces
            payload = bytearray(gateway_record(dice.choice(GATEWAY)))
            for _ in range(dice.randrange(12)):
                payload[dice.randrange(4, len(payload) - 1)] = dice.choice(b"0123456789    -.x")
            piece = bytes(payload)
        else:
            piece = bytes(dice.choice(b"\x02\x03 0125x\x00\xff") for _ in range(dice.randrange(30)))
        stream += damaged(dice, piece) if dice.random() < 0.15 else piece
    return stream


def can_stream(dice):
    lines, time = [], 1000.0
    for _ in range(dice.randrange(60)):
        time += dice.choice((0, 0.001, 0.3, 0.999999, 1.0, 1.000001, 3, -2))
        for line in can_text(dice.choice(CAN)).decode().splitlines():
            frame = line.split()[2]
            if dice.random() < 0.3:
                frame = dice.choice(("080", "081", "082", "083", "7FF", "00000081", "82")) + frame[3:]
            if dice.random() < 0.15:
                frame = frame[:dice.randrange(3, len(frame) + 1)]
            if dice.random() < 0.2 and "#" in frame:
                digits = list(frame)
                digits[-1 - dice.randrange(max(1, min(16, len(digits) - 4)))] = dice.choice("0123456789ABCDEFRx#")
                frame = "".join(digits)
            time += dice.choice((0, 0, 0, 0.0005, 0.9, 1.1)) if dice.random() < 0.2 else 0
            lines.append(f"({max(time, 0):.6f}) can0 {frame}")
            if dice.random() < 0.03:
                lines.append(dice.choice(("", "#", "(1) can0 081#00", "(1.2 can0 081#", "(1.5) can0 081#R", "junk")))
    return ("\n".join(lines) + dice.choice(("", "\n", "\r\n"))).encode()


STREAMS = {"daisy": daisy_stream, "gateway": gateway_stream, "can": can_stream}
CLEAN = {"daisy": [daisy_line(golden) for golden in DAISY], "gateway": [gateway_line(golden) for golden in GATEWAY],
         "can": [can_line(golden) for golden in CAN]}
ODD_VALUES = (-1, 0, 1, 2, 3, 7, 15, 16, 99, 100, 101, 180, 181, 200, 201, 255, 256, 1023, 1024, 9999, 10000, 32767, 32768, 65535,
              65536, 99999, 100000, -32768, -32769, 2 ** 31 - 1, 2 ** 31, -2 ** 31, 10 ** 18, 0.5, 48.2, 1e3, True, None, "", " ", "x",
              "none", "load", "ack", "clockwise", "sleep", "a\x03", "\u00e9", "0123456789", "01234567890", "0510004055", [], [1], [0] * 4, [0] * 5,
              ["busy"], ["busy", 1, 4096], {}, {"level": 16}, [{}], [{}, {}])


def places(value):
    """Every object and list in a value, as (container, key)."""
    keys = value.keys() if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ()
    for key in list(keys):
        yield value, key
        yield from places(value[key])


def odd_line(dice, text):
    """The line with some of its values replaced, left out or added."""
    line = json.loads(text)
    for _ in range(dice.choice((0, 1, 1, 1, 2, 3))):
        container, key = dice.choice([(c, k) for c, k in places(line) if c is not line or k not in ("protocol", "kind")] or [(line, "x")])
        pick = dice.random()
        if pick < 0.7:
            container[key] = copy.deepcopy(dice.choice(ODD_VALUES))
        elif pick < 0.85:
            del container[key]
        elif isinstance(container, dict):
            container[dice.choice(("extra", "level", "offset", "error"))] = 1
    return json.dumps(line, ensure_ascii=dice.random() < 0.5)


class Decode(ToolCase):
    def compare(self, protocol):
        for seed in SEEDS:
            stream = STREAMS[protocol](random.Random(f"{protocol} {seed}"))
            options = [str(seed % 3)] if protocol == "can" else []
            expected = reference("decode", protocol, *options, given=stream)
            run = trama("decode", protocol, *(["--timeout", *options] if options else []), given=stream)
            self.assertEqual(run.out.decode("ascii").splitlines(), expected, f"{protocol}, seed {seed}")
            fault = any('"error":' in line or '"violations":' in line for line in expected)
            self.assertEqual(run.status, 1 if fault else 0, f"{protocol}, seed {seed}")

    def test_daisy(self):
        self.compare("daisy")

    def test_gateway(self):
        self.compare("gateway")

    def test_can(self):
        self.compare("can")

    def test_in_pieces(self):
        for protocol, make in STREAMS.items():
            for seed in SEEDS[::10]:
                dice = random.Random(f"{protocol} {seed}")
                stream = make(dice)
                with subprocess.Popen([TRAMA, "decode", protocol], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                      bufsize=0) as process:
                    at = 0
                    while at < len(stream):
                        size = dice.randrange(1, 400)
                        process.stdin.write(stream[at:at + size])
                        at += size
                    out, _ = process.communicate(timeout=HANG)
                self.assertEqual(out.decode("ascii").splitlines(), reference("decode", protocol, given=stream),
                                 f"{protocol}, seed {seed}")


class Encode(ToolCase):
    def compare(self, protocol):
        for seed in SEEDS:
            dice = random.Random(f"{protocol} {seed} encode")
            lines = [odd_line(dice, dice.choice(CLEAN[protocol])) for _ in range(40)]
            given = ("\n".join(lines) + "\n").encode()
            unchecked = seed % 2 == 0
            expected = reference("encode", protocol, *(["unchecked"] if unchecked else []), given=given)
            options = (["--unchecked"] if unchecked else []) + ([] if protocol == "can" else ["--hex"])
            run = trama("encode", protocol, *options, given=given)
            refused = [number for number, line in self.numbered(protocol, expected) if line == "refused"]
            said = [int(number) for number in re.findall(r"line (\d+)", run.err)]
            self.assertEqual(said, refused, f"{protocol}, seed {seed}: " +
                             "\n".join(lines[number - 1] for number in set(said) ^ set(refused)) + "\n" + run.err)
            written = [line for line in expected if line != "refused"]
            self.assertEqual([line if protocol == "can" else line.replace(" ", "") for line in run.out.decode("ascii").splitlines()],
                             written, f"{protocol}, seed {seed}")
            self.assertEqual(run.status, 1 if refused else 0)

    @staticmethod
    def numbered(protocol, outcomes):
        """The reference's lines with the numbers of the lines that they answer."""
        number, left = 0, 0
        for line in outcomes:
            if left == 0:
                number += 1
                data = line.partition("#")[2]
                if protocol == "can" and line != "refused" and len(data) == 16:
                    left = {"46": 3, "52": 2, "43": 2}[data[4:6]]
                else:
                    left = 1
            left -= 1
            yield number, line

    def test_daisy(self):
        self.compare("daisy")

    def test_gateway(self):
        self.compare("gateway")

    def test_can(self):
        self.compare("can")


if __name__ == "__main__":
    unittest.main()
