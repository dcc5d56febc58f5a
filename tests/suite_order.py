"""The order of the tests that take long, by which all workers have work until the end."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import islice
from typing import TypeVar
from zlib import crc32

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


def in_order(
    tests: Sequence[T], workers: int, length: Callable[[T], float], file: Callable[[T], str]
) -> list[T]:
    """Return tests in an order in which no worker is alone in the end, and no processor waits.

    The share of each worker begins with some of the longest: were all of them at the front, one
    worker would have them all, and where their files are, it would come to them last. The other
    tests stay in the order of their file, for what they share; but the files are mixed. Most that
    run nodes wait, most others compute, and each kind lies together: one would be over first.

    Args:
        tests: what is run.
        workers: how many run it.
        length: tells how long a test is, or 0.
        file: names a test's file.
    """
    longest = sorted(filter(length, tests), key=length, reverse=True)
    short = [each for each in tests if not length(each)]
    others = iter(sorted(short, key=lambda each: (crc32(file(each).encode()), file(each))))
    ordered: list[T] = []
    for worker, size in enumerate(shares(len(tests), workers)):
        own = longest[worker::workers]
        ordered += [*own, *islice(others, max(size - len(own), 0))]
    return [*ordered, *others]
