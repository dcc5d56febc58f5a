"""Lines of a process, read in a thread, for somebody who takes them from time to time."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from functools import partial
from typing import IO


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
