"""The campaign from start to report."""
import fcntl
import queue
import shutil
import signal
import sys
import threading

from . import corpus, display, engine, finds, finishing, fuzzing, options, provenance, report, state, toolchain


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
        code = {"commit": provenance.commit(o.source), "digest": provenance.digest(o.source, toolchain.description(self.tools))}
        self.state = state.State(o.out, o.time, self.names, code)
        self.programs = {}
        self.artifacts = queue.Queue()
        self.environment = dict(engine.sanitizer_environment(self.tools["symbolizer"]), TMPDIR=str(o.out / "tmp"))
        shutil.rmtree(o.out / "tmp", ignore_errors=True)  # what merges leave there that were killed
        for name in ("corpus", "raw", "finds", "regressions", "logs", "afl", "feed", "tmp"):
            (o.out / name).mkdir(exist_ok=True)
        self._begin_empty()
        for name in self.names:
            corpus.repair(self.corpus(name))

    def _only_one(self):
        self._lock = open(self.o.out / "lock", "w")
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise toolchain.CannotRun(f"another campaign is running in {self.o.out}") from None

    def _begin_empty(self):
        """With --empty-corpus what is there must have grown from nothing; without it, it has not from now on."""
        if self.o.empty_corpus:
            self.environment["TRAMA_FUZZ_PLAIN"] = "1"
            if not self.state.data["empty_corpus"] and any(map(corpus.count, (self.o.out / "corpus").iterdir())):
                raise toolchain.CannotRun(f"{self.o.out / 'corpus'} holds inputs of a campaign that had seeds, so this one would not start from an empty "
                                          "corpus; choose another --out, or remove that folder")
        self.state.data["empty_corpus"] = self.o.empty_corpus

    # Where things are

    def corpus(self, name):
        return self.o.out / "corpus" / name

    def log(self, name):
        return self.o.out / "logs" / f"{name}.log"

    def artifacts_of(self, name):
        """How the paths of inputs begin that fail; `_leftovers` finds them again."""
        return f"{self.o.out}/raw/{name}-"

    def program(self, name, variant):
        return self.programs.get((name, variant))

    def seeds(self, name):
        return [] if self.o.empty_corpus else corpus.seed_folders(self.o.source, name)

    def dictionary(self, name):
        return None if self.o.empty_corpus else corpus.dictionary(self.o.source, name)

    def siblings(self, name):
        """Corpora of the other targets that read the same kind of input."""
        mine = corpus.group(self.o.source, name)
        folders = sorted((self.o.out / "corpus").iterdir())
        return [f for f in folders if f.is_dir() and f.suffix == "" and f.name != name and corpus.group(self.o.source, f.name) == mine]

    # From start to end

    def build(self):
        self.building = True
        variants = ["fast", "checked", "coverage"] + (["afl"] if self.tools["afl"] else [])
        for variant in variants:
            self.show.stage(f"building the {variant} variant of {len(self.names)} targets")
            extra = ["trama_tool"] if variant == "coverage" else []
            folder = toolchain.build(self.tools, self.o.source, self.o.out, variant, self.names, self.o.jobs, self.log("build"), extra)
            for name in self.names:
                self.programs[name, variant] = toolchain.executable(folder, f"fuzz_{name}")
            if variant == "coverage":
                self.programs["tool", variant] = toolchain.executable(folder, "trama")
        self.building = False

    def _file_finds(self, finder):
        """Files first what an interrupted campaign left half done, then what comes in, until None does."""
        self._attempt("the known finds", finder.finish)
        while (item := self.artifacts.get()) is not None:
            self._attempt(item[1], finder.take, *item)

    def _attempt(self, what, work, *arguments):
        try:
            work(*arguments)
        except Exception as error:  # one odd input must not end the campaign; it stays in raw/ for the next start
            self.show.say(f"could not file {what}: {error}")

    def _leftovers(self):
        """Artifacts that nobody has filed: a killed campaign's, those of closed finds that show another fault, those that merging came upon."""
        for path in sorted((self.o.out / "raw").iterdir()):
            for kind in ("crash", "timeout", "oom", "leak"):
                name, found, _ = path.name.partition(f"-{kind}-")
                if found and name in self.names:
                    self.artifacts.put((name, str(path)))

    def fuzz(self, finder):
        if self.state.open_finds():
            self.show.stage(f"replaying the open finds, {len(self.state.open_finds())}")
            self._attempt("the known finds", finder.replay)
        self._leftovers()
        filer = threading.Thread(target=self._file_finds, args=(finder,), daemon=True)
        filer.start()
        if self.state.data["phase"] == "fuzzing":
            fuzzing.Fuzzing(self, lambda target, path: self.artifacts.put((target, path))).run()
        self.artifacts.put(None)
        while filer.is_alive():
            filer.join(0.2)
        finishing.Finishing(self).run()
        self._leftovers()
        self.artifacts.put(None)
        self._file_finds(finder)

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
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            if signal.getsignal(number) != signal.SIG_IGN:  # under nohup
                signal.signal(number, self.on_signal)
        for line in toolchain.warnings(self.tools):
            self.show.say(line)
        self.build()
        self.state.save()
        if self.state.resumed:
            self.show.stage(f"resuming: {display.clock(self.state.data['left'])} left of {display.clock(self.state.data['asked'])}"
                            if self.state.data["phase"] == "fuzzing" else f"resuming: {self.state.data['phase']} was not finished")
        self.fuzz(finds.Finder(self.o.out, self.state, self.program, self.program("tool", "coverage"), self.environment, self.o.source, self.o.adopt,
                               self.show.say, lambda: self.stop))
        self.report()
        return 130 if self.stop else 1 if self.state.open_finds() else 0


def main(arguments=None):
    o = options.parse(arguments)
    try:
        if o.list:
            print("\n".join(toolchain.targets(o.source, o.targets)))
            return 0
        return Campaign(o).run()
    except (toolchain.CannotRun, OSError) as trouble:  # such as a full disk
        print(f"campaign: {trouble}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("campaign: ended; the corpora and the raw finds are kept, start it again to go on", file=sys.stderr)
        return 130
