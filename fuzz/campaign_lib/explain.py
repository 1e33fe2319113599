"""An input in words: its octets, and trama's own decode of what it puts on the wire."""
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
    if target.endswith("_text"):
        return "\n".join(text + ["As text:", octets.decode(errors="backslashreplace"), ""])
    if not printer or not tool:
        return "\n".join(text)
    wire = subprocess.run([str(printer), "--wire", str(path)], capture_output=True, timeout=20, start_new_session=True)
    form = target.split("_")[0]
    command = [str(tool), "decode", form] + ([] if form == "can" else ["--hex"])
    decoded = subprocess.run(command, input=wire.stdout, capture_output=True, timeout=20, start_new_session=True)
    text += ["On the wire:", wire.stdout.decode(errors="replace").strip(), "", f"As `trama decode {form}` reads it:",
             decoded.stdout.decode(errors="backslashreplace").strip() or "(nothing)", ""]
    return "\n".join(text)
