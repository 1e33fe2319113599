"""Which fault is it? Names a failure by what the program said of it."""
import re
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


def _distinction(words, said):
    """What tells faults of the same words apart where library and reference disagree: the side that refused, and the message."""
    line, reference = (re.search(rf"^{side}: +(.*)", said, re.MULTILINE) for side in ("line", "reference"))
    if not line or not reference:
        return ""
    side = ("reference" if reference.group(1) == "(refused)" else "library") if "refuse" in words else ""
    message = re.search(r'"message"\s*:\s*"([a-z_0-9]+(?:\.[a-z_0-9]+)?)"', line.group(1))
    return f" [{side} {message.group(1) if message else ''}]"


def signature(output, target):
    """(title, key) of a failed run: two inputs with one key show one fault. None when the output tells of no failure."""
    m = re.search(r"property broken: (.*)", output)
    if m:
        words = m.group(1).strip()
        return words, f"property {target}: {re.sub(r'[0-9]+', 'N', words)}{_distinction(words, output[:m.start()])}"
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
