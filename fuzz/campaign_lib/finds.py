"""What becomes of an input that fails: which fault is it, how small can it get, what does it say."""
import hashlib
import re
import shutil
import subprocess
import time
from pathlib import Path

_FRAME = re.compile(r"^\s*#\d+ 0x[0-9a-f]+ in (.+?) (\S+?)(?::(\d+))?(?::\d+)?$")
_HARNESS = ("fuzzer::", "__asan", "__ubsan", "__sanitizer", "__interceptor", "__libc", "_start", "main", "abort", "raise", "gsignal", "pthread_kill",
            "LLVMFuzzer", "trama::fuzz::require", "__pthread_kill")


def _plain(function):
    """A function's name without template arguments and parameters, which differ between instances of one fault."""
    out, depth = "", 0
    for c in function.replace("operator()", "operator_call").replace("(anonymous namespace)", "anonymous"):
        if c in "<([":
            depth += 1
        elif c in ">)]":
            depth -= 1
        elif depth == 0:
            out += c
    return out.replace(" const", "").strip().split(" ")[-1]


def stack_of(output):
    """The innermost frames that belong to the library or the target, as "function file:line"."""
    frames = []
    for line in output.splitlines():
        m = _FRAME.match(line)
        if m:
            name = _plain(m.group(1))
            if name and not any(name.startswith(h) or h in name for h in _HARNESS):
                frames.append((name, Path(m.group(2)).name, m.group(3) or "?"))
        elif frames and not line.strip():
            break
    return frames


def signature(output, target):
    """(title, key) of a failed run: two inputs with one key show one fault. None when the output tells of no failure."""
    m = re.search(r"property broken: (.*)", output)
    if m:
        return m.group(1).strip(), f"property {target}: {re.sub(r'[0-9]+', 'N', m.group(1).strip())}"
    where = stack_of(output)
    place = " < ".join(name for name, _, _ in where[:3])
    m = re.search(r"(\S+?):(\d+):\d+: runtime error: (.*)", output)
    if m:
        what = f"{m.group(3).strip()} at {Path(m.group(1)).name}:{m.group(2)}"
        return what, f"ubsan {re.sub(r'-?[0-9]+', 'N', m.group(3))} {Path(m.group(1)).name} {place}"
    m = re.search(r"ERROR: (AddressSanitizer|LeakSanitizer|MemorySanitizer): ([\w-]+)", output)
    if m:
        top = f" in {where[0][0]} ({where[0][1]}:{where[0][2]})" if where else ""
        return m.group(2) + top, f"{m.group(2)} {place}"
    m = re.search(r"ERROR: libFuzzer: ([\w-]+)", output)
    if m:
        top = f" in {where[0][0]}" if where else ""
        return m.group(1) + top, f"libfuzzer {m.group(1)} {place if m.group(1) != 'timeout' else target}"
    m = re.search(r"(Assertion .* failed)", output)
    if m:
        return m.group(1), m.group(1)
    return None


