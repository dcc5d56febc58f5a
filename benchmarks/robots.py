"""How long pictures of robots take, against finding where the links are, and with their number."""

from __future__ import annotations

from collections.abc import Iterator
from math import sin

from plastron_tui.diagnostics import Span
from plastron_tui.model.graph import Graph, GraphRobot
from plastron_tui.output.graphs import svg
from plastron_tui.output.graphs.robots.text import draw_sides, look_at
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Description,
    Joint,
    JointType,
    Link,
    Material,
    Pose,
    Sphere,
    Vector,
)
from plastron_tui.ros.robots.transforms import placed

from .row import Row, paired

_RUNS = 15
_SHAPES = (Box((0.1, 0.2, 0.1)), Cylinder(0.05, 0.2), Sphere(0.08))


def rows() -> Iterator[Row]:
    robot = many_links(60)
    drawn, found, ratio = paired(
        lambda: draw_sides(look_at(robot), 200, 50),
        lambda: [placed(robot) for _ in range(10)],
        _RUNS,
    )
    yield Row(
        "60 links in characters, three views, 200 by 50 / where they are, ten times",
        ratio,
        10,
        detail=f"{drawn * 1e3:.1f} ms / {found * 1e3:.1f} ms",
    )
    large = many_links(480)
    long, short, ratio = paired(lambda: _svg(large), lambda: [_svg(robot) for _ in range(8)], 5)
    yield Row(
        "480 links as SVG / 60 links, eight times",
        ratio,
        2.5,
        detail=f"{long * 1e3:.0f} ms / {short * 1e3:.0f} ms",
    )


def many_links(count: int) -> Description:
    """Return a robot whose links are turned every way, each third a branch of its own."""
    links, joints = {}, {}
    for at in range(count):
        color = Material(f"color {at % 7}", (at % 3 / 2, at % 5 / 4, at % 7 / 6, 1.0))
        body = Body(_SHAPES[at % 3], Pose(), color)
        links[f"link_{at}"] = Link(f"link_{at}", (body,))
        if at:
            turned: Vector = (sin(at), sin(2 * at), sin(3 * at))
            joints[f"joint_{at}"] = Joint(
                f"joint_{at}",
                JointType.FIXED if at % 4 == 0 else JointType.REVOLUTE,
                f"link_{max(0, at - 1 - at % 3)}",
                f"link_{at}",
                Pose((0.2, 0.1 * sin(at), 0.1), turned),
                (0.0, 0.0, 1.0),
            )
    return Description("many", links, joints)


def _svg(robot: Description) -> str:
    shown = GraphRobot(robot.name, robot.name, None, False, Span(0, 0), robot)
    return svg.render(Graph((), dict.fromkeys(InterfaceKind, ()), (shown,)))
