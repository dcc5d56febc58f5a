"""When messages of a topic came: how many there were, and how many a second."""

from __future__ import annotations

import time
from collections import deque

_WINDOW = 200
_LEAST_SPAN = 2.0
"""Seconds of which the rate is told, where there were messages enough."""
_SILENT = 1.5
"""Seconds without a message after which a topic is silent; one that is slow has three periods."""


class Arrivals:
    """Counts messages.

    Attributes:
        count: how many have come.
    """

    def __init__(self) -> None:
        self.count = 0
        self._times: deque[float] = deque(maxlen=_WINDOW)

    def note(self, at: float | None = None) -> None:
        """Note a message, and when it came, by the clock that never goes back."""
        self._times.append(time.monotonic() if at is None else at)
        self.count += 1

    def rate(self, now: float) -> float:
        """Messages a second lately, 0 where the topic went silent."""
        times = list(self._times)
        if len(times) < 2:
            return 0.0
        last = times[-1]
        recent = [each for each in times if last - each <= _LEAST_SPAN]
        if len(recent) < 3:
            recent = times[-3:]
        period = (last - recent[0]) / (len(recent) - 1)
        if period <= 0 or now - last > max(3 * period, _SILENT):
            return 0.0
        return 1 / period
