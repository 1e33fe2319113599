"""Tests of the campaign's parts that need no compiler."""
import argparse
import contextlib
import hashlib
import io
import json
import subprocess
import tempfile
import unittest
import unittest.mock
from pathlib import Path

from campaign_lib import corpus, display, explain, libfuzzer, options, page, provenance, report, schedule, shrink, signature, state, toolchain

STATUS = "#1048576\tREDUCE cov: 312 ft: 1501 corp: 207/31Kb lim: 4096 exec/s: 52428 rss: 61Mb L: 57/1024 MS: 2 CopyPart-Custom-"
ASAN = """==7==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x602 at pc 0x55 bp 0x7f sp 0x7e
READ of size 1 at 0x602 thread T0
    #0 0x55d1 in trama::daisy::decoder::next(std::span<unsigned char const, 18446744073709551615ul>&) /src/include/trama/daisy/decoder.hpp:91:20
    #1 0x55d2 in void trama::fuzz::stream<trama::daisy::format>(int) /src/fuzz/harness.hpp:40:3
    #2 0x55d3 in LLVMFuzzerTestOneInput /src/fuzz/targets/daisy_stream.cpp:4:68
    #3 0x55d4 in fuzzer::Fuzzer::ExecuteCallback(unsigned char const*, unsigned long) (/x/fuzz+0x5a)

0x602 is located 0 bytes to the right of 4-byte region
"""
UBSAN = """/src/include/trama/core/bytes.hpp:31:9: runtime error: shift exponent 64 is too large for 64-bit type
    #0 0x55 in trama::xor_of_short(unsigned char const*, unsigned long) /src/include/trama/core/bytes.hpp:31:9
"""


class command_line(unittest.TestCase):
    def test_durations(self):
        for text, seconds in (("90", 90), ("90s", 90), ("10m", 600), ("1h30m", 5400), ("0.5h", 1800)):
            self.assertEqual(options.duration(text), seconds)

    def test_refuses_what_is_no_duration(self):
        for text in ("", "m", "10x", "ten", "-5", "0", "5m junk"):
            with self.assertRaises(argparse.ArgumentTypeError, msg=text):
                options.duration(text)


    def test_refuses_paths_that_a_shell_takes_apart(self):
        said = io.StringIO()
        with self.assertRaises(SystemExit) as end, contextlib.redirect_stderr(said):
            options.parse(["--out", "/tmp/my projects"])
        self.assertEqual(end.exception.code, 2)
        self.assertIn("/tmp/my projects", said.getvalue())
        self.assertEqual(str(options.parse(["--out", "/tmp/josé/campaña-1"]).out), "/tmp/josé/campaña-1")


