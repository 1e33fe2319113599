"""Corpora: which target shares whose, merging and minimising, and the lines that they cover."""
import hashlib
import json
import os
import shutil
import subprocess
from pathlib import Path

from .libfuzzer import MAX_LENGTH, merge_command


def group(source, name):
    """Targets of one group read the same kind of input, so they feed each other: daisy_stream and daisy_roundtrip do, daisy_decode and daisy_text do not."""
    return name if (source / "fuzz" / "corpus" / name).is_dir() else name.split("_")[0]


def seed_folders(source, name):
    """Seeds, and what targets of the group once failed on."""
    mine, regressions = group(source, name), source / "fuzz" / "regressions"
    kin = sorted(f for f in regressions.iterdir() if group(source, f.name) == mine) if regressions.is_dir() else []
    return [f for f in (source / "fuzz" / "corpus" / mine, *kin) if f.is_dir() and any(f.iterdir())]


def dictionary(source, name):
    for stem in (name, group(source, name)):
        path = source / "fuzz" / "dict" / f"{stem}.dict"
        if path.is_file():
            return path
    return None


def newer_than(folders, when):
    """Inputs that appeared after `when` (seconds since the epoch)."""
    fresh = []
    for folder in folders:
        for path in Path(folder).iterdir() if Path(folder).is_dir() else ():
            try:
                if path.is_file() and path.stat().st_mtime > when:
                    fresh.append(str(path))
            except FileNotFoundError:  # a corpus lives: libFuzzer replaces inputs by smaller ones
                pass
    return sorted(fresh)


def gather(paths, folder, own, known):
    """Copies inputs into an otherwise empty folder, but for those that the corpus `own` holds by that name, and those whose digests are `known` to
    fail. False when none are left."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for path in map(Path, paths):
        try:
            octets = path.read_bytes()
        except FileNotFoundError:  # a corpus lives
            continue
        if not (own / path.name).exists() and hashlib.sha1(octets).hexdigest() not in known:
            (folder / path.name).write_bytes(octets)
    return any(folder.iterdir())


def leave_out(corpus, artifact):
    """Removes the input from the corpus that libFuzzer wrote as this artifact. False when the corpus does not hold it."""
    digest = Path(artifact).name.rpartition("-")[2]
    if (corpus / digest).is_file():
        held = [corpus / digest]
    else:  # a longer input, of which the fuzzer read the beginning, or one with a name of its own
        held = [p for p in corpus.iterdir() if p.is_file() and hashlib.sha1(p.read_bytes()[:MAX_LENGTH]).hexdigest() == digest]
    for path in held:
        path.unlink(missing_ok=True)
    return bool(held)


def count(folder):
    try:
        with os.scandir(folder) as entries:
            return sum(e.is_file() for e in entries)
    except FileNotFoundError:
        return 0


def _beside(corpus):
    return corpus.with_name(corpus.name + ".small"), corpus.with_name(corpus.name + ".old")


def minimise(program, corpus, others, artifacts, environment, log, timeout, watch):
    """Puts the smallest set with the same coverage, taken from `corpus` and `others`, beside it for `swap`. False when it could not. Inputs that
    fail are left out, and written to `artifacts`, the beginning of a path."""
    small, _ = _beside(corpus)
    shutil.rmtree(small, ignore_errors=True)
    small.mkdir(parents=True)
    command = merge_command(program, small, [corpus, *others], artifacts, timeout)
    with open(log, "ab") as f:
        p = subprocess.Popen(command, stdout=f, stderr=subprocess.STDOUT, env=environment, start_new_session=True)
        status = watch(p, timeout + 30)
    if status == 0 and any(small.iterdir()):
        return True
    shutil.rmtree(small, ignore_errors=True)
    return False


def swap(corpus, known=()):
    """Makes what `minimise` left the corpus, without the inputs whose digests are `known` to fail. Whatever interrupts the two renames, one whole
    corpus is there, and `repair` finds it."""
    small, old = _beside(corpus)
    if small.is_dir():
        shutil.rmtree(old, ignore_errors=True)
        os.rename(corpus, old)
        os.rename(small, corpus)
        shutil.rmtree(old)
    for digest in known:
        (corpus / digest).unlink(missing_ok=True)


def repair(corpus):
    """Undoes what an interrupted `minimise` may have left."""
    small, old = _beside(corpus)
    if not corpus.is_dir() and old.is_dir():
        os.rename(old, corpus)
    shutil.rmtree(small, ignore_errors=True)
    shutil.rmtree(old, ignore_errors=True)
    corpus.mkdir(parents=True, exist_ok=True)


def line_coverage(tools, program, folders, source, work, watch):
    """Lines, branches and functions of include/ and src/ that these inputs reach, as {"lines": {"count", "covered", "percent"}, …}."""
    work.mkdir(parents=True, exist_ok=True)
    raw, data = work / f"{program.name}.profraw", work / f"{program.name}.profdata"
    raw.unlink(missing_ok=True)
    p = subprocess.Popen([str(program), "-runs=0", *map(str, folders)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                         env=dict(os.environ, LLVM_PROFILE_FILE=str(raw)), start_new_session=True)
    if watch(p, 300) != 0 or not raw.is_file():
        return None
    subprocess.run([tools["profdata"], "merge", "-sparse", "-o", str(data), str(raw)], check=True, capture_output=True)
    sources = [str(p) for p in (source / "include", source / "src") if p.is_dir()]
    r = subprocess.run([tools["cov"], "export", "-summary-only", f"-instr-profile={data}", str(program), *sources], capture_output=True, text=True)
    raw.unlink()
    if r.returncode != 0:
        return None
    totals = json.loads(r.stdout)["data"][0]["totals"]
    return {k: {f: totals[k][f] for f in ("count", "covered", "percent")} for k in ("lines", "branches", "functions")}
