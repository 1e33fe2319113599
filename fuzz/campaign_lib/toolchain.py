"""Finds the compilers, says what is missing, and builds the variants of the targets."""
import fnmatch
import os
import shutil
import subprocess
import tempfile
from pathlib import Path


class CannotRun(Exception):
    """Something the campaign needs is not there; the text says what to install."""


# fast: as many executions as possible. checked: finds what does not crash by itself. coverage: replays, and measures lines and branches.
_SANITIZE = "address,undefined"
FLAGS = {
    "fast": "-O2 -gline-tables-only -fsanitize=fuzzer-no-link",
    "checked": f"-O1 -g -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,{_SANITIZE} -fno-sanitize-recover=all",
    "coverage": "-O1 -g -fprofile-instr-generate -fcoverage-mapping",
    "afl": "-O2 -gline-tables-only",
}
ENGINE = {"fast": "-fsanitize=fuzzer", "checked": "-fsanitize=fuzzer", "coverage": "", "afl": "-fsanitize=fuzzer"}


def _tool(names):
    return next((path for path in map(shutil.which, names) if path), None)


def _major(clang):
    return subprocess.run([clang, "-dumpversion"], capture_output=True, text=True).stdout.strip().split(".")[0]


def _links(clang, flags):
    """What stops a small fuzz target from being built with these flags; empty when nothing does."""
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "probe.cpp")
        source.write_text("#include <cstddef>\nextern \"C\" int LLVMFuzzerTestOneInput(const unsigned char*, std::size_t) { return 0; }\n")
        r = subprocess.run([clang, *flags, str(source), "-o", str(Path(folder, "probe"))], capture_output=True, text=True)
        return "" if r.returncode == 0 else (r.stderr.strip() or "it ended with status %d" % r.returncode)


def find(engine="auto"):
    """The tools as a dict; raises CannotRun naming the Debian package of the first that is missing."""
    clang = os.environ.get("CXX_FUZZ") or _tool(["clang++", *[f"clang++-{v}" for v in range(22, 11, -1)]])
    if not clang or not shutil.which(clang):
        raise CannotRun(f"{clang or 'clang++'} was not found; on Debian: apt install clang")
    cmake = shutil.which("cmake")
    if not cmake:
        raise CannotRun("cmake was not found; on Debian: apt install cmake")
    major = _major(clang)
    for flags, what in ((["-fsanitize=fuzzer"], "libFuzzer's runtime"), (["-fsanitize=fuzzer," + _SANITIZE], "the sanitizers' runtime")):
        trouble = _links(clang, flags)
        if trouble:
            raise CannotRun(f"{clang} cannot link a fuzz target, {what} may be missing; "
                            f"on Debian: apt install libclang-rt-{major}-dev\n{trouble}")
    afl = {"compiler": _tool(["afl-clang-fast++"]), "fuzz": _tool(["afl-fuzz"])}
    if engine == "afl" and not all(afl.values()):
        raise CannotRun("AFL++ was not found; on Debian: apt install afl++")
    return {
        "clang": clang, "cmake": cmake, "ninja": shutil.which("ninja"),
        "afl": afl if all(afl.values()) and engine != "libfuzzer" else None,
        "symbolizer": _tool(["llvm-symbolizer", f"llvm-symbolizer-{major}"]),
        "profdata": _tool([f"llvm-profdata-{major}", "llvm-profdata"]),
        "cov": _tool([f"llvm-cov-{major}", "llvm-cov"]),
    }


def description(tools):
    """Compiler and flags: with others the same sources count other edges."""
    version = subprocess.run([tools["clang"], "--version"], capture_output=True, text=True).stdout.partition("\n")[0]
    return " ".join([version, *FLAGS.values()])


def warnings(tools):
    """What will be poorer for want of a tool, one sentence each."""
    lines = []
    if not tools["symbolizer"]:
        lines.append("llvm-symbolizer was not found, stacks will have no names; on Debian: apt install llvm")
    if not tools["cov"] or not tools["profdata"]:
        lines.append("llvm-cov was not found, the report will have no line coverage; on Debian: apt install llvm")
    return lines


def targets(source, patterns=""):
    """Names of the targets in `source` that match the comma-separated patterns."""
    names = sorted(p.stem for p in (source / "fuzz" / "targets").glob("*.cpp"))
    if not names:
        raise CannotRun(f"{source / 'fuzz' / 'targets'} holds no targets")
    if not patterns:
        return names
    chosen = []
    for pattern in filter(None, (p.strip().removeprefix("fuzz_") for p in patterns.split(","))):
        hits = [n for n in names if fnmatch.fnmatchcase(n, pattern)]
        if not hits:
            raise CannotRun(f"no target matches '{pattern}'; there are: {' '.join(names)}")
        chosen += [h for h in hits if h not in chosen]
    return chosen


def build(tools, source, out, variant, names, jobs, log, extra=()):
    """Configures and builds one variant; the folder that holds it. `extra` are further CMake targets, built when they exist."""
    folder = out / "build" / variant
    folder.mkdir(parents=True, exist_ok=True)
    compiler = tools["afl"]["compiler"] if variant == "afl" else tools["clang"]
    configure = [tools["cmake"], "-S", str(source), "-B", str(folder), "-DTRAMA_BUILD_FUZZ=ON", "-DTRAMA_BUILD_TESTS=OFF",
                 "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={FLAGS[variant]}",
                 f"-DTRAMA_FUZZ_ENGINE={ENGINE[variant]}"]
    if tools["ninja"]:
        configure += ["-G", "Ninja"]
    environment = dict(os.environ, AFL_QUIET="1")
    for command in (configure, [tools["cmake"], "--build", str(folder), "-j", str(jobs), "--target", *[f"fuzz_{n}" for n in names], *extra]):
        with open(log, "ab") as f:
            f.write((" ".join(command) + "\n").encode())
            f.flush()
            # A session of its own: Ctrl-C then reaches only the campaign, which ends the build itself.
            p = subprocess.Popen(command, stdout=f, stderr=subprocess.STDOUT, env=environment, start_new_session=True)
            try:
                status = p.wait()
            except BaseException:
                os.killpg(p.pid, 15)
                raise
        if status != 0:
            tail = Path(log).read_text(errors="replace").splitlines()[-25:]
            raise CannotRun(f"building the {variant} variant failed; the end of {log}:\n" + "\n".join(tail))
    return folder


def executable(folder, name):
    """Where the build left an executable."""
    for path in (folder / "fuzz" / name, folder / name, folder / "src" / "tool" / name, folder / "src" / name):
        if path.is_file() and os.access(path, os.X_OK):
            return path
    found = [p for p in folder.rglob(name) if p.is_file() and os.access(p, os.X_OK)]
    if not found:
        raise CannotRun(f"{name} was built, but is nowhere under {folder}")
    return found[0]
