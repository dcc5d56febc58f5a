"""The tree of a robot in characters."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf

from plastron_tui.diagnostics.terminal import visible, width
from plastron_tui.ros.robots.description import Description

from .captions import joint_text, link_text, robot_text
from .rows import TreeRow, lead, tree_rows, unheld
from .runs import Run, RunLine, RunLines, fitted
from .shades import color_of, lifted
from .solids import Scene
from .text_marks import fill_chars, in_ascii

_MOST_PADDED = 26
"""One long name does not push everybody's caption away."""

_NARROW = 26
"""With fewer columns beside the links only the types of joints are told."""


def tree_width(robot: Description) -> int:
    """Return how wide a tree has to be that no row and no title is cut off."""
    rows = tree_rows(robot)
    pad = _padding(rows)
    lines = (_line(robot, row, pad, {}, "", False, inf) for row in rows)
    title = robot_text(robot.name, len(robot.links), len(robot.joints))
    return max([width(title), *(sum(width(run.text) for run in line) for line in lines)])


def draw_tree(
    robot: Description,
    scene: Scene,
    columns: int,
    height: int,
    marked: str,
    ascii_only: bool,
) -> tuple[RunLines, tuple[str, ...]]:
    """Return a tree, and for each line the link that it has, "" for none.

    What there is no room for is counted; the row that is marked is among those that are shown.
    """
    rows = tree_rows(robot)
    pad = _padding(rows)
    title = robot_text(robot.name, len(robot.links), len(robot.joints))
    head: list[tuple[RunLine, str]] = [((Run(title, "title"),), "")]
    colors = fill_chars(scene.links) if ascii_only else _colors(scene)
    body = [(_line(robot, row, pad, colors, marked, ascii_only, columns), row.link) for row in rows]
    lost = unheld(robot, rows)
    body += [((Run(f"{visible(name)}  held by nothing", "quiet"),), name) for name in lost]
    at = next((n for n, row in enumerate(rows) if _is_marked(row, marked)), 0)
    shown = [*head, *_window(body, height - len(head), at)][:height]
    shown += [((), "")] * (height - len(shown))
    lines = [line for line, _ in shown]
    if ascii_only:
        lines = [tuple(run._replace(text=in_ascii(run.text)) for run in line) for line in lines]
    fit = tuple(fitted(line, columns, "~" if ascii_only else "…") for line in lines)
    return fit, tuple(link for _, link in shown)


def _padding(rows: list[TreeRow]) -> int:
    wide = (_indent(row) + width(visible(row.link)) for row in rows)
    return max((each for each in wide if each <= _MOST_PADDED), default=0)


def _indent(row: TreeRow) -> int:
    """Return where the sign of a row is: a lane has two columns."""
    return 2 * row.lane + (2 if row.is_only else 0)


def _line(
    robot: Description,
    row: TreeRow,
    pad: int,
    colors: dict[str, str],
    marked: str,
    ascii_only: bool,
    room: float,
) -> RunLine:
    sign = colors.get(row.link, " ") if ascii_only else "■"
    swatch = Run(sign, "link", "" if ascii_only else colors.get(row.link, ""))
    name = visible(row.link)
    lines = lead(row)
    blank = " " * max(0, pad - width(lines) - width(name))
    role = _role(row.link, marked, "link")
    runs = [Run(lines, "quiet"), swatch, Run(f" {name}", role), Run(f"{blank}  ")]
    if row.joint is not None:
        role = _role(row.joint.name, marked, "joint")
        if room - pad < _NARROW:
            runs.append(Run(row.joint.type.value, role))
        else:
            runs += [Run(visible(row.joint.name), role), Run(f"  {joint_text(row.joint)}", "quiet")]
    else:
        runs.append(Run(link_text(robot.links[row.link]), "quiet"))
    return tuple(run for run in runs if run.text)


def _role(name: str, marked: str, role: str) -> str:
    return "marked" if marked and name == marked else role


def _is_marked(row: TreeRow, marked: str) -> bool:
    return marked == row.link or (row.joint is not None and marked == row.joint.name)


def _colors(scene: Scene) -> dict[str, str]:
    found: dict[str, str] = {}
    for solid in scene.solids:
        found.setdefault(solid.link, lifted(color_of(solid.rgba)))
    return found


def _window(body: list[tuple[RunLine, str]], room: int, at: int) -> Iterator[tuple[RunLine, str]]:
    """Yield as many rows as there is room for, with one of them among them."""
    if len(body) <= room:
        yield from body
        return
    if room < 3:
        yield from body[at : at + max(room, 0)]
        return
    start = min(max(0, at - room // 2), len(body) - room)
    end = start + room
    if start:
        yield (Run(f"… {start + 1} more", "quiet"),), ""
        start += 1
    if end < len(body):
        yield from body[start : end - 1]
        yield (Run(f"… {len(body) - end + 1} more", "quiet"),), ""
    else:
        yield from body[start:end]
