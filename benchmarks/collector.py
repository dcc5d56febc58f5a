"""What the policy of plastron_tui/collector.py is worth, against Python's own.

Both run in processes of their own, in turn. What is compared is the time of a processor, and what
stops the studio is the collector's own time, so that a busy machine changes little.
"""

from __future__ import annotations

import asyncio
import gc
import resource
import subprocess
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import thread_time

from plastron_tui import collector

from .process import ENVIRON, EXAMPLES
from .programs import program
from .row import Row

_RUNS = 15
_LONG_RUNS = 3
_OURS, _PYTHONS = "ours", "pythons"


def rows() -> Iterator[Row]:
    yield _row("plastron check", "check", _RUNS, 0.95)
    yield _row("understanding 100,000 statements", "understand", _LONG_RUNS, 0.8)
    ours, pythons = (float(_run("type", policy)) for policy in (_OURS, _PYTHONS))
    yield Row(
        "longest stop by the collector while one types in 10,000 statements",
        ours,
        10,
        "ms",
        f"without the policy: {pythons:.0f} ms",
    )


def _row(what: str, work: str, runs: int, bound: float) -> Row:
    pairs = [(_seconds(work, _OURS), _seconds(work, _PYTHONS)) for _ in range(runs + 1)][1:]
    ours, pythons = (median(times) * 1e3 for times in zip(*pairs, strict=True))
    return Row(
        f"{what}, with the collector's policy / without",
        median(a / b for a, b in pairs),
        bound,
        detail=f"{ours:.0f} ms / {pythons:.0f} ms of a processor",
    )


def _seconds(work: str, policy: str) -> float:
    """Return the processor's time of a process that does a work."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    _run(work, policy)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def _run(work: str, policy: str) -> str:
    command = [sys.executable, "-m", "benchmarks.collector", work, policy]
    return subprocess.run(command, check=True, capture_output=True, env=ENVIRON, text=True).stdout


def _check() -> None:
    sys.argv[1:] = ["check", *map(str, EXAMPLES)]
    import_module("plastron_tui.cli").main()


def _understand() -> None:
    from .language import understand

    collector.look_seldom()
    understand(program(100_000))


def _type() -> None:
    """Print for how many milliseconds the collector stopped the studio at most."""
    from .studio import measure, prepare

    stops = [0.0]
    start = 0.0

    def note(phase: str, _: dict[str, int]) -> None:
        nonlocal start
        if phase == "start":
            start = thread_time()
        else:
            stops.append(thread_time() - start)

    collector.look_seldom()
    with TemporaryDirectory() as folder:
        asyncio.run(measure(prepare(Path(folder)), lambda: gc.callbacks.append(note)))
    print(max(stops) * 1e3)


def _forget_policy() -> None:
    for name in ("look_seldom", "collect_if_due", "leave"):
        setattr(collector, name, lambda: None)


if __name__ == "__main__":
    if sys.argv[2] == _PYTHONS:
        _forget_policy()
    {"check": _check, "understand": _understand, "type": _type}[sys.argv[1]]()
