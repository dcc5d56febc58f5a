"""Asking services of ROS 1, which may never answer: of their types, and for what they do."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable

_AGAIN = 30.0
"""Seconds after which is asked again what was asked in vain."""


class ServiceTypes:
    """Asks for the types of services in a thread of its own.

    A node that hangs takes seconds for each of its services, and whoever waits for that hangs too.
    """

    def __init__(self, ask: Callable[[str], str]) -> None:
        """Start with no type; `ask` returns a service's by its name, however long that takes."""
        self._ask = ask
        self._known: dict[str, str] = {}
        self._next: dict[str, float] = {}
        self._wanted: queue.SimpleQueue[str] = queue.SimpleQueue()
        threading.Thread(target=self._work, daemon=True).start()

    def of(self, name: str) -> str:
        """Return the type of a service as far as it is known now, "" where it is not yet."""
        known = self._known.get(name)
        now = time.monotonic()
        if known is None and now > self._next.get(name, now - 1):
            self._next[name] = float("inf")
            self._wanted.put(name)
        return known or ""

    def _work(self) -> None:
        while True:
            name = self._wanted.get()
            try:
                known = self._ask(name)
            except Exception:  # whatever is at the other end of the service's address
                known = ""
            if known:
                self._known[name] = known
            self._next[name] = time.monotonic() + _AGAIN


def within(limit: float, work: Callable[[], str]) -> str | None:
    """Return what `work` returns, None where that takes more than so many seconds.

    It goes on in its thread then; nothing can end it.

    Raises:
        Exception: what `work` raised.
    """
    done: queue.SimpleQueue[str | Exception] = queue.SimpleQueue()

    def run() -> None:
        try:
            done.put(work())
        except Exception as error:  # told by who waits
            done.put(error)

    threading.Thread(target=run, daemon=True).start()
    try:
        found = done.get(timeout=limit)
    except queue.Empty:
        return None
    if isinstance(found, Exception):
        raise found
    return found
