"""Corpora: which target shares whose, merging and minimising, and the lines that they cover."""
import json
import os
import shutil
import subprocess
from pathlib import Path


def group(source, name):
    """Targets of one group read the same kind of input, so they feed each other: daisy_stream and daisy_decode do, daisy_text does not."""
    return name if (source / "fuzz" / "corpus" / name).is_dir() else name.split("_")[0]


def seed_folders(source, name):
    folders = [source / "fuzz" / "corpus" / group(source, name), source / "fuzz" / "regressions" / name]
    return [f for f in folders if f.is_dir() and any(f.iterdir())]


def dictionary(source, name):
    for stem in (name, name.split("_")[0]):
        path = source / "fuzz" / "dict" / f"{stem}.dict"
        if path.is_file():
            return path
    return None


def newer_than(folders, when):
    """Inputs that appeared after `when` (seconds since the epoch)."""
    fresh = []
    for folder in folders:
        try:
            with os.scandir(folder) as entries:
                fresh += [e.path for e in entries if e.is_file() and e.stat().st_mtime > when]
        except FileNotFoundError:
            pass
    return sorted(fresh)


def count(folder):
    try:
        with os.scandir(folder) as entries:
            return sum(e.is_file() for e in entries)
    except FileNotFoundError:
        return 0


def _beside(corpus):
    return corpus.with_name(corpus.name + ".small"), corpus.with_name(corpus.name + ".old")


def minimise(program, corpus, others, environment, log, timeout, watch):
    """Puts the smallest set with the same coverage, taken from `corpus` and `others`, beside it for `swap`. False when it could not."""
    small, _ = _beside(corpus)
    shutil.rmtree(small, ignore_errors=True)
    small.mkdir(parents=True)
    command = [str(program), "-merge=1", f"-max_total_time={max(1, int(timeout))}", "-timeout=10", "-rss_limit_mb=2048", "-max_len=4096",
               f"-artifact_prefix={small.parent}/merge-{corpus.name}-", str(small), str(corpus), *map(str, others)]
    with open(log, "ab") as f:
        p = subprocess.Popen(command, stdout=f, stderr=subprocess.STDOUT, env=environment, start_new_session=True)
        status = watch(p, timeout + 30)
    for leftover in small.parent.glob(f"merge-{corpus.name}-*"):  # inputs that fail; the slices have reported them
        leftover.unlink()
    if status == 0 and any(small.iterdir()):
        return True
    shutil.rmtree(small, ignore_errors=True)
    return False


def swap(corpus):
    """Makes what `minimise` left the corpus. Whatever interrupts the two renames, one whole corpus is there, and `repair` finds it."""
    small, old = _beside(corpus)
    if small.is_dir():
        shutil.rmtree(old, ignore_errors=True)
        os.rename(corpus, old)
        os.rename(small, corpus)
        shutil.rmtree(old)


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
