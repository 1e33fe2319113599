"""The greenhouse under faults: every node gets the time and its function and is read all day."""

import pathlib
import tempfile
import unittest

from soak_support import bereft_of, decoded, interrupted, run, wait_for_orphans


class Greenhouse(unittest.TestCase):
    def test_a_day_without_faults(self):
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder) / "day.log"
            status, output = run("--seconds", 5, "--record", log)
            self.assertEqual(status, 0, output)
            self.assertEqual(output.count("4 of 4 preparations"), 2, output)
            self.assertEqual(output.count("0 times with the wrong sensors"), 4, output)
            messages, errors = decoded("can", log)
            self.assertEqual(errors, [])
            self.assertEqual({m["message"] for m in messages}, {"define_function", "read_sensors", "sensor_readings", "set_actuator", "set_clock"})

    def test_a_day_on_a_bus_that_loses_doubles_and_delays_frames(self):
        for seed in (1, 2):
            with self.subTest(seed=seed):
                status, output = run("--seconds", 6, "--drop", 25, "--duplicate", 40, "--delay", 30, "--seed", seed)
                self.assertEqual(status, 0, output)
                self.assertIn("goal reached", output)
                self.assertNotIn(" 0 faults", output)

    def test_falls_back_to_datagrams_where_there_is_no_such_interface(self):
        status, output = run("--seconds", 3, "--can", "nosuchcan")
        self.assertEqual(status, 0, output)
        self.assertIn("using UNIX datagrams", output)

    def test_ends_cleanly_on_ctrl_c(self):
        status, output, left = interrupted()
        self.assertEqual((status, left), (0, 0), output)

    def test_ends_when_a_member_dies(self):
        for member, name in ((0, "the central master"), (2, "master 2"), (4, "node 2")):
            with self.subTest(name=name):
                status, said = bereft_of(member)
                self.assertIn(name + " has ended early", said)
                self.assertEqual(status, 1)

    def test_its_members_do_not_outlive_it(self):
        wait_for_orphans(20)  # before the day is over

    def test_gives_up_when_its_recording_cannot_be_written(self):
        status, output = run("--record", "/dev/full")
        self.assertEqual((status, output.count("No space left on device")), (2, 1), output)


if __name__ == "__main__":
    unittest.main()
