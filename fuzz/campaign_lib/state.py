"""What a campaign knows, kept in OUT/state.json so that nothing is lost when it is stopped."""
import json
import os
import threading
import time
from pathlib import Path

VERSION = 1


def _fresh_target():
    return {"executions": 0, "seconds": 0.0, "slices": 0, "coverage": 0, "features": 0, "new": 0, "slow_units": 0,
            "fed_at": 0.0, "curve": [], "variants": {}, "lines": None, "branches": None, "functions": None}


class State:
    """The campaign's figures; `save` replaces the file in one step."""

    def __init__(self, out, asked_seconds, names):
        self.path = Path(out) / "state.json"
        self.lock = threading.RLock()  # finds come in from another thread
        self.data = self._load()
        self.resumed = bool(self.data)
        if not self.data:
            self.data = {"version": VERSION, "started": time.time(), "targets": {}, "finds": {}, "rounds": 0, "left": 0.0, "fuzzed": 0.0}
        # An interrupted campaign goes on with the time it had left; a finished one starts another round on the same corpora.
        if self.data["left"] <= 0 or self.data.get("asked") != asked_seconds:
            self.data["left"] = asked_seconds
            self.data["rounds"] += 1
        self.data["asked"] = asked_seconds
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

    def target(self, name):
        return self.data["targets"].setdefault(name, _fresh_target())

    @property
    def finds(self):
        return self.data["finds"]

    def save(self):
        with self.lock:
            part = self.path.with_suffix(".part")
            part.write_text(json.dumps(self.data, indent=1))
            os.replace(part, self.path)

    def add_point(self, name, seconds, coverage, features):
        """One step of the growth curve; only what rises is kept."""
        t = self.target(name)
        if coverage > t["coverage"] or not t["curve"]:
            t["coverage"] = max(coverage, t["coverage"])
            t["curve"].append([round(seconds, 2), t["coverage"]])
        t["features"] = max(features, t["features"])

    def add_slice(self, name, variant, executions, seconds):
        t = self.target(name)
        t["executions"] += executions
        t["seconds"] += seconds
        t["slices"] += 1
        v = t["variants"].setdefault(variant, {"executions": 0, "seconds": 0.0})
        v["executions"] += executions
        v["seconds"] += seconds
