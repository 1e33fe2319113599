"""Builds one fault in a copy of the tree and looks what notices it."""
import fnmatch
import hashlib
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "fuzz"))

from campaign_lib import corpus  # noqa: E402

# What a compiler says when a check in the tests, or an array bound at compile time, has caught the fault.
_CHECKED = re.compile(r"error: [^\n]*(static assertion|static_assert|constant expression|constexpr variable|call to consteval)")
HALVES = ("tests", "fuzzing")
NO_PROGRAM, NO_BUILD = "no program", "does not build"  # why a half had nothing to say
_COPIED = ("CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "include", "src", "tests", "fuzz", "docs", "examples", "bench")


class Broken(Exception):
    """The tree is not fit for a campaign: it fails without any fault."""


def limits():
    # A fault may make a loop endless that fills memory.
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))


class Bench:
    """A copy of the tree with its build folders, which every fault starts from in the same state."""

    # All of it takes longer to compile than to run, so nothing is optimised.
    _BUILDS = {
        "tests": ("-DTRAMA_BUILD_TESTS=ON", "-DCMAKE_CXX_FLAGS=-O0 -D_GLIBCXX_ASSERTIONS"),
        "fuzz": ("-DTRAMA_BUILD_FUZZ=ON", "-DTRAMA_FUZZ_ENGINE=-fsanitize=fuzzer",
                 "-DCMAKE_CXX_FLAGS=-O0 -D_GLIBCXX_ASSERTIONS -fsanitize=fuzzer-no-link,address -fsanitize-address-use-after-return=never"),
    }

    def __init__(self, root, folder, programs, fuzz_seconds, stopped):
        self.root, self.folder = root, folder
        self.tree, self.build, self.pristine = folder / "tree", folder / "build", folder / "pristine"
        self.programs = programs
        self.fuzz_seconds, self.stopped = fuzz_seconds, stopped
        self.log = folder / "log"
        self._closures = {}
        self.seconds = {}  # that each program runs without a fault; those in it are known to pass
        self.process = None

    # Preparing

    def _sources(self):
        for name in _COPIED:
            top = self.root / name
            for path in sorted(top.rglob("*")) if top.is_dir() else [top]:
                if path.is_file() and path.suffix != ".pyc" and "mutation" not in path.relative_to(self.root).parts:
                    yield path, self.tree / path.relative_to(self.root)

    def _copy(self):
        for path, copy in self._sources():
            if not copy.is_file() or copy.read_bytes() != path.read_bytes():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(path, copy)

    def _digest(self):
        """What the copy is made from, and how it is built."""
        digest = hashlib.sha256(repr(sorted(self._BUILDS.items())).encode())
        for path, copy in self._sources():
            digest.update(str(copy.relative_to(self.tree)).encode() + b"\0" + path.read_bytes())
        return digest.hexdigest()

    def prepare(self, say):
        mark, digest = self.folder / "prepared.json", self._digest()
        before = json.loads(mark.read_text()) if mark.is_file() else {}
        if before.get("digest") == digest:  # an interrupted campaign goes on with what it has built
            self.seconds = before["seconds"]
            self._copy()  # a fault may still be in the tree
            self._restore()
        else:
            shutil.rmtree(self.folder, ignore_errors=True)
            self._copy()
            self._configure()
        for step in self.steps(None):
            self._fuzz_share = 5
            if step not in self.seconds:
                say(f"without a fault: {step}")
                self._check(step)
        shutil.copytree(self.build, self.pristine, symlinks=True, dirs_exist_ok=True)
        mark.write_text(json.dumps({"digest": digest, "seconds": self.seconds}))

    def _configure(self):
        clang = os.environ.get("CXX_FUZZ", "clang++")
        for part, settings in self._BUILDS.items():
            self._must(["cmake", "-S", str(self.tree), "-B", str(self.build / part), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
                        f"-DCMAKE_CXX_COMPILER={clang}", *settings], "configuring")

    def _check(self, step):
        """What notices a fault must not fail without one."""
        if self.stopped():
            return
        verdict = self._step(step)
        if self.stopped():
            return
        if verdict:
            raise Broken(f"{step} already fails without a fault ({verdict}); see {self.log}")
        self.seconds[step] = self._took

    def _must(self, command, what):
        if self._run(command, 1800)[0] != 0:
            raise Broken(f"{what} failed; see {self.log}")

    def _names(self):
        names = []
        for part in self._BUILDS:
            r = subprocess.run(["ninja", "-C", str(self.build / part), "-t", "targets", "all"], capture_output=True, text=True)
            names += [line.split(":")[0] for line in r.stdout.splitlines() if ":" in line]
        return names

    def steps(self, path):
        """What looks for a fault in `path`, likely finders first: test programs, then fuzz targets. All of them for None."""
        names = self._names()
        tests = sorted(n for n in set(names) if re.fullmatch(r"(test|probe)_\w+", n)) + ["cli"]
        fuzz = sorted(n for n in set(names) if re.fullmatch(r"fuzz_(daisy|can|gateway)_\w+", n))
        module = path.split("/")[2] if path and path.startswith("include/trama/") and path.count("/") > 2 else None
        if module in ("daisy", "can", "gateway"):
            fuzz = [n for n in fuzz if n.startswith(f"fuzz_{module}_")]
            others = {"daisy", "can", "gateway"} - {module}
            tests = [t for t in tests if t.partition("_")[2] not in others]
        # The probes compile quickly and know a whole format; the goldens take longest to compile, and of the targets those with the tool in them.
        first = {"probe_gateway": 0, "probe_can": 1, "probe_daisy": 2, "test_core": 3}
        first |= {f"test_{module}": 2, "test_laws": 5, "cli": 6, "test_golden": 7}
        ideas = {"stream": 0, "roundtrip": 1, "recovery": 2, "reassembly": 2, "decode": 3, "differential": 4, "text": 5, "session": 6}
        order = sorted(tests, key=lambda t: (first.get(t, 4), t)) + sorted(fuzz, key=lambda n: (ideas.get(n.split("_", 2)[2], 9), n))
        chosen = [n for n in order if any(fnmatch.fnmatchcase(n, p) for p in self.programs)]
        return [n for n in chosen if not path or path.endswith(".cpp") or self.tree / path in self._sources_of(n)]

    def _sources_of(self, name):
        """All files of the tree that a program is compiled from; only they can be noticed by it."""
        if name not in self._closures:
            kind, _, rest = name.partition("_")
            if kind == "test":
                files = list((self.tree / "tests" / rest).rglob("*.cpp"))
            elif kind == "cli":
                files = list((self.tree / "src" / "tool").glob("*.cpp"))
            elif kind == "probe":
                files = [self.tree / "tests" / "laws" / f"{law}_{rest}.cpp" for law in ("reference", "round_trip")]
                files.append(self.tree / "tests" / "subjects" / f"{rest}.cpp")
            else:
                files = [self.tree / "fuzz" / "targets" / f"{rest}.cpp", self.tree / "fuzz" / "mutators" / f"{rest.split('_')[0]}.cpp"]
            self._closures[name] = self._closure(files)
        return self._closures[name]

    def _closure(self, files):
        found, left = set(), list(files)
        while left:
            file = left.pop()
            if file in found or not file.is_file():
                continue
            found.add(file)
            if file.suffix == ".hpp" and file.parent == self.tree / "src" / "tool":
                left.extend(file.parent.glob("*.cpp"))
            for included in re.findall(r'#include "([^"]+)"', file.read_text()):
                places = (file.parent, *(self.tree / top for top in ("include", "tests", "fuzz", "src", ".")))
                left.extend((place / included).resolve() for place in places if (place / included).is_file())
        return found

    # One fault

    def judge(self, fault, halves):
        """What each half says of the fault: {half: the program that noticed and how, "" for nothing, "no program"},
        or {"invalid": True}; None if it was stopped."""
        source = self.tree / fault.path
        text, times = source.read_text(), source.stat()
        said = {}
        try:
            source.write_text(fault.applied_to(text))
            steps = self.steps(fault.path)
            for half in halves:
                mine = [s for s in steps if s.startswith("fuzz_") == (half == "fuzzing")]
                said[half] = self._first(mine) if mine else NO_PROGRAM
                if self.stopped():
                    return None
                if said[half] == "invalid":
                    if half == HALVES[0]:
                        return {"invalid": True}
                    said[half] = NO_BUILD  # with the tests it does, or they are not asked now
        finally:
            source.write_text(text)
            os.utime(source, ns=(times.st_atime_ns, times.st_mtime_ns))
            self._restore()
        return said

    def _first(self, steps):
        """The first that notices, and how."""
        left = self.fuzz_seconds
        for i, step in enumerate(steps):
            self._fuzz_share = math.ceil(left / (len(steps) - i))
            left -= self._fuzz_share
            verdict = self._step(step)
            if self.stopped() or verdict == "invalid":
                return verdict
            if verdict:
                return f"{step} ({verdict})"
        return ""

    def _restore(self):
        """Puts back every file of the build that the fault has touched."""
        kept = {p.relative_to(self.pristine): p for p in self.pristine.rglob("*") if p.is_file() and not p.is_symlink()}
        for path in self.build.rglob("*"):
            if path.is_file() and not path.is_symlink() and path.relative_to(self.build) not in kept:
                path.unlink()
        for name, path in kept.items():
            there, here = self.build / name, path.stat()
            if not there.exists() or there.stat().st_mtime_ns != here.st_mtime_ns or there.stat().st_size != here.st_size:
                shutil.copy2(path, there)

    _fuzz_share = 1
    _took = 0.0

    def _step(self, name):
        """Builds and runs one program: how it noticed something is wrong, "invalid", or nothing."""
        part = "fuzz" if name.startswith("fuzz_") else "tests"
        targets = ("trama_tool", "reference_lines") if name == "cli" else (name,)
        status, said = self._run(["cmake", "--build", str(self.build / part), "--target", *targets, "--", "-j1"], 1800)
        if status is None or (status != 0 and _CHECKED.search(said)):
            return "compile time"  # also if it never ends
        if status != 0:
            return "invalid"
        program = self.build / part / part / name
        if part == "tests":
            command = [str(program), "--gtest_brief=1", "--gtest_fail_fast"]
            if name == "cli":  # without those that look at pipes, terminals and large files, which take long
                command = ["ctest", "-E", "pipes|corners", "--test-dir", str(self.build / part), "-R", r"^cli\.", "--no-tests=error", "--stop-on-failure"]
            return self._verdict(command, 20 + 5 * self.seconds.get(name, 600))
        target = name.removeprefix("fuzz_")
        folders = [str(f) for f in corpus.seed_folders(self.tree, target)]
        if self._verdict([str(program), "-runs=0", *folders], 20 + 5 * self.seconds.get(name, 100)):
            return "seeds"
        seeds_took = self._took
        scratch = self.folder / "corpus"
        shutil.rmtree(scratch, ignore_errors=True)
        scratch.mkdir()
        seconds = max(1, math.ceil(self._fuzz_share + seeds_took))  # it counts from its start, and reads the seeds first
        verdict = self._verdict([str(program), f"-max_total_time={seconds}", "-seed=1", "-timeout=10", "-rss_limit_mb=2048", f"-artifact_prefix={scratch}/", str(scratch), *folders],
                                seconds + 120)
        self._took = seeds_took
        return verdict and "fuzzing"

    def _verdict(self, command, seconds):
        status, _ = self._run(command, seconds)
        return "" if status == 0 else "hangs" if status is None else "fails"

    def _run(self, command, seconds):
        """(status or None after too long, the beginning of what it said)."""
        sanitized = "/fuzz_" in command[0]  # reserves more than any limit, and libFuzzer has one of its own
        with open(self.log, "wb") as log:
            self.process = p = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, cwd=self.tree, start_new_session=True, preexec_fn=None if sanitized else limits)
            started = time.monotonic()
            try:
                status = p.wait(seconds)
            except subprocess.TimeoutExpired:
                os.killpg(p.pid, signal.SIGKILL)
                p.wait()
                status = None
            self._took = time.monotonic() - started
        text = Path(self.log).read_bytes()
        return status, text[:400000].decode(errors="replace")

    def stop(self):
        if self.process and self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)