class targets(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.source = Path(self.folder.name)
        for name in ("can_stream", "daisy_stream", "daisy_text"):
            path = self.source / "fuzz" / "targets" / f"{name}.cpp"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.touch()

    def tearDown(self):
        self.folder.cleanup()

    def test_patterns_choose(self):
        self.assertEqual(toolchain.targets(self.source), ["can_stream", "daisy_stream", "daisy_text"])
        self.assertEqual(toolchain.targets(self.source, "*_stream"), ["can_stream", "daisy_stream"])
        self.assertEqual(toolchain.targets(self.source, "fuzz_daisy_text, daisy_*"), ["daisy_text", "daisy_stream"])

    def test_a_pattern_without_targets_is_an_error(self):
        with self.assertRaisesRegex(toolchain.CannotRun, "daisy_text"):
            toolchain.targets(self.source, "nothing")

    def test_targets_share_their_formats_corpus_unless_they_have_their_own(self):
        for name in ("daisy", "daisy_text"):
            folder = self.source / "fuzz" / "corpus" / name
            folder.mkdir(parents=True)
            (folder / "seed").touch()
        self.assertEqual(corpus.group(self.source, "daisy_stream"), "daisy")
        self.assertEqual(corpus.group(self.source, "daisy_text"), "daisy_text")
        self.assertEqual([f.name for f in corpus.seed_folders(self.source, "daisy_text")], ["daisy_text"])
        self.assertEqual(corpus.seed_folders(self.source, "can_stream"), [])
        for name in ("daisy_roundtrip", "daisy_text", "can_stream"):  # what one target of a group failed on is for all of it
            folder = self.source / "fuzz" / "regressions" / name
            folder.mkdir(parents=True)
            (folder / "find").touch()
        self.assertEqual([f.name for f in corpus.seed_folders(self.source, "daisy_stream")], ["daisy", "daisy_roundtrip"])
        self.assertEqual([f.name for f in corpus.seed_folders(self.source, "daisy_text")], ["daisy_text", "daisy_text"])


class reading_engines(unittest.TestCase):
    def test_status_lines(self):
        self.assertEqual(libfuzzer.parse_status(STATUS),
                         {"runs": 1048576, "kind": "REDUCE", "coverage": 312, "features": 1501, "corpus": 207, "rate": 52428})
        self.assertIsNone(libfuzzer.parse_status("INFO: Seed: 17"))

    def test_a_fault_is_named_by_its_stack(self):
        title, key = signature.signature(ASAN, "daisy_stream")
        self.assertEqual(title, "heap-buffer-overflow in trama::daisy::decoder::next (decoder.hpp:91)")
        moved = ASAN.replace("decoder.hpp:91:20", "decoder.hpp:95:2").replace("0x55d1", "0x77aa")
        self.assertEqual(signature.signature(moved, "daisy_decode")[1], key)
        self.assertNotEqual(signature.signature(ASAN.replace("decoder::next", "decoder::hunt"), "daisy_stream")[1], key)

    def test_undefined_behaviour_is_named_by_place_and_kind(self):
        title, key = signature.signature(UBSAN, "daisy_stream")
        self.assertEqual(title, "shift exponent 64 is too large for 64-bit type at bytes.hpp:31")
        self.assertEqual(signature.signature(UBSAN.replace("exponent 64", "exponent 72"), "daisy_stream")[1], key)

    def test_broken_properties_are_told_apart_by_target_and_words(self):
        said = "property broken: decode(encode(m)) == m, message 7\n"
        title, key = signature.signature(said, "can_roundtrip")
        self.assertEqual(title, "decode(encode(m)) == m, message 7")
        self.assertEqual(signature.signature(said.replace("7", "12"), "can_roundtrip")[1], key)
        self.assertNotEqual(signature.signature(said, "daisy_roundtrip")[1], key)

    def test_disagreements_are_told_apart_by_the_side_that_refused_and_the_message(self):
        def key(message, library, reference, target="can_text"):
            return signature.signature(f'line:      {{"message":"{message}","id":3}}\nlibrary:   {library}\nreference: {reference}\n'
                                       "property broken: library and reference refuse the same lines\n", target)[1]

        ping = key("common.ping", "(0.0) can0 000#00", "(refused)")
        self.assertEqual(key("common.ping", "(0.0) can0 17F#0011\n(0.0) can0 17F#1", "(refused)"), ping)
        self.assertNotEqual(key("common.reset", "(0.0) can0 000#00", "(refused)"), ping)
        self.assertNotEqual(key("common.ping", "column 7: no number", "(0.0) can0 000#00"), ping)

    def test_no_failure_has_no_name(self):
        self.assertIsNone(signature.signature("Executed 1 runs\n", "can_roundtrip"))


class explaining(unittest.TestCase):
    """With a tool that says what it was called with and what it was given."""

    def said(self, target, octets):
        with tempfile.TemporaryDirectory() as folder:
            tool, given = Path(folder) / "tool", Path(folder) / "input"
            tool.write_text("#!/bin/sh\nprintf '%s %s %s: ' $1 $2 $3\ncat\n")
            tool.chmod(0o755)
            given.write_bytes(octets)
            return explain.explain(target, given, tool, tool)

    def test_json_is_encoded_and_what_came_of_it_decoded(self):
        self.assertIn("decode can : encode can --unchecked: {}", self.said("can_text", b"{}"))
        self.assertIn("decode daisy : encode daisy --unchecked: {}", self.said("daisy_text", b"{}"))

    def test_a_log_is_decoded(self):
        self.assertIn("decode can : (1.0) can0 080#", self.said("can_text", b"(1.0) can0 080#"))

    def test_octets_are_put_on_the_wire_and_decoded(self):
        self.assertIn("decode gateway --hex: --wire", self.said("gateway_stream", b"x"))


class shrinking(unittest.TestCase):
    def test_keeps_only_what_is_needed(self):
        small = shrink.shrink(b"junk" * 20 + b"a..b" + b"more" * 9, lambda o: b"a" in o and b"b" in o[o.index(b"a"):], 10)
        self.assertEqual(small, (b"ab", True))

    def test_octets_that_do_not_matter_become_zero(self):
        self.assertEqual(shrink.shrink(b"xyz!", lambda o: len(o) >= 3 and o[-1:] == b"!", 10), (b"\0\0!", True))

    def test_stops_when_time_is_up(self):
        ticks = iter(range(10000))
        self.assertEqual(shrink.shrink(b"abcd", lambda o: True, 0, now=lambda: next(ticks)), (b"abcd", False))


class sharing_time(unittest.TestCase):
    def test_the_least_served_target_that_is_not_running_comes_next(self):
        seconds = {"a": 10.0, "b": 3.0, "c": 5.0}
        self.assertEqual(schedule.next_target(["a", "b", "c"], seconds, {}), "b")
        self.assertEqual(schedule.next_target(["a", "b", "c"], seconds, {"b": 1}), "c")

    def test_all_variants_have_had_a_turn_before_they_begin_anew(self):
        for with_afl in (False, True):
            n = schedule.turns(with_afl)
            self.assertEqual(len({schedule.variant_of(turn, with_afl) for turn in range(n)}), n)
            self.assertEqual(schedule.variant_of(n, with_afl), schedule.variant_of(0, with_afl))

    def test_slices_are_bounded(self):
        self.assertEqual(schedule.slice_seconds(10, 1, 20), 5)
        self.assertEqual(schedule.slice_seconds(100000, 8, 1), 120)

    def test_what_is_left_fills_up_the_least_served_first(self):
        self.assertEqual(schedule.to_come({"a": 10.0, "b": 0.0}, 10, 1), {"a": 0.0, "b": 10.0})
        self.assertEqual(schedule.to_come({"a": 10.0, "b": 0.0}, 10, 2), {"a": 5.0, "b": 15.0})
        self.assertEqual(schedule.to_come({"a": 10.0, "b": 0.0}, -1, 2), {"a": 0.0, "b": 0.0})

    def test_every_variant_gets_its_turn(self):
        self.assertEqual([schedule.variant_of(i, True) for i in range(4)], ["fast", "checked", "afl", "fast"])
        self.assertEqual([schedule.variant_of(i, False) for i in range(3)], ["fast", "checked", "fast"])


def did(executions, seconds, processor=0.0, new=0):
    return {"executions": executions, "seconds": seconds, "processor": processor, "new": new}


class keeping_state(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.out = self.folder.name

    def tearDown(self):
        self.folder.cleanup()

    def open(self, asked=60, commit="c1", digest="d1"):
        return state.State(self.out, asked, ["can_stream"], {"commit": commit, "digest": digest})

    def test_an_interrupted_campaign_goes_on_and_a_finished_one_starts_again(self):
        s = self.open()
        self.assertFalse(s.resumed)
        s.data["left"] = 21.5
        s.add("can_stream", "fast", did(1000, 38.5))
        s.save()
        s = self.open()
        self.assertTrue(s.resumed)
        self.assertEqual((s.data["left"], s.data["rounds"], s.target("can_stream")["executions"]), (21.5, 1, 1000))
        s.data.update(left=-0.2, phase="done")
        s.save()
        s = self.open()
        self.assertFalse(s.resumed)
        self.assertEqual((s.data["left"], s.data["rounds"], s.target("can_stream")["executions"]), (60, 2, 1000))

    def test_a_round_whose_corpora_are_not_merged_or_measured_is_finished_first(self):
        for phase in ("merging", "measuring"):
            s = self.open()
            s.data.update(left=-0.2, phase=phase)
            s.save()
            s = self.open()
            self.assertEqual((s.resumed, s.data["phase"], s.data["left"]), (True, phase, -0.2))

    def test_other_code_begins_new_figures_and_keeps_the_earlier_ones_apart(self):
        s = self.open()
        s.add("can_stream", "fast", did(1000, 50.0, 40.0))
        s.add_point("can_stream", 312, 900)
        s.target("can_stream")["read_until"] = 5.0
        s.finds["ab"] = {"found": s.data["since"] + 1}
        s.data["left"] = 10
        s.save()
        s = self.open(commit="c2")  # the same sources
        self.assertEqual((s.resumed, s.data["earlier"]), (True, []))
        s.save()
        s = self.open(commit="c3", digest="d2")
        self.assertEqual((s.resumed, s.data["left"]), (False, 60))
        (old,) = s.data["earlier"]
        self.assertEqual((old["commit"], old["executions"], old["core_seconds"], old["processor_seconds"], old["finds"]), ("c2", 1000, 50.0, 40.0, 1))
        t = s.target("can_stream")
        self.assertEqual((t["executions"], t["seconds"], t["coverage"], t["curve"], t["variants"], t["read_until"]), (0, 0.0, 0, [], {}, 0.0))
        s.add_point("can_stream", 200, 300)
        self.assertEqual(t["coverage"], 200)

    def test_figures_of_a_state_that_names_no_code_are_earlier_ones(self):
        old = {"version": 1, "started": 5.0, "rounds": 1, "left": 0, "fuzzed": 9.0, "asked": 60, "finds": {},
               "targets": {"can_stream": {"executions": 7, "seconds": 9.0, "slices": 1, "curve": [[1, 2]], "fed_at": 8.0}}}
        Path(self.out, "state.json").write_text(json.dumps(old))
        s = self.open()
        self.assertEqual([(e["commit"], e["executions"], e["core_seconds"]) for e in s.data["earlier"]], [("", 7, 9.0)])
        self.assertEqual(s.target("can_stream")["executions"], 0)

    def test_a_damaged_state_is_put_aside(self):
        Path(self.out, "state.json").write_text("{half")
        self.assertFalse(self.open().resumed)
        self.assertTrue(Path(self.out, "state.damaged").exists())

    def test_the_curve_only_rises_and_never_goes_back_in_time(self):
        s = self.open()
        for coverage in (5, 9, 7, 12):
            s.add("can_stream", "fast", did(10, 1.0))
            s.add_point("can_stream", coverage, coverage * 3)
        self.assertEqual(s.target("can_stream")["curve"], [[1.0, 5], [2.0, 9], [4.0, 12]])
        self.assertEqual(s.target("can_stream")["features"], 36)


    def test_other_targets_start_a_round_of_their_own(self):
        code = {"commit": "1", "digest": "1"}
        for names, resumed in ((["can_stream"], False), (["daisy_stream"], False), (["daisy_stream"], True)):
            s = state.State(self.out, 60, names, code)
            self.assertEqual(s.resumed, resumed, names)
            s.data["left"] = 20
            s.save()


class provenance_of_code(unittest.TestCase):
    def test_the_digest_is_of_what_is_compiled_and_how(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder)
            (source / "include" / "trama").mkdir(parents=True)
            (source / "fuzz" / "regressions").mkdir(parents=True)
            (source / "include" / "trama" / "a.hpp").write_text("one")
            first = provenance.digest(source)
            self.assertNotEqual(provenance.digest(source, "-O3"), first)
            (source / "fuzz" / "regressions" / "input.txt").write_text("fed")
            (source / "README.md").write_text("read")
            self.assertEqual(provenance.digest(source), first)
            (source / "include" / "trama" / "a.hpp").write_text("two")
            self.assertNotEqual(provenance.digest(source), first)
            self.assertEqual(provenance.commit(source), "")

    def test_a_changed_tree_is_marked(self):
        git = ["git", "-c", "user.name=t", "-c", "user.email=t@t", "-c", "commit.gpgsign=false"]
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder)
            (source / "include").mkdir()
            (source / "include" / "a.hpp").write_text("one")
            for words in (["init", "-q"], ["add", "-A"], ["commit", "-qm", "first"]):
                subprocess.run([*git, *words], cwd=source, check=True)
            self.assertRegex(provenance.commit(source), "^[0-9a-f]{12}$")
            (source / "README.md").write_text("read")
            self.assertRegex(provenance.commit(source), "^[0-9a-f]{12}$")
            (source / "include" / "a.hpp").write_text("two")
            self.assertRegex(provenance.commit(source), "^[0-9a-f]{12}[+]$")


class corpora(unittest.TestCase):
    def test_whatever_interrupts_the_swap_a_whole_corpus_is_left(self):
        for names in (("c",), ("c", "c.small"), ("c.old", "c.small"), ("c", "c.old")):
            with tempfile.TemporaryDirectory() as out:
                for name in names:
                    Path(out, name).mkdir()
                    Path(out, name, "input").write_text("whole" if name != "c.small" else "part")
                corpus.repair(Path(out, "c"))
                self.assertEqual(sorted(p.name for p in Path(out).iterdir()), ["c"])
                self.assertEqual(Path(out, "c", "input").read_text(), "whole")

    def test_what_is_known_to_fail_or_held_already_is_not_gathered(self):
        with tempfile.TemporaryDirectory() as out:
            own, new = Path(out, "own"), Path(out, "new")
            for folder in (own, new):
                folder.mkdir()
            (own / "held").write_bytes(b"1")
            for name, octets in (("held", b"1"), ("bad", b"2"), ("good", b"3")):
                (new / name).write_bytes(octets)
            known = {hashlib.sha1(b"2").hexdigest()}
            self.assertTrue(corpus.gather([*new.iterdir(), new / "gone"], Path(out, "feed"), own, known))
            self.assertEqual([p.name for p in Path(out, "feed").iterdir()], ["good"])
            self.assertFalse(corpus.gather([new / "bad"], Path(out, "feed"), own, known))

    def test_a_target_has_the_dictionary_of_what_it_reads(self):
        source = Path(__file__).resolve().parent.parent.parent
        for name, expected in (("can_stream", "can"), ("can_reassembly", "can"), ("can_decode", "can_decode"), ("can_text", "can_text"), ("can_session", None)):
            found = corpus.dictionary(source, name)
            self.assertEqual(found and found.stem, expected, name)

    def test_an_input_that_fails_leaves_the_corpus_whatever_its_name(self):
        with tempfile.TemporaryDirectory() as out:
            bad, long = b"bad", b"l" * 5000
            for name, octets in ((hashlib.sha1(bad).hexdigest(), bad), ("named", long), ("good", b"good")):
                Path(out, name).write_bytes(octets)
            self.assertTrue(corpus.leave_out(Path(out), "/raw/can_stream-crash-" + hashlib.sha1(bad).hexdigest()))
            self.assertTrue(corpus.leave_out(Path(out), "/raw/can_stream-crash-" + hashlib.sha1(long[:4096]).hexdigest()))
            self.assertFalse(corpus.leave_out(Path(out), "/raw/can_stream-crash-" + hashlib.sha1(b"other").hexdigest()))
            self.assertEqual([p.name for p in Path(out).iterdir()], ["good"])


    def test_an_input_that_goes_while_they_are_listed_takes_no_other_with_it(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in "abc":
                (Path(folder) / name).write_bytes(b"x")
            plain = Path.stat

            def stat(path, **how):
                if path.name == "b":
                    raise FileNotFoundError(path)
                return plain(path, **how)

            with unittest.mock.patch.object(Path, "stat", stat):
                fresh = corpus.newer_than([Path(folder), Path(folder) / "none"], 0)
            self.assertEqual([Path(p).name for p in fresh], ["a", "c"])


class showing(unittest.TestCase):
    ROW = {"name": "can_stream", "running": ["fast"], "rate": 52000, "executions": 1234567, "coverage": 312, "corpus": 40, "new": 3, "finds": 0,
           "seconds": 61, "left": 30}

    def test_amounts_and_clocks(self):
        self.assertEqual([display.amount(n) for n in (0, 999, 1500, 1234567, 5e9)], ["0", "999", "1.5k", "1.2M", "5.0G"])
        self.assertEqual([display.clock(s) for s in (0, 61, 3661)], ["0:00", "1:01", "1:01:01"])

    def test_without_a_terminal_it_prints_plain_lines(self):
        stream = io.StringIO()
        display.Display(stream).update([self.ROW], 30, 60, 2)
        self.assertEqual(stream.getvalue(), "0:30 left, 2 finds, 1.2M executions: can_stream 52.0k/s cov 312 corpus 40 new 3\n")

    def test_a_table_taller_than_the_terminal_keeps_head_foot_and_running_rows(self):
        lines = display.Display._table([dict(self.ROW, name=f"t{i}", running=["fast"] if i == 19 else []) for i in range(20)], 30, 60, 0)
        fitted = display.Display._fit(lines, 8)
        self.assertEqual(len(fitted), 8)
        self.assertTrue(any("t19" in line for line in fitted))

    def test_the_report_escapes_what_programs_say(self):
        with tempfile.TemporaryDirectory() as out:
            s = state.State(out, 60, ["can_stream"])
            s.add_point("can_stream", 10, 20)
            s.finds["ab"] = {"target": "can_stream", "targets": ["can_stream"], "title": "a < b", "variant": "fast", "count": 1, "size": 1,
                             "original_size": 9, "folder": "finds/x", "found": 1.0}
            s.finds["cd"] = dict(s.finds["ab"], title="c > d", state="closed", why="its input passes now", closed=2.0)
            s.data["earlier"] = [{"commit": "0a1b", "from": 1.0, "until": 2.0, "executions": 99, "core_seconds": 3.0, "processor_seconds": 0, "finds": 4}]
            o = argparse.Namespace(out=Path(out), jobs=1, empty_corpus=False, source=Path(out))
            data = report.gather(s, o, ["can_stream"], {"clang": "true"}, {"can_stream": 4})
            report.write(out, data)
            html = Path(out, "report.html").read_text()
            self.assertIn("a &lt; b", html)
            self.assertNotIn("a < b", html)
            self.assertIn("<svg", html)
            self.assertNotIn("http", html)
            self.assertIn("c &gt; d", html)
            self.assertIn("0a1b", html)
            said = json.loads(Path(out, "report.json").read_text())
            self.assertEqual((said["targets"][0]["corpus"], len(said["finds"]), len(said["closed"]), len(said["earlier"])), (4, 1, 1, 1))

    def test_the_page_says_what_was_not_finished(self):
        for left, phase, words in ((5, "fuzzing", "stopped with 0:05 left"), (0, "merging", "before the corpora were merged"),
                                   (0, "measuring", "before the lines were measured"), (0, "done", "complete")):
            self.assertIn(words, page._progress({"left_seconds": left, "phase": phase}))

    def test_a_terminal_that_is_gone_ends_nothing(self):
        class gone(io.StringIO):
            def write(self, text):
                raise OSError(5, "Input/output error")

        display.Display(gone()).say("stopping")


if __name__ == "__main__":
    unittest.main()
