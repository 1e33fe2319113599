"""The report: one JSON file, and one HTML page that needs nothing else."""
import html
import json
import os
import platform
import subprocess
import time
from pathlib import Path

from .display import amount, clock


def _first_line(command, cwd=None):
    try:
        r = subprocess.run(command, capture_output=True, text=True, cwd=cwd)
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


def gather(state, o, names, tools, corpus_sizes):
    """Everything the report shows, as plain data."""
    targets = []
    for name in sorted(state.data["targets"]):
        t = state.data["targets"][name]
        targets.append({
            "name": name, "executions": t["executions"], "seconds": round(t["seconds"], 1), "coverage": t["coverage"], "features": t["features"],
            "corpus": corpus_sizes.get(name, 0), "new": t["new"],
            "executions_per_second": {v: round(d["executions"] / d["seconds"]) if d["seconds"] else 0 for v, d in sorted(t["variants"].items())},
            "variants": t["variants"], "curve": t["curve"], "lines": t["lines"], "branches": t["branches"], "functions": t["functions"],
            "finds": sorted(i for i, f in state.finds.items() if name in f["targets"])})
    finds = []
    for ident, f in sorted(state.finds.items(), key=lambda item: item[1]["found"]):
        folder = Path(o.out) / f["folder"]
        texts = {k: (folder / k).read_text(errors="replace") if (folder / k).is_file() else "" for k in ("explanation.txt", "output.txt")}
        finds.append(dict(f, id=ident, explanation=texts["explanation.txt"], output=texts["output.txt"][:20000]))
    return {
        "report": "trama fuzz campaign", "started": state.data["started"], "ended": time.time(), "rounds": state.data["rounds"],
        "asked_seconds": state.data["asked"], "left_seconds": max(0, round(state.data["left"], 1)), "fuzzed_seconds": round(state.data["fuzzed"], 1),
        "core_seconds": round(sum(t["seconds"] for t in targets), 1), "jobs": o.jobs, "chosen": names, "empty_corpus": o.empty_corpus,
        "machine": {"processor": _processor(), "cores": os.cpu_count(), "system": platform.system() + " " + platform.release()},
        "compiler": _first_line([tools["clang"], "--version"]),
        "commit": _first_line(["git", "rev-parse", "--short=12", "HEAD"], cwd=o.source),
        "executions": sum(t["executions"] for t in targets), "targets": targets, "finds": finds}


def summary(data):
    lines = []
    width = max([6, *(len(t["name"]) for t in data["targets"])])
    lines.append(f"{'target':<{width}} {'executions':>11} {'per second':>11} {'edges':>6} {'corpus':>6} {'lines':>7} {'branches':>8} {'finds':>5}")
    for t in data["targets"]:
        rate = round(t["executions"] / t["seconds"]) if t["seconds"] else 0
        lines.append(f"{t['name']:<{width}} {t['executions']:>11} {rate:>11} {t['coverage']:>6} {t['corpus']:>6} "
                     f"{_percent(t['lines']):>7} {_percent(t['branches']):>8} {len(t['finds']):>5}")
    lines.append(f"{data['executions']} executions in {clock(data['core_seconds'])} of core time, {len(data['finds'])} finds")
    for f in data["finds"]:
        lines.append(f"  {f['target']}-{f['id']}: {f['title']} ({f['count']} times, {f['size']} octets) in {f['folder']}")
    return "\n".join(lines)


def _percent(part):
    return f"{part['percent']:.1f}%" if part else "-"


def _ticks(high):
    """Three round values from 0 up to about `high`."""
    return [0, high / 2, high]


def curve(points, end, width=340, height=150):
    """Coverage over core time as SVG: a step line, since coverage holds until the next rise."""
    left, top, right, bottom = 44, 8, width - 8, height - 24
    points = [tuple(p) for p in points] or [(0, 0)]
    end = max(end, points[-1][0], 1)
    high = max(1, max(c for _, c in points))

    def x(seconds):
        return left + (right - left) * seconds / end

    def y(coverage):
        return bottom - (bottom - top) * coverage / high

    path = f"M{x(points[0][0]):.1f},{y(points[0][1]):.1f}"
    for seconds, coverage in points[1:]:
        path += f"H{x(seconds):.1f}V{y(coverage):.1f}"
    path += f"H{x(end):.1f}"
    grid = "".join(f'<line class="grid" x1="{left}" x2="{right}" y1="{y(t):.1f}" y2="{y(t):.1f}"/>'
                   f'<text x="{left - 5}" y="{y(t) + 3.5:.1f}" text-anchor="end">{t:.0f}</text>' for t in _ticks(high))
    times = "".join(f'<text x="{x(t):.1f}" y="{height - 8}" text-anchor="{"start" if t == 0 else "end" if t == end else "middle"}">{clock(t)}</text>'
                    for t in _ticks(end))
    return (f'<svg viewBox="0 0 {width} {height}" role="img" aria-label="{points[-1][1]} edges after {clock(end)}">{grid}{times}'
            f'<path class="line" d="{path}"/></svg>')


