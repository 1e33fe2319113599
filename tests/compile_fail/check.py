"""Checks that the compiler refuses one source file, for the right reason.

usage: check.py FILE.cpp COMPILER FLAGS...

The first line of FILE is `// expect: REGEX`; the lines that misuse the library end in `// wrong`.
Without those lines the file has to compile (so it fails for nothing else); with them it has to be
refused with a message (`error:` or `note:`) that matches REGEX. A file that starts with `// control` is compiled as it is
and has to pass: it shows that the compiler and its flags work at all.
"""

import pathlib
import re
import subprocess
import sys
import tempfile


def compile_text(text, name, command):
    """The compiler's exit status and everything it printed for this text."""
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, name)
        source.write_text(text)
        # Messages in plain English, whatever the user's language.
        run = subprocess.run(["env", "LC_ALL=C"] + command + ["-S", "-o", str(pathlib.Path(folder, "out.s")), str(source)],
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return run.returncode, run.stdout


def is_wrong(line):
    return line.rstrip().endswith("// wrong")


def judge(path, command):
    """None when the file behaves as it says, else what is amiss."""
    lines = path.read_text().splitlines(keepends=True)
    right = "".join("\n" if is_wrong(line) else line for line in lines)
    status, output = compile_text(right, path.name, command)
    if status != 0:
        return "does not compile even without its wrong lines:\n" + output
    if lines and lines[0].strip() == "// control":
        return None
    stated = re.match(r"// expect: (.+)", lines[0]) if lines else None
    if not stated:
        return "the first line is neither `// expect: REGEX` nor `// control`"
    if not any(map(is_wrong, lines)):
        return "no line ends in `// wrong`"
    status, output = compile_text("".join(lines), path.name, command)
    if status == 0:
        return "compiles, and must not"
    messages = "\n".join(re.findall(r": (?:error|note): (.*)", output))
    if not re.search(stated.group(1).strip(), messages):
        return f"is refused, but not for `{stated.group(1).strip()}`:\n{output}"
    return None


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    path = pathlib.Path(sys.argv[1])
    amiss = judge(path, sys.argv[2:])
    if amiss:
        sys.exit(f"{path.name}: {amiss}")


main()
