"""What follows the fuzzing: corpora are merged and minimised, then the lines they reach are measured. An interrupted step is done at the next start."""
import os
import signal
import threading
import time

from . import corpus, engine, finds


class Finishing:
    """`c` is the campaign."""

    def __init__(self, c):
        self.c, self.o, self.state = c, c.o, c.state

    def run(self):
        for phase, work, after in (("merging", self._merge_all, "measuring"), ("measuring", self._measure_all, "done")):
            if self.state.data["phase"] == phase and not self.c.stop:
                work()
                if not self.c.stop:
                    self.state.data["phase"] = after
                self.state.save()

    def _watch(self, process, seconds):
        """Waits for a process and ends it when the campaign is stopped; its status, or None."""
        end = time.monotonic() + seconds
        while process.poll() is None:
            if self.c.stop or time.monotonic() > end:
                os.killpg(process.pid, signal.SIGKILL)  # a merge has a process of its own beneath
                process.wait()
                return None
            time.sleep(0.05)
        return process.returncode

    def _in_parallel(self, what, work):
        left = list(self.c.names)
        lock = threading.Lock()

        def worker():
            while not self.c.stop:
                with lock:
                    if not left:
                        return
                    name = left.pop(0)
                try:
                    work(name)
                except Exception as error:
                    self.c.show.say(f"{what} {name}: {error}")

        threads = [threading.Thread(target=worker, daemon=True) for _ in range(self.o.jobs)]
        for t in threads:
            t.start()
        for t in threads:
            while t.is_alive():
                t.join(0.2)

    def _merge_all(self):
        self.c.show.stage("merging and minimising the corpora")
        self._in_parallel("minimising", self._minimise)
        known = finds.open_inputs(self.o.out, self.state.open_finds())
        # Only now: until here they read each other's.
        for name in self.c.names if not self.c.stop else ():
            corpus.swap(self.c.corpus(name), known)

    def _minimise(self, name):
        others = self.c.siblings(name) + self.c.seeds(name)
        done = corpus.minimise(self.c.program(name, "fast"), self.c.corpus(name), others, self.c.artifacts_of(name), engine.unnamed(self.c.environment),
                               self.c.log(name), 120, self._watch)
        if not done and not self.c.stop:
            self.c.show.say(f"{name}: the corpus could not be minimised and stays as it is; see {self.c.log(name)}")

    def _measure_all(self):
        if self.c.tools["cov"] and self.c.tools["profdata"]:
            self.c.show.stage("measuring the lines that the corpora reach")
            self._in_parallel("measuring", self._measure)

    def _measure(self, name):
        covered = corpus.line_coverage(self.c.tools, self.c.program(name, "coverage"), [self.c.corpus(name)], self.o.source,
                                       self.o.out / "build" / "profiles", self._watch)
        if covered:
            with self.state.lock:
                self.state.target(name).update(covered)
