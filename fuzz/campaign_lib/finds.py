"""Filing what fails: one folder per fault, further inputs of it beside the first, and a second look once the library was mended."""
import hashlib
import itertools
import shutil
import subprocess
import time
from pathlib import Path

from .engine import unnamed
from .explain import explain, hexdump
from .shrink import shrink
from .signature import signature

SHRINKING = 45  # seconds for each find, and as many again at each further start
MORE = 5  # further inputs kept of one fault: what looks like it may be another
ALIKE = 8  # finds of one target with the same title; inputs beyond them go to the first one's


def open_finds(finds):
    return {ident: f for ident, f in finds.items() if f.get("state", "open") == "open"}


def inputs_of(folder):
    """The files of a find's folder that fail, the minimised one first."""
    return [p for p in (folder / "input", folder / "original", *sorted(folder.glob("more/*"))) if p.is_file()]


def digest(path):
    return hashlib.sha1(Path(path).read_bytes()).hexdigest()


def open_inputs(out, finds):
    """Digests of all inputs that are known to fail: nothing is to start from them."""
    return {digest(p) for f in open_finds(finds).values() for p in inputs_of(Path(out) / f["folder"])}


class Finder:
    """Turns raw artifacts into finds. `programs(target, variant)` gives an executable or None, `tool` is the trama program or None,
    `stop` tells whether to hurry: what is left undone then is marked, and done by `finish` at the next start."""

    def __init__(self, out, state, programs, tool, environment, source, adopt, say, stop=lambda: False):
        self._out, self._state, self._programs, self._tool = Path(out), state, programs, tool
        self._environment, self._source, self._adopt, self._say, self._stop = environment, Path(source), adopt, say, stop

    def run(self, program, path, seconds=20, environment=None):
        try:
            r = subprocess.run([str(program), "-timeout=10", "-rss_limit_mb=2048", str(path)], capture_output=True, env=environment or self._environment,
                               timeout=seconds, start_new_session=True, cwd=self._out)
        except subprocess.TimeoutExpired as late:
            return 1, "ERROR: libFuzzer: timeout\n" + (late.stderr or b"").decode(errors="replace")
        return r.returncode, r.stderr.decode(errors="replace")

    def examine(self, target, path):
        """(variant, title, key, output) of the failure, from the checked variant if it shows there."""
        for variant in ("checked", "fast"):
            program = self._programs(target, variant)
            if not program:
                continue
            code, output = self.run(program, path)
            if code != 0:
                title, key = signature(output, target) or (f"ended with status {code}", f"status {code} {target}")
                return variant, title, key, output
        return None, "does not fail again", f"not reproduced {target}", ""

    # Filing

    def take(self, target, artifact):
        """Files one artifact: a new find, or one more input of a known one. The new find's id, or None."""
        artifact = Path(artifact)
        if not artifact.is_file():
            return None
        variant, title, key, output = self.examine(target, artifact)
        if variant is None and "-timeout-" in artifact.name:
            # Time-outs go by the clock on the wall: a busy machine makes some that are none.
            self._say(f"{target}: slow once, not again: {artifact.name}")
            home = self._out / "corpus" / target
            home.mkdir(parents=True, exist_ok=True)
            artifact.rename(home / digest(artifact))  # from where it was left out
            return None
        ident = self._place(target, title, key)
        if ident in self._state.finds:
            self._one_more(ident, target, artifact)
            return None
        self._file(ident, target, artifact.read_bytes(), variant, title, key, output)
        artifact.unlink()
        return ident

    def _place(self, target, title, key):
        """The id under which a failure belongs: an open find's, or a new one. A closed one stays closed: what fails now is another fault."""
        known = open_finds(self._state.finds)
        same = [i for i, f in known.items() if f.get("key") == key]
        alike = [i for i, f in known.items() if f["target"] == target and f["title"] == title]
        if same or len(alike) >= ALIKE:
            return (same or alike)[0]
        name = hashlib.sha1(key.encode()).hexdigest()[:10]
        return next(i for i in itertools.chain([name], (f"{name}-{n}" for n in itertools.count(2))) if i not in self._state.finds)

    def _one_more(self, ident, target, artifact):
        find = self._state.finds[ident]
        folder = self._out / find["folder"]
        name = digest(artifact)
        if len(list(folder.glob("more/*"))) < MORE and digest(artifact) not in map(digest, inputs_of(folder)):
            (folder / "more").mkdir(parents=True, exist_ok=True)
            shutil.copy(artifact, folder / "more" / f"{target}-{digest(artifact)}")
        with self._state.lock:
            find["count"] += 1
            find["targets"] = sorted({*find["targets"], target})
            self._state.save()
        artifact.unlink()

    def _file(self, ident, target, original, variant, title, key, output):
        shrinks = variant is not None and "timeout" not in key
        small, smallest = self._shrink(target, variant, key, original) if shrinks else (original, True)
        folder = self._out / "finds" / f"{target}-{ident}"
        self._write(folder, target, ident, title, variant, original, small, output)
        with self._state.lock:
            self._state.finds[ident] = {
                "target": target, "targets": [target], "title": title, "key": key, "variant": variant, "count": 1, "size": len(small), "state": "open",
                "original_size": len(original), "folder": str(folder.relative_to(self._out)), "found": time.time(), "to_minimise": not smallest}
            self._state.save()
        self._say(f"find {target}-{ident}: {title} ({len(small)} octets)")

    def _shrink(self, target, variant, key, octets):
        """(the smallest input found that fails alike, whether there was time to try all)."""
        program = self._programs(target, variant)
        environment = unnamed(self._environment) if key.startswith("property ") else self._environment  # whose key needs no stack
        trial = self._out / "raw" / f".trial-{target}"

        def still_fails(candidate):
            if self._stop():
                return False
            trial.write_bytes(candidate)
            code, output = self.run(program, trial, environment=environment)
            again = signature(output, target) if code != 0 else None
            return again is not None and again[1] == key

        small, finished = shrink(octets, still_fails, SHRINKING)
        trial.unlink(missing_ok=True)
        return small, finished and not self._stop()

    def _write(self, folder, target, ident, title, variant, original, small, output):
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "input").write_bytes(small)
        (folder / "original").write_bytes(original)
        if variant and small != original:
            output = self.run(self._programs(target, variant), folder / "input")[1] or output
        (folder / "output.txt").write_text(output, encoding="utf-8")
        try:
            explanation = explain(target, folder / "input", self._programs(target, "coverage"), self._tool)
        except (OSError, subprocess.SubprocessError) as error:
            explanation = f"no explanation: {error}\n\n{hexdump(small)}\n"
        (folder / "explanation.txt").write_text(f"{target}: {title}\n\n{explanation}", encoding="utf-8")
        program = self._programs(target, variant or "checked") or self._programs(target, "fast")
        script = folder / "reproduce.sh"
        script.write_text("#!/bin/sh\n# " + title.replace("\n", " ") + f'\nexec "{program}" "$@" "$(dirname "$0")/input"\n', encoding="utf-8")
        script.chmod(0o755)
        places = [self._out / "regressions" / target] + ([self._source / "fuzz" / "regressions" / target] if self._adopt and variant else [])
        for place in places:
            place.mkdir(parents=True, exist_ok=True)
            (place / ident).write_bytes(small)

    # At the next start

    def replay(self):
        """Runs the open finds again and closes those that are mended. Their inputs that still fail go back to raw/, to be filed anew."""
        for ident, find in list(open_finds(self._state.finds).items()):
            if self._stop():
                return
            if self._programs(find["target"], "checked"):
                try:
                    self._look_again(ident, find)
                except (OSError, subprocess.SubprocessError) as error:
                    self._say(f"could not look at {find['target']}-{ident} again: {error}")

    def _look_again(self, ident, find):
        target, path = find["target"], self._out / find["folder"] / "input"
        variant = None
        for _ in range(3) if path.is_file() else ():  # not every fault shows every time
            variant, _, key, _ = self.examine(target, path)
            if variant and key == find.setdefault("key", key):
                return
        why = "its input shows another fault now" if variant else "its input passes now" if find["variant"] else "it never failed a second time"
        # What fails goes back before the find is closed, so that nothing is lost if it ends here.
        for path in inputs_of(self._out / find["folder"]):
            owner = path.name.rpartition("-")[0] or target
            if self._stop():
                return
            if self._programs(owner, "checked") and self.examine(owner, path)[0]:
                shutil.copy(path, self._out / "raw" / f"{owner}-crash-{digest(path)}")
        self._close(ident, find, why)
        self._say(f"closed {target}-{ident}: {why}")

    def _close(self, ident, find, why):
        folder = self._out / find["folder"]
        closed = self._out / "finds" / "closed" / folder.name
        closed.parent.mkdir(parents=True, exist_ok=True)
        if folder.is_dir():
            shutil.rmtree(closed, ignore_errors=True)
            folder.rename(closed)
        with self._state.lock:
            find.update(state="closed", why=why, closed=time.time(), folder=str(closed.relative_to(self._out)))
            self._state.save()

    def finish(self):
        """Minimises what an interrupted campaign had no time for."""
        for ident, find in list(open_finds(self._state.finds).items()):
            folder, target, variant = self._out / find["folder"], find["target"], find["variant"]
            if self._stop() or not find.get("to_minimise") or not self._programs(target, variant):
                continue
            small, smallest = self._shrink(target, variant, find["key"], (folder / "input").read_bytes())
            output = (folder / "output.txt").read_text(encoding="utf-8", errors="replace")
            self._write(folder, target, ident, find["title"], variant, (folder / "original").read_bytes(), small, output)
            with self._state.lock:
                find.update(size=len(small), to_minimise=not smallest)
                self._state.save()
