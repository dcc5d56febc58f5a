"""How a monitor speaks with the studio: lines of JSON, orders on stdin and reports on stdout.

The studio holds the other end of stdin: when that ends, however it did, so does the monitor.
"""

from __future__ import annotations

import json
import os
import queue
import sys
import threading
import time
from collections.abc import Iterator
from typing import Any

_LEFT: dict[str, Any] = {"do": "leave"}
_LONGEST_END = 5.0
_LOCK = threading.Lock()


def send(**report: Any) -> None:
    """Tell the studio something; without a studio the monitor ends at once."""
    line = json.dumps(report, ensure_ascii=True) + "\n"
    try:
        with _LOCK:
            sys.stdout.write(line)
            sys.stdout.flush()
    except OSError:
        os._exit(0)


class Orders:
    """What the studio wants, read in a thread of its own."""

    def __init__(self) -> None:
        self._queue: queue.SimpleQueue[dict[str, Any]] = queue.SimpleQueue()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        for line in sys.stdin:
            try:
                order = json.loads(line)
            except ValueError:
                continue
            if isinstance(order, dict):
                self._queue.put(order)
        self._queue.put(_LEFT)
        # Whatever keeps the main thread busy: nobody is there any more who could end it.
        time.sleep(_LONGEST_END)
        os._exit(1)

    def take(self, wait: float) -> Iterator[dict[str, Any]]:
        """Yield the orders that came, waiting for the first one for so many seconds."""
        try:
            yield self._queue.get(timeout=wait)
            while True:
                yield self._queue.get_nowait()
        except queue.Empty:
            return


def answer(order: dict[str, Any], text: str, *, is_failure: bool = False) -> None:
    """Tell what came of an order."""
    send(tell="answer", id=order.get("id"), text=text, is_failure=is_failure)


def is_now(name: str, value: Any) -> str:
    """Say which value a parameter has been given."""
    shown = json.dumps(value, ensure_ascii=False) if isinstance(value, str) else str(value)
    return f"{name} is {shown} now"


def sent_words(name: str, listening: int, reached: int) -> str:
    """Say that a message was sent, and to how many of those who listen it cannot come."""
    if listening <= 0:
        return f"sent to {name}; nobody listens there"
    if reached >= listening:
        return f"sent to {name}"
    if listening == 1:
        return f"sent to {name}, but who listens there does not take it"
    missing = listening - max(0, reached)
    return f"sent to {name}, but {missing} of {listening} who listen there do not take it"
