"""Tests of slices, with shell scripts that say what libFuzzer would."""
import hashlib
import tempfile
import time
import types
import unittest
from pathlib import Path

from campaign_lib import afl, corpus, fuzzing, libfuzzer, state

READ = "echo '#3 INITED cov: 30 ft: 40 corp: 2/9b exec/s: 0 rss: 27Mb' >&2\n"
RUN = "echo '#100 NEW    cov: 35 ft: 50 corp: 3/9b lim: 4 exec/s: 100 rss: 27Mb L: 5/5' >&2\n"
DONE = "echo 'stat::number_of_executed_units: 150' >&2\nexit 0\n"


def failing(name):
    return f"echo \"artifact_prefix='raw/t-'; Test unit written to raw/t-crash-{name}\" >&2\nexit 77\n"


class slices(unittest.TestCase):
    """`turns` are the scripts of the processes one after the other; the last one serves for all that follow."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = Path(self.folder.name)
        (self.out / "corpus").mkdir()
        self.asked = []

    def tearDown(self):
        self.folder.cleanup()

    def slice(self, turns, feed=None, seconds=30):
        def command(left):
            self.asked.append(left)
            return ["sh", "-c", turns[min(len(self.asked), len(turns)) - 1]]

        return libfuzzer.LibFuzzerSlice("t", "fast", seconds, command, feed and ["sh", "-c", feed],
                                        lambda path: corpus.leave_out(self.out / "corpus", path), {}, self.out / "log")

    def run_slice(self, *turns, **how):
        s = self.slice(turns, **how)
        s.start()
        s.join(20)
        self.assertFalse(s.is_alive())
        return s

    def test_a_find_does_not_end_the_slice(self):
        s = self.run_slice(READ + RUN + failing("a"), READ + RUN + failing("b"), READ + RUN + DONE)
        self.assertEqual([Path(p).name for p in s.artifacts], ["t-crash-a", "t-crash-b"])
        self.assertEqual((s.executions, s.trouble), (100 + 100 + 150, ""))
        self.assertTrue(30 >= self.asked[0] > self.asked[1] > self.asked[2] > 10)

    def test_an_input_of_the_corpus_that_fails_is_left_out(self):
        bad = hashlib.sha1(b"bad").hexdigest()
        (self.out / "corpus" / bad).write_bytes(b"bad")
        s = self.run_slice(failing(bad), READ + RUN + DONE)
        self.assertEqual(list((self.out / "corpus").iterdir()), [])
        self.assertEqual((len(s.artifacts), s.executions, s.trouble), (1, 150, ""))

    def test_one_that_always_fails_before_it_has_read_its_corpus_gives_up(self):
        s = self.run_slice(failing("unknown"))
        self.assertEqual(len(self.asked), s.HOPELESS)
        self.assertIn("before it has read its corpus", s.trouble)

    def test_it_waits_while_too_much_is_to_be_filed(self):
        s = self.slice([READ + DONE], seconds=3)
        waiting = iter([99, 99, 99])
        s._backlog = lambda: next(waiting, 0)
        s.start()
        time.sleep(0.3)
        self.assertEqual(self.asked, [])
        s.join(20)
        self.assertEqual(len(self.asked), 1)

    def test_an_end_without_an_input_is_told(self):
        s = self.run_slice("echo 'out of luck' >&2\nexit 3\n")
        self.assertEqual((len(self.asked), s.trouble), (1, "t (fast) ended with status 3: out of luck"))

    def test_what_others_found_is_read_only_when_the_merge_ended_well(self):
        s = self.run_slice(READ + DONE, feed="echo '#9 DONE cov: 9 ft: 9 corp: 9/9b exec/s: 9' >&2\n" + failing("fed"))
        self.assertFalse(s.fed)
        self.assertEqual((len(s.artifacts), s.executions, s.live["coverage"]), (1, 150, 30))
        self.assertIn("could not read seeds", s.trouble)
        self.asked = []
        self.assertTrue(self.run_slice(READ + DONE, feed="exit 0").fed)

    def test_figures_come_in_parts_that_add_up(self):
        s = self.slice([READ + RUN + "sleep 1\ni=0; while [ $i -lt 20000 ]; do i=$((i+1)); done\n" + DONE])
        s.start()
        parts = []
        while s.is_alive():
            time.sleep(0.1)
            parts.append(s.take_figures())
        parts.append(s.take_figures())
        self.assertEqual(sum(p["executions"] for p in parts), 150)
        self.assertEqual(parts[0]["executions"], 100)
        self.assertAlmostEqual(sum(p["seconds"] for p in parts), s.elapsed)
        self.assertGreater(sum(p["processor"] for p in parts), 0)

    def test_stop_ends_it_during_the_merge_and_after(self):
        for turns, feed in (([READ + "exec sleep 60"], None), ([READ + DONE], "trap '' INT; sleep 60")):
            s = self.slice(turns, feed=feed)
            s.start()
            time.sleep(0.3)
            s.stop()
            s.join(10)
            self.assertFalse(s.is_alive())
            self.assertEqual((s.fed, s.trouble), (False, ""))


class afl_slices(unittest.TestCase):
    def test_what_a_killed_campaign_left_in_afl_s_own_folders_is_kept(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder)
            for name in ("seeds", "corpus", "raw", "afl/t/default/queue", "afl/t/default/crashes"):
                (out / name).mkdir(parents=True)
            (out / "afl/t/default/queue/id:000001,src:0").write_bytes(b"new")
            (out / "afl/t/default/crashes/id:000000,sig:06").write_bytes(b"bad")
            anew = out / "fuzz"  # AFL++ begins anew where it finds a queue
            anew.write_text(f"#!/bin/sh\nrm -r {out}/afl/t/default\n")
            anew.chmod(0o755)
            s = afl.AflSlice("t", 1, {"fuzz": str(anew)}, "program", [out / "seeds"], out / "afl/t", out / "corpus", out / "raw", None, set(), out / "log")
            s.start()
            s.join(20)
            self.assertEqual([p.read_bytes() for p in (out / "corpus").iterdir()], [b"new"])
            self.assertEqual([p.read_bytes() for p in (out / "raw").iterdir()], [b"bad"])
            self.assertEqual(s.artifacts, [str(p) for p in (out / "raw").iterdir()])


class ending(unittest.TestCase):
    def test_who_asks_twice_leaves_nothing_running(self):
        with tempfile.TemporaryDirectory() as out:
            s = libfuzzer.LibFuzzerSlice("t", "fast", 60, lambda left: ["sh", "-c", "trap '' INT; sleep 60 & wait; wait"], None, None, {}, Path(out) / "log")
            s.start()
            c = types.SimpleNamespace(o=None, state=state.State(out, 60, ["t"]))
            f = fuzzing.Fuzzing(c, None)
            f._running.append(s)
            time.sleep(0.3)

            def again():
                raise KeyboardInterrupt
            f._run = again
            self.assertRaises(KeyboardInterrupt, f.run)
            s.join(10)
            self.assertFalse(s.is_alive())


class booking(unittest.TestCase):
    def test_features_are_taken_without_value_profile_and_edges_of_the_fast_variant(self):
        with tempfile.TemporaryDirectory() as out:
            c = types.SimpleNamespace(o=None, state=state.State(out, 60, ["t"]))
            f = fuzzing.Fuzzing(c, None)
            for variant, value_profile, coverage, features in (("fast", False, 30, 40), ("fast", True, 31, 900), ("checked", False, 99, 99)):
                s = libfuzzer.LibFuzzerSlice("t", variant, 5, None, None, None, {}, None, value_profile)
                s.live.update(coverage=coverage, features=features)
                f._take(s)
            t = c.state.target("t")
            self.assertEqual((t["coverage"], t["features"]), (31, 40))
            self.assertEqual(t["curve"], sorted(t["curve"]))


if __name__ == "__main__":
    unittest.main()
