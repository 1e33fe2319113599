"""Line and branch coverage of include/ and src/ from clang's source-based counts.

usage: coverage.py PROFILE PROGRAM...

PROFILE is what llvm-profdata merged, the programs are those that ran. A template is compiled many times over: what counts
is whether any instantiation took a branch. Prints a row per file and the total, then every line and branch that nothing
reached, with the reason where tests/coverage_explained.json has one. Fails if a line that nothing reached has none.
"""

import json
import os
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
EXPLAINED = ROOT / "tests" / "coverage_explained.json"


def export(profile, programs, *options):
    objects = [word for program in programs[1:] for word in ("-object", program)]
    return subprocess.run(["llvm-cov", "export", *options, "-instr-profile", profile, programs[0], *objects, str(ROOT / "include"), str(ROOT / "src")],
                          capture_output=True, text=True, check=True).stdout


def own(name):
    """The path below the root, or nothing for a file of somebody else's."""
    path = Path(os.path.realpath(name))
    relative = path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else ""
    return relative if relative.startswith(("include/", "src/")) else ""


def count_lines(tracefile):
    """file → line → how often it ran"""
    lines, name = defaultdict(dict), ""
    for text in tracefile.splitlines():
        if text.startswith("SF:"):
            name = own(text[3:])
        elif text.startswith("DA:") and name:
            line, count = text[3:].split(",")[:2]
            lines[name][int(line)] = int(count)
    return lines


def count_branches(report):
    """file → place → [how often true, how often false], without the conditions that the compiler decided"""
    ways = defaultdict(lambda: defaultdict(lambda: [0, 0]))
    for function in json.loads(report)["data"][0]["functions"]:
        names = [own(n) for n in function["filenames"]]
        for line, column, end, end_column, true, false, file, *_ in function["branches"]:
            if names[file]:
                taken = ways[names[file]][line, column, end, end_column]
                taken[0] += true
                taken[1] += false
    return {name: {place: taken for place, taken in places.items() if any(taken)} for name, places in ways.items()}


def missing(lines, branches):
    """(file, line, code, what)"""
    for name in sorted(lines):
        text = (ROOT / name).read_text(encoding="utf-8").splitlines()
        for number, count in sorted(lines[name].items()):
            if count == 0:
                yield name, number, text[number - 1].strip(), "not reached"
        for (line, column, end, end_column), taken in sorted(branches.get(name, {}).items()):
            if 0 in taken:
                code = text[line - 1][column - 1:end_column - 1] if line == end else text[line - 1][column - 1:]
                yield name, line, code, "never true" if taken[0] == 0 else "never false"


def reason(explained, name, code, what):
    for e in explained:
        if re.search(e["file"], name) and re.search(e["code"], code) and what in e["what"].split(" or "):
            return e["why"]
    return None


def row(name, hit, of, taken, ways):
    def share(a, b):
        return f"{a:6}/{b:<6}{100 * a / b:6.1f} %" if b else f"{'–':>21}"
    print(f"{name:52}{share(hit, of)}  {share(taken, ways)}")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    profile, programs = sys.argv[1], sys.argv[2:]
    lines = count_lines(export(profile, programs, "-format=lcov"))
    branches = count_branches(export(profile, programs))
    total = [0, 0, 0, 0]
    print(f"{'file':52}{'lines':>21}  {'branches':>21}")
    for name in sorted(lines):
        ways = [way for taken in branches.get(name, {}).values() for way in taken]
        sums = [sum(c > 0 for c in lines[name].values()), len(lines[name]), sum(w > 0 for w in ways), len(ways)]
        row(name, *sums)
        total = [a + b for a, b in zip(total, sums)]
    row("total", *total)
    explained = json.loads(EXPLAINED.read_text(encoding="utf-8"))
    missed = [(*m, reason(explained, m[0], m[2], m[3])) for m in missing(lines, branches)]
    for name, number, code, what, why in missed:
        print(f"\n{name}:{number}: {what}\n    {code[:160]}\n    {why or 'UNEXPLAINED'}")
    lines_left = [why for *_, what, why in missed if what == "not reached"]
    ways_left = [why for *_, what, why in missed if what != "not reached"]
    print(f"\n{len(lines_left)} lines not reached, {lines_left.count(None)} of them unexplained; "
          f"{len(ways_left)} branches never taken, {ways_left.count(None)} of them unexplained")
    return 1 if None in lines_left else 0


if __name__ == "__main__":
    sys.exit(main())
