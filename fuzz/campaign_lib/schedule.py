"""Shares the time out among the targets: slices of some seconds, the least served target first."""


def slice_seconds(left, jobs, count):
    """So long that starting up does not matter, so short that every target gets its turns."""
    return max(5.0, min(60.0, left * jobs / max(1, count) / 4))


def variant_of(turn, with_afl):
    """fast and checked take turns; AFL++ joins every third one where it is installed."""
    order = ("fast", "checked", "afl") if with_afl else ("fast", "checked")
    return order[turn % len(order)]


def next_target(names, seconds, running):
    """The target with the least time so far, those not running now first. `running` counts processes per name."""
    return min(names, key=lambda n: (running.get(n, 0), seconds[n], names.index(n)))
