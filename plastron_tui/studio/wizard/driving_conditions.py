"""When a robot drives that stops where something is near: offered, and understood."""

from __future__ import annotations

import re

from .ask import Ask, Choice
from .obstacles import distances_of_trigger, way_is_free

_METRES = ("0.5", "0.3", "1", "2")
"""The distances that are offered: everything has to be farther away for the robot to drive."""

_MEANT = re.compile(
    r"\s*((any|all)\s+)?(received\b\.?)?(?P<name>[A-Za-z]\w*)?(?P<at>\[\d+\])?"
    r"\s*([<>]=?|=[<>])?\s*(?P<value>\d+(\.\d*)?|\.\d+|parameter\s*'[^']*')\s*m?\s*",
    re.ASCII,
)
"""What somebody writes who says how near is near: with `<` for when it stops, `>` for when not."""


def meant(ask: Ask, text: str) -> str:
    """Return the condition to drive on that a text means; one of something else stays as it is.

    `any received.ranges < 1`, `ranges < 1` and `1` all say within how many metres it stops. An
    empty text means the usual condition: without one it would drive into things.
    """
    far = distances_of_trigger(ask)
    if not text:
        return way_is_free(ask)
    found = _MEANT.fullmatch(text)
    if not far or found is None:
        return text
    path = far.removeprefix("all ")
    if found["name"] is not None and found["name"] != path.rpartition(".")[2]:
        return text
    told = f"{path}{found['at']}" if found["at"] else far
    return f"{told} > {found['value']}"


def choices(ask: Ask, query: str) -> list[Choice]:
    """Return how far everything may have to be, that which was written first."""
    far = distances_of_trigger(ask)
    found = _MEANT.fullmatch(query)
    written = () if found is None else (found["value"],)
    return [
        Choice(f"{far} > {metres}", f"drive while nothing is nearer than {metres} m")
        for metres in dict.fromkeys((*written, *_METRES))
    ]


def problem(ask: Ask, text: str) -> str | None:
    """Tell why nobody can drive on a condition: it says nothing of all distances."""
    far = distances_of_trigger(ask)
    path = re.escape(far.removeprefix("all "))
    if re.fullmatch(rf"({re.escape(far)}|{path}\[\d+\]) > \S.*", text):
        return None
    return f"it says when it drives, by all that is measured, such as `{far} > {_METRES[0]}`"
