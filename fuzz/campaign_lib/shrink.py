"""The smallest input that still fails."""
import time


def shrink(octets, still_fails, seconds, now=time.monotonic):
    """Delta debugging: the smallest input found in time for which `still_fails` holds, and whether there was time to try all. First
    pieces go, then octets become 0."""
    end = now() + seconds
    size = max(1, len(octets) // 2)
    while octets and now() < end:
        at, gone = 0, False
        while at < len(octets) and now() < end:
            shorter = octets[:at] + octets[at + size:]
            if still_fails(shorter):
                octets, gone = shorter, True
            else:
                at += size
        if size == 1 and not gone:
            break
        size = max(1, size // 2)
    for at in range(len(octets)):
        if now() >= end:
            break
        if octets[at] != 0:
            plainer = octets[:at] + b"\0" + octets[at + 1:]
            if still_fails(plainer):
                octets = plainer
    return octets, now() < end
