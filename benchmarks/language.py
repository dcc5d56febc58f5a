"""How fast a program is understood, against the bare parse of its text."""

from __future__ import annotations

import resource
import subprocess
import sys
from collections.abc import Iterator
from statistics import median

from plastron_tui import collector
from plastron_tui.language.grammar import new_parser
from plastron_tui.session import Session

from .programs import program
from .row import Row, paired, seconds


def understand(text: bytes) -> Session:
    session = Session(text, environ={})
    assert session.diagnostics == ()
    return session


def rows() -> Iterator[Row]:
    parser = new_parser()
    text = program(10_000)
    full, parse, ratio = paired(lambda: understand(text), lambda: parser.parse(text), 15)
    yield Row(
        "parse + lower + interpret / bare parse, 10,000 statements",
        ratio,
        5,
        detail=f"{full * 1e3:.0f} ms / {parse * 1e3:.0f} ms",
    )
    yield _growth()
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.language"], capture_output=True, text=True, check=True
    )
    yield Row("peak memory with 100,000 statements", float(done.stdout), 300, "MB")


def _growth() -> Row:
    """The time of a statement in a long program against a short one.

    The short one runs as often as makes the same number of statements, so that both take as long
    and the machine's drift falls on both.
    """
    short, long = program(1_000), program(100_000)

    def many() -> None:
        for _ in range(100):
            understand(short)

    understand(long)
    pairs = [(seconds(lambda: understand(long)), seconds(many)) for _ in range(5)]
    at_long, at_short = (median(times) for times in zip(*pairs, strict=True))
    return Row(
        "time of a statement, at 100,000 / at 1,000",
        median(a / b for a, b in pairs),
        1.3,
        detail=f"{at_long * 10:.1f} us / {at_short * 10:.1f} us",
    )


if __name__ == "__main__":
    collector.look_seldom()
    held = understand(program(100_000))
    print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
