"""When Python's cycle collector works, in the command line and in the studio.

Reference counts free nearly all that Plastron makes; the collector finds what refers to itself,
which Textual and tracebacks leave behind. Python's own rhythm lets it walk all that is alive again
and again: a sixth of the time of `plastron check`, a quarter of that of a program of 100,000
statements, and stops of nearly 200 ms while one types (`python -m benchmarks collector`).

Only a process of Plastron's own is tuned, by the entry points and by those that lint starts. What
uses Plastron as a library keeps the collector as it was.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

_ALLOCATIONS = 500_000
"""How many more objects there are when the collector works of its own accord; Python's own are 700.

A studio with 10,000 statements makes and frees half as many while one types. If all of them were
garbage, they would take some 50 MB.
"""

DUE = 20_000
"""From how many more objects on it is worth to look for garbage while nobody types."""


def look_seldom() -> None:
    """Let the collector work so seldom that nobody waits for it; for the start of a process."""
    gc.set_threshold(_ALLOCATIONS)


def collect_if_due() -> None:
    """Let the collector work now, when nobody waits, if there may be something to find.

    With a program of 10,000 statements in the studio that takes a tenth of a second.
    """
    if gc.get_count()[0] >= DUE:
        gc.collect()


def collect() -> None:
    """Let the collector work now."""
    gc.collect()


@contextmanager
def paused() -> Iterator[None]:
    """Make much data, none of which is garbage; the collector is left as it was."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


def spare() -> None:
    """Never walk what there is by now.

    At its exit the system takes it back anyway; for a process that begins as a copy of another one,
    what that has is no garbage, and a look at it would copy it.
    """
    gc.freeze()
