"""The robot's ring under faults: all boards found, values read back, alarms neither lost nor heard twice."""

import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

from soak_support import PROGRAM, bereft_of, decoded, interrupted, run, wait_for_orphans

DAMAGE = ["--flip", 500, "--drop", 900, "--duplicate", 900, "--delay", 80]


class RobotRing(unittest.TestCase):
    def test_reaches_its_goal_on_lines_without_faults(self):
        with tempfile.TemporaryDirectory() as folder:
            status, output = run("--cycles", 5, "--alarms", 2, "--pause", 1, "--record", folder)
            self.assertEqual(status, 0, output)
            self.assertIn("goal reached", output)
            self.assertIn("5 of 5 boards, 5 rounds, 2 of 2 alarms, 0 twice", output)
            for line in range(6):
                messages, errors = decoded("daisy", pathlib.Path(folder) / f"line_{line}.daisy")
                self.assertGreater(len(messages), 50)
                self.assertEqual(errors, [], f"line {line}")

    def test_reaches_its_goal_on_lines_that_damage_bytes(self):
        for seed in (1, 100):
            with self.subTest(seed=seed), tempfile.TemporaryDirectory() as folder:
                status, output = run("--cycles", 10, "--alarms", 3, "--pause", 1, "--seconds", 300, "--seed", seed,
                                     "--record", folder, *DAMAGE)
                self.assertEqual(status, 0, output)
                self.assertIn("5 of 5 boards, 10 rounds, 3 of 3 alarms, 0 twice", output)
                self.assertNotIn(" 0 retries", output)
                messages, errors = decoded("daisy", pathlib.Path(folder) / "line_5.daisy")
                self.assertGreater(len(messages), 50)
                self.assertGreater(len(errors), 0)

    def test_ends_cleanly_on_ctrl_c(self):
        status, output, left = interrupted("--pause", 50)
        self.assertEqual((status, left), (0, 0), output)
        self.assertIn("5 of 5 boards", output)

    def test_ends_when_a_board_dies(self):
        status, said = bereft_of(3)
        self.assertIn("board 3 has ended early", said)
        self.assertEqual(status, 1)

    def test_ends_on_a_signal_at_any_time(self):
        for delay in (0.003, 0.005, 0.01, 0.02):
            ring = subprocess.Popen([PROGRAM], stdout=subprocess.DEVNULL)
            time.sleep(delay)
            ring.terminate()
            self.assertIn(ring.wait(60), (0, -signal.SIGTERM))

    def test_its_members_do_not_outlive_it(self):
        wait_for_orphans()

    def test_ends_when_nobody_reads_what_it_prints(self):
        ring = subprocess.Popen([PROGRAM, "--pause", "1"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        ring.stdout.readline()
        ring.stdout.close()
        self.assertEqual((ring.stderr.read(), ring.wait(60)), (b"", 2))
        ring.stderr.close()

    def test_gives_up_when_a_capture_cannot_be_written(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "line_3.daisy").symlink_to("/dev/full")
            status, output = run("--record", folder)
            self.assertEqual((status, output.count("No space left on device")), (2, 1), output)

    def test_refuses_options_that_it_does_not_know(self):
        self.assertEqual(run("--flop", 3)[0], 2)
        self.assertEqual(run("--flip", "x")[0], 2)
        self.assertEqual(run("--alarms", 1002), (2, "--alarms 1002: not in 0..1001\n"))
        self.assertEqual(run("--help")[0], 0)


if __name__ == "__main__":
    unittest.main()
