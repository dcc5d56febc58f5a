"""The views of a robot as SVG: in one scale, above and beside each other as their axes are."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, hypot
from typing import NamedTuple

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.output.graphs.style import number
from plastron_tui.output.graphs.widths import drawable, text_width
from plastron_tui.ros.robots.description import JointType, Vector

from .labels import SIZE, Label, Sheet
from .outlines import Ellipse, Outline
from .scales import Seen, ruler_length, ruler_text, seen_from_all
from .shades import color_of
from .solids import Axis, Scene, Solid
from .svg_style import OPACITY, PLAIN_SHADES
from .svg_text import escaped, text
from .views import FRONT, SIDE, TOP, Frame, Point

_PAD_X, _PAD_Y = 78.0, 40.0
"""Room around each view, for names."""

_SMALL, _MIDDLE, _LARGE = (440.0, 380.0), (720.0, 620.0), (1000.0, 860.0)
"""How wide and high the bodies in all views are together, with few, more and many joints."""

_FEW, _MANY = 10, 40
_AXIS, _HEAD = 30.0, 7.0
_ENDWAYS = 0.3
"""An axis that is seen shorter than this part of it is drawn as an end."""

_TRIAD = 24.0
_DIAMOND = 6.0
_LONGEST_NAME = 190.0
_CLEAREST = 0.2
"""A body that is clearer than this is drawn as if it were so: one has to see that it is there."""

_ENOUGH = 20
"""When so many names, one after the other, find no room, there is none for more."""

_ORIGIN: Vector = (0.0, 0.0, 0.0)
_XYZ: tuple[tuple[str, Vector], ...] = (
    ("x", (1.0, 0.0, 0.0)),
    ("y", (0.0, 1.0, 0.0)),
    ("z", (0.0, 0.0, 1.0)),
)


class SvgViews(NamedTuple):
    """The views, and how large they are."""

    lines: tuple[str, ...]
    width: float
    height: float


def views_svg(scene: Scene) -> SvgViews:
    """Return the views of a robot from above, from its right side, and from its front."""
    top, side, front = sides = seen_from_all(scene)
    assert (top.view, side.view, front.view) == (TOP, SIDE, FRONT)
    moving = [axis for axis in scene.axes if axis.type is not JointType.FIXED]
    width, height = _SMALL if len(moving) <= _FEW else _MIDDLE if len(moving) <= _MANY else _LARGE
    scale = min(
        width / (side.frame.width + front.frame.width),
        height / (top.frame.height + side.frame.height),
    )
    left = max(side.frame.width * scale + 2 * _PAD_X, _NARROWEST)
    right = max(front.frame.width * scale + 2 * _PAD_X, _NARROWEST)
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
        drawn = _View(scene, moving, seen, places[seen.view], scale)
        lines += drawn.lines()
        named |= drawn.named
    unnamed = sum(axis.joint not in named for axis in moving)
    lines += _notes(scene, unnamed, left + 24.0, scale)
    return SvgViews(tuple(lines), left + right, upper + lower)


_NARROWEST, _LOWEST = 230.0, 150.0
"""How small the place of a view may be."""


def _notes(scene: Scene, unnamed: int, left: float, scale: float) -> Iterator[str]:
    """Yield what stands in the corner that no view has: the ruler, and what there is to know."""
    length = ruler_length(110.0 / scale)
    end = length * scale
    yield f'<g class="ruler"><title>{ruler_text(length)}</title>'
    yield f'<path class="rule" d="M{number(left)} 22v8h{number(end)}v-8"/>'
    yield text("said", left + end + 8, 30, ruler_text(length))
    yield "</g>"
    notes = ["third-angle projection, all joints at 0"]
    if any(solid.shape is None for solid in scene.solids):
        notes.append("a diamond is a mesh whose size is not known")
    if any(solid.is_bounds for solid in scene.solids):
        notes.append("a dashed box is the box around a mesh")
    if unnamed:
        one = "name stands" if unnamed == 1 else "names stand"
        notes.append(f"{unnamed} more {one} in the tree")
    y = 50.0
    for note in notes:
        yield text("said", left, y, note)
        y += 15
    if scene.missing:
        count = len(scene.missing)
        words = f"{count} link{'' if count == 1 else 's'} cannot be drawn"
        yield text("alarm", left, y, words)


class _View:
    """One view, in its place."""

    def __init__(
        self, scene: Scene, moving: list[Axis], seen: Seen, place: Frame, scale: float
    ) -> None:
        self._scene = scene
        self._moving = moving
        self._seen = seen
        self._place = place
        self._scale = scale
        self._sheet = Sheet(place.width, place.height)
        frame = seen.frame
        self._left = (place.width - frame.width * scale) / 2 - frame.left * scale
        self._top = (place.height - frame.height * scale) / 2 + frame.high * scale
        self.named: set[str] = set()

    def _pixel(self, at: Point) -> Point:
        return Point(self._left + at.x * self._scale, self._top - at.y * self._scale)

    def lines(self) -> Iterator[str]:
        """Yield bodies, then signs on them, then names on these."""
        view, place = self._seen.view, self._place
        across, up = view.axes
        yield (
            f'<g class="view" data-view="{view.key}" '
            f'transform="translate({number(place.left)} {number(place.low)})">'
        )
        head = f"{view.name}, {across} to the right, {up} up"
        self._sheet.keep(Frame(0.0, 0.0, 8 + text_width(head, SIZE), 18.0))
        yield text("said", 4, 13, head)
        for outline in self._seen.outlines:
            yield from self._body(outline)
        yield from self._triad()
        named: list[tuple[str, str, Point]] = []
        for axis in self._moving:
            yield from self._axis(axis)
            named.append((axis.joint, axis.joint, self._pixel(view.point(axis.at))))
        unknown = [each for each in self._seen.outlines if each.solid.shape is None]
        named += [(each.solid.link, "", self._pixel(each.points[0])) for each in unknown]
        yield from self._names(named)
        yield "</g>"

    def _body(self, outline: Outline) -> Iterator[str]:
        solid = outline.solid
        points = [self._pixel(point) for point in outline.points]
        if solid.shape is None:
            x, y = points[0]
            self._sheet.mark(points[0], _DIAMOND)
            yield (
                f'<path class="unknown" d="M{_xy(Point(x - _DIAMOND, y))}l6 -6l6 6l-6 6z">'
                f"<title>{escaped(solid.link)}</title></path>"
            )
            return
        kind, opacity = "body box" if solid.is_bounds else "body", ""
        if solid.rgba is not None and solid.rgba[3] < 1:
            opacity = f' style="opacity:{max(solid.rgba[3], _CLEAREST) * OPACITY:.2f}"'
        yield f'<g class="{kind}"{opacity}><title>{escaped(solid.link)}</title>'
        if outline.radius:
            radius = outline.radius * self._scale
            x, y = points[0]
            reach = radius * 0.9
            self._sheet.cover([
                Point(x - reach, y), Point(x, y - reach), Point(x + reach, y), Point(x, y + reach),
            ])  # fmt: skip
            circle = f'cx="{number(x)}" cy="{number(y)}" r="{_fine(radius)}"'
            yield f"<circle {_fill(solid, 1.0)} {circle}/>"
        else:
            self._sheet.cover(points)
            if outline.rim is not None:
                yield from self._cylinder(outline, outline.rim, points)
            elif outline.faces:
                # All of the outline is faces.
                for face in outline.faces:
                    corners = [self._pixel(point) for point in face.points]
                    yield f'<path {_fill(solid, face.facing)} d="{_path(corners)}"/>'
            else:
                yield f'<path {_fill(solid, outline.facing)} d="{_path(points)}"/>'
        yield "</g>"

    def _cylinder(self, outline: Outline, rim: Ellipse, points: list[Point]) -> Iterator[str]:
        half = len(points) // 2
        # y goes down in a picture, so all turns are the other way around.
        long, short = rim.long * self._scale, rim.short * self._scale
        arc = f"A{number(long)} {number(short)} {number(degrees(-rim.turn))} 0 0 "
        ends = [_xy(points[at]) for at in (0, half - 1, half, -1)]
        path = f"M{ends[0]}{arc}{ends[1]}L{ends[2]}{arc}{ends[3]}z"
        yield f'<path {_fill(outline.solid, outline.facing)} d="{path}"/>'
        for face in outline.faces:
            count = len(face.points) // 2
            one, other = (self._pixel(face.points[at]) for at in (0, count))
            path = f"M{_xy(one)}{arc}{_xy(other)}{arc}{_xy(one)}z"
            yield f'<path {_fill(outline.solid, face.facing)} d="{path}"/>'

    def _triad(self) -> Iterator[str]:
        """Draw the frame of the root in the colours that RViz has for x, y and z."""
        view = self._seen.view
        start = self._pixel(view.point(_ORIGIN))
        for name, along in _XYZ:
            seen = view.point(along)
            if not seen.x and not seen.y:
                continue
            end = Point(start.x + seen.x * _TRIAD, start.y - seen.y * _TRIAD)
            letter = Point(end.x + seen.x * 7 - 3, end.y - seen.y * 7 + 3.5)
            yield f'<path class="{name}" d="M{_xy(start)}L{_xy(end)}"/>'
            yield text(f"xyz {name}", letter.x, letter.y, name)
            self._sheet.keep(Frame(letter.x - 2, letter.y - 9, letter.x + 8, letter.y + 3))

    def _axis(self, axis: Axis) -> Iterator[str]:
        view = self._seen.view
        at = self._pixel(view.point(axis.at))
        self._sheet.mark(at, 5.0)
        yield f'<g class="joint-axis"><title>{escaped(axis.joint)}</title>'
        yield from self._sign(axis, at)
        yield "</g>"

    def _sign(self, axis: Axis, at: Point) -> Iterator[str]:
        view = self._seen.view
        place = f'cx="{number(at.x)}" cy="{number(at.y)}"'
        if axis.along is None:
            yield f'<circle class="end" {place} r="3.5"/>'
            return
        seen = view.point(axis.along)
        length = hypot(seen.x, seen.y)
        if length < _ENDWAYS:
            yield f'<circle class="end" {place} r="5"/>'
            if view.depth(axis.along) > 0:
                yield f'<circle class="tip" {place} r="1.8"/>'
            else:
                yield f'<path class="axis" d="M{_xy(Point(at.x - 3, at.y - 3))}l6 6m0 -6l-6 6"/>'
            return
        across, down = seen.x / length, -seen.y / length
        reach = max(_AXIS * length, _HEAD + 4)
        tip = Point(at.x + across * reach, at.y + down * reach)
        foot = Point(tip.x - across * _HEAD, tip.y - down * _HEAD)
        half = _HEAD * 0.45
        one = Point(foot.x - down * half, foot.y + across * half)
        other = Point(foot.x + down * half, foot.y - across * half)
        yield f'<path class="axis" d="M{_xy(at)}L{_xy(foot)}"/>'
        yield f'<path class="tip" d="M{_xy(tip)}L{_xy(one)}L{_xy(other)}z"/>'
        yield f'<circle class="tip" {place} r="2.4"/>'
        for part in (0.45, 0.75, 1.0):
            x, y = at.x + across * reach * part, at.y + down * reach * part
            self._sheet.keep(Frame(x - 3, y - 3, x + 3, y + 3))

    def _names(self, named: list[tuple[str, str, Point]]) -> Iterator[str]:
        failed = 0
        for name, joint, at in named:
            if failed == _ENOUGH:
                return
            label = self._sheet.put(_short(drawable(visible(name))), at)
            failed = failed + 1 if label is None else 0
            if label is not None:
                self.named.add(joint)
                yield from _label(label)


def _label(label: Label) -> Iterator[str]:
    if label.leader is not None:
        start, end = label.leader
        yield f'<path class="lead" d="M{_xy(start)}L{_xy(end)}"/>'
    yield text("name", label.x, label.baseline, label.text)


def _short(name: str) -> str:
    """Return a name that is not too long to stand in a picture: the middle is left out."""
    if text_width(name, SIZE) <= _LONGEST_NAME:
        return name
    half = len(name) // 2
    while text_width(f"{name[:half]}…{name[-half:]}", SIZE) > _LONGEST_NAME and half > 1:
        half -= 1
    return f"{name[:half]}…{name[-half:]}"


def _fill(solid: Solid, facing: float) -> str:
    """Return the attributes of a face, by how far it is turned to who looks."""
    if solid.rgba is None:
        return f'class="edge p{round(facing * PLAIN_SHADES)}"'
    return f'class="edge" fill="{color_of(solid.rgba, facing)}"'


def _path(points: list[Point]) -> str:
    return f"M{'L'.join(map(_xy, points))}z"


def _xy(point: Point) -> str:
    return f"{number(point.x)} {number(point.y)}"


def _fine(value: float) -> str:
    return number(max(value, 0.1))
