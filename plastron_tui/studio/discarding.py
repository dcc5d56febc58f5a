"""Letting go of what a program meant before, a little at a time.

Python frees a thing and all that it alone holds in one go, in which no other thread can run: ten
milliseconds for what 10,000 statements mean, between two keys.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from .panels.entry import Entries

if TYPE_CHECKING:
    from .analysis import Analysis

_AT_ONCE = 100
"""How many things are let go at once; with what they hold that takes a tenth of a millisecond."""


class Discarded:
    """What nobody needs any more, and is not gone yet."""

    def __init__(self) -> None:
        self._parts: list[list[object]] = []

    def add(self, analysis: Analysis) -> None:
        """Take an analysis over from the last one who needed it."""
        known = analysis.workspace
        entries = [each.all for each in analysis.made.values() if isinstance(each, Entries)]
        things = analysis.program.statements, known.generations, *entries
        self._parts += map(list, (*things, known.nodes.values(), known.messages.values()))

    def let_go(self, must_stop: Callable[[], bool]) -> None:
        """Let go of all, or of as much as can be until something has to be done."""
        while self._parts and not must_stop():
            del self._parts[-1][-_AT_ONCE:]
            if not self._parts[-1]:
                self._parts.pop()
