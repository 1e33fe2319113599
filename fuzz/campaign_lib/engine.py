"""One slice of fuzzing: processes of one target in one variant, watched while they run. AFL++'s is in afl.py."""
import os
import re
import signal
import subprocess
import threading
import time

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


def sanitizer_environment(symbolizer):
    environment = dict(os.environ)
    common = "symbolize=1:handle_abort=1:allocator_may_return_null=0"
    environment["ASAN_OPTIONS"] = common + ":detect_leaks=1:detect_stack_use_after_return=1"
    environment["UBSAN_OPTIONS"] = "print_stacktrace=1:symbolize=1"
    if symbolizer:
        environment["ASAN_SYMBOLIZER_PATH"] = environment["UBSAN_SYMBOLIZER_PATH"] = symbolizer
    return environment


def unnamed(environment):
    """The same without names in stacks: looking them up takes longer than most restarts, and what fails is run again to be filed."""
    return dict(environment, ASAN_OPTIONS=environment["ASAN_OPTIONS"] + ":symbolize=0", UBSAN_OPTIONS=environment["UBSAN_OPTIONS"] + ":symbolize=0")


class Slice(threading.Thread):
    """Runs one target in one variant for some seconds. `live` may be read at any time."""

    def __init__(self, name, variant, seconds):
        super().__init__(daemon=True, name=f"{name}/{variant}")
        self.target, self.variant, self.seconds = name, variant, seconds
        self.live = {"coverage": 0, "features": 0, "corpus": 0, "rate": 0, "new": 0}
        self.started = time.monotonic()
        self.executions = 0
        self.processor = 0.0  # seconds that the processes which ended had a core
        self.artifacts = []
        self._filed = 0
        self.trouble = ""
        self._merging = False
        self.fed = False  # whether what others found has been read
        self._elapsed = None
        self._process = None
        self._ending = threading.Lock()  # a process that is reaped under it cannot be signalled any more
        self._stopping = False
        self._told = {}

    def run(self):
        try:
            self.work()
        except OSError as error:
            self.trouble = f"{self.target} ({self.variant}): {error}"
        self._elapsed = time.monotonic() - self.started

    @property
    def elapsed(self):
        return time.monotonic() - self.started if self._elapsed is None else self._elapsed

    def take_figures(self):
        """What came in since this was last asked."""
        now = {"executions": self.executions, "seconds": self.elapsed, "processor": self.processor, "new": self.live["new"]}
        news = {k: v - self._told.get(k, 0) for k, v in now.items()}
        self._told = now
        return news

    def take_artifacts(self):
        """Those that came since this was last asked."""
        news = self.artifacts[self._filed:]
        self._filed += len(news)
        return news

    def _spawn(self, command, **how):
        with self._ending:
            self._process = subprocess.Popen(command, start_new_session=True, **how)
        if self._stopping:
            self.stop()
        return self._process

    def _reap(self):
        """Waits for the process; its status. Its time and its children's are added up."""
        p = self._process
        os.waitid(os.P_PID, p.pid, os.WEXITED | os.WNOWAIT)
        with self._ending:
            _, status, used = os.wait4(p.pid, 0)
            p.returncode = os.waitstatus_to_exitcode(status)
        self.processor += used.ru_utime + used.ru_stime
        return p.returncode

    def _signal(self, number):
        with self._ending:
            if self._process and self._process.returncode is None:
                os.killpg(self._process.pid, number)

    def stop(self):
        """Ends the process in a way that lets it write its last figures."""
        self._stopping = True
        # A merge would begin anew after SIGINT; it has no figures to write.
        self._signal(signal.SIGKILL if self._merging else signal.SIGINT)

    def kill_if_late(self, grace):
        if self.elapsed > self.seconds + grace:
            self._stopping = True
            self._signal(signal.SIGKILL)


class LibFuzzerSlice(Slice):
    """libFuzzer ends at its first find; the slice then goes on with what is left of its time. An input of the corpus that fails already
    while it is read is left out: `leave_out(artifact)` does that, and tells whether there was one. `feed` is a command that merges
    what others found into the corpus, None when there is nothing; `command(seconds)` is the fuzzer's."""

    HOPELESS = 5  # ends in a row before the corpus was read, without an input to leave out

    def __init__(self, name, variant, seconds, command, feed, leave_out, environment, log, value_profile=False):
        super().__init__(name, variant, seconds)
        self._command, self._feed, self._leave_out, self._environment, self._log = command, feed, leave_out, environment, log
        self.value_profile = value_profile
        self._before = 0  # executions of the processes that ended
        self._read = False  # whether this process has read its corpus

    def work(self):
        with open(self._log, "a", errors="replace") as log:
            if self._feed:
                self._merging = True
                self.fed = self._follow(self._feed, log, self._take_artifact) == 0
                self._merging = False
            hopeless = 0
            while not self._stopping and self.elapsed <= max(0, self.seconds - 1) and hopeless < self.HOPELESS:
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
            self.live.update({k: status[k] for k in ("coverage", "features", "corpus", "rate")})
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


def libfuzzer_command(program, corpus, dictionary, artifacts, seconds, value_profile):
    command = [str(program), str(corpus), *_limits(artifacts, seconds), "-print_final_stats=1", "-reload=1",
               "-use_value_profile=" + ("1" if value_profile else "0")]
    return command + ([f"-dict={dictionary}"] if dictionary else [])


def merge_command(program, into, folders, artifacts, seconds):
    """Adds to `into` what the folders add to its coverage. It survives inputs that fail, and what it takes stays: seeds that are only read
    are forgotten when the slice ends."""
    return [str(program), "-merge=1", *_limits(artifacts, seconds), str(into), *map(str, folders)]


def _limits(artifacts, seconds):
    return [f"-max_total_time={max(1, round(seconds))}", "-timeout=10", "-rss_limit_mb=2048", f"-max_len={MAX_LENGTH}", f"-artifact_prefix={artifacts}"]
