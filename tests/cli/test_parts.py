"""--jobs and --range: parts of a file, put together, print what the whole prints."""

import os
import random
import re
import subprocess
import tempfile
import unittest

from tool import HANG, TRAMA, packet, record, trama


def daisy_traffic(dice, packets):
    """Polls of motors and their answers, now and then damaged or interrupted by noise."""
    stream = bytearray()
    for _ in range(packets):
        board = f"1{dice.randrange(4)}"
        stream += packet(f"{board} 00 43") + packet(f"00 {board} C3", dice.randbytes(4))
        if dice.random() < 0.02:
            stream[-dice.randrange(1, 14)] ^= 1 << dice.randrange(8)
        if dice.random() < 0.01:
            stream += dice.randbytes(dice.randrange(400))
    return bytes(stream)


def gateway_traffic(dice, records):
    """Orders, now and then damaged."""
    stream = bytearray()
    for i in range(records):
        stream += record(f" 20{i % 100000:5}{dice.randrange(100000):5}")
        if dice.random() < 0.05:
            stream[-dice.randrange(1, 15)] = dice.choice(b"\x02\x03\x7fA ")
    return bytes(stream)


def can_traffic(dice, messages):
    """A log of messages of one to three frames, interleaved by identifier; now and then a frame is lost, doubled or late, a line is none."""
    starts = {"46": (8, 8, 8), "41": (5,), "43": (8, 2)}
    left = {identifier: [] for identifier in ("080", "081", "082", "123")}
    lines, now = [], 0
    while messages:
        identifier = dice.choice(list(left))
        if not left[identifier]:
            messages -= 1
            letter = dice.choice(list(starts))
            left[identifier] = [bytes((1, dice.randrange(200))) + bytes.fromhex(letter) + dice.randbytes(starts[letter][0] - 3)]
            left[identifier] += [dice.randbytes(size) for size in starts[letter][1:]]
        now += 3000000 if dice.random() < 0.002 else dice.randrange(2000)
        line = f"({now // 1000000}.{now % 1000000:06}) can0 {identifier}#{left[identifier].pop(0).hex().upper()}"
        if dice.random() < 0.01:
            line = dice.choice(("", "nonsense", line + "\n" + line, line[:-1]))
        lines.append(line)
    return ("\n".join(lines) + dice.choice(("", "\n"))).encode()


