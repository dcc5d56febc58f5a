"""The views of a robot as SVG: in one scale, above and beside each other as their axes are."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from plastron_tui.diagnostics.wording import counted
from plastron_tui.output.graphs.style import number
from plastron_tui.output.graphs.widths import text_width
from plastron_tui.ros.robots.description import JointType

from .labels import SIZE
from .scales import ruler_length, ruler_text, seen_from_all
from .solids import Hull, Scene
from .svg_text import text
from .svg_view import SvgView
from .views import FRONT, SIDE, TOP, Frame

_PAD_X, _PAD_Y = 78.0, 40.0
"""Room around each view, for names."""

_NARROWEST, _LOWEST = 230.0, 150.0
"""How small the place of a view may be."""

_SMALL, _MIDDLE, _LARGE = 380.0, 620.0, 860.0
"""How high the bodies in all views are together, with few, more and many joints."""

_WIDE = 1.16
"""How much wider than high they may be."""

_FEW, _MANY = 10, 40
_CORNER, _LINE = 24.0, 15.0
_RULER = 110.0
_SIGN, _APART = 16.0, 14.0
_TOWARD, _AWAY = "an axis that points at you", "away"


class SvgViews(NamedTuple):
    """The views, and how large they are."""

    lines: tuple[str, ...]
    width: float
    height: float


def views_svg(scene: Scene, beside: float) -> SvgViews:
    """Return the views of a robot from above, from its right side, and from its front.

    Args:
        scene: what is drawn.
        beside: how high what stands beside it is: up to that there is room.
    """
    top, side, front = sides = seen_from_all(scene)
    assert (top.view, side.view, front.view) == (TOP, SIDE, FRONT)
    moving = [axis for axis in scene.axes if axis.type is not JointType.FIXED]
    height = _SMALL if len(moving) <= _FEW else _MIDDLE if len(moving) <= _MANY else _LARGE
    height = max(height, min(beside - 4 * _PAD_Y, _LARGE))
    scale = min(
        height * _WIDE / (side.frame.width + front.frame.width),
        height / (top.frame.height + side.frame.height),
    )
    left = max(side.frame.width * scale + 2 * _PAD_X, _NARROWEST)
    notes = _notes(scene)
    signs = text_width(f"{_TOWARD}{_AWAY}", SIZE) + 2 * _SIGN + _APART
    widest = max(signs, *(text_width(note, SIZE) for note in notes)) + _CORNER
    right = max(front.frame.width * scale + 2 * _PAD_X, _NARROWEST, widest)
    upper = max(top.frame.height * scale + 2 * _PAD_Y, _LOWEST)
    lower = max(side.frame.height * scale + 2 * _PAD_Y, _LOWEST)
    places = {
        TOP: Frame(0.0, 0.0, left, upper),
        SIDE: Frame(0.0, upper, left, upper + lower),
        FRONT: Frame(left, upper, left + right, upper + lower),
    }
    lines: list[str] = []
    named: set[str] = set()
    for seen in sides:
        drawn = SvgView(scene, moving, seen, places[seen.view], scale)
        lines += drawn.lines()
        named |= drawn.named
    unnamed = sum(axis.joint not in named for axis in moving)
    if unnamed:
        one = "name stands" if unnamed == 1 else "names stand"
        notes.append(f"{unnamed} more {one} in the tree")
    lines += _corner(scene, notes, left + _CORNER, scale)
    return SvgViews(tuple(lines), left + right, upper + lower)


def _notes(scene: Scene) -> list[str]:
    """Return what there is to know of the views of a robot."""
    notes = ["third-angle projection, all joints at 0"]
    if any(solid.shape is None for solid in scene.solids):
        notes.append("a diamond is a mesh whose size is not known")
    if any(solid.is_rough for solid in scene.solids):
        notes.append("dashed is the box around a mesh, or what collides")
    if any(isinstance(solid.shape, Hull) for solid in scene.solids):
        notes.append("meshes are drawn as their convex hulls")
    return notes


def _signs(left: float, baseline: float) -> Iterator[str]:
    """Yield what the ends of axes look like, and what they are."""
    place = f'cx="{number(left + 5)}" cy="{number(baseline - 4)}"'
    yield f'<circle class="end" {place} r="5"/><circle class="tip" {place} r="1.8"/>'
    yield text("said", left + _SIGN, baseline, _TOWARD)
    left += _SIGN + text_width(_TOWARD, SIZE) + _APART
    yield f'<circle class="end" cx="{number(left + 5)}" cy="{number(baseline - 4)}" r="5"/>'
    yield f'<path class="axis" d="M{number(left + 2)} {number(baseline - 7)}l6 6m0 -6l-6 6"/>'
    yield text("said", left + _SIGN, baseline, _AWAY)


def _corner(scene: Scene, notes: list[str], left: float, scale: float) -> Iterator[str]:
    """Yield what stands in the corner that no view has: the ruler and the notes."""
    length = ruler_length(_RULER / scale)
    end = length * scale
    yield f'<g class="ruler"><title>{ruler_text(length)}</title>'
    yield f'<path class="rule" d="M{number(left)} 4v8h{number(end)}v-8"/>'
    yield text("said", left + end + 8, 12, ruler_text(length))
    yield "</g>"
    baseline = 32.0
    for note in notes:
        yield text("said", left, baseline, note)
        baseline += _LINE
    if any(axis.along is not None for axis in scene.axes):
        yield from _signs(left, baseline)
        baseline += _LINE
    if scene.missing:
        words = f"{counted(len(scene.missing), 'link')} cannot be drawn"
        yield text("alarm", left, baseline, words)
