"""The command line."""
import argparse
import os
import re
from pathlib import Path

_TAKEN_APART = re.compile(r"[\s'\"\\$`!*?;&|<>(){}\[\]~#]")  # by a shell
_UNITS = {"": 1, "s": 1, "m": 60, "h": 3600, "d": 86400}


def duration(text):
    """Seconds in "90", "90s", "10m", "2h", "1h30m"."""
    parts = re.findall(r"(\d+(?:\.\d+)?)([smhd]?)", text)
    if not parts or "".join(number + unit for number, unit in parts) != text:
        raise argparse.ArgumentTypeError(f"'{text}' is no duration; write 90s, 10m, 2h or 1h30m")
    seconds = sum(float(number) * _UNITS[unit] for number, unit in parts)
    if seconds <= 0:
        raise argparse.ArgumentTypeError("the time must be more than 0")
    return seconds


def positive(text):
    value = int(text) if text.isdigit() else 0
    if value < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number of 1 or more")
    return value


def parse(arguments=None):
    root = Path(__file__).resolve().parent.parent.parent
    p = argparse.ArgumentParser(
        prog="fuzz/campaign",
        description="Builds the fuzz targets, runs them on all cores for a while, minimises what they find and writes a report. "
                    "Ctrl-C ends it early with everything kept; the same command goes on where it stopped.")
    p.add_argument("--time", type=duration, default=600.0, metavar="TIME",
                   help="how long to fuzz, all targets together: 90s, 10m, 2h (default 10m); building and minimising come on top")
    p.add_argument("--targets", default="", metavar="NAMES",
                   help="which targets: names or patterns with commas, such as daisy_stream or 'gateway_*,*_text' (default all)")
    p.add_argument("--jobs", type=positive, default=os.cpu_count() or 1, metavar="N", help="processes at a time (default: one per core)")
    p.add_argument("--out", type=Path, default=None, metavar="DIR",
                   help="where builds, corpora, finds and the report go (default build/campaign); its presence is what resumes a campaign")
    p.add_argument("--engine", choices=["auto", "libfuzzer", "afl"], default="auto",
                   help="auto: libFuzzer, and AFL++ beside it where installed (default)")
    p.add_argument("--empty-corpus", action="store_true", help="start from nothing: no seeds, no dictionary")
    p.add_argument("--adopt", action="store_true", help="also copy the regression input of every find into fuzz/regressions/")
    p.add_argument("--list", action="store_true", help="print the targets and end")
    p.add_argument("--source", type=Path, default=root, metavar="DIR", help="the source tree (default: the one this program lies in)")
    o = p.parse_args(arguments)
    o.source = o.source.resolve()
    o.out = (o.out or o.source / "build" / "campaign").resolve()
    for path in (o.source, o.out):
        if _TAKEN_APART.search(str(path)):
            p.error(f"libFuzzer merges corpora by way of a shell, which would take the path '{path}' apart; work in a folder without spaces and the like")
    return o
