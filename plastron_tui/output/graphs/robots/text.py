"""A robot in characters: its tree, and how it looks from three sides."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.ros.robots.description import Description

from .runs import Run, RunLine, RunLines
from .scales import Seen, seen_from_all
from .solids import MeshBounds, Scene, no_bounds, scene_of
from .text_tree import draw_tree, tree_width
from .text_views import draw_view, draw_views

_ALL_WIDTH, _ALL_HEIGHT = 110, 28
"""From this size on there is room for the tree and all views."""

_TWO_WIDTH, _TWO_HEIGHT = 60, 14
"""From one of these on there is room for the tree and one view, beside or below each other."""

_VIEWS_WIDTH, _VIEWS_HEIGHT = 46, 17
"""From this size on there is room for all views."""

_TREE_WIDTH = 36
_GAP = 2

_CORNERS = 12
"""Of a circle that is seen at an angle: more are not told apart."""


class TextPicture(NamedTuple):
    """A robot in characters.

    Attributes:
        lines: as many lines as were asked for, each as wide.
        links: for each line the link whose row of the tree it has, "" for none.
        view: the view that is shown alone: `tree`, `top`, `side` or `front`; "" where several are.
    """

    lines: RunLines
    links: tuple[str, ...]
    view: str


def render_text(
    robot: Description,
    width: int,
    height: int,
    *,
    view: str = "",
    marked: str = "",
    mesh_bounds: MeshBounds = no_bounds,
    ascii_only: bool = False,
) -> TextPicture:
    """Return a robot in characters, just so wide and so high.

    Args:
        robot: the robot; one that is not a tree yet is drawn as far as it is one.
        width: how many columns there are.
        height: how many lines.
        view: what is shown alone: `tree`, or the `key` of one of `VIEWS`; "" for as much as there
            is room for: all of it from 110 by 28 on, the tree and one view from 60 by 14 on.
        marked: the link or joint to point out: the rest stands back, and the tree shows its row.
        mesh_bounds: tells how large meshes are.
        ascii_only: whether there is nothing but ASCII, and no colours.
    """
    width, height = max(width, 1), max(height, 1)
    scene = scene_of(robot, mesh_bounds)
    how = _How(robot, scene, marked, ascii_only)
    if view == "tree" or not robot.links:
        lines, links = how.tree(width, height)
        return TextPicture(lines, links, "tree")
    sides = seen_from_all(scene, _CORNERS)
    for side in sides:
        if side.view.key == view:
            return TextPicture(how.side(side, width, height), ("",) * height, view)
    wide = min(tree_width(robot), max(width * 2 // 5, min(width // 2, _TREE_WIDTH)))
    if width >= _ALL_WIDTH and height >= _ALL_HEIGHT:
        lines, links = how.tree(wide, height)
        views = draw_views(scene, sides, width - wide - _GAP, height, marked, ascii_only)
        return TextPicture(_beside(lines, views), links, "")
    best = _best(sides)
    if width >= _TWO_WIDTH:
        lines, links = how.tree(wide, height)
        return TextPicture(_beside(lines, how.side(best, width - wide - _GAP, height)), links, "")
    if height >= _TWO_HEIGHT:
        low = min(len(robot.links) + 1, height // 2)
        lines, links = how.tree(width, low)
        upper = how.side(best, width, height - low)
        return TextPicture((*upper, *lines), (*[""] * len(upper), *links), "")
    lines, links = how.tree(width, height)
    return TextPicture(lines, links, "tree")


def render_views(
    robot: Description,
    width: int,
    height: int,
    *,
    view: str = "",
    marked: str = "",
    mesh_bounds: MeshBounds = no_bounds,
    ascii_only: bool = False,
) -> RunLines:
    """Return what a robot looks like in characters, without its tree, just so wide and so high.

    Args:
        robot: the robot.
        width: how many columns there are.
        height: how many lines.
        view: the `key` of one of `VIEWS`, to have that alone; "" for all of them if there is room,
            which is from 46 by 17 on, and else for the one that shows most.
        marked: the link or joint to point out.
        mesh_bounds: tells how large meshes are.
        ascii_only: whether there is nothing but ASCII, and no colours.
    """
    sides = look_at(robot, mesh_bounds)
    return draw_sides(sides, width, height, view=view, marked=marked, ascii_only=ascii_only)


class Sides(NamedTuple):
    """A robot from all sides, before anybody says how large it is drawn."""

    scene: Scene
    seen: tuple[Seen, ...]


def look_at(robot: Description, mesh_bounds: MeshBounds = no_bounds) -> Sides:
    """Return a robot from all sides: half of the work of drawing it, whatever is marked in it."""
    scene = scene_of(robot, mesh_bounds)
    return Sides(scene, seen_from_all(scene, _CORNERS))


def draw_sides(
    sides: Sides,
    width: int,
    height: int,
    *,
    view: str = "",
    marked: str = "",
    ascii_only: bool = False,
) -> RunLines:
    """Return what `render_views` does of a robot that was looked at before."""
    width, height = max(width, 1), max(height, 1)
    scene, seen = sides
    chosen = next((side for side in seen if side.view.key == view), None)
    if chosen is None and width >= _VIEWS_WIDTH and height >= _VIEWS_HEIGHT:
        return draw_views(scene, seen, width, height, marked, ascii_only)
    return draw_view(scene, chosen or _best(seen), width, height, marked, ascii_only)


def _best(sides: tuple[Seen, ...]) -> Seen:
    """Return the side from which one sees most of a robot."""
    return max(sides, key=lambda side: side.frame.width * side.frame.height)


class _How(NamedTuple):
    """What is drawn, and how."""

    robot: Description
    scene: Scene
    marked: str
    ascii_only: bool

    def tree(self, width: int, height: int) -> tuple[RunLines, tuple[str, ...]]:
        return draw_tree(self.robot, self.scene, width, height, self.marked, self.ascii_only)

    def side(self, side: Seen, width: int, height: int) -> RunLines:
        return draw_view(self.scene, side, width, height, self.marked, self.ascii_only)


def _beside(left: RunLines, right: RunLines) -> RunLines:
    blank: RunLine = (Run(" " * _GAP),)
    return tuple((*one, *blank, *other) for one, other in zip(left, right, strict=True))
