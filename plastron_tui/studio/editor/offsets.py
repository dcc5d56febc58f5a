"""Sorted places of a text that move along when it is edited."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable


class Offsets:
    """Sorted offsets, such as line starts; an edit costs what lies between it and the last one.

    What comes after the last edit is shifted as a whole, by one number, until an edit elsewhere
    settles what lies between.
    """

    def __init__(self, values: Iterable[int] = ()) -> None:
        self._values = list(values)
        self._border = len(self._values)
        self._shift = 0

    def __len__(self) -> int:
        return len(self._values)

    def __getitem__(self, index: int) -> int:
        value = self._values[index]
        return value + self._shift if index >= self._border else value

    def after(self, offset: int) -> int:
        """Return the index of the first entry beyond an offset."""
        values, border = self._values, self._border
        if border < len(values) and values[border] + self._shift <= offset:
            return bisect_right(values, offset - self._shift, lo=border)
        return bisect_right(values, offset, hi=border)

    def at_or_after(self, offset: int) -> int:
        """Return the index of the first entry that is not before an offset."""
        values, border = self._values, self._border
        if border < len(values) and values[border] + self._shift < offset:
            return bisect_left(values, offset - self._shift, lo=border)
        return bisect_left(values, offset, hi=border)

    def edit(self, first: int, last: int, new: list[int], shift: int) -> None:
        """Replace the entries from index `first` to `last` by new ones, and shift what follows."""
        self._settle(last)
        self._values[first:last] = new
        self._border = first + len(new)
        self._shift += shift

    def _settle(self, border: int) -> None:
        values, old, shift = self._values, self._border, self._shift
        if shift and border > old:
            values[old:border] = [value + shift for value in values[old:border]]
        elif shift and border < old:
            values[border:old] = [value - shift for value in values[border:old]]
        self._border = border
