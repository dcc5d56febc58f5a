"""A robot as an SVG picture: its tree of links and joints, and how it looks from three sides."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.output.graphs.style import MARGIN, number
from plastron_tui.output.graphs.widths import drawable, text_width
from plastron_tui.ros.robots.description import Description

from .captions import joint_text, robot_text
from .rows import tree_rows
from .solids import MeshBounds, no_bounds, scene_of
from .svg_style import STYLE
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


def robot_svg(robot: Description, mesh_bounds: MeshBounds = no_bounds) -> SvgRobot:
    """Return the picture of a robot."""
    scene = scene_of(robot, mesh_bounds)
    tree, views = tree_svg(robot, scene), views_svg(scene)
    title = robot_text(robot.name, len(robot.links), len(robot.joints))
    head = drawable(title)
    lines = (
        f'<g class="robot"><title>{escaped(title)}</title>',
        text("head", 0, 15, head),
        f'<g class="tree" transform="translate(0 {number(_HEAD)})">',
        *tree.lines,
        "</g>",
        f'<g class="views" transform="translate({number(tree.width + _GAP)} 0)">',
        *views.lines,
        "</g>",
        "</g>",
    )
    width = max(tree.width + _GAP + views.width, text_width(head, _SIZE, bold=True))
    height = max(tree.height + _HEAD, views.height)
    return SvgRobot(lines, width, height, title, _in_words(robot))


def render(robot: Description, mesh_bounds: MeshBounds = no_bounds) -> str:
    """Return a picture as a document.

    It is the same for the same robot, has its own background in light and in dark, and says
    everything in `title` and `desc` elements too.
    """
    made = robot_svg(robot, mesh_bounds)
    width, height = made.width + 2 * MARGIN, made.height + 2 * MARGIN
    size = f'width="{number(width)}" height="{number(height)}"'
    from plastron_tui.output.graphs.style import STYLE as GRAPH_STYLE

    return "\n".join((
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 {number(width)} '
        f'{number(height)}" role="img" aria-labelledby="title desc">',
        f'<title id="title">{escaped(made.title)}</title>',
        f'<desc id="desc">{escaped(made.description)}</desc>',
        GRAPH_STYLE,
        STYLE,
        f'<rect class="paper" {size} rx="10"/>',
        f'<g transform="translate({number(MARGIN)} {number(MARGIN)})">',
        *made.lines,
        "</g>",
        "</svg>\n",
    ))  # fmt: skip


def _in_words(robot: Description) -> str:
    parts = []
    for row in tree_rows(robot):
        if row.joint is not None:
            joint = row.joint
            parts.append(
                f"{visible(joint.name)} ({joint_text(joint)}) from {visible(joint.parent)} "
                f"to {visible(joint.child)}"
            )
    return "; ".join(parts) or robot_text(robot.name, len(robot.links), len(robot.joints))
