"""The views of a robot in characters."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from plastron_tui.diagnostics.terminal import visible, width
from plastron_tui.ros.robots.description import JointType

from .canvas import Canvas
from .outlines import Outline
from .runs import RunLines
from .scales import Seen, ruler_length, ruler_text
from .shades import color_of, dimmed, edge_of, lifted
from .solids import Scene
from .text_marks import MIDDLE, UNKNOWN, axis_sign, fill_chars, in_ascii
from .views import FRONT, SIDE, TOP, Point

_PAD_X, _PAD_Y = 2, 1
"""Columns and rows around a view, for signs and names."""

_FEW = 8
"""So many names of joints may hide what is drawn behind them."""

_BONE = "#7f8b97"
"""The colour of what holds bodies together: it is seen on dark and on light."""

_THICK = 6.0
"""A body that is so many pixels wide and high has an edge."""


class _Pixels(NamedTuple):
    """Where on the canvas a view is: its origin in pixels, and how many pixels a metre has."""

    x: float
    y: float
    scale: float

    def at(self, point: Point) -> Point:
        """Return the pixel of a point."""
        return Point(self.x + point.x * self.scale, self.y - point.y * self.scale)

    def of(self, points: Iterable[Point]) -> list[tuple[float, float]]:
        """Return the pixels of points."""
        left, top, scale = self
        return [(left + x * scale, top - y * scale) for x, y in points]


class _Place(NamedTuple):
    """A rectangle of the canvas: columns and rows."""

    column: int
    row: int
    columns: int
    rows: int


def draw_view(
    scene: Scene, seen: Seen, columns: int, rows: int, marked: str, ascii_only: bool
) -> RunLines:
    """Return one view as large as fits, with its name above and a ruler below."""
    canvas = Canvas(columns, rows, ascii_only=ascii_only)
    drawing = _Drawing(canvas, scene, marked)
    room = _Place(0, 1, columns, max(rows - 2, 1))
    scale = _scale(room, seen.frame.width, seen.frame.height)
    drawing.view(seen, room, scale)
    drawing.ruler(0, rows - 1, columns, scale)
    return canvas.lines()


def draw_views(
    scene: Scene, sides: tuple[Seen, ...], columns: int, rows: int, marked: str, ascii_only: bool
) -> RunLines:
    """Return all views in one scale: above and beside each other is what has the same x or z."""
    top, side, front = sides
    assert (top.view, side.view, front.view) == (TOP, SIDE, FRONT)
    canvas = Canvas(columns, rows, ascii_only=ascii_only)
    drawing = _Drawing(canvas, scene, marked)
    wide = side.frame.width + front.frame.width
    tall = top.frame.height + side.frame.height
    pads_x, pads_y = 4 * _PAD_X, 2 * (2 * _PAD_Y + 1)
    scale = min((columns - pads_x) / wide, 2 * (rows - pads_y) / tall)
    scale = max(scale, 1e-12)
    # What one direction leaves over is shared.
    spare_x = max(0, columns - pads_x - wide * scale)
    spare_y = max(0, rows - pads_y - tall * scale / 2)
    left = min(round(side.frame.width * scale + 2 * _PAD_X + spare_x / 2), columns - 1)
    upper = min(round(top.frame.height * scale / 2 + 2 * _PAD_Y + 1 + spare_y / 2), rows - 1)
    cells = (
        (top, _Place(0, 0, left, upper)),
        (side, _Place(0, upper, left, rows - upper)),
        (front, _Place(left, upper, columns - left, rows - upper)),
    )
    for seen, cell in cells:
        below = _Place(cell.column, cell.row + 1, cell.columns, max(cell.rows - 1, 1))
        drawing.view(seen, below, scale)
    drawing.ruler(left, 0, columns - left, scale)
    return canvas.lines()


def _scale(room: _Place, wide: float, tall: float) -> float:
    """Return how many pixels a metre has."""
    across, down = max(room.columns - 2 * _PAD_X, 1), max(room.rows - 2 * _PAD_Y, 1)
    return min(across / wide, 2 * down / tall)


class _Drawing:
    """A canvas that views of one robot are drawn on."""

    def __init__(self, canvas: Canvas, scene: Scene, marked: str) -> None:
        self.canvas = canvas
        self.scene = scene
        self.marked = marked
        links = {solid.link for solid in scene.solids}
        # A joint that is pointed out leaves the bodies as they are.
        self.stands_out = marked if marked in links else ""
        self.fills = fill_chars(scene.links) if canvas.ascii_only else {}

    def view(self, seen: Seen, place: _Place, scale: float) -> None:
        """Draw a view in the middle of a place; its name is in the row above."""
        frame = seen.frame
        left = place.column + (place.columns - frame.width * scale) / 2
        top = 2 * place.row + (2 * place.rows - frame.height * scale) / 2

        # The origin is between two pixels: what is the same on both sides of it looks the same.
        x, y = round(left - frame.left * scale), round(top + frame.high * scale)
        pixels = _Pixels(x, y, scale)
        for bone in self.scene.bones:
            start, end = (pixels.at(seen.view.point(at)) for at in bone)
            self.canvas.line(start, end, "." if self.canvas.ascii_only else _BONE)
        for outline in self._ordered(seen.outlines):
            self._body(outline, pixels)
        across, up = seen.view.axes
        signs = f"{across}→ {up}↑"
        self._write(place.column, place.row - 1, seen.view.name, "title")
        self._write(place.column + len(seen.view.name) + 2, place.row - 1, signs, "quiet")
        self._unknown(seen.outlines, pixels)
        self._axes(seen, pixels, place)

    def ruler(self, column: int, row: int, columns: int, scale: float) -> None:
        """Draw a ruler, and how long it is."""
        length = ruler_length(max(columns * 0.6, 4) / scale)
        cells = max(round(length * scale), 1)
        bar = "├" + "─" * max(cells - 2, 0) + "┤" if cells > 1 else "│"
        text = ruler_text(length)
        if cells + len(text) + 1 <= columns:
            self._write(column, row, bar, "quiet")
            self._write(column + cells + 1, row, text, "quiet")

    def _ordered(self, outlines: tuple[Outline, ...]) -> list[Outline]:
        """Return the bodies as they are drawn: what is pointed out comes last."""
        return sorted(outlines, key=lambda each: each.solid.link == self.stands_out)

    def _body(self, outline: Outline, pixels: _Pixels) -> None:
        solid = outline.solid
        if solid.shape is None:
            return
        fill = self._fill(outline, outline.facing)
        edge = self.fills.get(solid.link) or self._dimmed(edge_of(solid.rgba), solid.link)
        if outline.radius:
            middle, radius = pixels.at(outline.points[0]), outline.radius * pixels.scale
            thick = 2 * radius >= _THICK
            self.canvas.fill_circle(middle, radius, edge if thick else fill)
            if thick:
                self.canvas.fill_circle(middle, radius - 1, fill)
            return
        points = pixels.of(outline.points)
        xs, ys = [x for x, _ in points], [y for _, y in points]
        thick = min(max(xs) - min(xs), max(ys) - min(ys)) >= _THICK
        self.canvas.fill(points, edge if thick else fill)
        if thick:
            self.canvas.fill(_shrunk(points), fill)
        for face in outline.faces if thick else ():
            self.canvas.fill(_shrunk(pixels.of(face.points)), self._fill(outline, face.facing))

    def _fill(self, outline: Outline, facing: float) -> str:
        solid = outline.solid
        char = self.fills.get(solid.link)
        return char or self._dimmed(lifted(color_of(solid.rgba, facing)), solid.link)

    def _dimmed(self, color: str, link: str) -> str:
        return dimmed(color) if self.stands_out not in ("", link) else color

    def _unknown(self, outlines: tuple[Outline, ...], pixels: _Pixels) -> None:
        """Show where meshes are of which nobody knows how large they are."""
        for outline in outlines:
            if outline.solid.shape is None:
                at = pixels.at(outline.points[0])
                role = "marked" if outline.solid.link == self.marked else "link"
                self._write(int(at.x), int(at.y / 2), UNKNOWN, role)

    def _axes(self, seen: Seen, pixels: _Pixels, place: _Place) -> None:
        """Draw the axes of what moves, then as many of their names as there is room for."""
        moving = [axis for axis in self.scene.axes if axis.type is not JointType.FIXED]
        moving.sort(key=lambda axis: axis.joint != self.marked)
        places = []
        for axis in moving:
            at = pixels.at(seen.view.point(axis.at))
            sign = MIDDLE
            if axis.along is not None:
                sign = axis_sign(seen.view.point(axis.along), seen.view.depth(axis.along))
            role = "marked" if axis.joint == self.marked else "axis"
            places.append((axis.joint, role, (int(at.x), int(at.y / 2)), sign))
        # What is pointed out has its sign over others, and its name before theirs.
        for _, role, cell, sign in reversed(places):
            self._write(*cell, sign, role)
        for joint, role, cell, _ in places:
            may_hide = len(moving) <= _FEW or role == "marked"
            self._name(visible(joint), role, cell, place, may_hide=may_hide)

    def _name(
        self, name: str, role: str, sign: tuple[int, int], place: _Place, *, may_hide: bool
    ) -> None:
        """Write a name beside, above or below a sign, where it hides as little as can be."""
        column, row = sign
        length = width(name)
        if length != len(name):
            return
        places = [
            (column + 2, row), (column - length - 1, row), (column + 1, row - 1),
            (column + 1, row + 1), (column - length, row - 1), (column - length, row + 1),
            (column - length // 2, row - 2), (column - length // 2, row + 2),
        ]  # fmt: skip
        places = [
            (at, line)
            for at, line in places
            if place.row <= line < place.row + place.rows
            and place.column <= at
            and at + length <= place.column + place.columns
        ]
        for over_pixels in (False, True) if may_hide else (False,):
            for at, line in places:
                # A blank on either side keeps names apart.
                if self.canvas.is_free(at - 1, line, length + 2, over_pixels=over_pixels):
                    self._write(at, line, name, role)
                    return

    def _write(self, column: int, row: int, text: str, role: str) -> None:
        self.canvas.write(column, row, in_ascii(text) if self.canvas.ascii_only else text, role)


def _shrunk(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return a convex polygon a pixel smaller on each side."""
    xs, ys = [x for x, _ in points], [y for _, y in points]
    left, right, high, low = min(xs), max(xs), min(ys), max(ys)
    across = max(0.0, 1 - 2 / (right - left)) if right > left else 0.0
    down = max(0.0, 1 - 2 / (low - high)) if low > high else 0.0
    x, y = (left + right) / 2, (high + low) / 2
    return [(x + (one - x) * across, y + (other - y) * down) for one, other in points]
