"""Prints line and branch coverage per file and in total from gcovr's JSON, and the lines not reached.

usage: coverage.py COVERAGE.json
"""

import json
import sys


def ranges(numbers):
    """`[1, 2, 3, 7]` as `1-3 7`."""
    runs = []
    for number in numbers:
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    return " ".join(str(a) if a == b else f"{a}-{b}" for a, b in runs)


def row(name, lines, branches):
    def share(hit, of):
        return f"{hit:6}/{of:<6}{100 * hit / of:6.1f} %" if of else f"{'–':>21}"
    print(f"{name:48}{share(*lines)}  {share(*branches)}")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as report:
        files = json.load(report)["files"]
    total_lines, total_branches, missed = [0, 0], [0, 0], []
    print(f"{'file':48}{'lines':>21}  {'branches':>21}")
    for file in sorted(files, key=lambda f: f["file"]):
        lines = [line for line in file["lines"] if not line.get("gcovr/noncode")]
        branches = [branch for line in lines for branch in line.get("branches", [])]
        hit = (sum(line["count"] > 0 for line in lines), len(lines))
        taken = (sum(branch["count"] > 0 for branch in branches), len(branches))
        row(file["file"], hit, taken)
        total_lines = [a + b for a, b in zip(total_lines, hit)]
        total_branches = [a + b for a, b in zip(total_branches, taken)]
        never = sorted({line["line_number"] for line in lines if line["count"] == 0})
        half = sorted({line["line_number"] for line in lines
                       if line["count"] > 0 and any(b["count"] == 0 for b in line.get("branches", []))})
        if never or half:
            missed.append((file["file"], never, half))
    row("total", total_lines, total_branches)
    for name, never, half in missed:
        print(f"\n{name}")
        if never:
            print(f"  lines not reached:             {ranges(never)}")
        if half:
            print(f"  lines with a branch not taken: {ranges(half)}")


main()
