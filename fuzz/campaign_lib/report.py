"""The report: its data, as one JSON file and a short text. The page is made in page.py."""
import json
import os
import platform
import subprocess
import time
from pathlib import Path

from .display import clock
from .finds import open_finds
from .page import page, percent


def _first_line(command):
    try:
        r = subprocess.run(command, capture_output=True, text=True)
        return r.stdout.splitlines()[0].strip() if r.returncode == 0 and r.stdout else ""
    except OSError:
        return ""


def _processor():
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def _rate(figures):
    return round(figures["executions"] / figures["seconds"]) if figures["seconds"] else 0


def _targets(state, corpus_sizes):
    targets = []
    for name in sorted(state.data["targets"]):
        t = state.target(name)
        targets.append({
            "name": name, "executions": t["executions"], "seconds": round(t["seconds"], 1), "processor_seconds": round(t["processor"], 1),
            "coverage": t["coverage"], "features": t["features"], "corpus": corpus_sizes.get(name, 0), "new": t["new"],
            "executions_per_second": {v: _rate(d) for v, d in sorted(t["variants"].items())},
            "variants": t["variants"], "curve": t["curve"], "lines": t["lines"], "branches": t["branches"], "functions": t["functions"],
            "finds": sorted(i for i, f in open_finds(state.finds).items() if name in f["targets"])})
    return targets


def _finds(state, out):
    """The open ones with what is known of them, and the titles of those that are closed."""
    known = open_finds(state.finds)
    finds = []
    for ident, f in sorted(known.items(), key=lambda item: item[1]["found"]):
        folder = Path(out) / f["folder"]
        texts = {k: (folder / k).read_text(encoding="utf-8", errors="replace") if (folder / k).is_file() else "" for k in ("explanation.txt", "output.txt")}
        finds.append(dict(f, id=ident, more=len(list(folder.glob("more/*"))), explanation=texts["explanation.txt"], output=texts["output.txt"][:20000]))
    closed = [{k: f.get(k, "") for k in ("target", "title", "why", "found", "closed", "folder")} | {"id": i} for i, f in state.finds.items() if i not in known]
    return finds, closed


def gather(state, o, names, tools, corpus_sizes):
    """Everything the report shows, as plain data."""
    targets, (finds, closed) = _targets(state, corpus_sizes), _finds(state, o.out)
    return {
        "report": "trama fuzz campaign", "started": state.data["started"], "since": state.data["since"], "ended": time.time(), "rounds": state.data["rounds"],
        "asked_seconds": state.data["asked"], "left_seconds": max(0, round(state.data["left"], 1)), "fuzzed_seconds": round(state.data["fuzzed"], 1),
        "phase": state.data["phase"], "core_seconds": round(sum(t["seconds"] for t in targets), 1),
        "processor_seconds": round(sum(t["processor_seconds"] for t in targets), 1), "jobs": o.jobs, "chosen": names, "empty_corpus": o.empty_corpus,
        "machine": {"processor": _processor(), "cores": os.cpu_count(), "system": platform.system() + " " + platform.release()},
        "compiler": _first_line([tools["clang"], "--version"]),
        "commit": state.data["code"]["commit"], "digest": state.data["code"]["digest"], "earlier": state.data["earlier"],
        "found_since": state.finds_since(state.data["since"]),
        "executions": sum(t["executions"] for t in targets), "targets": targets, "finds": finds, "closed": closed}


def summary(data):
    lines = []
    width = max([6, *(len(t["name"]) for t in data["targets"])])
    lines.append(f"{'target':<{width}} {'executions':>11} {'per second':>11} {'edges':>6} {'corpus':>6} {'lines':>7} {'branches':>8} {'finds':>5}")
    for t in data["targets"]:
        lines.append(f"{t['name']:<{width}} {t['executions']:>11} {_rate(t):>11} {t['coverage']:>6} {t['corpus']:>6} "
                     f"{percent(t['lines']):>7} {percent(t['branches']):>8} {len(t['finds']):>5}")
    lines.append(f"{data['executions']} executions in {clock(data['core_seconds'])} of core time ({clock(data['processor_seconds'])} of processor time) "
                 f"on {data['commit'] or 'unknown code'}, {data['found_since']} new finds, {len(data['finds'])} open")
    for f in data["finds"]:
        lines.append(f"  {f['target']}-{f['id']}: {f['title']} ({f['count']} times, {f['size']} octets) in {f['folder']}")
    return "\n".join(lines)


def write(out, data):
    for name, text in (("report.json", json.dumps(data, indent=1) + "\n"), ("report.html", page(data))):
        part = Path(out) / (name + ".part")
        part.write_text(text, encoding="utf-8")
        os.replace(part, Path(out) / name)
