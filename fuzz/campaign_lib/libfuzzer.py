"""A slice of libFuzzer, its commands and what it says."""
import re
import subprocess
import time

from .engine import Slice

MAX_LENGTH = 4096  # of an input
_STATUS = re.compile(r"^#(\d+)\s+(\w+)\s+cov: (\d+) ft: (\d+) corp: (\d+)/\S+ .*?exec/s: (\d+)")
_FINAL = re.compile(r"^stat::number_of_executed_units:\s+(\d+)")
_ARTIFACT = re.compile(r"Test unit written to (\S+)")


def parse_status(line):
    """The figures of a libFuzzer status line as a dict, or None."""
    m = _STATUS.match(line)
    if not m:
        return None
    runs, kind, coverage, features, corpus, rate = m.groups()
    return {"runs": int(runs), "kind": kind, "coverage": int(coverage), "features": int(features), "corpus": int(corpus), "rate": int(rate)}


class LibFuzzerSlice(Slice):
    """libFuzzer ends at its first find; the slice then goes on with what is left of its time. An input of the corpus that fails already
    while it is read is left out: `leave_out(artifact)` does that, and tells whether there was one. `feed` is a command that merges
    what others found into the corpus, None when there is nothing; `command(seconds)` is the fuzzer's."""

    HOPELESS = 5  # ends in a row before the corpus was read, without an input to leave out
    BACKLOG = 64  # failing inputs that nobody has filed yet, at which it waits

    def __init__(self, name, variant, seconds, command, feed, leave_out, environment, log, value_profile=False, backlog=lambda: 0):
        super().__init__(name, variant, seconds)
        self._command, self._feed, self._leave_out, self._environment, self._log = command, feed, leave_out, environment, log
        self._backlog = backlog
        self.value_profile = value_profile
        self._before = 0  # executions of the processes that ended
        self._read = False  # whether this process has read its corpus

    def work(self):
        with open(self._log, "a", errors="replace", buffering=1) as log:
            if self._feed:
                self._merging = True
                self.fed = self._follow(self._feed, log, self._take_artifact) == 0
                self._merging = False
                if not self.fed and not self._stopping:
                    self.trouble = f"{self.target} ({self.variant}) could not read seeds and what other targets found; see {self._log}"
            hopeless = 0
            while not self._stopping and self.elapsed <= max(0, self.seconds - 1) and hopeless < self.HOPELESS:
                if self._backlog() >= self.BACKLOG:
                    time.sleep(0.2)
                    continue
                known, self._read = len(self.artifacts), False
                code = self._follow(self._command(self.seconds - self.elapsed), log, self._take)
                self._before = self.executions
                if code == 0 or self._stopping:
                    return
                if len(self.artifacts) == known:
                    self.trouble = f"{self.target} ({self.variant}) ended with status {code}: " + " ".join("".join(self._tail).split())[:300]
                    return
                left_out = [self._leave_out(path) for path in self.artifacts[known:]]
                hopeless = 0 if self._read or any(left_out) else hopeless + 1
            if hopeless:
                self.trouble = f"{self.target} ({self.variant}) fails before it has read its corpus; see {self._log}"

    def _follow(self, command, log, take):
        """Runs a command to its end, gives every line of it to `take`; its status."""
        log.write(" ".join(command) + "\n")
        p = self._spawn(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace", env=self._environment)
        self._tail = []
        with p.stderr:
            for line in p.stderr:
                take(line)
                status = line.startswith("#")
                if not status:
                    self._tail = (self._tail + [line])[-6:]
                if not status or "INITED" in line or "DONE" in line:
                    log.write(line)
        return self._reap()

    def _take(self, line):
        status = parse_status(line)
        if status:
            self.live.update({k: status[k] for k in ("coverage", "features", "corpus")})
            self.live["new"] += status["kind"] == "NEW"
            self._read = self._read or status["kind"] == "INITED"
            self.executions = max(self.executions, self._before + status["runs"])
            return
        m = _FINAL.match(line)
        if m:
            self.executions = max(self.executions, self._before + int(m.group(1)))
        self._take_artifact(line)

    def _take_artifact(self, line):
        m = _ARTIFACT.search(line)
        if m and "slow-unit-" not in m.group(1):
            self.artifacts.append(m.group(1))


def fuzz_command(program, corpus, dictionary, artifacts, seconds, value_profile):
    command = [str(program), str(corpus), *_limits(artifacts, seconds), "-print_final_stats=1", "-reload=1",
               "-use_value_profile=" + ("1" if value_profile else "0")]
    return command + ([f"-dict={dictionary}"] if dictionary else [])


def merge_command(program, into, folders, artifacts, seconds):
    """Adds to `into` what the folders add to its coverage. It survives inputs that fail, and what it takes stays: seeds that are only read
    are forgotten when the slice ends. libFuzzer looks at the time only between inputs of one process, so that it may take longer."""
    return [str(program), "-merge=1", *_limits(artifacts, seconds), str(into), *map(str, folders)]


def _limits(artifacts, seconds):
    return [f"-max_total_time={max(1, round(seconds))}", "-timeout=10", "-rss_limit_mb=2048", f"-max_len={MAX_LENGTH}", f"-artifact_prefix={artifacts}"]
