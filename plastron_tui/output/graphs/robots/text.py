"""How a robot looks in characters, from one side or from all three."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.ros.robots.description import Description

from .runs import RunLines
from .scales import Seen, seen_from_all
from .solids import MeshBounds, Scene, no_bounds, scene_of
from .text_views import draw_view, draw_views

_VIEWS_WIDTH, _VIEWS_HEIGHT = 46, 17
"""From this size on there is room for all views."""

_CORNERS = 12
"""Of a circle that is seen at an angle: more are not told apart."""


class Sides(NamedTuple):
    """A robot from all sides, before anybody says how large it is drawn."""

    scene: Scene
    seen: tuple[Seen, ...]


def look_at(robot: Description, mesh_bounds: MeshBounds = no_bounds) -> Sides:
    """Return a robot from all sides: half of the work of drawing it, whatever is marked in it.

    Args:
        robot: the robot; one that is not a tree yet is drawn as far as it is one.
        mesh_bounds: tells how large meshes are.
    """
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
    """Return what a robot looks like in characters, just so wide and so high.

    Args:
        sides: the robot.
        width: how many columns there are.
        height: how many lines.
        view: the `key` of one of `VIEWS`, to have that alone; "" for all of them if there is room,
            which is from 46 by 17 on, and else for the one that shows most.
        marked: the link or joint to point out.
        ascii_only: whether there is nothing but ASCII, and no colours.
    """
    width, height = max(width, 1), max(height, 1)
    scene, seen = sides
    chosen = next((side for side in seen if side.view.key == view), None)
    if chosen is None and width >= _VIEWS_WIDTH and height >= _VIEWS_HEIGHT:
        return draw_views(scene, seen, width, height, marked, ascii_only)
    return draw_view(scene, chosen or _best(seen), width, height, marked, ascii_only)


def _best(sides: tuple[Seen, ...]) -> Seen:
    """Return the side from which one sees most of a robot."""
    return max(sides, key=lambda side: side.frame.width * side.frame.height)
