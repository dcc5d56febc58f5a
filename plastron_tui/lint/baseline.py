"""What was found before and is left as it is: only what is new is told.

A finding is known by its rule, its file, the text of its line and what is said, and not by the
number of the line, which changes with every edit above it.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from plastron_tui.diagnostics import LineIndex

from .engine import Found
from .selection import path_from

LARGEST = 64 * 1024 * 1024
_VERSION = 1

Lines = Callable[[Path], LineIndex | None]
Known = Counter[tuple[str, str, str, str]]


def baseline_text(found: Iterable[Found], root: Path, lines: Lines) -> str:
    """Return the text of a baseline that has all of what was found."""
    rows = sorted(Counter(_key(each, root, lines) for each in found).items())
    entries = [
        {"code": code, "file": file, "line": line, "message": message, "count": count}
        for (code, file, line, message), count in rows
    ]
    return json.dumps({"version": _VERSION, "findings": entries}, indent=1) + "\n"


def read_baseline(text: bytes) -> Known:
    """Return what a baseline has.

    Raises:
        ValueError: it is no baseline.
    """
    try:
        data = json.loads(text)
        if data["version"] != _VERSION:
            raise ValueError(f"it is of version {data['version']!r}, not {_VERSION}")
        return Counter(
            {
                (str(one["code"]), str(one["file"]), str(one["line"]), str(one["message"])): int(
                    one["count"]
                )
                for one in data["findings"]
            }
        )
    except (KeyError, TypeError, AttributeError, OverflowError, RecursionError) as error:
        raise ValueError("it is no baseline of `plastron lint`") from error


def only_new(found: Iterable[Found], known: Known, root: Path, lines: Lines) -> Iterator[Found]:
    """Yield what a baseline has not; of several of a kind as many as are more than it has."""
    left = Counter(known)
    for each in found:
        key = _key(each, root, lines)
        if left[key] > 0:
            left[key] -= 1
        else:
            yield each


def _key(found: Found, root: Path, lines: Lines) -> tuple[str, str, str, str]:
    diagnostic = found.diagnostic
    file, span = diagnostic.file, diagnostic.span
    index = None if file is None or span is None else lines(file)
    line = "" if index is None or span is None else index.line(index.position(span.start).line)
    path = "" if file is None else path_from(root, file)
    return str(found.rule.code), path, line.strip(), diagnostic.message
