"""The mutation campaign from start to table."""
import argparse
import fcntl
import fnmatch
import hashlib
import json
import os
import queue
import shutil
import signal
import sys
import threading
import time
from pathlib import Path

from . import faults, run

ROOT = Path(__file__).resolve().parent.parent.parent
EXPLAINED = Path(__file__).resolve().parent / "explained.json"
RECORDED = Path(__file__).resolve().parent / "results.json"


def options(arguments=None):
    p = argparse.ArgumentParser(
        prog="tests/mutants",
        description="Seeds faults into copies of the tree, one at a time, and looks whether the tests notice and whether fuzzing does. "
                    "Ctrl-C keeps what is known; the same command goes on from there. What is known of a fault is forgotten when the code of its file changes.")
    p.add_argument("--jobs", type=int, default=1, metavar="N", help="copies that work side by side (default 1)")
    p.add_argument("--only", default="", metavar="PATTERN", help="faults whose path, kind or id match, such as '*decoder*', crc or 1a2b3c4d")
    p.add_argument("--count", type=int, default=300, metavar="N", help="so many faults: first those of checksums and slots, then a fair sample of the others (default 300; 0: all)")
    p.add_argument("--fuzz-time", type=float, default=60.0, metavar="SECONDS", help="fuzzing for each fault, all targets together (default 60)")
    p.add_argument("--programs", default="*", metavar="PATTERNS", help="which programs look for them, such as 'test_can,fuzz_can_*' (default all that apply)")
    p.add_argument("--again", action="store_true", help="judge those once more that survived and are not explained, by other programs or since tests were added")
    p.add_argument("--work", type=Path, default=ROOT / "build" / "mutants", metavar="DIR", help="where copies and results go (default build/mutants)")
    p.add_argument("--record", action="store_true", help="write what is known into tests/mutation/results.json, from where the next campaign goes on")
    p.add_argument("--list", action="store_true", help="print the faults and end")
    return p.parse_args(arguments)


def chosen(o):
    everything = faults.all_faults(ROOT)
    if o.only:
        pattern = o.only if any(c in o.only for c in "*?[") else f"*{o.only}*"
        everything = [f for f in everything if any(fnmatch.fnmatchcase(x, pattern) for x in (f.path, f.kind, f.ident))]
    return everything[:o.count] if o.count else everything


def explained():
    """{id: {"fault": what it changes, "why": nobody can notice}}."""
    return json.loads(EXPLAINED.read_text()) if EXPLAINED.is_file() else {}


NOTHING = "nothing"


class Results:
    """What is known about each fault, on disk after every one. It is forgotten when the file that the fault is in has changed in more than
    comments and texts.
    `digests` are the files' now."""

    def __init__(self, path, recorded, digests):
        self.path, self.digests, self.lock = path, digests, threading.Lock()
        self.known = self._read(recorded)
        for ident, said in self._read(path).items():
            before = self.known.setdefault(ident, said)
            # What once was noticed stays so, whoever was asked again with less.
            before.update({k: v for k, v in said.items() if not (k in run.HALVES and has_noticed(before.get(k)) and v.startswith(NOTHING))})

    def _read(self, path):
        everything = json.loads(path.read_text()) if path.is_file() else {}
        if "faults" in everything:  # as it was written once, without the files' digests
            everything = {}
        # A half that had no program is asked again, since it may have one by now.
        return {i: {k: v for k, v in r.items() if v != run.NO_PROGRAM} for i, r in everything.items() if self.digests.get(r["fault"].partition(":")[0]) == r["file"]}

    def write(self, path):
        """A line for each fault."""
        lines = [f"{json.dumps(i)}: {json.dumps(r)}" for i, r in self.known.items()]
        part = path.with_suffix(".part")
        part.write_text("{\n" + ",\n".join(lines) + "\n}\n")
        os.replace(part, path)

    def forget_others(self, idents):
        """A fault whose line has changed in its comment or texts is another one."""
        self.known = {i: r for i, r in self.known.items() if i in idents}

    def add(self, fault, said):
        with self.lock:
            self.known.setdefault(fault.ident, {"fault": fault.what, "file": self.digests[fault.path]}).update(said)
            self.write(self.path)

    def missing(self, fault, misses, again):
        """The halves that have yet to judge it: those that have not, and those that noticed nothing with fewer programs or in less time.
        `misses` is what a half would say if it noticed nothing now."""
        known = self.known.get(fault.ident, {})
        if known.get("invalid"):
            return []
        unsure = {h for h in known if h in misses and known[h].startswith(NOTHING)}
        return [h for h in misses if h not in known or (h in unsure and ((again and not noticed(known)) or not covers(known[h], misses[h])))]