_STYLE = """
:root{color-scheme:light dark;--ink:#1b1f24;--soft:#5b6673;--rule:#d7dde3;--back:#fff;--line:#0a6ebd;--bad:#b3261e}
@media(prefers-color-scheme:dark){:root{--ink:#e7ebef;--soft:#9aa6b2;--rule:#38424c;--back:#14181c;--line:#5eb3f6;--bad:#ff8a80}}
body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--back);max-width:1100px;margin:2rem auto;padding:0 1rem}
h1{font-size:1.5rem}h2{font-size:1.15rem;margin-top:2.2rem}
.wide{overflow-x:auto}table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{padding:.3rem .6rem;text-align:right;border-bottom:1px solid var(--rule);white-space:nowrap}
th:first-child,td:first-child{text-align:left}th{color:var(--soft);font-weight:600}
.curves{display:grid;grid-template-columns:repeat(auto-fill,minmax(300px,1fr));gap:1rem}
figure{margin:0}figcaption{font-weight:600}svg{width:100%;height:auto}svg text{font-size:10px;fill:var(--soft)}
.grid{stroke:var(--rule)}.line{fill:none;stroke:var(--line);stroke-width:2}
.bad{color:var(--bad);font-weight:600}.soft{color:var(--soft)}
pre{overflow-x:auto;border:1px solid var(--rule);padding:.7rem;font-size:12.5px}
"""


def _table(data):
    head = ("target", "executions", "fast/s", "checked/s", "afl/s", "edges", "features", "corpus", "new", "lines", "branches", "core time", "finds")
    rows = []
    for t in data["targets"]:
        rate = t["executions_per_second"]
        found = f'<span class="bad">{len(t["finds"])}</span>' if t["finds"] else "0"
        cells = [html.escape(t["name"]), f"{t['executions']:,}", *(f"{rate[v]:,}" if v in rate else "–" for v in ("fast", "checked", "afl")), t["coverage"],
                 t["features"], t["corpus"], t["new"], _percent(t["lines"]), _percent(t["branches"]), clock(t["seconds"]), found]
        rows.append("<tr>" + "".join(f"<td>{c}</td>" for c in cells) + "</tr>")
    return ('<div class="wide"><table><thead><tr>' + "".join(f"<th>{h}</th>" for h in head) + "</tr></thead><tbody>" + "".join(rows) +
            "</tbody></table></div>")


def _find(f):
    regression = f"regressions/{f['target']}/{f['id']}"
    return (f'<h3 id="{f["id"]}">{html.escape(f["target"])}-{f["id"]}: {html.escape(f["title"])}</h3>'
            f'<p>Seen {f["count"]} times, in {html.escape(", ".join(f["targets"]))}; {f["original_size"]} octets, minimised to {f["size"]}. '
            f'Reproduce: <code>{html.escape(f["folder"])}/reproduce.sh</code>. Regression input: <code>{html.escape(regression)}</code>.</p>'
            f'<pre>{html.escape(f["explanation"])}</pre><details><summary>What the program said</summary><pre>{html.escape(f["output"])}</pre></details>')


def page(data):
    when = time.strftime("%Y-%m-%d %H:%M", time.localtime(data["ended"]))
    state = f"stopped with {clock(data['left_seconds'])} left" if data["left_seconds"] > 0 else "complete"
    found = (f'<p class="bad">{len(data["finds"])} finds.</p>' + "".join(map(_find, data["finds"]))) if data["finds"] else "<p>None.</p>"
    curves = "".join(f'<figure><figcaption>{html.escape(t["name"])}</figcaption>{curve(t["curve"], t["seconds"])}</figure>' for t in data["targets"])
    facts = " · ".join(html.escape(str(x)) for x in (
        f"{data['executions']:,} executions", f"{clock(data['core_seconds'])} of core time", f"{data['jobs']} processes", f"commit {data['commit'] or 'unknown'}",
        data["compiler"], data["machine"]["processor"], data["machine"]["system"]))
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">'
            f"<title>trama fuzz campaign</title><style>{_STYLE}</style></head><body><h1>trama fuzz campaign</h1>"
            f'<p>{when}, {state}{", started from an empty corpus with random bytes alone" if data["empty_corpus"] else ""}.</p><p class="soft">{facts}</p>'
            f"<h2>Targets</h2>{_table(data)}"
            f'<p class="soft">Edges and features are the fast variant\'s, as libFuzzer counts them. Lines and branches are those of include/ and src/ '
            f"that the target was built with, reached by its corpus alone. {amount(data['executions'])} executions count all variants.</p>"
            f'<h2>Coverage growth</h2><p class="soft">Edges over the core time that the target had.</p><div class="curves">{curves}</div>'
            f"<h2>Finds</h2>{found}</body></html>\n")


def write(out, data):
    for name, text in (("report.json", json.dumps(data, indent=1) + "\n"), ("report.html", page(data))):
        part = Path(out) / (name + ".part")
        part.write_text(text)
        os.replace(part, Path(out) / name)
