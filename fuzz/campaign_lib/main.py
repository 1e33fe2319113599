"""The campaign from start to report."""
import fcntl
import queue
import signal
import sys
import threading
import time

from . import corpus, display, engine, finds, options, report, schedule, state, toolchain


class Campaign:
    def __init__(self, o):
        self.o = o
        self.stop = False
        self.building = False
        self.show = display.Display()
        self.names = toolchain.targets(o.source, o.targets)
        self.tools = toolchain.find(o.engine)
        o.out.mkdir(parents=True, exist_ok=True)
        self._only_one()
        self.state = state.State(o.out, o.time, self.names)
        self.programs = {}
        self.running = []
        self.artifacts = queue.Queue()
        self.environment = engine.sanitizer_environment(self.tools["symbolizer"])
        if o.empty_corpus:
            self.environment["TRAMA_FUZZ_PLAIN"] = "1"
        for name in ("corpus", "raw", "finds", "regressions", "logs", "afl"):
            (o.out / name).mkdir(exist_ok=True)
        for name in self.names:
            corpus.repair(self.corpus(name))

    def _only_one(self):
        self._lock = open(self.o.out / "lock", "w")
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise toolchain.CannotRun(f"another campaign is running in {self.o.out}") from None

    def corpus(self, name):
        return self.o.out / "corpus" / name

    def log(self, name):
        return self.o.out / "logs" / f"{name}.log"

    def program(self, name, variant):
        return self.programs.get((name, variant))

    def siblings(self, name):
        """Corpora of the other targets that read the same kind of input."""
        mine = corpus.group(self.o.source, name)
        folders = sorted((self.o.out / "corpus").iterdir())
        return [f for f in folders if f.is_dir() and f.suffix == "" and f.name != name and corpus.group(self.o.source, f.name) == mine]

    # Building

    def build(self):
        variants = ["fast", "checked", "coverage"] + (["afl"] if self.tools["afl"] else [])
        for variant in variants:
            self.show.stage(f"building the {variant} variant of {len(self.names)} targets")
            extra = ["trama_tool"] if variant == "coverage" else []
            folder = toolchain.build(self.tools, self.o.source, self.o.out, variant, self.names, self.o.jobs, self.log("build"), extra)
            for name in self.names:
                self.programs[name, variant] = toolchain.executable(folder, f"fuzz_{name}")
            if variant == "coverage":
                self.programs["tool", variant] = toolchain.executable(folder, "trama")

    # Fuzzing

    def _start(self, name, seconds):
        t = self.state.target(name)
        busy = sum(s.target == name for s in self.running)
        variant = schedule.variant_of(t["slices"] + busy, self.tools["afl"] is not None)
        seeds = [] if self.o.empty_corpus else corpus.seed_folders(self.o.source, name)
        words = None if self.o.empty_corpus else corpus.dictionary(self.o.source, name)
        program = self.program(name, variant)
        if variant == "afl":
            if any(s.target == name and s.variant == "afl" for s in self.running):
                variant, program = "fast", self.program(name, "fast")
            else:
                inputs = [self.corpus(name), *seeds]
                s = engine.AflSlice(name, seconds, self.tools["afl"], program, inputs, self.o.out / "afl" / name, self.corpus(name),
                                    self.o.out / "raw", words, self.log(name))
        if variant != "afl":
            fresh = corpus.newer_than(self.siblings(name), t["fed_at"])
            seed_list = None
            if fresh:
                seed_list = self.o.out / "logs" / f"{name}.feed"
                seed_list.write_text(",".join(fresh))
            command = engine.libfuzzer_command(program, self.corpus(name), seeds, seed_list, words, f"{self.o.out}/raw/{name}-",
                                               seconds, value_profile=t["slices"] % 4 == 2)
            s = engine.LibFuzzerSlice(name, variant, seconds, command, self.environment, self.log(name))
        t["fed_at"] = time.time()
        s.base = t["seconds"]
        s.start()
        self.running.append(s)

    def _collect(self):
        for s in [s for s in self.running if not s.is_alive()]:
            self.running.remove(s)
            with self.state.lock:
                self._take_points(s)
                self.state.add_slice(s.target, s.variant, s.executions, s.elapsed)
                self.state.target(s.target)["new"] += s.live["new"]
            for path in s.artifacts:
                self.artifacts.put((s.target, path))
            if s.trouble:
                self.show.say(s.trouble)

    def _take_points(self, s):
        # The variants count different edges; one of them makes the curve.
        if s.variant == "fast":
            while s.points:
                at, coverage, features = s.points.pop(0)
                self.state.add_point(s.target, s.base + at, coverage, features)

    def _rows(self):
        rows = []
        for name in self.names:
            t = self.state.target(name)
            live = [s for s in self.running if s.target == name]
            rows.append({"name": name, "running": [s.variant for s in live], "rate": sum(s.live["rate"] for s in live),
                         "executions": t["executions"] + sum(s.live["runs"] for s in live), "coverage": t["coverage"],
                         "corpus": corpus.count(self.corpus(name)), "new": t["new"] + sum(s.live["new"] for s in live),
                         "finds": sum(name in f["targets"] for f in list(self.state.finds.values())),
                         "seconds": t["seconds"] + sum(time.monotonic() - s.started for s in live)})
        return rows

    def fuzz(self):
        total = self.state.data["left"]
        last_save = last = time.monotonic()
        while self.state.data["left"] > 0 and not self.stop:
            while len(self.running) < self.o.jobs:
                seconds = {n: self.state.target(n)["seconds"] for n in self.names}
                busy = {}
                for s in self.running:
                    busy[s.target] = busy.get(s.target, 0) + 1
                    seconds[s.target] += time.monotonic() - s.started
                length = schedule.slice_seconds(total, self.o.jobs, len(self.names))
                self._start(schedule.next_target(self.names, seconds, busy), min(length, max(1, self.state.data["left"])))
            time.sleep(0.25)
            now = time.monotonic()
            self.state.data["left"] -= now - last
            self.state.data["fuzzed"] += now - last
            last = now
            with self.state.lock:
                for s in self.running:
                    self._take_points(s)
                    s.kill_if_late(60)
            self._collect()
            if now - last_save > 5:
                self.state.save()
                last_save = now
            self.show.update(self._rows(), self.state.data["left"], self.state.data["asked"], len(self.state.finds))
        for s in self.running:
            s.stop()
        for s in self.running:
            s.join(20)
        self._collect()
        self.state.save()

    # Finds, in a thread of their own

    def _file_finds(self):
        finder = finds.Finder(self.o.out, self.state, self.program, self.program("tool", "coverage"), self.environment, self.o.source,
                              self.o.adopt, self.show.say)
        while True:
            item = self.artifacts.get()
            if item is None:
                return
            try:
                finder.take(*item, stop=lambda: self.stop)
            except Exception as error:  # one odd input must not end the campaign; it stays in raw/ for the next start
                self.show.say(f"could not file {item[1]}: {error}")

    def _leftovers(self):
        """Artifacts of a campaign that was killed before it could file them."""
        for path in sorted((self.o.out / "raw").iterdir()):
            for kind in ("crash", "timeout", "oom", "leak"):
                name, found, _ = path.name.partition(f"-{kind}-")
                if found and name in self.names:
                    self.artifacts.put((name, str(path)))

    # Afterwards

    def _watch(self, process, seconds):
        """Waits for a process and ends it when the campaign is stopped; its status, or None."""
        end = time.monotonic() + seconds
        while process.poll() is None:
            if self.stop or time.monotonic() > end:
                process.kill()
                process.wait()
                return None
            time.sleep(0.05)
        return process.returncode

    def _in_parallel(self, what, work):
        left = list(self.names)
        lock = threading.Lock()

        def worker():
            while not self.stop:
                with lock:
                    if not left:
                        return
                    name = left.pop(0)
                try:
                    work(name)
                except Exception as error:
                    self.show.say(f"{what} {name}: {error}")

        threads = [threading.Thread(target=worker, daemon=True) for _ in range(self.o.jobs)]
        for t in threads:
            t.start()
        for t in threads:
            while t.is_alive():
                t.join(0.2)

    def _minimise(self, name):
        others = self.siblings(name) + ([] if self.o.empty_corpus else corpus.seed_folders(self.o.source, name))
        if not corpus.minimise(self.program(name, "fast"), self.corpus(name), others, self.environment, self.log(name), 120, self._watch):
            if not self.stop:
                self.show.say(f"{name}: the corpus could not be minimised and stays as it is; see {self.log(name)}")

    def _measure(self, name):
        covered = corpus.line_coverage(self.tools, self.program(name, "coverage"), [self.corpus(name)], self.o.source,
                                       self.o.out / "build" / "profiles", self._watch)
        if covered:
            with self.state.lock:
                self.state.target(name).update(covered)

    def finish(self):
        if not self.stop:
            self.show.stage("merging and minimising the corpora")
            self._in_parallel("minimising", self._minimise)
            # Only now: until here they read each other's.
            for name in self.names if not self.stop else ():
                corpus.swap(self.corpus(name))
        if not self.stop and self.tools["cov"] and self.tools["profdata"]:
            self.show.stage("measuring the lines that the corpora reach")
            self._in_parallel("measuring", self._measure)
        self.state.save()

    def report(self):
        data = report.gather(self.state, self.o, self.names, self.tools, {n: corpus.count(self.corpus(n)) for n in self.state.data["targets"]})
        report.write(self.o.out, data)
        self.show.say(report.summary(data))
        self.show.say(f"report: {self.o.out / 'report.html'} and report.json")

    def on_signal(self, number, frame):
        if self.stop or self.building:  # a build has nothing to lose: the next start goes on with it
            raise KeyboardInterrupt
        self.stop = True
        self.show.say("stopping; once more ends at once")

    def run(self):
        signal.signal(signal.SIGINT, self.on_signal)
        signal.signal(signal.SIGTERM, self.on_signal)
        for line in toolchain.warnings(self.tools):
            self.show.say(line)
        self.building = True
        self.build()
        self.building = False
        if self.state.resumed:
            self.show.stage(f"resuming: {display.clock(self.state.data['left'])} left of {display.clock(self.state.data['asked'])}")
        self._leftovers()
        filer = threading.Thread(target=self._file_finds, daemon=True)
        filer.start()
        self.fuzz()
        self.artifacts.put(None)
        while filer.is_alive():
            filer.join(0.2)
        self.finish()
        self.report()
        return 130 if self.stop else 1 if self.state.finds else 0


def main(arguments=None):
    o = options.parse(arguments)
    try:
        if o.list:
            print("\n".join(toolchain.targets(o.source, o.targets)))
            return 0
        return Campaign(o).run()
    except toolchain.CannotRun as trouble:
        print(f"campaign: {trouble}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("campaign: ended; the corpora and the raw finds are kept, start it again to go on", file=sys.stderr)
        return 130
