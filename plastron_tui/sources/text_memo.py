"""What was found out about texts lately, so that a text is not read again to find out the same.

One `generate` asks about a text from several sides: what it holds, what an edit would make of it,
whether a merge is worse than it. Each asks with the text alone, and none knows of the others.
"""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from functools import wraps
from typing import Any, TypeVar

MOST_BYTES = 1024 * 1024
"""How large the texts are in all, each counted once for each result.

What is known of a file of Python are four results, which take some 50 bytes a byte of the file.
"""

_LEAST = 1024
"""What a result counts at least: a text of a few bytes is not all that is kept of it."""

_Result = TypeVar("_Result")
_Source = TypeVar("_Source")


class TextMemo(threading.local):
    """Results by what they were made of, the least recently used of which is forgotten first.

    Each thread has results of its own: what knows the names of a file notes what it was asked.
    """

    def __init__(self, most: int = MOST_BYTES) -> None:
        """Begin with nothing, in a thread that asks for the first time."""
        self._most = most
        self._known: OrderedDict[Hashable, tuple[Any, int]] = OrderedDict()
        self.size = 0

    def get(self, key: Hashable) -> Any:
        """Return the result of a key, None where it is not known."""
        found = self._known.get(key)
        if found is None:
            return None
        self._known.move_to_end(key)
        return found[0]

    def keep(self, key: Hashable, result: object, size: int) -> None:
        """Keep the result of a key, unless it is larger than all that may be kept.

        Args:
            key: what it was made of.
            result: the result, which is never changed.
            size: how many bytes of text it is about.
        """
        self.size -= self._known.pop(key, (None, 0))[1]
        size = max(size, _LEAST)
        if size > self._most:
            return
        self._known[key] = result, size
        self.size += size
        while self.size > self._most:
            _, (_, left) = self._known.popitem(last=False)
            self.size -= left

    def take(self, key: Hashable) -> Any:
        """Return the result of a key and forget it, None where it is not known."""
        found, size = self._known.pop(key, (None, 0))
        self.size -= size
        return found

    def clear(self) -> None:
        """Forget all, in this thread."""
        self._known.clear()
        self.size = 0


MEMO = TextMemo()
"""What all of Plastron knows of texts."""


def remembered(make: Callable[[bytes], _Result]) -> Callable[[bytes], _Result]:
    """Let a function return what it made of the same text before.

    Its result follows from the text alone, and nobody changes it.
    """

    @wraps(make)
    def find(text: bytes) -> _Result:
        key = make, text
        # None may be a result.
        found: tuple[_Result] | None = MEMO.get(key)
        if found is None:
            found = (make(text),)
            MEMO.keep(key, found, len(text))
        return found[0]

    return find


class _Lending(threading.local):
    """Results that may be had again, and those that somebody has now."""

    depth = 0

    def __init__(self) -> None:
        """Begin with nothing, in a thread that asks for the first time."""
        self.lent: list[tuple[Hashable, object, int]] = []


_LENDING = _Lending()


@contextmanager
def sharing() -> Iterator[None]:
    """Let `lent` return what was lent before, to who has given it back at the end of this.

    For who reads many files one after the other, and keeps nothing of a file but plain data.
    """
    _LENDING.depth += 1
    try:
        yield
    finally:
        _LENDING.depth -= 1
        if not _LENDING.depth:
            for key, result, size in _LENDING.lent:
                MEMO.keep(key, result, size)
            _LENDING.lent.clear()


def lent(make: Callable[[_Source], _Result], source: _Source, text: bytes) -> _Result:
    """Return what a function makes of something that stands for a text.

    Who gets it may change it, until somebody else gets it: of two that have it at the same time
    each has one of its own. Without `sharing` it is always made anew.
    """
    if not _LENDING.depth:
        return make(source)
    key = lent, make, text
    found: _Result | None = MEMO.take(key)
    result = make(source) if found is None else found
    _LENDING.lent.append((key, result, len(text)))
    return result
