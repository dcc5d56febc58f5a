"""What build tools print: how far they are, and what they say of a package's files."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span

Spans = Mapping[int, Span]
"""Where a program says what the lines of a file say, counted from 1; 0 stands for all of it."""

MOST_ERRORS = 20

_PERCENT = re.compile(r"\[ *(\d{1,3})%\] (.*)")
_STARTED = re.compile(r"Starting >>> (\S+)")
_PLACE = re.compile(r"(/[^:\n]{1,4096}):(\d{1,9}):(?:\d{1,9}:)? *(?:fatal )?(?:error: )?(.*)")


class Progress(NamedTuple):
    """How far a build is.

    Attributes:
        package: the package that is being built.
        step: what is being done.
        percent: how much of the package is done, None where that is not known.
    """

    package: str
    step: str
    percent: int | None = None


def progress_of(line: str, before: Progress) -> Progress:
    """Return how far a build is after a line of its output."""
    if started := _STARTED.match(line):
        return Progress(started[1], "configure")
    if done := _PERCENT.match(line):
        return before._replace(step="build", percent=min(int(done[1]), 100))
    if line.startswith(("-- Installing: ", "-- Install configuration: ")):
        return before._replace(step="install", percent=100)
    return before


def errors_of(
    lines: Iterable[str], source: Path, spans: Mapping[str, Mapping[str, Spans]], log: Path
) -> list[Diagnostic]:
    """Return what a build says of the files of packages.

    Args:
        lines: its output.
        source: the folder with a folder for each package.
        spans: for each package and file where the program says what it says.
        log: the file with the whole output.
    """
    return []
