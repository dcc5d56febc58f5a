"""What a monitor knows of a topic that is looked at, whichever ROS it is of."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from arrivals import Arrivals
from message_summary import fields_of, summary_of

# Making one message readable may take this share of the time until the next one is.
_SHARE = 0.05


class WatchedTopic:
    """Counts the messages of a topic, and keeps the last one undecoded until it is asked for."""

    def __init__(self, type_name: str, decode: Callable[[Any], Any]) -> None:
        """Start with no message.

        Args:
            type_name: the type, such as `std_msgs/String`.
            decode: makes a message of what `see` was given.
        """
        self.type_name = type_name
        self.arrivals = Arrivals()
        self.is_full = False
        self._decode = decode
        self._last: Any = None
        self._told = (-1, -1.0, False)
        self._next_decoding = 0.0
        self._content: dict[str, Any] = {}

    def see(self, raw: Any, at: float | None = None) -> None:
        """Note a message, and when it came, by the clock that never goes back."""
        self._last = raw
        self.arrivals.note(at)

    def report(self) -> dict[str, Any] | None:
        """Return what is new since this was asked last, None where nothing is."""
        now = time.monotonic()
        count, rate = self.arrivals.count, round(self.arrivals.rate(now), 1)
        told = (count, rate, self.is_full)
        if told == self._told:
            return None
        is_new = count != self._told[0] or self.is_full != self._told[2]
        if is_new and self._last is not None:
            if now < self._next_decoding:
                # Too much work for now: what was made last stays, and this is looked at later.
                told = (-1, rate, self.is_full)
            else:
                self._content = self._readable()
                taken = time.monotonic() - now
                self._next_decoding = now + taken / _SHARE
        self._told = told
        return {"count": count, "rate": rate, **self._content}

    def _readable(self) -> dict[str, Any]:
        try:
            message = self._decode(self._last)
            summary = summary_of(message, self.type_name)
            found: dict[str, Any] = {"text": summary.text, "number": summary.number}
            if self.is_full:
                found["fields"] = fields_of(message)
            return found
        except Exception as error:  # whatever a foreign message makes of its bytes
            return {"text": f"cannot be read: {error}", "number": None}
