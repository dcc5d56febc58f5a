"""Which test modules have tests that take long: where only those are run, no other is read.

Each worker of a run reads all test modules; two of three have no long test.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path

import pytest

_SAYS_SO = re.compile(rb"mark\.long|mostly_long|given\(|SIZES|service_graph")
"""The mark, what gives it, and the shared values and fixtures that have it; a property is tried
on all of its examples."""


@cache
def may_be_long(module: Path) -> bool:
    """Tell whether a test module says of any of its tests that it takes long."""
    return _SAYS_SO.search(module.read_bytes()) is not None


def is_left_out(path: Path) -> bool:
    """Tell whether a path is that of a test module without a long test."""
    return path.suffix == ".py" and path.name.startswith("test_") and not may_be_long(path)


def overlooked(items: Iterable[pytest.Item]) -> list[str]:
    """Return the long tests among these that a run of the long ones alone would leave out."""
    return [
        item.nodeid
        for item in items
        if item.get_closest_marker("long") is not None and not may_be_long(item.path)
    ]
