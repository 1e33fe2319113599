"""What slices of fuzzing have in common: processes of one target in one variant, watched while they run. See libfuzzer.py and afl.py."""
import os
import signal
import subprocess
import threading
import time


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
        self.live = {"coverage": 0, "features": 0, "corpus": 0, "new": 0}
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

    @property
    def rate(self):
        """Executions a second, restarts included."""
        return self.executions / max(1.0, self.elapsed)

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

    def kill(self):
        self._stopping = True
        self._signal(signal.SIGKILL)
