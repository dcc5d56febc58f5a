"""A robot in characters: as large as is asked for, in colours or in ASCII, the marked part seen."""

from __future__ import annotations

from typing import Any

import pytest
from drawn_robots import RobotMaker, hostile_robots, rover
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples

from plastron_tui.diagnostics.terminal import width
from plastron_tui.output.graphs.robots.runs import ROLES, RunLines
from plastron_tui.output.graphs.robots.solids import scene_of
from plastron_tui.output.graphs.robots.text import draw_sides, look_at
from plastron_tui.ros.robots.description import Box, Description, JointType, Mesh, Pose


def drawn(robot: Description, columns: int, rows: int, **how: Any) -> RunLines:
    return draw_sides(look_at(robot), columns, rows, **how)


def texts(lines: RunLines) -> list[str]:
    return ["".join(run.text for run in line) for line in lines]


def check_size(lines: RunLines, columns: int, rows: int) -> None:
    assert len(lines) == rows
    for line in lines:
        assert sum(width(run.text) for run in line) == columns
        assert all(run.role in ROLES for run in line)


_sizes = st.tuples(st.integers(1, 130), st.integers(1, 40))


@settings(max_examples=examples(200), deadline=None)
@given(hostile_robots(), _sizes, st.sampled_from(("", "side", "top", "front")), st.booleans())
def test_a_picture_of_any_robot_has_the_size_that_is_asked_for(
    robot: Description, size: tuple[int, int], view: str, ascii_only: bool
) -> None:
    columns, rows = size
    marked = next(iter(robot.links), "")
    lines = drawn(robot, columns, rows, view=view, marked=marked, ascii_only=ascii_only)
    check_size(lines, columns, rows)
    assert "".join(texts(lines)).isprintable()
    if ascii_only:
        assert "".join(texts(lines)).isascii()
        assert not any(run.color or run.behind for line in lines for run in line)


@pytest.mark.parametrize(
    ("columns", "rows", "views"), [(200, 50, 3), (46, 17, 3), (45, 17, 1), (46, 16, 1), (1, 1, 0)]
)
def test_as_much_is_shown_as_there_is_room_for(columns: int, rows: int, views: int) -> None:
    lines = drawn(rover(), columns, rows)
    check_size(lines, columns, rows)
    whole = "\n".join(texts(lines))
    assert sum(f"{name}  {axes}" in whole for name, axes in _VIEWS) == views


_VIEWS = (("top", "x→ y↑"), ("right side", "x→ z↑"), ("front", "y→ z↑"))


def test_a_box_in_ascii() -> None:
    make = RobotMaker()
    make.link("body", Box((4, 4, 2)))
    make.link("lid", Box((2, 2, 1)))
    make.joint("slide", "body", "lid", JointType.PRISMATIC, Pose((0, 0, 1.5)), (1, 0, 0))
    lines = texts(drawn(make.robot, 28, 10, view="side", ascii_only=True))
    assert [line.rstrip() for line in lines] == [
        "right side  x> z^",
        "            slide",
        "          %%%%%%%%",
        "          %%%%>%%%",
        "      ################",
        "      ################",
        "      ################",
        "      ################",
        "",
        "+------| 2 m",
    ]


def test_what_is_marked_stands_out() -> None:
    plain = drawn(rover(), 60, 20, view="front")
    marked = drawn(rover(), 60, 20, view="front", marked="head")

    def colors(lines: RunLines) -> set[str]:
        return {color for line in lines for run in line for color in (run.color, run.behind)}

    def is_blue(color: str) -> bool:
        return color != "" and int(color[5:], 16) > 0x90 and int(color[1:3], 16) < 0x30

    assert any(map(is_blue, colors(plain) & colors(marked)))
    orange = "#ff9900"
    assert orange in colors(plain) and orange not in colors(marked)
    by_joint = drawn(rover(), 60, 20, view="front", marked="zoom")
    assert "zoom" in [run.text for line in by_joint for run in line if run.role == "marked"]
    assert orange in colors(by_joint)


@pytest.mark.parametrize("marked", ["pan", "tilt"])
def test_of_joints_in_one_place_the_marked_one_is_seen(marked: str) -> None:
    make = RobotMaker()
    for name in ("base", "neck", "head"):
        make.link(name, Box((1, 1, 1)))
    make.joint("pan", "base", "neck", JointType.REVOLUTE, Pose((0, 0, 1)), (0, 0, 1))
    make.joint("tilt", "neck", "head", JointType.REVOLUTE, Pose((0, 0, 0)), (0, 1, 0))
    lines = drawn(make.robot, 30, 14, view="side", marked=marked)
    found = "".join(run.text for line in lines for run in line if run.role == "marked")
    assert sorted(found) == sorted(marked + ("↑" if marked == "pan" else "⊗"))


def test_a_link_that_a_loose_joint_holds_too_is_where_the_first_one_has_it() -> None:
    make = RobotMaker()
    for name in ("base", "arm", "a", "b"):
        make.link(name, Box((1, 1, 1)))
    make.joint("hold", "base", "arm", JointType.REVOLUTE, Pose((0, 0, 1)))
    make.joint("again", "a", "arm", JointType.REVOLUTE)
    make.joint("one", "a", "b")
    make.joint("other", "b", "a")
    scene = scene_of(make.robot)
    assert [axis.joint for axis in scene.axes] == ["hold"]
    assert scene.missing == ("a", "b")


def test_a_mesh_of_unknown_size_has_a_sign_and_holds_on_to_the_others() -> None:
    make = RobotMaker()
    make.link("base", Mesh("a.stl"))
    make.link("arm", Mesh("b.stl"))
    make.joint("lift", "base", "arm", JointType.REVOLUTE, Pose((0, 0, 1)), (0, 0, 1))
    lines = texts(drawn(make.robot, 30, 14, view="side", ascii_only=True))
    whole = "\n".join(lines)
    assert whole.count("?") == 1 and "^" in whole and whole.count(".") > 5
