"""Shares the time out among the targets: slices of some seconds, the least served target first."""


def slice_seconds(left, jobs, count):
    """So long that starting up, when the whole corpus is read, does not matter; so short that every target gets its turns."""
    return max(5.0, min(120.0, left * jobs / max(1, count) / 8))


def _order(with_afl):
    return ("fast", "checked", "afl") if with_afl else ("fast", "checked")


def turns(with_afl):
    """After so many slices the variants begin anew."""
    return len(_order(with_afl))


def variant_of(turn, with_afl):
    """fast and checked take turns; AFL++ joins every third one where it is installed."""
    return _order(with_afl)[turn % turns(with_afl)]


def next_target(names, seconds, running):
    """The target with the least time so far, those not running now first. `running` counts processes per name."""
    return min(names, key=lambda n: (running.get(n, 0), seconds[n], names.index(n)))


def to_come(seconds, left, jobs):
    """Core seconds each target may still expect, from what each has had: the least served are filled up first."""
    budget = max(0.0, left) * jobs
    served = sorted(seconds.values())
    level = 0.0
    for count in range(1, len(served) + 1):
        level = (budget + sum(served[:count])) / count
        if count == len(served) or level <= served[count]:
            break
    return {name: max(0.0, level - had) for name, had in seconds.items()}
