"""The scale that a robot is drawn at, and its ruler."""

from __future__ import annotations

from collections.abc import Iterable
from math import floor, log10
from typing import NamedTuple

from .outlines import CORNERS, Outline, frame_of, outline
from .solids import Scene
from .views import VIEWS, Frame, View

_SMALLEST = 1e-6
"""A robot that is smaller than this, in metres, is drawn as if it were so large."""


class Seen(NamedTuple):
    """A robot from one side.

    Attributes:
        view: the side.
        outlines: what one sees of its bodies, the farthest first.
        frame: what all of it fits into: bodies, joints and the origin.
    """

    view: View
    outlines: tuple[Outline, ...]
    frame: Frame


def seen(scene: Scene, view: View, corners: int = CORNERS) -> Seen:
    """Return a robot from one side."""
    found = [outline(solid, view, corners) for solid in scene.solids]
    # What is nearest is drawn last; of what is as near, what comes later in the robot.
    found.sort(key=lambda each: each.nearest)
    points = [view.point(at) for at in ((0.0, 0.0, 0.0), *scene.points)]
    return Seen(view, tuple(found), _around([frame_of(points), *(each.frame for each in found)]))


def seen_from_all(scene: Scene, corners: int = CORNERS) -> tuple[Seen, ...]:
    """Return a robot from all sides; frames have the same x, y and z."""
    return tuple(seen(scene, view, corners) for view in VIEWS)


def _around(frames: Iterable[Frame]) -> Frame:
    left, low, right, high = zip(*frames, strict=True)
    frame = Frame(min(left), min(low), max(right), max(high))
    wide = max(0.0, _SMALLEST - frame.width) / 2
    tall = max(0.0, _SMALLEST - frame.height) / 2
    return Frame(frame.left - wide, frame.low - tall, frame.right + wide, frame.high + tall)


def ruler_length(longest: float) -> float:
    """Return a round length, 1, 2 or 5 times a power of ten, in metres, no longer than one."""
    power = 10.0 ** floor(log10(longest))
    for factor in (5, 2):
        if factor * power <= longest:
            return factor * power
    return power


def ruler_text(length: float) -> str:
    """Return a round length: `0.2 m`, `50 m`, `0.0005 m`."""
    places = max(0, -floor(log10(length) + 1e-9))
    return f"{length:.{places}f} m"
