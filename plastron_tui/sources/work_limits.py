"""How much may be done to find out what the names of a file stand for.

A name is looked up in what it is bound to, which has names in turn: a file of a few lines can be
written so that this never ends. What is not known by then stays unknown.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any, Protocol, TypeVar, cast

MOST_STEPS = 10_000
"""The most steps for one question; what people write takes some ten."""

MOST_NESTED = 40
"""The most questions that one leads to, each asked by the one before; people write up to 26."""

FREE_STEPS = 32
"""How many of them count for no file: there are as many questions as the file is large."""

LEAST_IN_ALL = 200_000
"""The steps for a whole file, to which those of its size are added."""

BYTES_PER_STEP = 8


class Effort:
    """What is left of the steps for a file, and for the question that is asked just now.

    Attributes:
        in_all: what is left for the file.
    """

    def __init__(self, size: int) -> None:
        """Set the size of the file, in bytes."""
        self.in_all = LEAST_IN_ALL + size // BYTES_PER_STEP
        self._left = 0
        self._taken = 0
        self._depth = 0

    def begin(self) -> None:
        """Begin with a question, or with one that another asks in turn."""
        if self._depth == 0:
            self._taken = 0
            self._left = min(MOST_STEPS, max(FREE_STEPS, self.in_all))
        self._depth += 1

    def end(self) -> bool:
        """End the question; tell whether there was enough for it, and for those that asked it."""
        self._depth -= 1
        return self._left > 0

    def spend(self) -> bool:
        """Take a step; tell whether there was one left, and no question too many asked another."""
        self._left -= 1
        self._taken += 1
        self.in_all -= self._taken > FREE_STEPS
        return self._left > 0 and self._depth <= MOST_NESTED


class _HasEffort(Protocol):
    effort: Effort


_Question = TypeVar("_Question", bound=Callable[..., Any])


def bounded(unknown: object) -> Callable[[_Question], _Question]:
    """Let a method answer a question about a file with `unknown` where it takes too many steps."""

    def decorate(method: _Question) -> _Question:
        @wraps(method)
        def ask(self: _HasEffort, *arguments: Any) -> Any:
            effort = self.effort
            effort.begin()
            try:
                answer = method(self, *arguments) if effort.spend() else unknown
            finally:
                is_enough = effort.end()
            return answer if is_enough else unknown

        return cast(_Question, ask)

    return decorate
