"""Tests of how faults are derived; nothing is built."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from mutation import faults, main, run  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent.parent
SAMPLE = '''#pragma once
// a < b and "quoted" stay
constexpr bool f(int a, int b) noexcept {
    x_ ^= a;  // crc
    return a < b && b != 3;
}
const char* s = "a < b";
'''


class deriving(unittest.TestCase):
    def test_finds_operators_constants_and_steps(self):
        found = {(f.kind, f.old.strip(), f.new.strip()) for f in faults.faults_in("x.hpp", SAMPLE)}
        for expected in (("compare", "<", "<="), ("logic", "&&", "||"), ("compare", "!=", "=="), ("constant", "3", "3 + 1"), ("crc", "^=", "|=")):
            self.assertIn(expected, found)

    def test_leaves_comments_strings_and_directives_alone(self):
        for fault in faults.faults_in("x.hpp", SAMPLE):
            self.assertIn(fault.line, (3, 4, 5), fault.title)

    def test_leaves_other_machines_code_alone(self):
        text = "#if defined(__SSE2__)\nint a = b + c;\n#elif defined(__ARM_NEON)\nint a = b - c;\n#else\nint a = 3;\n#endif\nint d = 4 * b;\n"
        self.assertEqual({f.line for f in faults.faults_in("x.hpp", text)}, {2, 8})

    def test_code_is_what_is_left_without_comments_and_texts(self):
        text = 'int a = 3;  // three\nf("b // c", \'d\');\n'
        self.assertEqual(faults.code_of(text), "int a = 3; f(\"\", 'd');")
        self.assertEqual(main.digest(text), main.digest('/// One.\nint a = 3;\n\nf("another text", \'d\');'))
        self.assertNotEqual(main.digest(text), main.digest(text.replace("3;", "4;")))
        self.assertNotEqual(main.digest(text), main.digest(text.replace("'d'", "'e'")))

    def test_a_fault_changes_one_place(self):
        for fault in faults.faults_in("x.hpp", SAMPLE):
            changed = fault.applied_to(SAMPLE)
            self.assertEqual(changed[:fault.start], SAMPLE[:fault.start])
            self.assertTrue(changed.endswith(SAMPLE[fault.end:]))
            self.assertNotEqual(changed, SAMPLE)


class sampling(unittest.TestCase):
    def test_the_library_has_enough_faults_each_with_its_own_name(self):
        everything = faults.all_faults(ROOT)
        self.assertGreater(len(everything), 1000)
        self.assertEqual(len({f.ident for f in everything}), len(everything))

    def test_the_sample_covers_every_kind_and_module(self):
        sample = faults.all_faults(ROOT)[:main.options([]).count]
        self.assertGreaterEqual(len(sample), 200)
        self.assertLessEqual({"compare", "logic", "arithmetic", "bits", "bound", "constant", "width", "answer", "code", "step", "crc", "slot"}, {f.kind for f in sample})
        self.assertLessEqual({"core", "daisy", "can", "gateway"}, {f.path.split("/")[2] for f in sample if f.path.startswith("include/")})

    def test_explanations_are_of_faults_that_exist(self):
        """And it is the fault that was meant."""
        everything = {f.ident: f.what for f in faults.all_faults(ROOT)}
        for ident, said in main.explained().items():
            self.assertEqual(said["fault"], everything.get(ident), ident)


class keeping_results(unittest.TestCase):
    ALL, SOME = main.misses(["*"], 60), main.misses(["test_*", "fuzz_can_*"], 60)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path, self.recorded = Path(self.folder.name) / "results.json", Path(self.folder.name) / "recorded.json"
        self.fault = faults.faults_in("x.hpp", SAMPLE)[0]
        self.results = main.Results(self.path, self.recorded, {"x.hpp": "1"})

    def tearDown(self):
        self.folder.cleanup()

    def missing(self, misses=ALL, again=False):
        return self.results.missing(self.fault, misses, again)

    def test_a_half_judges_once(self):
        self.assertEqual(self.missing(), ["tests", "fuzzing"])
        self.results.add(self.fault, {"tests": "nothing"})
        self.assertEqual(self.missing(), ["fuzzing"])
        self.results.add(self.fault, {"fuzzing": "fuzz_can_stream (seeds)"})
        self.assertEqual(self.missing(), [])

    def test_what_some_programs_missed_is_for_all(self):
        self.assertEqual(main.misses(["test_*"], 60), {"tests": "nothing of test_*"})
        self.results.add(self.fault, self.SOME)
        self.assertEqual((self.missing(self.SOME), self.missing()), ([], ["tests", "fuzzing"]))
        self.results.add(self.fault, self.ALL)
        self.assertEqual((self.missing(self.SOME), self.missing()), ([], []))
        self.results.add(self.fault, main.misses(["*"], 5))
        self.assertEqual(self.missing(), ["fuzzing"])

    def test_again_is_for_those_that_no_half_noticed(self):
        self.results.add(self.fault, self.ALL)
        self.assertEqual(self.missing(again=True), ["tests", "fuzzing"])
        self.results.add(self.fault, {"tests": "test_can (fails)"})
        self.assertEqual(self.missing(again=True), [])

    def test_more_time_or_all_programs_ask_again_those_that_missed_it(self):
        self.results.add(self.fault, {"tests": "test_can (fails)", **{h: m for h, m in self.ALL.items() if h == "fuzzing"}})
        self.assertEqual(self.missing(main.misses(["*"], 600)), ["fuzzing"])
        self.assertEqual(self.missing(main.misses(["fuzz_can_*"], 5)), [])
        for said, miss, covered in (("nothing", "nothing of test_*", True), ("nothing of test_*", "nothing", False), ("nothing in 60 s", "nothing in 7.5 s of fuzz_*", True),
                                    ("nothing in 60 s of fuzz_*", "nothing in 60 s of fuzz_can_*", False), ("nothing in 5 s", "nothing in 60 s", False)):
            self.assertEqual(main.covers(said, miss), covered, (said, miss))

    def test_results_are_kept_for_the_same_file_alone(self):
        self.results.add(self.fault, self.ALL)
        self.results.write(self.recorded)
        self.path.unlink()
        self.assertEqual(main.Results(self.path, self.recorded, {"x.hpp": "1"}).known, self.results.known)
        self.assertEqual(main.Results(self.path, self.recorded, {"x.hpp": "2"}).known, {})
        self.assertEqual(main.Results(self.path, self.recorded, {}).known, {}, "the file is gone")
        self.path.write_text('{"code": "1", "faults": {"a": {"fault": "x.hpp: b"}}}')
        self.assertEqual(main.Results(self.path, self.path, {"x.hpp": "1"}).known, {}, "an older form")

    def test_what_is_no_fault_any_more_is_not_recorded(self):
        self.results.add(self.fault, self.ALL)
        self.results.forget_others({self.fault.ident})
        self.assertIn(self.fault.ident, self.results.known)
        self.results.forget_others({"12345678"})
        self.assertEqual(self.results.known, {})

    def test_a_half_without_a_program_is_asked_again_at_the_next_start(self):
        self.results.add(self.fault, {"tests": "test_can (fails)", "fuzzing": "no program"})
        self.assertEqual(self.missing(), [])
        self.assertEqual(main.Results(self.path, self.recorded, {"x.hpp": "1"}).missing(self.fault, self.ALL, False), ["fuzzing"])

    def test_what_is_recorded_and_what_is_new_go_together(self):
        self.results.add(self.fault, {"tests": "test_can (fails)", "fuzzing": "fuzz_can_stream (seeds)"})
        self.results.write(self.recorded)
        self.path.unlink()
        here = main.Results(self.path, self.path, {"x.hpp": "1"})
        here.add(self.fault, {"tests": "test_can (hangs)"})
        both = main.Results(self.path, self.recorded, {"x.hpp": "1"}).known[self.fault.ident]
        self.assertEqual((both["tests"], both["fuzzing"]), ("test_can (hangs)", "fuzz_can_stream (seeds)"))
        here.add(self.fault, {"tests": "nothing", "fuzzing": "nothing in 1 s"})
        both = main.Results(self.path, self.recorded, {"x.hpp": "1"}).known[self.fault.ident]
        self.assertEqual((both["tests"], both["fuzzing"]), ("test_can (fails)", "fuzz_can_stream (seeds)"))
        here.add(self.fault, {"invalid": True})
        self.assertTrue(main.Results(self.path, self.recorded, {"x.hpp": "1"}).known[self.fault.ident]["invalid"])

    def test_each_fault_counts_where_it_belongs(self):
        for tests, fuzzing, columns in (("test_can (compile time)", "fuzz_can_stream (compile time)", "when compiled"), ("test_can (hangs)", "no program", "by tests"),
                                        ("nothing", "no program", "survived"), ("test_can (fails)", "nothing in 60 s", "by tests, fuzzed, not noticed"),
                                        ("nothing", "fuzz_can_stream (fuzzing)", "by fuzzing alone, fuzzed, by 60 s"), ("test_can (fails)", "fuzz_can_stream (seeds)", "by tests, fuzzed, by seeds")):
            self.assertEqual(", ".join(main.count({"tests": tests, "fuzzing": fuzzing}, False)), "faults, " + columns)

    def test_a_fault_survives_when_both_halves_have_missed_it(self):
        for tests, fuzzing, said in ((None, "nothing in 60 s", "faults, fuzzed, not noticed"), ("nothing", None, "faults"), ("nothing", "nothing in 60 s", "faults, survived, fuzzed, not noticed"),
                                     ("nothing", "does not build", "faults, survived"), ("cli (fails)", "does not build", "faults, by tests")):
            self.assertEqual(", ".join(main.count({"tests": tests, "fuzzing": fuzzing}, False)), said)
        self.assertEqual(main.table([self.fault], {self.fault.ident: {"fuzzing": "nothing in 60 s"}}, {})[1], 0)

    def test_survivors_and_refuted_explanations_need_attention(self):
        known, reasons = {self.fault.ident: self.ALL}, {self.fault.ident: {"why": "so"}}
        self.assertEqual(main.table([self.fault], known, {})[1], 1)
        self.assertEqual(main.table([self.fault], known, reasons)[1], 0)
        self.assertEqual(main.table([self.fault], {self.fault.ident: {"tests": "cli (fails)", "fuzzing": "no program"}}, reasons)[1], 1)


class judging(unittest.TestCase):
    def judged(self, halves, **says):
        """What becomes of a fault when each half says so."""
        with tempfile.TemporaryDirectory() as folder:
            bench = run.Bench(ROOT, Path(folder), ["*"], 60, lambda: False)
            bench.tree = Path(folder)
            (bench.tree / "x.hpp").write_text(SAMPLE)
            bench.steps = lambda path: ["test_x", "fuzz_can_x"]
            bench._restore = lambda: None
            bench._first = lambda steps: says["fuzzing" if steps[0].startswith("fuzz_") else "tests"]
            return bench.judge(faults.faults_in("x.hpp", SAMPLE)[0], halves)

    def test_what_does_not_build_with_the_tests_is_no_fault(self):
        self.assertEqual(self.judged(["tests", "fuzzing"], tests="invalid", fuzzing=""), {"invalid": True})

    def test_what_does_not_build_with_fuzzing_alone_is_one(self):
        self.assertEqual(self.judged(["tests", "fuzzing"], tests="", fuzzing="invalid"), {"tests": "", "fuzzing": "does not build"})
        self.assertEqual(self.judged(["fuzzing"], fuzzing="invalid"), {"fuzzing": "does not build"})


class choosing(unittest.TestCase):
    def test_a_program_can_notice_only_what_it_is_compiled_from(self):
        bench = run.Bench(ROOT, ROOT / "build", ["*"], 60, lambda: False)
        bench.tree = ROOT
        library = ROOT / "include" / "trama"
        for name, seen, unseen in (("probe_can", "can/reassembler.hpp", "can/sensor_node.hpp"), ("test_systems", "can/sensor_node.hpp", "daisy/footing.hpp"),
                                   ("cli", "daisy/footing.hpp", "can/sensor_node.hpp"), ("fuzz_daisy_text", "daisy/footing.hpp", "can/sensor_node.hpp"),
                                   ("fuzz_gateway_stream", "gateway/decoder.hpp", "gateway/client.hpp")):
            self.assertIn(library / seen, bench._sources_of(name), name)
            self.assertNotIn(library / unseen, bench._sources_of(name), name)


if __name__ == "__main__":
    unittest.main()
