"""What a campaign knows, kept in OUT/state.json so that nothing is lost when it is stopped."""
import json
import os
import threading
import time
from pathlib import Path

from .finds import open_finds

VERSION = 1
FIGURES = ("executions", "seconds", "processor", "new")


def _fresh_figures():
    return {"executions": 0, "seconds": 0.0, "processor": 0.0, "slices": 0, "coverage": 0, "features": 0, "new": 0, "curve": [], "variants": {},
            "lines": None, "branches": None, "functions": None}


class State:
    """The campaign's figures, which are those of one code (`code`: commit and digest); `save` replaces the file in one step."""

    def __init__(self, out, asked_seconds, names, code=None):
        self.path = Path(out) / "state.json"
        self.lock = threading.RLock()  # finds come in from another thread
        now = time.time()
        fresh = {"version": VERSION, "started": now, "since": now, "targets": {}, "finds": {}, "rounds": 0, "left": 0.0, "fuzzed": 0.0,
                 "phase": "done", "code": {"commit": "", "digest": ""}, "earlier": [], "empty_corpus": False}
        found = self._load()
        self.data = {**fresh, **(found or {"code": code or fresh["code"]})}
        if found and "since" not in found:
            self.data["since"] = found["started"]
        changed = code is not None and code["digest"] != self.data["code"]["digest"]
        if changed:
            self._put_aside()
        self.data["code"] = code or self.data["code"]
        # An interrupted campaign goes on with what it had left; a finished one, other code, targets or time start a round on the same corpora.
        unfinished = self.data["left"] > 0 or self.data["phase"] in ("merging", "measuring")
        self.resumed = bool(found) and unfinished and not changed and self.data.get("asked") == asked_seconds and self.data.get("chosen", names) == names
        self.data["chosen"] = names
        if not self.resumed:
            self.data.update(left=asked_seconds, asked=asked_seconds, rounds=self.data["rounds"] + 1, phase="fuzzing")
        for name in names:
            self.target(name)

    def _load(self):
        try:
            data = json.loads(self.path.read_text())
        except FileNotFoundError:
            return None
        except ValueError:
            os.replace(self.path, self.path.with_suffix(".damaged"))
            return None
        return data if data.get("version") == VERSION else None

    def _put_aside(self):
        """The figures so far belong to other code: they become one entry of `earlier`. Corpora and finds go on."""
        d = self.data
        totals = {k: sum(t.get(k, 0) for t in d["targets"].values()) for k in FIGURES}
        if totals["executions"]:
            d["earlier"].append({"commit": d["code"]["commit"], "from": d["since"], "until": time.time(), "executions": totals["executions"],
                                 "core_seconds": round(totals["seconds"], 1), "processor_seconds": round(totals["processor"], 1),
                                 "finds": self.finds_since(d["since"])})
        for t in d["targets"].values():
            t.update(_fresh_figures(), read_until=0.0)
        d.update(since=time.time(), rounds=0, fuzzed=0.0)

    def finds_since(self, when):
        return sum(f["found"] >= when for f in self.finds.values())

    def target(self, name):
        t = self.data["targets"].setdefault(name, {})
        for key, value in dict(_fresh_figures(), read_until=0.0).items():
            t.setdefault(key, value)
        return t

    @property
    def finds(self):
        return self.data["finds"]

    def open_finds(self):
        with self.lock:
            return open_finds(self.finds)

    def save(self):
        with self.lock:
            part = self.path.with_suffix(".part")
            part.write_text(json.dumps(self.data, indent=1), encoding="utf-8")
            os.replace(part, self.path)

    def add_point(self, name, coverage, features=0):
        """One step of the growth curve, at the core time the target has had; only what rises is kept."""
        t = self.target(name)
        if coverage > t["coverage"] or not t["curve"]:
            t["coverage"] = max(coverage, t["coverage"])
            t["curve"].append([round(t["seconds"], 2), t["coverage"]])
        t["features"] = max(features, t["features"])

    def add(self, name, variant, figures):
        """Adds what a slice did since it was last asked: a dict with FIGURES."""
        t = self.target(name)
        v = t["variants"].setdefault(variant, {})
        for key in FIGURES:
            t[key] += figures[key]
            v[key] = v.get(key, 0) + figures[key]