def covers(said, miss):
    """Whether a half that said `said` would say `miss` too: it had as many programs and as much time."""
    (programs, seconds), (other_programs, other_seconds) = (_asked(x) for x in (said, miss))
    return programs in ("", other_programs) and seconds >= other_seconds


def _asked(miss):
    """(which programs, "" for all, and for how long) noticed nothing."""
    head, _, programs = miss.partition(" of ")
    return programs, float(head.removeprefix(f"{NOTHING} in ").removesuffix(" s")) if " in " in head else 0.0


def misses(patterns, fuzz_time):
    """What each half that programs of these patterns belong to says when it notices nothing."""
    some = "" if patterns == ["*"] else " of " + ",".join(patterns)
    said = {"tests": NOTHING + some, "fuzzing": f"{NOTHING} in {fuzz_time:g} s{some}"}
    return {h: said[h] for h in run.HALVES if any((h == "fuzzing") == p.startswith("fuzz_") or p[0] in "*?[" for p in patterns)}


def has_noticed(how):
    return bool(how) and how not in (run.NO_PROGRAM, run.NO_BUILD) and not how.startswith(NOTHING)


def noticed(known):
    """Whether any half has."""
    return any(has_noticed(known.get(h)) for h in run.HALVES)


def digests():
    """{file: digest of its code}, of the files that faults are in."""
    return {path.relative_to(ROOT).as_posix(): digest(path.read_text(encoding="utf-8")) for path in faults.files(ROOT)}


def digest(text):
    return hashlib.sha256(faults.code_of(text).encode()).hexdigest()[:12]


COLUMNS = ("faults", "when compiled", "by tests", "by fuzzing alone", "explained", "survived", "fuzzed", "by seeds", "by 60 s", "not noticed")


def count(known, explained):
    """The columns that a fault counts in."""
    tests, fuzzing = (known.get(h) or "" for h in run.HALVES)
    builds = "compile time" not in fuzzing
    yield "faults"
    if "compile time" in tests or (not has_noticed(tests) and not builds):
        yield "when compiled"
    elif has_noticed(tests):
        yield "by tests"
    elif has_noticed(fuzzing):
        yield "by fuzzing alone"
    elif all(known.get(h) for h in run.HALVES):  # else the other half may yet notice
        yield "explained" if explained else "survived"
    if fuzzing and fuzzing not in (run.NO_PROGRAM, run.NO_BUILD) and builds:
        yield "fuzzed"
        yield "not noticed" if not has_noticed(fuzzing) else "by seeds" if "seeds" in fuzzing else "by 60 s"


def table(all_faults, results, reasons):
    """The outcome by kind, then what went unnoticed, as Markdown; and how many need somebody's attention."""
    rows, invalid, total = {}, 0, dict.fromkeys(COLUMNS, 0)
    survivors, missed, refuted = [], [], []
    for f in all_faults:
        known = results.get(f.ident)
        if not known or known.get("invalid"):
            invalid += bool(known)
            continue
        counted = list(count(known, f.ident in reasons))
        for c in counted:
            row = rows.setdefault(f.kind, dict.fromkeys(COLUMNS, 0))
            row[c] += 1
            total[c] += 1
        if f.ident in reasons and noticed(known):
            refuted.append(f)
        if "explained" in counted or "survived" in counted:
            survivors.append(f)
        elif "not noticed" in counted:
            missed.append(f)
    lines = ["| kind | " + " | ".join(COLUMNS) + " |", "|---" * (len(COLUMNS) + 1) + "|"]
    for kind, row in [*sorted(rows.items()), ("all", total)]:
        lines.append(f"| {kind} | " + " | ".join(str(row[c]) for c in COLUMNS) + " |")
    half = sum(any(h not in results[f.ident] for h in run.HALVES) for f in all_faults if f.ident in results and not results[f.ident].get("invalid"))
    lines += ["", f"{total['faults']} faults that build, {invalid} that do not." + (f" {half} have been judged by one half only." if half else "")]
    for f in survivors:
        why = reasons.get(f.ident, {}).get("why")
        lines.append(f"- {f.ident} {f.title}" + (f": {why}" if why else ": **survived**"))
    lines += [f"- {f.ident} {f.title}: **explained, but noticed**" for f in refuted]
    lines += ["", "Noticed by tests, not by fuzzing:", *(f"- {f.ident} {f.title}" for f in missed)]
    return "\n".join(lines), total["survived"] + len(refuted)


