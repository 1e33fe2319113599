"""The tool on pipes: prompt, quiet when nobody listens any more, and small whatever comes."""

import os
import select
import subprocess
import sys
import tempfile
import time
import unittest

from goldens import CAN, DAISY, GATEWAY, can_line, can_text, daisy_line, daisy_packet, gateway_line, gateway_record
from tool import HANG, TRAMA, ToolCase, can_log, packet, record, trama


class Live:
    """The tool with a pipe at both ends."""

    def __init__(self, *words):
        self.process = subprocess.Popen([TRAMA, *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, bufsize=0)

    def __enter__(self):
        return self

    def __exit__(self, *what):
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            if not pipe.closed:
                pipe.close()
        self.process.kill()
        self.process.wait()

    def write(self, data):
        self.process.stdin.write(data)

    def printed(self, seconds=0):
        """What it has printed; waits that long for something to come."""
        ready, _, _ = select.select([self.process.stdout], [], [], seconds)
        return os.read(self.process.stdout.fileno(), 1 << 20) if ready else b""

    def wait_for(self, size):
        """The next `size` bytes, however long they take; what came until the pipe was silent for too long."""
        got = b""
        while len(got) < size:
            more = self.printed(HANG)
            if not more:
                break
            got += more
        return got

    def end(self):
        """Closes its input; what else it printed, its status and its complaints."""
        self.process.stdin.close()
        rest = self.process.stdout.read()
        err = self.process.stderr.read()
        return rest, self.process.wait(HANG), err


class Prompt(ToolCase):
    """With its input still open, the tool has nothing to wait for once a message's last byte has come."""

    def byte_by_byte(self, words, parts):
        with Live(*words) as live:
            for given, expected in parts:
                for index in range(len(given)):
                    self.assertEqual(live.printed(), b"", f"before byte {index} of {given!r}")
                    live.write(given[index:index + 1])
                self.assertEqual(live.wait_for(len(expected)).decode(), expected.decode())
            return live.end()

    def test_decode_daisy(self):
        parts, offset = [], 0
        for golden in DAISY[::5]:
            parts.append((daisy_packet(golden), daisy_line(golden, offset).encode() + b"\n"))
            offset += len(daisy_packet(golden))
        self.assertEqual(self.byte_by_byte(["decode", "daisy"], parts), (b"", 0, b""))

    def test_decode_daisy_hex(self):
        given = packet("10 00 03").hex(" ").encode()
        line = ('{"protocol":"daisy","offset":0,"length":5,"destination":16,"source":0,"message":"common.ping",'
                '"kind":"request","fields":{}}\n')
        self.assertEqual(self.byte_by_byte(["decode", "daisy", "--hex"], [(given, line.encode())]), (b"", 0, b""))

    def test_decode_gateway(self):
        parts, offset = [], 0
        for golden in GATEWAY:
            parts.append((gateway_record(golden), gateway_line(golden, offset).encode() + b"\n"))
            offset += len(gateway_record(golden))
        self.assertEqual(self.byte_by_byte(["decode", "gateway"], parts), (b"", 0, b""))

    def test_decode_can(self):
        parts, line = [], 1
        for golden in CAN:
            parts.append((can_text(golden), can_line(golden, line).encode() + b"\n"))
            line += len(golden[0])
        self.assertEqual(self.byte_by_byte(["decode", "can", "-"], parts), (b"", 0, b""))

    def test_encode(self):
        parts = [(gateway_line(golden).encode() + b"\n", gateway_record(golden)) for golden in GATEWAY[::4]]
        self.assertEqual(self.byte_by_byte(["encode", "gateway"], parts), (b"", 0, b""))

    def test_errors_with_their_last_byte(self):
        parts = [(record(" 50   1x"), b'{"protocol":"gateway","offset":0,"length":10,"error":"bad_number",'
                                      b'"bytes":"02203530202020317803","field":"msg_id"}\n'),
                 (record("999"), b'{"protocol":"gateway","offset":10,"length":5,"error":"unknown_message",'
                                 b'"bytes":"0239393903","type":999}\n')]
        self.assertEqual(self.byte_by_byte(["decode", "gateway"], parts), (b"", 1, b""))
        self.assertEqual(self.byte_by_byte(["decode", "can"], [(b"oops\n", b'{"protocol":"can","line":1,"error":"bad_line"}\n')]),
                         (b"", 1, b""))

    def test_text_format_is_as_prompt(self):
        with Live("decode", "gateway", "--format", "text") as live:
            live.write(record(" 50   12"))
            self.assertIn(b"idle_processing", live.wait_for(1))

    def test_many_at_once_come_without_further_input(self):
        given = b"".join(map(gateway_record, GATEWAY)) * 40
        with Live("decode", "gateway") as live:
            live.write(given)
            lines = b""
            while lines.count(b"\n") < 40 * len(GATEWAY):
                more = live.printed(HANG)
                self.assertNotEqual(more, b"", f"only {lines.count(10)} lines came")
                lines += more
            self.assertEqual(live.end(), (b"", 0, b""))


class Closed(ToolCase):
    """Nobody reads on: the tool ends, says nothing, and is not killed."""

    def closes(self, words, given):
        with Live(*words) as live:
            live.process.stdout.close()
            try:
                for _ in range(1 << 16):
                    live.write(given)
                self.fail("it reads on")
            except BrokenPipeError:
                pass
            status = live.process.wait(HANG)
            self.assertEqual(live.process.stderr.read(), b"")
            self.assertIn(status, (0, 1))

    def test_decode(self):
        self.closes(["decode", "daisy"], packet("10 00 03") * 1000)
        self.closes(["decode", "gateway"], record(" 50   12") * 1000)
        self.closes(["decode", "can"], can_log("081#020452") * 1000)
        self.closes(["decode", "gateway", "--format", "text"], record(" 50   12") * 1000)

    def test_encode(self):
        self.closes(["encode", "gateway"], b'{"message":"idle_processing"}\n' * 1000)

    def test_describe_and_help(self):
        for words in (["describe"], ["describe", "daisy"], ["--help"], ["--version"]):
            read, write = os.pipe()
            os.close(read)
            try:
                run = subprocess.run([TRAMA, *words], stdout=write, stderr=subprocess.PIPE, timeout=HANG, check=False)
            finally:
                os.close(write)
            self.assertEqual(run.stderr, b"")
            self.assertIn(run.returncode, (0, 1))

    def test_after_the_first_line(self):
        with tempfile.TemporaryFile() as file:
            file.write(record(" 50   12") * 200_000)
            file.seek(0)
            with subprocess.Popen([TRAMA, "decode", "gateway"], stdin=file, stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE) as process:
                self.assertIn(b"idle_processing", process.stdout.readline())
                process.stdout.close()
                self.assertEqual(process.stderr.read(), b"")
                self.assertIn(process.wait(HANG), (0, 1))


class NonBlocking(ToolCase):
    """A pipe that somebody else made non-blocking is waited for like any other."""

    def piped(self, words, given, end):
        """What the tool prints when its end of a pipe does not block and the other side takes its time."""
        with subprocess.Popen([TRAMA, *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0,
                              preexec_fn=lambda: os.set_blocking(end, False)) as process:
            if end == 0:
                time.sleep(0.2)
                process.stdin.write(given[:len(given) // 2])
                time.sleep(0.2)
                process.stdin.write(given[len(given) // 2:])
            else:
                process.stdin.write(given)
            time.sleep(0.2)
            out, err = process.communicate(timeout=HANG)
            return out, err, process.returncode

    def test_standard_input(self):
        given = record(" 50   12") * 2
        expected = trama("decode", "gateway", given=given).out
        self.assertEqual(self.piped(["decode", "gateway"], given, 0), (expected, b"", 0))
        given = b'{"message":"idle_processing","fields":{"msg_id":12}}\n' * 2
        self.assertEqual(self.piped(["encode", "gateway"], given, 0), (record(" 50   12") * 2, b"", 0))

    def test_standard_output(self):
        given = record(" 50   12") * 4000  # what they say is more than a pipe holds
        expected = trama("decode", "gateway", given=given).out
        self.assertGreater(len(expected), 1 << 18)
        out, err, status = self.piped(["decode", "gateway"], given, 1)
        self.assertEqual((len(out), err, status), (len(expected), b"", 0))
        self.assertTrue(out == expected)

    def test_standard_error(self):
        out, err, status = self.piped(["encode", "gateway"], b"oops\n" * 12000, 2)
        self.assertEqual((out, status), (b"", 1))
        self.assertEqual(err.count(b"\n"), 12000)


class Small(ToolCase):
    """64 MB of messages take no more memory than 64 kB, nor do 16 MB of anything else. What this script itself needs is
    part of both figures."""

    MEGA = 1 << 20

    def peak(self, words, block, size, before, status_due):
        """The tool's peak memory on `before` and so many bytes of blocks."""
        # Under AddressSanitizer freed memory is kept back, by default more than the whole input.
        environment = dict(os.environ, ASAN_OPTIONS=os.environ.get("ASAN_OPTIONS", "") + ":quarantine_size_mb=1")
        block *= max(1, 65536 // len(block))
        with tempfile.TemporaryFile() as file:
            file.write(before)
            for _ in range(size // len(block)):
                file.write(block)
            file.seek(0)
            process = subprocess.Popen([TRAMA, *words], stdin=file, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                       env=environment)
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, status_due)
        return used.ru_maxrss * 1024

    def flat(self, words, block, before=b"", size=16 * MEGA, status=1):
        small = self.peak(words, block, 65536, before, status)
        large = self.peak(words, block, size, before, status)
        self.assertLess(large, small + 4 * self.MEGA)

    def test_decode_messages(self):
        long = packet("00 10 81", b"long descriptions keep the number of lines down".ljust(251)) * 20
        self.flat(["decode", "daisy"], b"".join(map(daisy_packet, DAISY)) + long, size=64 * self.MEGA, status=0)
        self.flat(["decode", "gateway"], b"".join(map(gateway_record, GATEWAY)), size=64 * self.MEGA, status=0)
        self.flat(["decode", "can"], b"".join(map(can_text, CAN)), size=64 * self.MEGA, status=0)

    def test_decode_hex(self):
        self.flat(["decode", "gateway", "--hex"], gateway_record(GATEWAY[0]).hex().encode(), status=0)

    def test_encode(self):
        self.flat(["encode", "gateway"], "".join(gateway_line(golden) + "\n" for golden in GATEWAY).encode(), status=0)
        self.flat(["encode", "can", "--unchecked"], "".join(can_line(golden) + "\n" for golden in CAN).encode(), status=0)

    def test_no_end_of_a_record_in_sight(self):
        self.flat(["decode", "gateway"], b"1", before=b"\x02")
        self.flat(["decode", "gateway"], b"noise")

    def test_no_footing_on_the_ring(self):
        self.flat(["decode", "daisy"], b"\0")
        self.flat(["decode", "daisy"], b"\xff\x01\x02\x03\x55")

    def test_no_end_of_a_line_in_sight(self):
        self.flat(["decode", "can"], b"0", before=b"(1.0) can0 081#")
        self.flat(["encode", "gateway"], b" ", before=b"{")
        self.flat(["encode", "gateway"], b"x", before=b'{"')
        self.flat(["decode", "daisy", "--hex"], b" ", status=0)

    def test_the_measure_sees_memory(self):
        """A program that keeps its input does not pass as small."""
        def peak_of(size):
            program = f"kept = b'x' * {size}; print(len(kept))"
            process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.DEVNULL)
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            return used.ru_maxrss * 1024
        self.assertGreater(peak_of(16 * self.MEGA), peak_of(1) + 4 * self.MEGA)


if __name__ == "__main__":
    unittest.main()
