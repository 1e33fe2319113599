"""Tests of what becomes of failing inputs, with a program that fails by rule instead of a fuzz target."""
import hashlib
import tempfile
import unittest
from pathlib import Path

from campaign_lib import engine, finds, state

# Fails when its input contains a word of the file "faults" beside it: "word=what is said".
PROGRAM = """#!/bin/sh
for last; do :; done
while IFS='=' read -r word said; do
    grep -q "$word" "$last" && { echo "property broken: $said" >&2; exit 77; }
done < "$(dirname "$0")/faults"
exit 0
"""


class filing(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = Path(self.folder.name)
        for name in ("raw", "finds"):
            (self.out / name).mkdir()
        self.program = self.out / "program"
        self.program.write_text(PROGRAM)
        self.program.chmod(0o755)
        self.stopped = False
        self.faults("apple=same words", "pear=same words", "plum=other words")
        self.start()

    def tearDown(self):
        self.folder.cleanup()

    def faults(self, *lines):
        (self.out / "faults").write_text("".join(line + "\n" for line in lines))

    def start(self):
        self.state = state.State(self.out, 60, ["t"])
        self.finder = finds.Finder(self.out, self.state, lambda target, variant: self.program if variant == "checked" else None, None,
                                   engine.sanitizer_environment(""), self.out,
                                   False, lambda text: None, lambda: self.stopped)

    def restart_mended(self, *faults):
        self.faults(*faults)
        self.start()
        self.finder.replay()

    def take(self, octets):
        raw = self.out / "raw" / f"t-crash-{hashlib.sha1(octets).hexdigest()}"
        raw.write_bytes(octets)
        return self.finder.take("t", raw)

    def take_raw(self):
        return [self.finder.take("t", p) for p in sorted((self.out / "raw").iterdir())]

    def test_a_find_is_minimised_and_further_inputs_of_it_are_kept(self):
        ident = self.take(b"an apple.")
        self.assertEqual((self.out / "finds" / f"t-{ident}" / "input").read_bytes(), b"apple")
        self.assertEqual([self.take(f"{n} apples".encode()) for n in range(8)], [None] * 8)
        self.assertEqual(len(list((self.out / "finds" / f"t-{ident}" / "more").iterdir())), finds.MORE)
        self.assertEqual(self.state.finds[ident]["count"], 9)
        self.assertEqual(list((self.out / "raw").iterdir()), [])
        known = finds.open_inputs(self.out, self.state.finds)
        self.assertEqual(len(known), 2 + finds.MORE)
        self.assertIn(hashlib.sha1(b"apple").hexdigest(), known)

    def test_a_mended_find_is_closed_and_what_it_hid_is_filed(self):
        apple, plum = self.take(b"an apple."), self.take(b"plums")
        self.take(b"a pear.")
        self.faults("pear=same words", "plum=other words")
        self.start()
        self.finder.replay()
        (pear,) = self.take_raw()
        self.assertEqual(set(self.state.open_finds()), {plum, pear})
        self.assertEqual((self.out / "finds" / f"t-{pear}" / "input").read_bytes(), b"pear")
        self.assertEqual((self.out / "finds" / "closed" / f"t-{apple}" / "input").read_bytes(), b"apple")
        self.assertEqual(self.state.finds[apple]["why"], "its input passes now")
        self.assertIsNone(self.take(b"pears"))

    def test_when_all_is_mended_nothing_is_open(self):
        self.take(b"an apple.")
        self.faults()
        self.start()
        self.finder.replay()
        self.assertEqual(self.state.open_finds(), {})
        self.assertEqual(list((self.out / "raw").iterdir()), [])

    def test_what_never_failed_again_is_open_until_the_next_start(self):
        ident = self.take(b"a stone")
        self.assertIn(ident, self.state.open_finds())
        self.finder.replay()
        self.assertEqual(self.state.open_finds(), {})
        self.assertEqual(self.state.finds[ident]["why"], "it never failed a second time")

    def test_a_find_without_a_key_of_an_older_state_stays_open(self):
        ident = self.take(b"an apple.")
        del self.state.finds[ident]["key"], self.state.finds[ident]["state"]
        self.finder.replay()
        self.assertIn(ident, self.state.open_finds())
        self.assertIsNone(self.take(b"apples"))

    def test_an_interrupted_minimisation_is_finished_at_the_next_start(self):
        self.stopped = True
        ident = self.take(b"an apple.")
        self.assertEqual((self.state.finds[ident]["size"], self.state.finds[ident]["to_minimise"]), (9, True))
        self.stopped = False
        self.start()
        self.finder.finish()
        self.assertEqual((self.state.finds[ident]["size"], self.state.finds[ident]["to_minimise"]), (5, False))
        self.assertEqual((self.out / "finds" / f"t-{ident}" / "input").read_bytes(), b"apple")
        self.assertEqual((self.out / "finds" / f"t-{ident}" / "original").read_bytes(), b"an apple.")

    def test_a_find_that_there_was_no_time_to_minimise_is_minimised_later(self):
        finds.SHRINKING, before = 0, finds.SHRINKING
        try:
            ident = self.take(b"an apple.")
        finally:
            finds.SHRINKING = before
        self.assertTrue(self.state.finds[ident]["to_minimise"])
        self.finder.finish()
        self.assertEqual((self.state.finds[ident]["size"], self.state.finds[ident]["to_minimise"]), (5, False))

    def test_nothing_is_closed_before_all_that_it_hid_has_gone_back(self):
        apple = self.take(b"an apple.")
        self.take(b"a pear.")
        self.stopped = True
        self.faults("pear=same words")
        self.finder._look_again(apple, self.state.finds[apple])
        self.assertIn(apple, self.state.open_finds())
        self.stopped = False
        self.restart_mended("pear=same words")
        self.assertEqual(self.state.open_finds(), {})
        self.assertEqual([p.read_bytes() for p in (self.out / "raw").iterdir()], [b"a pear."])

    def test_one_find_that_cannot_be_looked_at_does_not_hold_up_the_others(self):
        apple, plum = self.take(b"an apple."), self.take(b"plums")
        examine = self.finder.examine

        def failing(target, path):
            if b"apple" in path.read_bytes():
                raise OSError("no memory")
            return examine(target, path)

        self.finder.examine = failing
        self.faults()
        self.finder.replay()
        self.assertEqual(set(self.state.open_finds()), {apple})
        self.assertNotIn(plum, self.state.open_finds())

    def test_what_was_slow_but_once_goes_back_to_the_corpus(self):
        raw = self.out / "raw" / "t-timeout-x"
        raw.write_bytes(b"a stone")
        self.assertIsNone(self.finder.take("t", raw))
        self.assertEqual([p.read_bytes() for p in (self.out / "corpus" / "t").iterdir()], [b"a stone"])
        self.assertEqual(list((self.out / "raw").iterdir()), [])

    def test_only_what_fails_again_is_adopted(self):
        self.finder._adopt, self.finder._source = True, self.out / "source"
        self.take(b"a stone")
        self.assertFalse((self.out / "source").exists())
        ident = self.take(b"an apple.")
        self.assertEqual([p.name for p in (self.out / "source" / "fuzz" / "regressions" / "t").iterdir()], [ident])

    def test_finds_that_read_alike_are_not_endless(self):
        self.faults(*(f"fault{n}x=same words" for n in range(20)))
        filed = [self.finder._place("t", "same words", f"key {n}") for n in range(3)]
        self.assertEqual(len(set(filed)), 3)
        for n in range(finds.ALIKE):
            self.state.finds[f"id{n}"] = {"target": "t", "title": "same words", "key": f"key {n}", "state": "open"}
        self.assertEqual(self.finder._place("t", "same words", "another key"), "id0")
        self.assertNotIn(self.finder._place("t", "other words", "yet another key"), self.state.finds)


if __name__ == "__main__":
    unittest.main()
