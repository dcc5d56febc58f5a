"""What nodes print, as records: repeated lines are one with a count, each node has its colour."""

from __future__ import annotations

import re
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.runtime.labels import OWN_NAME, SIGN, split_label

from .styles import Line, Piece

MOST_RECORDS = 5000
MOST_TEXT = 1_000_000
"""So many characters are kept of all records: what is broken anew at once for another width."""
TIMES = "  ×"
"""What stands behind a line, before how often it was printed."""
_NEAR = 8
"""So many records above the last one a repeated line is still counted, and not shown again."""
_MOST_CHARACTERS = 4000
"""The most characters of a line that are shown."""
_NUMBER = r"(?:-?\d[\d.e+-]*|-?inf|nan)"
_NUMBERS = re.compile(rf"\[((?:{_NUMBER}, ){{4}})((?:{_NUMBER}, ){{8,}}){_NUMBER}(\]|$)")
"""A list of many numbers, as the ranges of a scan: the first ones tell enough of it."""
_NODE_TONES = ("primary", "accent", "success", "secondary")
"""Yellow and red are for what is wrong."""
_LEVEL = re.compile(r"\[(DEBUG|INFO|WARN|WARNING|ERROR|FATAL)\]", re.IGNORECASE)
_LEVEL_TONES = {"WARN": "warning", "WARNING": "warning", "ERROR": "error", "FATAL": "error"}


@dataclass(frozen=True, slots=True)
class Record:
    """A line that was printed.

    Attributes:
        label: the node's name with the sign behind it, "" for what no node printed.
        text: what it printed, with nothing in it that a terminal obeys.
        tone: the colour of the text.
        times: how often it was printed.
        at: when it came, the last time, in seconds since the epoch.
    """

    label: str
    text: str
    tone: str = ""
    times: int = 1
    at: float = field(default_factory=time.time, compare=False)

    @property
    def node(self) -> str:
        """The name of the node."""
        return self.label.removesuffix(SIGN).rstrip()

    def matches(self, words: Sequence[str]) -> bool:
        """Tell whether all words are in it, whatever their case; they are lower case."""
        if not words:
            return True
        whole = f"{self.label}{self.text}".lower()
        return all(word in whole for word in words)


class Change(NamedTuple):
    """How the records have changed.

    Attributes:
        dropped: how many of the first ones are gone.
        start: from which one on, as they were counted before, they are other ones.
    """

    dropped: int
    start: int


class OutputLog:
    """The last records, and the colour of each node.

    Attributes:
        records: the records, the oldest first.
    """

    def __init__(self) -> None:
        self.records: list[Record] = []
        self._tones: dict[str, str] = {}
        self._length = 0

    def clear(self) -> None:
        """Forget all records; nodes keep their colours."""
        self.records.clear()
        self._length = 0

    def add(self, printed: Iterable[Record]) -> Change:
        """Take records; count those that were there just before."""
        records = self.records
        before = start = len(records)
        for record in printed:
            at = _repeated(records, record)
            if at is None:
                records.append(record)
                self._length += len(record.text)
            else:
                times = records[at].times + record.times
                records[at] = replace(records[at], times=times, at=record.at)
                start = min(start, at)
        excess = max(0, len(records) - MOST_RECORDS)
        self._length -= sum(len(record.text) for record in records[:excess])
        while self._length > MOST_TEXT:
            self._length -= len(records[excess].text)
            excess += 1
        del records[:excess]
        dropped = min(excess, before)
        return Change(dropped, max(start, dropped))

    def line(self, record: Record, *, with_time: bool = False) -> Line:
        """Return a record as it is shown."""
        pieces = [Piece(record.text, record.tone)]
        if record.label:
            pieces.insert(0, Piece(record.label, self._tone(record.node)))
        if record.times > 1:
            pieces.append(Piece(f"{TIMES}{record.times:,}", "quiet"))
        if with_time:
            pieces.insert(0, Piece(f"{clock_time(record.at)} ", "quiet"))
        return tuple(pieces)

    def _tone(self, node: str) -> str:
        if node == OWN_NAME:
            return "quiet"
        return self._tones.setdefault(node, _NODE_TONES[len(self._tones) % len(_NODE_TONES)])


def clock_time(at: float) -> str:
    """Return a time of the day to a tenth of a second: lines are gathered for half of that."""
    return f"{time.strftime('%H:%M:%S', time.localtime(at))}.{int(at * 10) % 10}"


def _repeated(records: list[Record], record: Record) -> int | None:
    """Return which record of late is the same: the last one of its node, if it is near."""
    for at in range(len(records) - 1, max(-1, len(records) - 1 - _NEAR), -1):
        if records[at].label == record.label:
            is_same = records[at].text == record.text and records[at].tone == record.tone
            return at if is_same and record.text.strip() else None
    return None


def printed_record(text: str) -> Record:
    """Return the record of a line that was printed."""
    label, rest = split_label(visible(text.expandtabs(4)))
    if "[" in rest:
        rest = _NUMBERS.sub(_few_numbers, rest)
    if len(rest) > _MOST_CHARACTERS:
        rest = f"{rest[:_MOST_CHARACTERS]} … and {len(rest) - _MOST_CHARACTERS:,} characters more"
    return Record(label, rest, _tone_of(rest))


def _few_numbers(found: re.Match[str]) -> str:
    first, more, end = found.groups()
    return f"[{first}… {more.count(',') + 1} more{end}"


def _tone_of(text: str) -> str:
    level = _LEVEL.search(text[:80])
    if level is not None:
        return _LEVEL_TONES.get(level[1].upper(), "")
    lower = text.lower()
    if "error" in lower or "traceback" in lower or " was ended by " in lower or " died " in lower:
        return "error"
    return "warning" if "warn" in lower else ""
