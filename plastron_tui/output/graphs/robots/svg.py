"""A robot as an SVG picture: its tree of links and joints, and how it looks from three sides."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.model.graph import GraphRobot
from plastron_tui.output.graphs.style import number
from plastron_tui.output.graphs.widths import drawable, text_width
from plastron_tui.ros.robots.description import Description

from .captions import joint_text
from .listing import robot_title
from .rows import tree_rows
from .solids import scene_of
from .svg_text import escaped, text
from .svg_tree import tree_svg
from .svg_views import views_svg

_HEAD = 38.0
_GAP = 48.0
_SIZE = 15.0


class SvgRobot(NamedTuple):
    """A robot's picture, to be put into a document that has `STYLE`.

    Attributes:
        lines: its elements, from 0, 0 on.
        width: how wide it is, in pixels.
        height: how high.
        title: what it is, in a line.
        description: what it shows, in words.
    """

    lines: tuple[str, ...]
    width: float
    height: float
    title: str
    description: str


def robot_svg(shown: GraphRobot) -> SvgRobot:
    """Return the picture of a robot."""
    robot = shown.description
    scene = scene_of(robot, shown.meshes.get)
    tree = tree_svg(robot, scene)
    views = views_svg(scene, tree.height)
    title = robot_title(shown)
    head = drawable(title)
    lines = (
        f'<g class="robot"><title>{escaped(title)}</title>',
        text("head", 0, 15, head),
        f'<g class="tree" transform="translate(0 {number(_HEAD)})">',
        *tree.lines,
        "</g>",
        f'<g class="views" transform="translate({number(tree.width + _GAP)} {number(_HEAD)})">',
        *views.lines,
        "</g>",
        "</g>",
    )
    width = max(tree.width + _GAP + views.width, text_width(head, _SIZE, bold=True))
    height = max(tree.height, views.height) + _HEAD
    return SvgRobot(lines, width, height, title, _in_words(robot))


def _in_words(robot: Description) -> str:
    parts = []
    for row in tree_rows(robot):
        if row.joint is not None:
            joint = row.joint
            parts.append(
                f"{visible(joint.name)} ({joint_text(joint)}) from {visible(joint.parent)} "
                f"to {visible(joint.child)}"
            )
    return "; ".join(parts) or ", ".join(map(visible, robot.links))
