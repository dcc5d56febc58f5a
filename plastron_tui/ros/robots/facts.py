"""What a robot's description says, one by one."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from typing import NamedTuple

from .description import Description


class Fact(NamedTuple):
    """One thing that a description says.

    Attributes:
        of: what it is about: `links`, and the name of a link, say; then from part to part.
        value: what it says of that.
    """

    of: tuple[str, ...]
    value: Hashable


def facts_of(robot: Description) -> Iterator[Fact]:
    """Yield all that a description says, value by value, such as the mass of a link."""
    yield Fact(("name",), robot.name)
    for kind in ("links", "joints", "materials"):
        for name, part in getattr(robot, kind).items():
            yield from _facts((kind, name), part)


def _facts(of: tuple[str, ...], value: Hashable) -> Iterator[Fact]:
    if not isinstance(value, tuple):
        yield Fact(of, value)
    elif hasattr(value, "_fields"):
        # Of two shapes with a `radius` only one is a sphere.
        yield Fact(of, type(value).__name__)
        for field in value._fields:
            yield from _facts((*of, field), getattr(value, field))
    elif value and all(isinstance(each, float | int) for each in value):
        yield Fact(of, value)
    else:
        for at, each in enumerate(value):
            yield from _facts((*of, str(at)), each)
