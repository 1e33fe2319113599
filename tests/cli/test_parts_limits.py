"""--jobs and --range where things run short: unreadable files, memory, threads."""

import hashlib
import os
import random
import resource
import shutil
import subprocess
import tempfile
import unittest

from test_parts import daisy_traffic, gateway_traffic
from tool import HANG, TRAMA, packet, trama

MEGA = 1 << 20
CORES = len(os.sched_getaffinity(0))


class Limits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.path = os.path.join(folder.name, "capture")

    def store(self, *pieces):
        with open(self.path, "wb") as file:
            for piece in pieces:
                file.write(piece)


class Unreadable(Limits):
    def cut_short(self, protocol, *options):
        """Runs the tool on a file that loses its second half while nobody reads what it prints."""
        with subprocess.Popen([TRAMA, "decode", protocol, *options, self.path], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as tool:
            first = tool.stdout.read(1)  # it has asked for the file's size
            os.truncate(self.path, os.path.getsize(self.path) // 2)
            out = first + tool.stdout.read()
            return out, tool.stderr.read().decode(), tool.wait(HANG)

    def test_a_file_that_becomes_shorter_is_an_error(self):
        dice = random.Random(5)
        for protocol, traffic in (("daisy", daisy_traffic(dice, 60000) * 16), ("gateway", gateway_traffic(dice, 60000) * 16)):
            for options in (("--jobs", "2"), ("--range", f"0:{len(traffic)}")):
                self.store(traffic)
                out, err, status = self.cut_short(protocol, *options)
                self.assertRegex(err, "^trama: cannot read: .*\n$", (protocol, options))
                self.assertEqual(status, 2)
                whole = trama("decode", protocol, self.path).out
                self.assertTrue(out and out.endswith(b"\n"))
                self.assertEqual(out[:len(whole) // 2], whole[:len(whole) // 2], "what could be read is printed")

    def test_what_tells_no_size_is_refused(self):
        for path in ("/proc/self/mem", "/proc/version", self.folder):
            for options in (("--jobs", "2"), ("--range", "0:9")):
                run = trama("decode", "gateway", *options, path)
                self.assertEqual((run.status, run.out), (2, b""), (path, options))
                self.assertNotEqual(run.err, "")

    def test_a_pipe_is_refused_and_not_waited_for(self):
        os.mkfifo(self.path)
        for options in (("--jobs", "2"), ("--range", "0:9")):
            self.assertEqual(trama("decode", "gateway", *options, self.path),
                             (2, b"", f"trama: decode: {self.path}: --jobs and --range need a regular file\n"))

    def test_what_cannot_be_opened_is_told_as_without_them(self):
        for path in (self.path, os.path.join(self.path, "deeper"), self.folder, ""):
            for options in (("--jobs", "2"), ("--range", "0:9")):
                run = trama("decode", "gateway", *options, path)
                self.assertEqual(run, trama("decode", "gateway", path))
                self.assertRegex(run.err, "No such file or directory|Is a directory")

    def test_an_empty_file_is_none(self):
        self.store(b"")
        for options in (("--jobs", "2"), ("--range", "0:9")):
            self.assertEqual(trama("decode", "gateway", *options, self.path), trama("decode", "gateway", self.path))


class Memory(Limits):
    """Parts whose decoder is never sure of its footing are not collected."""

    def measured(self, *options):
        """Peak memory, and what was printed as its hash."""
        environment = dict(os.environ, ASAN_OPTIONS=os.environ.get("ASAN_OPTIONS", "") + ":quarantine_size_mb=1")
        with subprocess.Popen([TRAMA, "decode", "daisy", *options, self.path], stdout=subprocess.PIPE, env=environment) as tool:
            printed = hashlib.sha256()
            while block := tool.stdout.read(MEGA):
                printed.update(block)
            _, status, used = os.wait4(tool.pid, 0)
            tool.returncode = os.waitstatus_to_exitcode(status)
        return used.ru_maxrss * 1024, printed.hexdigest(), tool.returncode

    def check(self, *pieces, jobs=("2",)):
        self.store(*pieces)
        one = self.measured()
        for count in jobs:
            many = self.measured("--jobs", count)
            self.assertEqual(many[1:], one[1:])
            # So much of lines may wait, as two have and many share; the rest is for threads.
            self.assertLess(many[0], one[0] + (32 if count == "2" else 96) * MEGA, count)

    def test_undocumented_packets_without_end(self):
        odd = packet("10 00 7E")
        self.check(packet("10 00 03") * 4, odd * (4 * MEGA // len(odd)))

    def test_undocumented_packets_for_long_stretches(self):
        odd, known = packet("10 00 7E"), packet("10 00 03")
        self.check(*(known * 400 + odd * (MEGA // len(odd)) for _ in range(4)))

    def test_many_short_packets(self):
        short = packet("10 00 03")
        self.check(short * (8 * MEGA // len(short)), jobs=("2", "64", "1024"))


class Threads(Limits):
    def test_goes_on_with_those_that_can_be_started(self):
        """As a user who may have few processes or none besides this one; root may always have more."""
        tool = os.path.join(self.folder, "trama")
        shutil.copy(TRAMA, tool)
        os.chmod(tool, 0o755)
        os.chmod(self.folder, 0o755)
        self.store(gateway_traffic(random.Random(6), 60000))
        os.chmod(self.path, 0o644)
        other = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}
        # The leak checker of a sanitized build needs a process of its own.
        environment = dict(os.environ, ASAN_OPTIONS=os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0")
        whole = trama("decode", "gateway", self.path)
        for most in (1, 3):
            run = subprocess.run([tool, "decode", "gateway", "--jobs", "16", self.path], capture_output=True, timeout=HANG, check=False, env=environment,
                                 preexec_fn=lambda most=most: resource.setrlimit(resource.RLIMIT_NPROC, (most, most)), **other)
            self.assertEqual((run.returncode, run.stdout), (whole.status, whole.out), run.stderr)

    def most(self, jobs):
        """The most threads that are seen at work."""
        most = 0
        with subprocess.Popen([TRAMA, "decode", "gateway", "--jobs", jobs, self.path], stdout=subprocess.PIPE) as tool:
            while tool.stdout.read(1 << 14):
                with open(f"/proc/{tool.pid}/status", encoding="ascii") as status:
                    most = max([most, *(int(line.split()[1]) for line in status if line.startswith("Threads:"))])
            tool.wait(HANG)
        return most

    def test_no_more_than_asked_for(self):
        self.store(gateway_traffic(random.Random(7), 60000) * 8)
        most = self.most("3")
        self.assertGreaterEqual(most, min(2, CORES))
        self.assertLessEqual(most, 3)

    def test_no_more_than_cores(self):
        self.store(gateway_traffic(random.Random(7), 60000) * 8)
        self.assertLessEqual(self.most("1024"), CORES)


if __name__ == "__main__":
    unittest.main()
