"""What was found out about texts lately, so that a text is not read again to find out the same.

One `generate` asks about a text from several sides: what it holds, what an edit would make of it,
whether a merge is worse than it. Each asks with the text alone, and none knows of the others.
"""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable
from functools import wraps
from typing import Any, TypeVar

MOST_BYTES = 1024 * 1024
"""How large the texts are in all, each counted once for each result.

What is known of a file of Python are four results, which take some 50 bytes a byte of the file.
"""

_LEAST = 1024
"""What a result counts at least: a text of a few bytes is not all that is kept of it."""

_Result = TypeVar("_Result")


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
