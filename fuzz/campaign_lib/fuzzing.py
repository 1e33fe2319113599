"""The campaign's main part: slices of all targets side by side until the time is up."""
import time

from . import afl, corpus, engine, finds, libfuzzer, schedule

SAVE_EVERY = 5.0
COUNT_EVERY = 2.0  # reading folders costs the fuzzers time
GRACE = 60.0  # for a slice that does not end by itself: one input may take 10 s, and the machine may be busy


class Fuzzing:
    """`c` is the campaign. What slices do goes into its state at every tick, so that a sudden end loses seconds; artifacts go to `file`."""

    def __init__(self, c, file):
        self.c, self.o, self.state = c, c.o, c.state
        self._file = file
        self._running = []
        self._sizes, self._counted = {}, 0.0  # of the corpora, and when

    def run(self):
        try:
            self._run()
        except BaseException:  # whatever ends it, nothing is left running
            for s in self._running:
                s.kill()
            raise

    def _run(self):
        total = self.state.data["left"]
        length = schedule.slice_seconds(total, self.o.jobs, len(self.c.names))
        last_save = last = time.monotonic()
        while self.state.data["left"] > 0 and not self.c.stop:
            while len(self._running) < self.o.jobs:
                self._start(self._next(), min(length, max(1, self.state.data["left"])))
            time.sleep(0.25)
            now = time.monotonic()
            self.state.data["left"] -= now - last
            self.state.data["fuzzed"] += now - last
            last = now
            for s in self._running:
                if s.elapsed > s.seconds + GRACE:
                    s.kill()
                    s.trouble = f"{s.target} ({s.variant}) did not end in time and was killed; see {self.c.log(s.target)}"
            self._collect()
            if now - last_save > SAVE_EVERY:
                self.state.save()
                last_save = now
            self.c.show.update(self._rows(), self.state.data["left"], self.state.data["asked"], len(self.state.open_finds()))
        self._end()

    def _end(self):
        for s in self._running:
            s.stop()
        for s in self._running:
            s.join(20)
            if s.is_alive():
                s.kill()
                s.join(5)
        self._collect()
        if self.state.data["left"] <= 0:
            self.state.data["phase"] = "merging"
        self.state.save()

    # Slices

    def _seconds(self):
        return {n: self.state.target(n)["seconds"] for n in self.c.names}

    def _next(self):
        busy = {}
        for s in self._running:
            busy[s.target] = busy.get(s.target, 0) + 1
        return schedule.next_target(self.c.names, self._seconds(), busy)

    def _start(self, name, seconds):
        t = self.state.target(name)
        beside = [s.variant for s in self._running if s.target == name]
        variant = schedule.variant_of(t["slices"] + len(beside), self.c.tools["afl"] is not None)
        if variant == "afl" and "afl" in beside:
            variant = "fast"
        known = finds.open_inputs(self.o.out, self.state.open_finds())
        make = self._afl_slice if variant == "afl" else self._libfuzzer_slice
        begun = time.time()  # before it looks what others have found: what they find meanwhile is for the next slice
        s = make(name, variant, seconds, known, bool(beside))
        s.begun = begun
        s.start()
        self._running.append(s)

    def _afl_slice(self, name, variant, seconds, known, beside):
        own = self.c.corpus(name)
        return afl.AflSlice(name, seconds, self.c.tools["afl"], self.c.program(name, variant), [own, *self.c.seeds(name)], self.o.out / "afl" / name, own,
                            self.o.out / "raw", self.c.dictionary(name), known, self.c.log(name))

    def _libfuzzer_slice(self, name, variant, seconds, known, beside):
        own, program, artifacts = self.c.corpus(name), self.c.program(name, variant), self.c.artifacts_of(name)
        value_profile = self.state.target(name)["slices"] // schedule.turns(self.c.tools["afl"] is not None) % 2 == 1
        feed = None if beside else self._feed(name, seconds, known, artifacts)

        def command(left):
            return libfuzzer.fuzz_command(program, own, self.c.dictionary(name), artifacts, left, value_profile)

        return libfuzzer.LibFuzzerSlice(name, variant, seconds, command, feed, lambda artifact: corpus.leave_out(own, artifact),
                                        engine.unnamed(self.c.environment), self.c.log(name), value_profile, self.c.artifacts.qsize)

    def _feed(self, name, seconds, known, artifacts):
        """The command that merges seeds, and what targets of the same kind found, into the corpus; None when there is nothing new."""
        fresh = corpus.newer_than([*self.c.seeds(name), *self.c.siblings(name)], self.state.target(name)["read_until"])
        folder = self.o.out / "feed" / name
        if not corpus.gather(fresh, folder, self.c.corpus(name), known):
            return None
        return libfuzzer.merge_command(self.c.program(name, "fast"), self.c.corpus(name), [folder], artifacts, seconds)

    def _collect(self):
        for s in list(self._running):
            ended = not s.is_alive()  # before its figures are taken, else the last ones might be missed
            with self.state.lock:
                self._take(s)
                if ended:
                    self.state.target(s.target)["slices"] += 1
            for path in s.take_artifacts():
                self._file(s.target, path)
            if ended:
                self._running.remove(s)
                if s.trouble:
                    self.c.show.say(s.trouble)

    def _take(self, s):
        t = self.state.target(s.target)
        self.state.add(s.target, s.variant, s.take_figures())
        if s.fed:
            t["read_until"] = max(t["read_until"], s.begun)
        # The variants count different edges; one of them makes the curve. Value profiles count as features, too.
        if s.variant == "fast" and s.live["coverage"]:
            self.state.add_point(s.target, s.live["coverage"], 0 if s.value_profile else s.live["features"])

    def _rows(self):
        seconds = self._seconds()
        to_come = schedule.to_come(seconds, self.state.data["left"], self.o.jobs)
        known = self.state.open_finds().values()
        rows = []
        if time.monotonic() - self._counted > COUNT_EVERY:
            self._sizes, self._counted = {name: corpus.count(self.c.corpus(name)) for name in self.c.names}, time.monotonic()
        for name in self.c.names:
            t = self.state.target(name)
            live = [s for s in self._running if s.target == name]
            rows.append({"name": name, "running": [s.variant for s in live], "rate": sum(s.rate for s in live), "executions": t["executions"],
                         "coverage": t["coverage"], "corpus": self._sizes[name], "new": t["new"],
                         "finds": sum(name in f["targets"] for f in known), "seconds": seconds[name], "left": to_come[name]})
        return rows
