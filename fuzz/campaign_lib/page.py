"""The report as one HTML page that needs nothing else."""
import html
import time

from .display import amount, clock


def percent(part):
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


def _grid(head, rows):
    """A table; what is in the cells is HTML."""
    body = "".join("<tr>" + "".join(f"<td>{c}</td>" for c in cells) + "</tr>" for cells in rows)
    return '<div class="wide"><table><thead><tr>' + "".join(f"<th>{h}</th>" for h in head) + f"</tr></thead><tbody>{body}</tbody></table></div>"


def _table(data):
    head = ("target", "executions", "fast/s", "checked/s", "afl/s", "edges", "features", "corpus", "new", "lines", "branches", "core time",
            "processor", "finds")
    rows = []
    for t in data["targets"]:
        rate = t["executions_per_second"]
        found = f'<span class="bad">{len(t["finds"])}</span>' if t["finds"] else "0"
        cells = [html.escape(t["name"]), f"{t['executions']:,}", *(f"{rate[v]:,}" if v in rate else "–" for v in ("fast", "checked", "afl")), t["coverage"],
                 t["features"], t["corpus"], t["new"], percent(t["lines"]), percent(t["branches"]), clock(t["seconds"]),
                 clock(t["processor_seconds"]), found]
        rows.append(cells)
    return _grid(head, rows)


def _find(f):
    regression = f"regressions/{f['target']}/{f['id']}"
    return (f'<h3 id="{f["id"]}">{html.escape(f["target"])}-{f["id"]}: {html.escape(f["title"])}</h3>'
            f'<p>Seen {f["count"]} times, in {html.escape(", ".join(f["targets"]))}; {f["original_size"]} octets, minimised to {f["size"]}'
            f'{" so far" if f.get("to_minimise") else ""}; {f["more"]} further inputs in its folder. '
            f'Reproduce: <code>{html.escape(f["folder"])}/reproduce.sh</code>. Regression input: <code>{html.escape(regression)}</code>.</p>'
            f'<pre>{html.escape(f["explanation"])}</pre><details><summary>What the program said</summary><pre>{html.escape(f["output"])}</pre></details>')


def _finds(data):
    found = f'<p class="bad">{len(data["finds"])} open.</p>' if data["finds"] else "<p>None open.</p>"
    rows = [[html.escape(f"{f['target']}-{f['id']}"), html.escape(f["title"]), html.escape(f["why"]), html.escape(f["folder"])]
            for f in data["closed"]]
    closed = "<h3>Closed</h3>" + _grid(("find", "what", "why", "kept in"), rows) if rows else ""
    return found + "".join(map(_find, data["finds"])) + closed


def _earlier(data):
    rows = [[html.escape(e["commit"] or "unknown"), _day(e["from"]), _day(e["until"]), f"{e['executions']:,}", clock(e["core_seconds"]),
             clock(e["processor_seconds"]) if e["processor_seconds"] else "–", e["finds"]] for e in data["earlier"]]
    head = ("commit", "from", "until", "executions", "core time", "processor", "finds")
    return f'<h2>On earlier code</h2><p class="soft">Not contained in the figures above.</p>{_grid(head, rows)}' if rows else ""


def _day(when):
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(when))


def _progress(data):
    if data["left_seconds"] > 0:
        return f"stopped with {clock(data['left_seconds'])} left"
    return {"merging": "stopped before the corpora were merged and the lines measured",
            "measuring": "stopped before the lines were measured"}.get(data["phase"], "complete")


def page(data):
    empty = ", started from an empty corpus with random bytes alone" if data["empty_corpus"] else ""
    curves = "".join(f'<figure><figcaption>{html.escape(t["name"])}</figcaption>{curve(t["curve"], t["seconds"])}</figure>' for t in data["targets"])
    facts = " · ".join(html.escape(str(x)) for x in (
        f"commit {data['commit'] or 'unknown'}", f"{data['executions']:,} executions", f"{clock(data['core_seconds'])} of core time",
        f"{clock(data['processor_seconds'])} of processor time", f"{data['found_since']} new finds, {len(data['finds'])} open", f"{data['jobs']} processes",
        data["compiler"], data["machine"]["processor"], data["machine"]["system"]))
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">'
            f"<title>trama fuzz campaign</title><style>{_STYLE}</style></head><body><h1>trama fuzz campaign</h1>"
            f'<p>{_day(data["ended"])}, {_progress(data)}{empty}.</p><p class="soft">{facts}</p>'
            f"<h2>Targets</h2>{_table(data)}"
            f'<p class="soft">All figures are of this commit\'s code. Edges and features are the fast variant\'s, as libFuzzer counts them. Lines and '
            f"branches are those of include/ and src/ that the target was built with, reached by its corpus alone. {amount(data['executions'])} executions "
            f"count all variants. Core time goes by the clock; processor time is what the machine gave of it.</p>"
            f'<h2>Coverage growth</h2><p class="soft">Edges over the core time that the target had.</p><div class="curves">{curves}</div>'
            f"<h2>Finds</h2>{_finds(data)}{_earlier(data)}</body></html>\n")
