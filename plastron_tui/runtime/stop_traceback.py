"""Tracebacks of nodes that were told to stop: a node that does not catch that prints one.

It looks like a mistake of whoever wrote the node, and is none.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from enum import Enum

_BEGIN = "Traceback (most recent call last):"
_CHAINED = (
    "During handling of the above exception, another exception occurred:",
    "The above exception was the direct cause of the following exception:",
)
_STOPS = frozenset({
    "KeyboardInterrupt",
    "rclpy.executors.ExternalShutdownException",
    "rospy.exceptions.ROSInterruptException",
})  # fmt: skip
"""What is raised in a node that is told to stop."""
STOPPED = "stopped"
"""What stands for such a traceback."""


class _Place(Enum):
    OUTSIDE = "outside"
    INSIDE = "inside"
    BEHIND = "behind the exception that a stop raises; another one may be chained to it"


class StopTracebacks:
    """Takes tracebacks that end in the exception of a stop out of what a node prints.

    Lines of one are held back until it ends; one that ends otherwise is let through whole.
    """

    def __init__(self) -> None:
        self._place = _Place.OUTSIDE
        self._held: list[str] = []

    def without(self, lines: Iterable[str]) -> Iterator[str]:
        """Yield lines that were printed after the node was told to stop."""
        for line in lines:
            if self._place is not _Place.OUTSIDE and self._goes_on(line):
                self._held.append(line)
                continue
            yield from self.rest()
            if line == _BEGIN:
                self._place = _Place.INSIDE
                self._held.append(line)
            else:
                yield line

    def rest(self) -> Iterator[str]:
        """Yield what is held back, when nothing more can belong to it."""
        held, self._held = self._held, []
        if self._place is _Place.BEHIND:
            yield STOPPED
        else:
            yield from held
        self._place = _Place.OUTSIDE

    def _goes_on(self, line: str) -> bool:
        """Tell whether a line belongs to the traceback that is held back, and follow it."""
        if line in (_BEGIN, *_CHAINED):
            self._place = _Place.INSIDE
            return True
        if self._place is _Place.BEHIND:
            return not line
        if line.partition(":")[0] in _STOPS:
            self._place = _Place.BEHIND
            return True
        return not line or line.startswith(" ")
