"""The table of `plastron run --watch`: topics with their rates, and service calls.

It is plain ANSI, drawn below the nodes' output and over itself: a few escape sequences that
every terminal has need no library.
"""

from __future__ import annotations

import json
import shutil
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from plastron_tui.diagnostics.terminal import cut, visible, width

_LONGEST_NAME = 40
_REDRAW = 0.2
_LINES_PERIOD = 2.0
_FALLBACK_SIZE = (100, 24)


@dataclass(frozen=True, slots=True)
class TopicRow:
    """A topic: messages a second, how many were seen, and the last one as text."""

    name: str
    type: str
    rate: float
    count: int
    text: str


@dataclass(slots=True)
class ServiceRow:
    """A service: how often it was served and called, and the last call.

    A call between two nodes of one run is seen at both ends; it is one call all the same.
    """

    name: str
    served: int = 0
    called: int = 0
    failed: int = 0
    request: str = ""
    response: str = ""

    @property
    def calls(self) -> int:
        """The number of calls."""
        return max(self.served, self.called)

    @property
    def last(self) -> str:
        """The last call, as text."""
        return f"({self.request}) → ({self.response})"


@dataclass(slots=True)
class Watch:
    """What is known of the running graph, fed by the observer and by the traced nodes."""

    topics: dict[str, TopicRow] = field(default_factory=dict)
    services: dict[str, ServiceRow] = field(default_factory=dict)

    def feed_topics(self, line: str) -> bool:
        """Take a line of the observer; False for one that is none of its reports."""
        report = _object(line)
        if "topics" not in report:
            return False
        for row in report["topics"]:
            self.topics[row["name"]] = TopicRow(**row)
        return True

    def feed_call(self, line: str) -> str | None:
        """Take a report of a service call; return it as text where it is a new call."""
        report = _object(line)
        if "service" not in report:
            return None
        row = self.services.setdefault(report["service"], ServiceRow(report["service"]))
        before = row.calls
        if report["kind"] == "served":
            row.served += 1
        else:
            row.called += 1
        row.failed += row.calls > before and bool(report["is_failure"])
        row.request, row.response = report["request"], report["response"]
        return f"{row.name} {visible(row.last)}" if row.calls > before else None

    def lines(self) -> list[str]:
        """Return one line a topic, for an output that is no terminal."""
        return [
            f"{row.name} {row.type} {row.rate:.1f} Hz {visible(row.text)}".rstrip()
            for row in self.topics.values()
        ]

    def table(self, columns: int, rows: int) -> list[str]:
        """Return the table, cut to a terminal's size."""
        topics = [
            (row.name, row.type, f"{row.rate:.1f} Hz", row.text) for row in self.topics.values()
        ]
        services = [
            (row.name, str(row.calls), str(row.failed), row.last) for row in self.services.values()
        ]
        lines = [
            *_columns(("topic", "type", "rate", "last message"), topics),
            *(_columns(("service", "calls", "failed", "last call"), services) if services else []),
        ]
        if len(lines) > rows:
            lines = [*lines[: rows - 1], f"… {len(lines) - rows + 1} more lines"]
        return [cut(line, columns) for line in lines]


class Screen:
    """Keeps the table below what is written to a terminal."""

    def __init__(
        self,
        watch: Watch,
        size: Callable[[], tuple[int, int]] | None = None,
    ) -> None:
        self._watch = watch
        self._size = size or _terminal_size
        self._height = 0
        self._drawn_at = 0.0

    def erase(self) -> str:
        """Return what takes the table off; to be written before anything else is."""
        height, self._height = self._height, 0
        return f"\x1b[{height}A\r\x1b[J" if height else ""

    def frame(self, *, is_forced: bool = False) -> str:
        """Return what draws the table anew, nothing when it is there and fresh."""
        now = time.monotonic()
        if self._height and now - self._drawn_at < _REDRAW and not is_forced:
            return ""
        columns, rows = self._size()
        lines = self._watch.table(columns - 1, max(rows - 1, 2))
        text = self.erase() + "".join(line + "\n" for line in lines)
        self._height = len(lines)
        self._drawn_at = now
        return text


def _terminal_size() -> tuple[int, int]:
    columns, rows = shutil.get_terminal_size(_FALLBACK_SIZE)
    return columns, rows


class Ticker:
    """Tells, for an output that is no terminal, when the next lines are due."""

    def __init__(self) -> None:
        self._next = time.monotonic() + _LINES_PERIOD

    def is_due(self) -> bool:
        """Tell whether it is time, once every two seconds."""
        if time.monotonic() < self._next:
            return False
        self._next = time.monotonic() + _LINES_PERIOD
        return True


def _object(line: str) -> Mapping[str, Any]:
    try:
        report = json.loads(line)
    except ValueError:
        return {}
    return report if isinstance(report, dict) else {}


def _columns(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> list[str]:
    """Align all columns but the last, which takes what is left of the line."""
    cells = [head, *(tuple(visible(cell) for cell in row) for row in rows)]
    cells = [tuple(cut(cell, _LONGEST_NAME) for cell in row[:-1]) + row[-1:] for row in cells]
    widths = [max(width(row[index]) for row in cells) for index in range(len(head) - 1)]
    return [
        "  ".join(
            [
                *(
                    cell + " " * (columns - width(cell))
                    for cell, columns in zip(row[:-1], widths, strict=True)
                ),
                row[-1],
            ]
        ).rstrip()
        for row in cells
    ]
