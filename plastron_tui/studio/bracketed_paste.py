"""Bracketed pastes, as xterm calls them: what stands between two marks is text, and no keys.

Whoever wrote a text that is pasted may have put sequences of keys into it. Textual's parser looks
for them between the marks as well, so nothing between the marks gets there.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from .key_bursts import Kind, Part

_START, STOP = "\x1b[200~", "\x1b[201~"
ESCAPE = "\x1b"
_MOST = 16 * 1024 * 1024
"""Characters of a paste that wait for its end; more than a program may have are handed on."""
_SILENCE = 1.0
"""Seconds after which what has come is handed on: the end of it may never come."""
_LOST = 2.0
"""Seconds after which a key that comes alone is one: the end was lost, and somebody wants on."""
_LONE_KEY = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|O.|[^\x1b\[O])|[\x01-\x08\x0e-\x1a\x1c-\x1f]")
"""The sequence of a key or of the mouse, or a control character; tabs and ends of lines are text,
and an Escape may be the beginning of the end."""


class PasteBrackets:
    """Takes pastes out of what a terminal sends, wherever it is torn apart between two readings.

    The end of a paste has all the time in the world; a connection that was lost in the middle of
    it leaves the keyboard alive nevertheless.
    """

    def __init__(self, escape_delay: float) -> None:
        """Begin outside of a paste.

        Args:
            escape_delay: seconds after which an Escape is the key, and begins no mark.
        """
        self._escape_delay = escape_delay
        self._is_inside = False
        self._gathered: list[str] = []
        self._length = 0
        self._torn = ""
        self._let_go = ""
        self._time = float("-inf")

    def parts(self, data: str, now: float) -> Iterator[Part]:
        """Yield what was read at a time, in seconds: pastes, and what is no paste as keys."""
        silence, self._time = now - self._time, now
        if self._is_inside and silence >= _LOST and _begins_anew(data):
            yield from self._handed_on(self._torn)
            self._is_inside, self._torn = False, ""
        if self._let_go and (self._let_go + data).startswith(_START):
            # The beginning of the mark was taken for a key meanwhile; the text is not.
            data = self._let_go + data
        elif self._is_late(silence) and not _START.startswith((self._torn + data)[: len(_START)]):
            yield self._let_go_of_torn()
        data = self._torn + data
        self._torn = self._let_go = ""
        while data:
            mark = STOP if self._is_inside else _START
            before, found, data = data.partition(mark)
            if not found:
                before, self._torn = _without_torn(before, mark)
            if self._is_inside:
                self._gather(before)
                if found or self._length >= _MOST:
                    yield from self._handed_on()
            elif before:
                yield Part(before)
            if found:
                self._is_inside = not self._is_inside

    def waited(self, now: float) -> Iterator[Part]:
        """Yield what need not wait for more any longer, when nothing has come until now."""
        silence = now - self._time
        if self._is_inside:
            if silence >= _SILENCE:
                yield from self._handed_on()
        elif self._is_late(silence):
            yield self._let_go_of_torn()

    def _is_late(self, silence: float) -> bool:
        """Tell whether what may begin the mark of a paste has waited for the rest of it."""
        longest = self._escape_delay if self._torn == ESCAPE else _SILENCE
        return not self._is_inside and bool(self._torn) and silence >= longest

    def _let_go_of_torn(self) -> Part:
        self._let_go, self._torn = self._torn, ""
        return Part(self._let_go)

    def _gather(self, text: str) -> None:
        # Programs take a NUL for an end.
        text = text.replace("\0", "")
        if text:
            self._gathered.append(text)
            self._length += len(text)

    def _handed_on(self, more: str = "") -> Iterator[Part]:
        """Yield what has been gathered, with more behind it, unless it is nothing."""
        text = "".join(self._gathered) + more
        self._gathered, self._length = [], 0
        if text:
            yield Part(text, Kind.PASTE)


def _begins_anew(data: str) -> bool:
    """Tell whether what was read after a long silence is no more of the paste before it."""
    return data.startswith(_START) or (data != STOP and _LONE_KEY.fullmatch(data) is not None)


def _without_torn(data: str, mark: str) -> tuple[str, str]:
    """Split off the end of what was read where a mark may begin with it."""
    for length in range(min(len(mark) - 1, len(data)), 0, -1):
        if mark.startswith(data[-length:]):
            return data[:-length], data[-length:]
    return data, ""
