"""Lines of a process, read in a thread, for somebody who takes them from time to time."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterator
from functools import partial
from typing import IO

_COST = 20
"""So many bytes more a line costs as much as to show it at all."""


class News:
    """Tells, from threads that read, that there is something to take: once, until it is taken."""

    def __init__(self, on_news: Callable[[], None]) -> None:
        """Prepare to call a function, in the thread that has read something."""
        self._on_news = on_news
        self._is_told = threading.Event()

    def tell(self) -> None:
        """Say that there is something to take."""
        if not self._is_told.is_set():
            self._is_told.set()
            self._on_news()

    def tell_anew(self) -> None:
        """Say it also where that was said: somebody may have taken all but this."""
        self._is_told.clear()
        self.tell()

    def taking(self) -> None:
        """Note that what is there now is taken next."""
        self._is_told.clear()


class Backlog:
    """Lines that wait until somebody has the time for them; too many are left out, and counted.

    One thread adds to it, and another one takes. Who takes gets no more at once than is shown in
    some milliseconds, and what is shown is never far behind.
    """

    def __init__(
        self, *, most_lines: int, most_bytes: int, at_once: int, is_kept: Callable[[bytes], bool]
    ) -> None:
        """Begin with nothing.

        Args:
            most_lines: how many lines wait at most.
            most_bytes: how long they are at most, all of them together.
            at_once: how long the lines are, about, that are taken at once.
            is_kept: tells which lines are left out last, one by one and in their order.
        """
        self._most_lines = most_lines
        self._most_bytes = most_bytes
        self._at_once = at_once
        self._is_kept = is_kept
        self._lock = threading.Lock()
        self._lines: deque[bytes] = deque()
        self._kept: deque[bytes] = deque()
        self._length = 0
        self._left_out = 0

    def add(self, line: bytes) -> None:
        """Have a line wait, at the end."""
        with self._lock:
            self._lines.append(line)
            self._length += len(line)
            self._shorten(self._most_lines, self._most_bytes)

    def skip(self) -> None:
        """Leave out all that is not taken at once: somebody wants to see the end."""
        with self._lock:
            self._shorten(self._most_lines, self._at_once)

    def take(self) -> list[bytes]:
        """Return the first lines; where some were left out before them, one that says so."""
        with self._lock:
            found = [*self._kept]
            if self._left_out:
                words = "line" if self._left_out == 1 else "lines"
                found.insert(0, f"… {self._left_out:,} {words} left out".encode())
            self._kept.clear()
            self._left_out = 0
            length = 0
            while self._lines and length < self._at_once:
                line = self._lines.popleft()
                # A line costs something however short it is.
                length += len(line) + _COST
                self._length -= len(line)
                found.append(line)
            return found

    def __len__(self) -> int:
        """Return how many lines wait."""
        return len(self._lines)

    def _shorten(self, most_lines: int, most_bytes: int) -> None:
        while len(self._lines) > most_lines or self._length > most_bytes:
            line = self._lines.popleft()
            self._length -= len(line)
            if self._is_kept(line) and len(self._kept) < most_lines:
                self._kept.append(line)
            else:
                self._left_out += 1


def lines_of(stream: IO[bytes], longest: int) -> Iterator[bytes]:
    """Yield lines as they come, without their ends; of a longer one its first bytes.

    Args:
        stream: what a process writes, which may go on without ever ending a line.
        longest: the most bytes of a line.
    """
    is_rest = False
    for line in iter(partial(stream.readline, longest), b""):
        if not is_rest:
            yield line.rstrip(b"\r\n")
        is_rest = not line.endswith(b"\n")
