"""One view of a robot as SVG: bodies, the axes of joints on them, and their names."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, hypot

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.output.graphs.style import number
from plastron_tui.output.graphs.widths import drawable, text_width
from plastron_tui.ros.robots.description import Vector

from .labels import SIZE, Label, Sheet
from .outlines import Ellipse, Outline
from .scales import Seen
from .shades import color_of
from .solids import Axis, Scene, Solid
from .svg_style import OPACITY, PLAIN_SHADES
from .svg_text import escaped, text
from .views import Frame, Point

_AXIS, _HEAD = 30.0, 7.0
_ENDWAYS = 0.3
"""An axis that is seen shorter than this part of it is drawn as an end."""

_TRIAD = 24.0
_DIAMOND = 6.0
_LONGEST_NAME = 190.0
_CLEAREST = 0.2
"""A body that is clearer than this is drawn as if it were so: one has to see that it is there."""

_MOST_NAMES = 30
"""With more names than this only joints have theirs."""

_ENOUGH = 20
"""When so many names, one after the other, find no room, there is none for more."""

_ORIGIN: Vector = (0.0, 0.0, 0.0)
_XYZ: tuple[tuple[str, Vector], ...] = (
    ("x", (1.0, 0.0, 0.0)),
    ("y", (0.0, 1.0, 0.0)),
    ("z", (0.0, 0.0, 1.0)),
)


class SvgView:
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
        for bone in self._scene.bones:
            ends = [self._pixel(view.point(end)) for end in bone]
            yield f'<path class="bone" d="M{"L".join(map(_xy, ends))}"/>'
        for outline in self._seen.outlines:
            yield from self._body(outline)
        yield from self._triad()
        named: list[tuple[str, str, Point]] = []
        for axis in self._moving:
            yield from self._axis(axis)
            named.append((axis.joint, axis.joint, self._pixel(view.point(axis.at))))
        unknown = [each for each in self._seen.outlines if each.solid.shape is None]
        if len(named) + len(unknown) <= _MOST_NAMES:
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
        kind, opacity = "body box" if solid.is_rough else "body", ""
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
        line = f"M{_xy(at)}L{_xy(foot)}"
        yield f'<path class="halo" d="{line}"/><path class="axis" d="{line}"/>'
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
