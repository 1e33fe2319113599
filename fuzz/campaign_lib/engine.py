"""One slice of fuzzing: a process of libFuzzer or AFL++, watched while it runs."""
import os
import re
import shutil
import signal
import subprocess
import threading
import time
from pathlib import Path

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


class Slice(threading.Thread):
    """Runs one target in one variant for some seconds. `live` may be read at any time."""

    def __init__(self, name, variant, seconds):
        super().__init__(daemon=True, name=f"{name}/{variant}")
        self.target, self.variant, self.seconds = name, variant, seconds
        self.live = {"runs": 0, "coverage": 0, "features": 0, "corpus": 0, "rate": 0, "new": 0}
        self.points = []  # (seconds since the start, coverage, features), at most one a second
        self.started = time.monotonic()
        self.executions = 0
        self.artifacts = []
        self.elapsed = 0.0
        self.trouble = ""
        self._process = None
        self._stopping = False

    def stop(self):
        """Ends the process in a way that lets it write its last figures."""
        self._stopping = True
        p = self._process
        if p and p.poll() is None:
            p.send_signal(signal.SIGINT)

    def kill_if_late(self, grace):
        p = self._process
        if p and p.poll() is None and time.monotonic() - self.started > self.seconds + grace:
            p.kill()


class LibFuzzerSlice(Slice):
    def __init__(self, name, variant, seconds, command, environment, log):
        super().__init__(name, variant, seconds)
        self._command, self._environment, self._log = command, environment, log

    def run(self):
        try:
            with open(self._log, "a", errors="replace") as log:
                log.write(" ".join(self._command) + "\n")
                self._process = subprocess.Popen(self._command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                                 errors="replace", env=self._environment, start_new_session=True)
                if self._stopping:
                    self.stop()
                tail = []
                for line in self._process.stderr:
                    self._take(line)
                    status = line.startswith("#")
                    if not status:
                        tail = (tail + [line])[-6:]
                    if not status or "INITED" in line or "DONE" in line:
                        log.write(line)
                code = self._process.wait()
            self.elapsed = time.monotonic() - self.started
            self.executions = max(self.executions, self.live["runs"])
            if code != 0 and not self.artifacts and not self._stopping:
                self.trouble = f"{self.target} ({self.variant}) ended with status {code}: " + " ".join("".join(tail).split())[:300]
        except OSError as error:
            self.elapsed = time.monotonic() - self.started
            self.trouble = f"{self.target} ({self.variant}): {error}"

    def _take(self, line):
        status = parse_status(line)
        if status:
            self.live.update({k: status[k] for k in ("runs", "coverage", "features", "corpus", "rate")})
            self.live["new"] += status["kind"] == "NEW"
            now = time.monotonic() - self.started
            if not self.points or status["coverage"] > self.points[-1][1]:
                self.points.append((now, status["coverage"], status["features"]))
            return
        m = _FINAL.match(line)
        if m:
            self.executions = int(m.group(1))
        m = _ARTIFACT.search(line)
        if m and "slow-unit-" not in m.group(1):
            self.artifacts.append(m.group(1))


class AflSlice(Slice):
    """AFL++ on the same executable interface; it reads the shared corpus and its finds go back into it."""

    def __init__(self, name, seconds, afl, program, inputs, work, corpus, crashes, dictionary, log):
        super().__init__(name, "afl", seconds)
        self._afl, self._program, self._inputs, self._work = afl, program, inputs, work
        self._corpus, self._crashes, self._dictionary, self._log = corpus, crashes, dictionary, log

    def run(self):
        queue = self._work / "default"
        taken = set(os.listdir(self._corpus))
        start = self._work / "start"
        shutil.rmtree(start, ignore_errors=True)
        start.mkdir(parents=True)
        for folder in self._inputs:
            for path in sorted(Path(folder).iterdir()):
                if path.is_file() and path.stat().st_size:
                    shutil.copy(path, start / path.name)
        if not any(start.iterdir()):
            (start / "first").write_bytes(b"\0")
        command = [self._afl["fuzz"], "-V", str(max(1, int(self.seconds))), "-i", str(start), "-o", str(self._work), "-t", "10000"]
        if self._dictionary:
            command += ["-x", str(self._dictionary)]
        command += ["--", str(self._program)]
        environment = dict(os.environ, AFL_NO_UI="1", AFL_SKIP_CPUFREQ="1", AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES="1", AFL_NO_AFFINITY="1",
                           AFL_QUIET="1", AFL_AUTORESUME="0", AFL_FAST_CAL="1")
        try:
            with open(self._log, "ab") as log:
                self._process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, env=environment, start_new_session=True)
                if self._stopping:
                    self.stop()
                while self._process.poll() is None:
                    self._read_stats(queue / "fuzzer_stats")
                    time.sleep(0.5)
            self._read_stats(queue / "fuzzer_stats")
        except OSError as error:
            self.trouble = f"{self.target} (afl): {error}"
        self.elapsed = time.monotonic() - self.started
        self.executions = self.live["runs"]
        self._collect(queue, taken)
        if self._process and self._process.returncode not in (0, None) and not self._stopping and not self.live["runs"]:
            self.trouble = f"{self.target} (afl) ended with status {self._process.returncode}; see {self._log}"

    def _read_stats(self, path):
        try:
            stats = dict((k.strip(), v.strip()) for k, _, v in (line.partition(":") for line in path.read_text().splitlines()))
            self.live.update(runs=int(stats["execs_done"]), rate=int(float(stats["execs_per_sec"])), corpus=int(stats["corpus_count"]))
        except (OSError, KeyError, ValueError, OverflowError):  # not written yet, half written, or a rate of inf
            pass

    def _collect(self, queue, taken):
        import hashlib
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


def libfuzzer_command(program, corpus, extra_folders, seed_list, dictionary, artifacts, seconds, value_profile):
    command = [str(program), str(corpus), *map(str, extra_folders), f"-max_total_time={max(1, int(seconds))}", "-print_final_stats=1",
               "-reload=1", "-timeout=10", "-rss_limit_mb=2048", "-max_len=4096", "-use_value_profile=" + ("1" if value_profile else "0"),
               f"-artifact_prefix={artifacts}"]
    if dictionary:
        command.append(f"-dict={dictionary}")
    if seed_list:
        command.append(f"-seed_inputs=@{seed_list}")
    return command