def shrink(octets, still_fails, seconds, now=time.monotonic):
    """Delta debugging: the smallest input found in time for which `still_fails` holds. First pieces go, then octets become 0."""
    end = now() + seconds
    size = max(1, len(octets) // 2)
    while octets and now() < end:
        at, gone = 0, False
        while at < len(octets) and now() < end:
            shorter = octets[:at] + octets[at + size:]
            if still_fails(shorter):
                octets, gone = shorter, True
            else:
                at += size
        if size == 1 and not gone:
            break
        size = max(1, size // 2)
    for at in range(len(octets)):
        if now() >= end:
            break
        if octets[at] != 0:
            plainer = octets[:at] + b"\0" + octets[at + 1:]
            if still_fails(plainer):
                octets = plainer
    return octets


def hexdump(octets):
    rows = []
    for at in range(0, len(octets), 16):
        row = octets[at:at + 16]
        rows.append(f"{at:06x}  {row.hex(' '):<47}  {''.join(chr(o) if 32 <= o < 127 else '.' for o in row)}")
    return "\n".join(rows) or "(empty)"


class Finder:
    """Turns raw artifacts into finds. `programs(target, variant)` gives an executable or None, `tool` is the trama program or None."""

    def __init__(self, out, state, programs, tool, environment, source, adopt, say):
        self._out, self._state, self._programs, self._tool = Path(out), state, programs, tool
        self._environment, self._source, self._adopt, self._say = environment, Path(source), adopt, say

    def run(self, program, path, seconds=20):
        try:
            r = subprocess.run([str(program), "-timeout=10", "-rss_limit_mb=2048", str(path)], capture_output=True, env=self._environment, timeout=seconds,
                               start_new_session=True, cwd=self._out)
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

    def take(self, target, artifact, stop=lambda: False):
        """Files one artifact: a new find, or one more input of a known one. The new find's id, or None."""
        artifact = Path(artifact)
        if not artifact.is_file():
            return None
        variant, title, key, output = self.examine(target, artifact)
        if variant is None and "-timeout-" in artifact.name:
            # Time-outs go by the clock on the wall: a busy machine makes some that are none.
            self._say(f"{target}: slow once, not again: {artifact.name}")
            artifact.unlink()
            return None
        ident = hashlib.sha1(key.encode()).hexdigest()[:10]
        with self._state.lock:
            known = self._state.finds.get(ident)
            if known:
                known["count"] += 1
                known["targets"] = sorted({*known["targets"], target})
                self._state.save()
                artifact.unlink()
                return None
        original = artifact.read_bytes()
        small = original
        if variant and "timeout" not in key and not stop():
            small = self._shrink(target, variant, key, original, stop)
        folder = self._out / "finds" / f"{target}-{ident}"
        self._write(folder, target, ident, title, variant, original, small, output)
        with self._state.lock:
            self._state.finds[ident] = {"target": target, "targets": [target], "title": title, "variant": variant, "count": 1, "size": len(small),
                                        "original_size": len(original), "folder": str(folder.relative_to(self._out)), "found": time.time()}
            self._state.save()
        artifact.unlink()
        self._say(f"find {target}-{ident}: {title} ({len(small)} octets)")
        return ident

    def _shrink(self, target, variant, key, octets, stop):
        program = self._programs(target, variant)
        trial = self._out / "raw" / f".trial-{target}"

        def still_fails(candidate):
            if stop():
                return False
            trial.write_bytes(candidate)
            code, output = self.run(program, trial)
            again = signature(output, target) if code != 0 else None
            return again is not None and again[1] == key

        small = shrink(octets, still_fails, 45)
        trial.unlink(missing_ok=True)
        return small

    def explain(self, target, path):
        """The input in words: trama's own decode of what it puts on the wire."""
        octets = Path(path).read_bytes()
        text = [f"{len(octets)} octets of input:", hexdump(octets), ""]
        if target.endswith("_text"):
            return "\n".join(text + ["As text:", octets.decode(errors="backslashreplace"), ""])
        printer = self._programs(target, "coverage")
        if not printer or not self._tool:
            return "\n".join(text)
        wire = subprocess.run([str(printer), "--wire", str(path)], capture_output=True, timeout=20, start_new_session=True)
        form = target.split("_")[0]
        command = [str(self._tool), "decode", form] + ([] if form == "can" else ["--hex"])
        decoded = subprocess.run(command, input=wire.stdout, capture_output=True, timeout=20, start_new_session=True)
        text += ["On the wire:", wire.stdout.decode(errors="replace").strip(), "", f"As `trama decode {form}` reads it:",
                 decoded.stdout.decode(errors="backslashreplace").strip() or "(nothing)", ""]
        return "\n".join(text)

    def _write(self, folder, target, ident, title, variant, original, small, output):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        (folder / "input").write_bytes(small)
        (folder / "original").write_bytes(original)
        if variant and small != original:
            output = self.run(self._programs(target, variant), folder / "input")[1] or output
        (folder / "output.txt").write_text(output)
        try:
            explanation = self.explain(target, folder / "input")
        except (OSError, subprocess.SubprocessError) as error:
            explanation = f"no explanation: {error}\n\n{hexdump(small)}\n"
        (folder / "explanation.txt").write_text(f"{target}: {title}\n\n{explanation}")
        program = self._programs(target, variant or "checked") or self._programs(target, "fast")
        script = folder / "reproduce.sh"
        script.write_text("#!/bin/sh\n# " + title.replace("\n", " ") + f'\nexec "{program}" "$@" "$(dirname "$0")/input"\n')
        script.chmod(0o755)
        places = [self._out / "regressions" / target] + ([self._source / "fuzz" / "regressions" / target] if self._adopt else [])
        for place in places:
            place.mkdir(parents=True, exist_ok=True)
            (place / ident).write_bytes(small)
