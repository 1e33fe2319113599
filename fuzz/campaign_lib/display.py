"""Progress on the terminal: a table redrawn in place, or plain lines where the output is no terminal."""
import os
import shutil
import sys
import time


def amount(n):
    """1234567 as 1.2M."""
    for unit in ("", "k", "M", "G"):
        if n < 1000:
            return f"{n:.0f}{unit}" if unit == "" or n >= 100 else f"{n:.1f}{unit}"
        n /= 1000
    return f"{n:.1f}T"


def clock(seconds):
    s = max(0, int(seconds + 0.5))
    return f"{s // 3600}:{s // 60 % 60:02}:{s % 60:02}" if s >= 3600 else f"{s // 60}:{s % 60:02}"


class Display:
    """`rows` are dicts: name, running (variants), rate, coverage, corpus, new, finds, executions,
    seconds (core time it had), left (core time it may still expect)."""

    PLAIN_EVERY = 10.0

    def __init__(self, stream=None):
        self._stream = stream or sys.stdout
        self._live = self._stream.isatty() and os.environ.get("TERM", "dumb") != "dumb"
        self._bold = self._live and "NO_COLOR" not in os.environ
        self._drawn = 0
        self._last_plain = None

    def say(self, text):
        """A line that stays."""
        self._write(self._erase() + text + "\n")

    def _erase(self):
        drawn, self._drawn = self._drawn, 0
        return f"\x1b[{drawn}A\x1b[J" if drawn else ""

    def _write(self, text):
        try:
            self._stream.write(text)
            self._stream.flush()
        except (OSError, RuntimeError):  # the terminal is gone, or a signal came in the midst of a write; the campaign still ends in good order
            pass

    def stage(self, text):
        self.say(text)

    def update(self, rows, left, total, finds):
        lines = self._table(rows, left, total, finds)
        if self._live:
            size = shutil.get_terminal_size()
            lines = [line[:max(20, size.columns - 1)] for line in self._fit(lines, size.lines - 1)]
            if self._bold:
                lines[0] = f"\x1b[1m{lines[0]}\x1b[0m"
            self._write(self._erase() + "\n".join(lines) + "\n")
            self._drawn = len(lines)
            return
        now = time.monotonic()
        if self._last_plain is None or now - self._last_plain >= self.PLAIN_EVERY:
            self._last_plain = now
            busy = [r for r in rows if r["running"]]
            what = "; ".join(f"{r['name']} {amount(r['rate'])}/s cov {r['coverage']} corpus {r['corpus']} new {r['new']}" for r in busy)
            self._write(f"{clock(left)} left, {finds} finds, {amount(sum(r['executions'] for r in rows))} executions: {what}\n")

    @staticmethod
    def _fit(lines, height):
        """Head and foot stay; of the targets, as many as there is room for, the running ones first."""
        if len(lines) <= height or height < 5:
            return lines[:max(1, height)] if height < 5 else lines
        body = sorted(range(1, len(lines) - 1), key=lambda i: "*" not in lines[i][:30])
        keep = sorted(body[:height - 3])
        return [lines[0], *(lines[i] for i in keep), f"  … {len(body) - len(keep)} more", lines[-1]]

    @staticmethod
    def _table(rows, left, total, finds):
        width = max([6, *(len(r["name"]) for r in rows)])
        lines = [f"{'target':<{width}}   {'variant':<8} {'exec/s':>7} {'execs':>7} {'cov':>6} {'corpus':>6} {'new':>5} {'finds':>5} "
                 f"{'ran':>7} {'left':>7}"]
        for r in rows:
            mark = "*" if r["running"] else " "
            lines.append(f"{r['name']:<{width}} {mark} {'+'.join(r['running']) or '-':<8} {amount(r['rate']) if r['running'] else '-':>7} "
                         f"{amount(r['executions']):>7} {r['coverage']:>6} {r['corpus']:>6} {r['new']:>5} {r['finds']:>5} "
                         f"{clock(r['seconds']):>7} {clock(r['left']):>7}")
        done = 1 - left / total if total else 1
        bar = "#" * int(20 * done) + "." * (20 - int(20 * done))
        executions = amount(sum(r["executions"] for r in rows))
        lines.append(f"[{bar}] {clock(left)} left for all, {executions} executions, {finds} finds; Ctrl-C stops and keeps everything")
        return lines
