"""The order of the tests that take long: each worker begins with some of those of minutes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import islice
from typing import TypeVar

import pytest

T = TypeVar("T")


def minutes(item: pytest.Item) -> float:
    """Return how many minutes a test says that it takes; 0 where it does not say it."""
    return max((mark.args[0] for mark in item.iter_markers("long") if mark.args), default=0)


def shares(number: int, workers: int) -> list[int]:
    """Return how many tests each worker gets, one behind the other, of a list of so many.

    That is what `--dist worksteal` does (xdist/scheduler/worksteal.py, `check_schedule`). A worker
    that has ended takes half of what another one has left, from its end; the last two stay.
    """
    left = number
    sizes = []
    for worker in range(workers):
        sizes.append(left // (workers - worker))
        left -= sizes[-1]
    return sizes


def longest_first(tests: Sequence[T], workers: int, length: Callable[[T], float]) -> list[T]:
    """Return tests in an order in which the share of each worker begins with the longest.

    If all of those came first, one worker would have them all; if they came where their files are,
    one would run alone in the end. Tests that have no length stay in their order, beside those
    that they share something with.
    """
    longest = sorted(filter(length, tests), key=length, reverse=True)
    others = iter([each for each in tests if not length(each)])
    ordered: list[T] = []
    for worker, size in enumerate(shares(len(tests), workers)):
        own = longest[worker::workers]
        ordered += [*own, *islice(others, max(size - len(own), 0))]
    return [*ordered, *others]
