"""The tree of a robot as SVG: a row for each link, the root first."""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil, sqrt
from typing import NamedTuple

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.output.graphs.style import number
from plastron_tui.output.graphs.widths import broken, drawable, text_width
from plastron_tui.ros.robots.description import Description, Joint, JointType, Rgba

from .captions import joint_text, link_text
from .rows import TreeRow, tree_rows, unheld
from .shades import color_of
from .solids import Scene
from .svg_text import escaped, text

_ROW = 33.0
_LANE = 18.0
_SPOT = 5.5
_ROOM = 340.0
"""How wide a line of text may be."""

_GAP = 10.0
_COLUMN_GAP = 34.0
_NAME, _SAID = 12.5, 10.5
_ABOVE, _BEND = -4.0, 5.0
_FEW = 40
"""So many rows stand in one column."""

_SHAPE = 1.7
"""How much wider than high a tree of many columns is."""


class _Line(NamedTuple):
    """A piece of a line of text: what it is and what it says."""

    kind: str
    text: str
    width: float


class SvgTree(NamedTuple):
    """A tree, and how large it is."""

    lines: tuple[str, ...]
    width: float
    height: float


def tree_svg(robot: Description, scene: Scene) -> SvgTree:
    """Return the tree of a robot; one of many links stands in several columns."""
    rows = tree_rows(robot)
    texts = [_texts(robot, row) for row in rows]
    widths = [
        row.lane * _LANE + 2 * _SPOT + 8 + max(map(_width, lines))
        for row, lines in zip(rows, texts, strict=True)
    ]
    most = _rows_a_column(len(rows), max(widths, default=0.0))
    found: list[str] = []
    left = height = 0.0
    for start in range(0, len(rows), most):
        part = range(start, min(start + most, len(rows)))
        found += _column(rows, texts, part, left, scene)
        left += max(widths[at] for at in part) + _COLUMN_GAP
        height = max(height, len(part) * _ROW)
    lost = unheld(robot, rows)
    if lost:
        names = ", ".join(visible(name) for name in lost)
        for line in broken(drawable(f"held by nothing: {names}"), _SAID, _ROOM, 3):
            height += 15
            found.append(text("alarm", 0, height, line))
            left = max(left, text_width(line, _SAID) + _COLUMN_GAP)
    return SvgTree(tuple(found), max(left - _COLUMN_GAP, 0.0), height)


def _rows_a_column(count: int, width: float) -> int:
    if count <= _FEW:
        return _FEW
    # count / rows columns of `width` are `_SHAPE` times as wide as rows are high
    most = max(_FEW, ceil(sqrt(count * (width + _COLUMN_GAP) / (_SHAPE * _ROW))))
    # The columns are about as long as each other.
    return ceil(count / ceil(count / most))


def _texts(robot: Description, row: TreeRow) -> tuple[list[_Line], list[_Line]]:
    link = robot.links[row.link]
    first = _line([("link", row.link, _NAME), ("said", link_text(link), _SAID)])
    joint = row.joint
    if joint is None:
        return first, []
    kind = "firm" if joint.type is JointType.FIXED else "joint"
    return first, _line([(kind, joint.name, _SAID), ("said", joint_text(joint), _SAID)])


def _line(parts: list[tuple[str, str, float]]) -> list[_Line]:
    found: list[_Line] = []
    texts = [drawable(visible(words)) for _, words, _ in parts]
    wanted = text_width(texts[1], parts[1][2])
    # What follows a long name has a third of the room, if it needs that.
    rooms = (_ROOM - min(wanted + _GAP, _ROOM * 0.3), _ROOM)
    left = _ROOM
    for (kind, _, size), words, room in zip(parts, texts, rooms, strict=True):
        bold = kind == "link"
        shown = broken(words, size, max(min(room, left), 40.0), 1, bold=bold)[0]
        if shown:
            wide = text_width(shown, size, bold=bold)
            found.append(_Line(kind, shown, wide))
            left -= wide + _GAP
    return found


def _short(name: str) -> str:
    return broken(drawable(visible(name)), _SAID, _ROOM * 0.68, 1)[0]


def _width(line: list[_Line]) -> float:
    return sum(piece.width + _GAP for piece in line)


def _column(
    rows: list[TreeRow],
    texts: list[tuple[list[_Line], list[_Line]]],
    part: range,
    left: float,
    scene: Scene,
) -> Iterator[str]:
    """Yield a column: lines first, then what stands on them."""
    middles = [(at + 0.5) * _ROW for at in range(len(part))]
    first = rows[part.start].joint
    if first is not None:
        yield text("said", left + 2 * _SPOT + 8, _ABOVE, f"below {_short(first.parent)}")
    for at, y in zip(part, middles, strict=True):
        yield from _rails(rows[at], left + _SPOT, y, _ABOVE if at == part.start else y - _ROW)
    colors: dict[str, Rgba | None] = {}
    for solid in scene.solids:
        colors.setdefault(solid.link, solid.rgba)
    for at, y in zip(part, middles, strict=True):
        yield from _row(rows[at], texts[at], left + rows[at].lane * _LANE + _SPOT, y, colors)


def _rails(row: TreeRow, left: float, y: float, above: float) -> Iterator[str]:
    """Yield the lines that lead to a row from the one above, and past it."""
    for lane in row.rails:
        # Whose line this is, is one of the rows below.
        yield _rail(None, f"M{_xy(left + lane * _LANE, above)}V{number(y)}")
    if row.joint is None:
        return
    x = left + row.lane * _LANE
    if row.is_only:
        yield _rail(row.joint, f"M{_xy(x, above)}V{number(y)}")
        return
    trunk = x - _LANE
    if not row.is_last:
        yield _rail(None, f"M{_xy(trunk, above)}V{number(y)}")
    bend = f"Q{_xy(trunk, y)} {_xy(trunk + _BEND, y)}H{number(x)}"
    start = number(y - _BEND) if not row.is_last else f"{number(above)}V{number(y - _BEND)}"
    yield _rail(row.joint, f"M{number(trunk)} {start}{bend}")


def _row(
    row: TreeRow,
    texts: tuple[list[_Line], list[_Line]],
    x: float,
    y: float,
    colors: dict[str, Rgba | None],
) -> Iterator[str]:
    joint = row.joint
    title = "" if joint is None else f": {joint.name}, {joint_text(joint)}"
    yield f"<g><title>{escaped(row.link + title)}</title>"
    yield _spot(x, y, row.link, colors)
    baselines = (y - 3, y + 10.5) if joint is not None else (y + 4, y)
    for line, baseline in zip(texts, baselines, strict=True):
        across = x + _SPOT + 8
        for piece in line:
            yield text(piece.kind, across, baseline, piece.text)
            across += piece.width + _GAP
    yield "</g>"


def _spot(x: float, y: float, link: str, colors: dict[str, Rgba | None]) -> str:
    rgba = colors.get(link)
    fill = "" if rgba is None else f' fill="{color_of(rgba)}"'
    kind = "" if rgba is not None else " plain" if link in colors else " none"
    place = f'cx="{number(x)}" cy="{number(y)}" r="{number(_SPOT)}"'
    return f'<circle class="spot{kind}" {place}{fill}/>'


def _rail(joint: Joint | None, path: str) -> str:
    moves = joint is not None and joint.type is not JointType.FIXED
    return f'<path class="rail{" moves" if moves else ""}" d="{path}"/>'


def _xy(x: float, y: float) -> str:
    return f"{number(x)} {number(y)}"
