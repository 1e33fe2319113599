"""A slice of AFL++: it reads the shared corpus, and what it finds goes back into it."""
import hashlib
import os
import shutil
import subprocess
import time
from pathlib import Path

from .engine import Slice


class AflSlice(Slice):
    """`known` are digests of inputs not to start from: they fail."""

    def __init__(self, name, seconds, afl, program, inputs, work, corpus, crashes, dictionary, known, log):
        super().__init__(name, "afl", seconds)
        self._afl, self._program, self._inputs, self._out = afl, program, inputs, work
        self._corpus, self._crashes, self._dictionary, self._known, self._log = corpus, crashes, dictionary, known, log

    def work(self):
        queue = self._out / "default"
        self._collect(queue, set(os.listdir(self._corpus)))  # what a campaign left there that was killed
        taken = set(os.listdir(self._corpus))
        start = self._gather()
        command = [self._afl["fuzz"], "-V", str(max(1, int(self.seconds))), "-i", str(start), "-o", str(self._out), "-t", "10000"]
        if self._dictionary:
            command += ["-x", str(self._dictionary)]
        command += ["--", str(self._program)]
        environment = dict(os.environ, AFL_NO_UI="1", AFL_SKIP_CPUFREQ="1", AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES="1", AFL_NO_AFFINITY="1",
                           AFL_QUIET="1", AFL_AUTORESUME="0", AFL_FAST_CAL="1")
        with open(self._log, "ab") as log:
            p = self._spawn(command, stdout=log, stderr=subprocess.STDOUT, env=environment)
            while os.waitid(os.P_PID, p.pid, os.WEXITED | os.WNOWAIT | os.WNOHANG) is None:
                self._read_stats(queue / "fuzzer_stats")
                time.sleep(0.5)
        code = self._reap()
        self._read_stats(queue / "fuzzer_stats")
        self._collect(queue, taken)
        if code != 0 and not self._stopping and not self.executions:
            self.trouble = f"{self.target} (afl) ended with status {code}; see {self._log}"

    def _gather(self):
        start = self._out / "start"
        shutil.rmtree(start, ignore_errors=True)
        start.mkdir(parents=True)
        for folder in self._inputs:
            for path in sorted(Path(folder).iterdir()):
                if path.is_file() and path.stat().st_size and hashlib.sha1(path.read_bytes()).hexdigest() not in self._known:
                    shutil.copy(path, start / path.name)
        if not any(start.iterdir()):
            (start / "first").write_bytes(b"\0")
        return start

    def _read_stats(self, path):
        try:
            stats = dict((k.strip(), v.strip()) for k, _, v in (line.partition(":") for line in path.read_text().splitlines()))
            self.executions = max(self.executions, int(stats["execs_done"]))
            self.live["corpus"] = int(stats["corpus_count"])
        except (OSError, KeyError, ValueError):  # not written yet, or half written
            pass

    def _collect(self, queue, taken):
        for folder, out in ((queue / "queue", self._corpus), (queue / "crashes", self._crashes), (queue / "hangs", self._crashes)):
            for path in sorted(folder.glob("id:*")) if folder.is_dir() else ():
                octets = path.read_bytes()
                name = hashlib.sha1(octets).hexdigest()
                if out == self._crashes:
                    kind = "timeout" if folder.name == "hangs" else "crash"
                    place = out / f"{self.target}-{kind}-{name}"
                    place.write_bytes(octets)
                    self.artifacts.append(str(place))
                elif name not in taken:
                    (out / name).write_bytes(octets)
                    self.live["new"] += 1
        shutil.rmtree(queue, ignore_errors=True)
