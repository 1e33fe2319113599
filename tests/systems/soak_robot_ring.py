"""The robot's ring under faults: all boards found, values read back, alarms neither lost nor heard twice."""

import pathlib
import tempfile
import unittest

from soak_support import decoded, interrupted, run

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

    def test_refuses_options_that_it_does_not_know(self):
        self.assertEqual(run("--flop", 3)[0], 2)
        self.assertEqual(run("--flip", "x")[0], 2)
        self.assertEqual(run("--help")[0], 0)


if __name__ == "__main__":
    unittest.main()