class Parts(unittest.TestCase):
    def setUp(self):
        self.dice = random.Random(4)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "capture")

    def check(self, protocol, stream):
        with open(self.path, "wb") as file:
            file.write(stream)
        whole = trama("decode", protocol, self.path)
        self.assertGreater(len(whole.out), len(stream))
        self.assertEqual(trama("decode", protocol, "--jobs", "3", self.path), whole)
        for _ in range(4):
            cuts = sorted(self.dice.randrange(len(stream)) for _ in range(4))
            bounds = [0, *cuts, len(stream)]
            parts = [trama("decode", protocol, "--range", f"{a}:{b}", self.path) for a, b in zip(bounds, bounds[1:])]
            self.assertEqual(b"".join(part.out for part in parts), whole.out, f"cut at {cuts}")
            self.assertEqual(max(part.status for part in parts), whole.status)
            self.assertEqual("".join(part.err for part in parts), "")

    def test_daisy(self):
        self.check("daisy", daisy_traffic(self.dice, 40000))

    def test_gateway(self):
        self.check("gateway", gateway_traffic(self.dice, 40000))

    def test_can(self):
        for messages in (1, 3000, 60000):
            with open(self.path, "wb") as file:
                file.write(can_traffic(self.dice, messages))
            for options in ([], ["--timeout", "0.5"], ["--format", "text"]):
                whole = trama("decode", "can", *options, self.path)
                self.assertIn(b"define_function" if messages > 1 else b"line", whole.out)
                for jobs in ("2", "5"):
                    self.assertEqual(trama("decode", "can", "--jobs", jobs, *options, self.path), whole)

    def test_a_log_without_line_ends(self):
        for stream in (b"x" * (3 << 20), b"\n" * (1 << 20)):
            with open(self.path, "wb") as file:
                file.write(stream)
            self.assertEqual(trama("decode", "can", "--jobs", "2", self.path), trama("decode", "can", self.path))

    def test_many_megabytes_without_a_seam(self):
        for protocol in ("daisy", "gateway"):
            with open(self.path, "wb") as file:
                file.write(bytes(40 << 20))
            whole = trama("decode", protocol, self.path)
            self.assertIn(b'"length":%d,"error":"noise"' % (40 << 20), whole.out)
            self.assertEqual(trama("decode", protocol, "--jobs", "2", self.path), whole)

    def test_garbage_has_no_seams_and_still_comes_out_whole(self):
        self.check("daisy", self.dice.randbytes(600000) + daisy_traffic(self.dice, 9000))

    def two_readings(self, times):
        """18 bytes are six readings or two replies of an encoder; what came before decides. See tests/daisy/footing.cpp."""
        encoder = packet("00 11 C3", self.dice.randbytes(4))
        return packet("11 00 03") * 60 + (bytes.fromhex("11 00 30 C4 3F") + encoder + bytes.fromhex("08 00 11 C3")) * times

    def test_jobs_on_a_stream_of_two_readings(self):
        """A part that joins in the other reading must not be taken, and where none settles there is no part."""
        text = packet("00 11 81", bytes.fromhex("80 0411000316 0e001181"))
        for stream in (self.two_readings(50000), (packet("11 00 03") + text) * 50000):
            with open(self.path, "wb") as file:
                file.write(stream)
            self.assertEqual(trama("decode", "daisy", "--jobs", "2", self.path), trama("decode", "daisy", self.path))

    def test_ranges_of_a_stream_of_two_readings(self):
        """Where a range may not fit the one before, that one says so; where none does, they print the whole."""
        stream = self.two_readings(3000)
        with open(self.path, "wb") as file:
            file.write(stream)
        whole = trama("decode", "daisy", self.path)
        self.assertEqual((whole.status, whole.err), (1, ""), "both readings have violations")
        doubtful = 0
        for cut in (0, len(stream), *(self.dice.randrange(len(stream)) for _ in range(40))):
            first, second = (trama("decode", "daisy", "--range", bounds, self.path) for bounds in (f"0:{cut}", f"{cut}:{len(stream)}"))
            if first.err == "":
                self.assertTrue(first.out + second.out == whole.out, cut)
            else:
                place = int(re.fullmatch(r"trama: decode: byte (\d+): the part behind may not fit.*\n", first.err).group(1))
                self.assertTrue(cut <= place < cut + 100, (cut, place))
                self.assertEqual(first.status, 1)
                doubtful += 1
        self.assertTrue(doubtful)

    def test_processes_side_by_side_print_the_whole(self):
        """bench/ranges_in_parallel, the pattern for a cluster's engine."""
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench", "ranges_in_parallel")
        for protocol, stream in (("daisy", daisy_traffic(self.dice, 5000)), ("gateway", gateway_traffic(self.dice, 5000))):
            with open(self.path, "wb") as file:
                file.write(stream)
            whole = trama("decode", protocol, self.path)
            self.assertEqual(whole.status, 1)
            for parts in ("1", "5"):
                run = subprocess.run([script, TRAMA, protocol, self.path, parts], capture_output=True, timeout=HANG, check=False)
                self.assertEqual((run.returncode, run.stdout, run.stderr), (whole.status, whole.out, b""))

    def test_usage(self):
        for words in (("daisy", "--range", "0:1"), ("daisy", "--range", "5:1", "f"), ("daisy", "--range", "5", "f"),
                      ("daisy", "--jobs", "0", "f"), ("daisy", "--jobs", "2", "--hex", "f"), ("can", "--range", "0:1", "f"),
                      ("daisy", "--jobs", "2", "--range", "0:1", "f"), ("daisy", "--jobs", "2", "/no/such/file")):
            self.assertEqual(trama("decode", *words).status, 2, words)


if __name__ == "__main__":
    unittest.main()
