"""Which code is fuzzed: figures of different code must not be added up."""
import hashlib
import subprocess

PLACES = ("CMakeLists.txt", "include", "src", "fuzz", "tests/reference")
_DATA = ("fuzz/corpus", "fuzz/regressions", "fuzz/dict")  # what the targets are fed is not what they are
_KINDS = (".hpp", ".cpp", ".h", ".inc", ".txt", ".cmake", ".json")


def _sources(source):
    for place in PLACES:
        root = source / place
        for path in sorted(root.rglob("*")) if root.is_dir() else [root]:
            if path.is_file() and path.suffix in _KINDS and not path.relative_to(source).as_posix().startswith(_DATA):
                yield path


def digest(source, build=""):
    """Of everything the targets are compiled from; `build` says how, as compiler and flags."""
    h = hashlib.sha1(build.encode())
    for path in _sources(source):
        octets = path.read_bytes()
        h.update(f"\n{path.relative_to(source).as_posix()} {len(octets)}\n".encode() + octets)
    return h.hexdigest()[:16]


def _git(source, *words):
    try:
        r = subprocess.run(["git", *words], capture_output=True, text=True, cwd=source)
    except OSError:
        return ""
    return r.stdout if r.returncode == 0 else ""


def commit(source):
    """The commit, with + when what is fuzzed differs from it; empty outside git."""
    head = _git(source, "rev-parse", "--short=12", "HEAD").strip()
    aside = [f":!{place}" for place in (*_DATA, "fuzz/campaign_lib", "fuzz/campaign")]
    there = [place for place in PLACES if (source / place).exists()]
    return head + ("+" if head and _git(source, "status", "--porcelain", "--", *there, *aside).strip() else "")
