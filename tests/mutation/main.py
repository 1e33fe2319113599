"""The mutation campaign from start to table."""
import argparse
import fcntl
import fnmatch
import json
import os
import queue
import shutil
import signal
import sys
import threading
from pathlib import Path

from . import faults, run

ROOT = Path(__file__).resolve().parent.parent.parent
EXPLAINED = Path(__file__).resolve().parent / "explained.json"


def options(arguments=None):
    p = argparse.ArgumentParser(
        prog="tests/mutants",
        description="Seeds faults into copies of the tree, one at a time, and looks whether the tests or fuzzing notice. "
                    "Ctrl-C keeps what is known; the same command goes on from there.")
    p.add_argument("--jobs", type=int, default=1, metavar="N", help="copies that work side by side (default 1)")
    p.add_argument("--only", default="", metavar="PATTERN", help="faults whose path, kind or id match, such as '*decoder*', crc or 1a2b3c4d")
    p.add_argument("--count", type=int, default=240, metavar="N", help="so many faults, a fair sample of all (default 240; 0: all)")
    p.add_argument("--fuzz-time", type=float, default=60.0, metavar="SECONDS", help="fuzzing for each fault that the tests miss, all targets together (default 60)")
    p.add_argument("--programs", default="*", metavar="PATTERNS", help="which programs look for them, such as 'test_can,fuzz_can_*' (default all that apply)")
    p.add_argument("--thorough", action="store_true", help="go on after the first program that notices, to see which others do")
    p.add_argument("--again", action="store_true", help="judge those once more that survived and are not explained, by other programs or since tests were added")
    p.add_argument("--work", type=Path, default=ROOT / "build" / "mutants", metavar="DIR", help="where copies and results go (default build/mutants)")
    p.add_argument("--list", action="store_true", help="print the faults and end")
    return p.parse_args(arguments)


def chosen(o):
    everything = faults.all_faults(ROOT)
    if o.only:
        pattern = o.only if any(c in o.only for c in "*?[") else f"*{o.only}*"
        everything = [f for f in everything if any(fnmatch.fnmatchcase(x, pattern) for x in (f.path, f.kind, f.ident))]
    return everything[:o.count] if o.count else everything


def explained():
    return json.loads(EXPLAINED.read_text()) if EXPLAINED.is_file() else {}


class Results:
    """What is known about each fault, on disk after every one."""

    def __init__(self, path):
        self.path, self.lock = path, threading.Lock()
        self.known = json.loads(path.read_text()) if path.is_file() else {}

    def add(self, fault, outcome):
        with self.lock:
            self.known[fault.ident] = dict(outcome, path=fault.path, line=fault.line, kind=fault.kind, title=fault.title, source=fault.source)
            part = self.path.with_suffix(".part")
            part.write_text(json.dumps(self.known, indent=1) + "\n")
            os.replace(part, self.path)


def table(all_faults, results, reasons):
    """The outcome by kind, then every survivor, as Markdown."""
    rows = {}
    for f in all_faults:
        r = results.get(f.ident)
        if not r:
            continue
        verdict = r["verdict"]
        if verdict == "survived" and f.ident in reasons:
            verdict = "explained"
        elif verdict == "killed":
            by = r["by"][0]
            verdict = "compile time" if "compile time" in by else "seeds" if "seeds" in by else "fuzzing" if by.startswith("fuzz_") else "tests"
        rows.setdefault(f.kind, {}).setdefault(verdict, 0)
        rows[f.kind][verdict] += 1
    columns = ("compile time", "tests", "seeds", "fuzzing", "explained", "survived", "invalid")
    lines = ["| kind | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    total = dict.fromkeys(columns, 0)
    for kind in sorted(rows):
        lines.append(f"| {kind} | " + " | ".join(str(rows[kind].get(c, 0)) for c in columns) + " |")
        for c in columns:
            total[c] += rows[kind].get(c, 0)
    lines.append("| all | " + " | ".join(str(total[c]) for c in columns) + " |")
    real = sum(total.values()) - total["invalid"]
    lines += ["", f"{real} faults that build, {real - total['survived'] - total['explained']} noticed, {total['explained']} explained as equivalent, {total['survived']} survived."]
    for f in all_faults:
        r = results.get(f.ident)
        if r and r["verdict"] == "survived":
            why = reasons.get(f.ident)
            lines.append(f"- {f.ident} {f.title}" + (f": {why}" if why else " — **unexplained**"))
    return "\n".join(lines), total["survived"]


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
    results, reasons = Results(o.work / "results.json"), explained()
    todo = queue.Queue()
    for f in all_chosen:
        known = results.known.get(f.ident)
        if known is None or (o.again and known["verdict"] == "survived" and f.ident not in reasons):
            todo.put(f)
    print(f"{len(all_chosen)} faults, {len(all_chosen) - todo.qsize()} known from before", flush=True)
    stop = threading.Event()
    benches = [run.Bench(ROOT, o.work / f"job{i}", o.programs, o.fuzz_time, o.thorough, stop.is_set) for i in range(o.jobs)]
    trouble = []

    def work(bench):
        try:
            bench.prepare(lambda text: print(text, flush=True))
            while not stop.is_set():
                fault = todo.get_nowait()
                outcome = bench.judge(fault)
                if outcome is None or stop.is_set():
                    return
                results.add(fault, outcome)
                by = f" by {outcome['by'][0]}" if outcome["by"] else ""
                print(f"[{sum(x.ident in results.known for x in all_chosen)}/{len(all_chosen)}] {outcome['verdict']}{by}, {outcome['seconds']:.0f} s: {fault.ident} {fault.title}", flush=True)
        except queue.Empty:
            pass
        except run.Broken as why:
            trouble.append(str(why))
            stop.set()

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
    print(text)
    return 130 if stop.is_set() else 1 if survived else 0