def main(arguments=None):
    o = options(arguments)
    all_chosen = chosen(o)
    if o.list:
        print("\n".join(f"{f.ident} {f.title}" for f in all_chosen))
        return 0
    for program, package in (("cmake", "cmake"), ("ninja", "ninja-build"), (os.environ.get("CXX_FUZZ", "clang++"), "clang")):
        if not shutil.which(program):
            print(f"mutants: {program} was not found; on Debian: apt install {package}", file=sys.stderr)
            return 2
    o.work = o.work.resolve()
    o.work.mkdir(parents=True, exist_ok=True)
    lock = open(o.work / "lock", "w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        print(f"mutants: another campaign is at work in {o.work}", file=sys.stderr)
        return 2
    results, reasons = Results(o.work / "results.json", RECORDED, digests()), explained()
    patterns = [p.strip() for p in o.programs.split(",")]
    unnoticed = misses(patterns, o.fuzz_time)
    todo = queue.Queue()
    for f in sorted(all_chosen, key=lambda f: f.ident in reasons):  # nothing is to be expected of those, and they take the longest
        missing = results.missing(f, unnoticed, o.again and f.ident not in reasons)
        if missing:
            todo.put((f, missing))
    total = todo.qsize()
    print(f"{len(all_chosen)} faults, {total} of them to be judged", flush=True)
    stop = threading.Event()
    benches = [run.Bench(ROOT, o.work / f"job{i}", patterns, o.fuzz_time, stop.is_set) for i in range(o.jobs)]
    trouble = []

    def work(bench):
        try:
            bench.prepare(lambda text: print(text, flush=True))
            while not stop.is_set():
                fault, missing = todo.get_nowait()
                started = time.monotonic()
                said = bench.judge(fault, missing)
                if said is None or stop.is_set():
                    return
                said = {half: how or unnoticed[half] for half, how in said.items()}
                results.add(fault, said)
                outcome = ", ".join(f"{half}: {how}" for half, how in said.items())
                print(f"[{total - todo.qsize()}/{total}] {outcome}, {time.monotonic() - started:.0f} s: {fault.ident} {fault.title}", flush=True)
        except queue.Empty:
            pass
        except Exception as why:  # no room on the disk, say: what has not been judged must not look as if it had
            trouble.append(str(why) if isinstance(why, run.Broken) else repr(why))
            stop.set()
            for b in benches:
                b.stop()

    def on_signal(number, frame):
        stop.set()
        for b in benches:
            b.stop()

    signal.signal(signal.SIGINT, on_signal)
    signal.signal(signal.SIGTERM, on_signal)
    if not todo.empty():
        threads = [threading.Thread(target=work, args=(b,), daemon=True) for b in benches]
        for t in threads:
            t.start()
        for t in threads:
            while t.is_alive():
                t.join(0.2)
    if trouble:
        print(f"mutants: {trouble[0]}", file=sys.stderr)
        return 2
    text, survived = table(all_chosen, results.known, reasons)
    (o.work / "results.md").write_text(text + "\n")
    if o.record:
        results.forget_others({f.ident for f in faults.all_faults(ROOT)})
        results.write(RECORDED)
    print(text)
    return 130 if stop.is_set() else 1 if survived else 0
