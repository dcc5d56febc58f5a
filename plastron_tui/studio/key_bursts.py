"""Text that comes as keys, many at once: what a terminal pastes that puts no brackets around it.

A terminal, tmux or a robot that types sends no more than characters, and each would be a key: 500
lines are 20,000 keys, with what follows from each. What a person types comes one by one. So what
is read at once from a terminal is looked at before it is taken apart into keys. What comes with
brackets is taken out before that.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum
from typing import NamedTuple

_TEXT = re.compile(r"[^\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f]+")
_STRING = re.compile(r"\x1b[\]PX^_]")
_SEQUENCE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|O.|[^\x1b\[O])?", re.DOTALL)
_TORN = re.compile(r"\x1b(?:\[[0-?]*[ -/]*|O)?\Z")
"""An answer of the terminal as a string, the sequence of a key or of the mouse, and one's start."""
_LONG = 64
"""Characters that nobody types between two readings of a terminal, however slow the line to it."""
_ENDS = re.compile(r"[\r\n]+")
_MOST_LINES = 5
"""With so many ends of lines a text was pasted; fewer may be answers that were typed ahead."""
_SOON = 0.1
"""Seconds within which what comes belongs to the burst before it, or to an end of a line."""
_LONGEST_SEQUENCE = 32
"""Characters that the sequence of one key has at most."""


class Kind(Enum):
    """What came."""

    KEYS = "keys"
    BURST = "burst"
    """A text, where the focus takes one; keys that somebody typed ahead, where it takes those."""
    PASTE = "paste"
    """More than anybody types ahead."""


class Part(NamedTuple):
    """A piece of what was read, and how it is to be taken."""

    text: str
    kind: Kind = Kind.KEYS


class Bursts:
    """Tells bursts of text from keys, in what a terminal sends.

    CR and LF together are one end of a line: a terminal sends CR for Enter, and LF for Ctrl-J.
    """

    def __init__(self) -> None:
        self._before = ""
        self._time = -1.0
        self._burst_time = -1.0
        self._burst = Kind.BURST

    def parts(self, data: str, now: float) -> list[Part]:
        """Return what was read at a time, in seconds, as keys and bursts in its order."""
        before, since = self._before, now - self._time
        self._before, self._time = (before + data)[-_LONGEST_SEQUENCE:], now
        recent = before if since < _SOON else ""
        if _TORN.search(recent) or _STRING.search(recent + data):
            return [Part(data)]
        if recent.endswith("\r"):
            data = data.removeprefix("\n")
        data = data.replace("\r\n", "\r")
        found, at = list[Part](), 0
        for sequence in _SEQUENCE.finditer(data):
            found += self._parts_of_text(data[at : sequence.start()], now)
            found.append(Part(sequence.group()))
            at = sequence.end()
        return _joined([*found, *self._parts_of_text(data[at:], now)])

    def _parts_of_text(self, data: str, now: float) -> Iterator[Part]:
        """Yield what is in a text without sequences."""
        at = 0
        for found in _TEXT.finditer(data):
            if found.start() > at:
                yield Part(data[at : found.start()])
            yield from self._told_apart(found.group(), now)
            at = found.end()
        if at < len(data):
            yield Part(data[at:])

    def _told_apart(self, text: str, now: float) -> list[Part]:
        is_going_on = now - self._burst_time < _SOON
        if is_going_on or len(text) >= _LONG:
            line = text.rstrip("\r\n")
            if not is_going_on and "\r" not in line and "\n" not in line:
                # Enter after a line is somebody's answer.
                end = text[len(line) :]
                return [Part(line, Kind.BURST), *([Part(end)] if end else [])]
            if not is_going_on:
                is_long = len(_ENDS.findall(text)) >= _MOST_LINES
                self._burst = Kind.PASTE if is_long else Kind.BURST
            self._burst_time = now
            return [Part(text, self._burst)]
        return [Part(text)]


def _joined(parts: list[Part]) -> list[Part]:
    """Return parts with keys that follow each other as one."""
    found: list[Part] = []
    for part in parts:
        if found and part.kind is found[-1].kind is Kind.KEYS:
            found[-1] = Part(found[-1].text + part.text)
        else:
            found.append(part)
    return found
