"""What the switch interval of the analysis worker is worth, against Python's own.

Both studios run in terminals of their own, in turn: only there a key passes all of its threads.
The worker is busy, since the program has 10,000 statements and each key changes what it means.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter

from plastron_tui.studio import analysis_worker

from .programs import program
from .row import Row
from .terminal import Terminal

_RUNS = 5
_KEYS_A_SECOND = 15
# Cyrillic, then Greek: no letter comes twice, or is on the screen before.
_TYPED = [*map(chr, (*range(0x410, 0x450), *range(0x3B1, 0x3C9)))]
_OURS, _PYTHONS = "ours", "pythons"


def rows() -> Iterator[Row]:
    pairs = [(_in_new_folder(_OURS), _in_new_folder(_PYTHONS)) for _ in range(_RUNS)]
    ours, pythons = (median(times) * 1e3 for times in zip(*pairs, strict=True))
    yield Row(
        "a key in a terminal, with the worker's switch interval / without",
        median(a / b for a, b in pairs),
        0.95,
        detail=f"{ours:.0f} ms / {pythons:.0f} ms",
    )


def _in_new_folder(policy: str) -> float:
    # In the same one the second studio would ask what to do with what the first had open.
    with TemporaryDirectory() as folder:
        file = Path(folder) / "program.plastron"
        file.write_bytes(program(10_000))
        return _key(policy, file)


def _key(policy: str, file: Path) -> float:
    """Return how many seconds it takes until a key is shown, in the middle of many."""
    command = [sys.executable, "-m", "benchmarks.threads", policy, str(file)]
    terminal = Terminal(command, file.parent)
    try:
        terminal.wait_for(b"create_message")
        terminal.rest(4)
        times = []
        for letter in _TYPED:
            start = perf_counter()
            terminal.type(letter.encode())
            terminal.wait_for(letter.encode())
            times.append(perf_counter() - start)
            terminal.rest(1 / _KEYS_A_SECOND - times[-1])
    finally:
        terminal.close()
    return median(times)


if __name__ == "__main__":
    if sys.argv[1] == _PYTHONS:
        analysis_worker._SWITCH_INTERVAL = sys.getswitchinterval()
    sys.argv[1:] = sys.argv[2:]
    import_module("plastron_tui.cli").main()
