"""An input in words: its octets, and trama's own decode of what it puts on the wire."""
import os
import subprocess
from pathlib import Path


def hexdump(octets):
    rows = []
    for at in range(0, len(octets), 16):
        row = octets[at:at + 16]
        rows.append(f"{at:06x}  {row.hex(' '):<47}  {''.join(chr(o) if 32 <= o < 127 else '.' for o in row)}")
    return "\n".join(rows) or "(empty)"


def explain(target, path, printer, tool):
    """`printer` is a build of the target that knows --wire, `tool` the trama program; without them the octets have to do."""
    octets = Path(path).read_bytes()
    text = [f"{len(octets)} octets of input:", hexdump(octets), ""]
    form, _, idea = target.partition("_")
    decode = [str(tool), "decode", form]
    if idea == "text":
        text += ["As text:", octets.decode(errors="backslashreplace"), ""]
    if not tool or (idea != "text" and not printer):
        return "\n".join(text)
    if idea == "text" and form == "can" and octets.startswith(b"("):
        wire = octets
    elif idea == "text":
        wire, said = run([str(tool), "encode", form, "--unchecked"], octets)
        text += [f"What `trama encode {form} --unchecked` makes of it:", hexdump(wire) if form != "can" else shown(wire), shown(said), ""]
    else:
        wire, _ = run([str(printer), "--wire", str(path)], b"")
        text += ["On the wire:", shown(wire), ""]
        decode += [] if form == "can" else ["--hex"]
    return "\n".join(text + [f"As `trama decode {form}` reads it:", shown(run(decode, wire)[0]) or "(nothing)", ""])


def run(command, given):
    """(output, complaints)."""
    r = subprocess.run(command, input=given, capture_output=True, timeout=20, start_new_session=True,
                       env=dict(os.environ, LLVM_PROFILE_FILE=os.devnull))  # these are builds that measure coverage
    return r.stdout, r.stderr


def shown(octets):
    return octets.decode(errors="backslashreplace").strip()
