"""A robot in characters: as large as is asked for, in colours or in ASCII, the marked part seen."""

from __future__ import annotations

import pytest
from drawn_robots import RobotMaker, hostile_robots, many_links, rover
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples

from plastron_tui.diagnostics.terminal import width
from plastron_tui.output.graphs.robots.runs import ROLES, RunLines, fitted, text_of
from plastron_tui.output.graphs.robots.runs import Run as Piece
from plastron_tui.output.graphs.robots.text import render_text, render_views
from plastron_tui.ros.robots.description import Box, Description, JointType, Mesh, Pose


def texts(lines: RunLines) -> list[str]:
    return [text_of(line) for line in lines]


def check_size(lines: RunLines, columns: int, rows: int) -> None:
    assert len(lines) == rows
    for line in lines:
        assert sum(width(run.text) for run in line) == columns
        assert all(run.role in ROLES for run in line)


_sizes = st.tuples(st.integers(1, 130), st.integers(1, 40))


@settings(max_examples=examples(200), deadline=None)
@given(hostile_robots(), _sizes, st.sampled_from(("", "tree", "top", "front")), st.booleans())
def test_a_picture_of_any_robot_has_the_size_that_is_asked_for(
    robot: Description, size: tuple[int, int], view: str, ascii_only: bool
) -> None:
    columns, rows = size
    marked = next(iter(robot.links), "")
    made = render_text(robot, columns, rows, view=view, marked=marked, ascii_only=ascii_only)
    check_size(made.lines, columns, rows)
    assert len(made.links) == rows and set(made.links) <= {"", *robot.links}
    assert "".join(texts(made.lines)).isprintable()
    if ascii_only:
        assert "".join(texts(made.lines)).isascii()
        assert not any(run.color or run.behind for line in made.lines for run in line)


@pytest.mark.parametrize(
    ("columns", "rows", "tree", "views"),
    [
        (80, 24, True, 1),
        (200, 50, True, 3),
        (110, 28, True, 3),
        (40, 24, True, 1),
        (40, 10, True, 0),
    ],
)
def test_as_much_is_shown_as_there_is_room_for(
    columns: int, rows: int, tree: bool, views: int
) -> None:
    made = render_text(rover(), columns, rows)
    check_size(made.lines, columns, rows)
    whole = "\n".join(texts(made.lines))
    assert ("rover: 8 links, 7 joints" in whole) is tree
    assert sum(f"{name}  {axes}" in whole for name, axes in _VIEWS) == views
    assert made.view == ("" if views else "tree")


_VIEWS = (("top", "x→ y↑"), ("right side", "x→ z↑"), ("front", "y→ z↑"))


def test_the_tree() -> None:
    made = render_text(rover(), 72, 9, view="tree")
    assert [line.rstrip() for line in texts(made.lines)] == [
        "rover: 8 links, 7 joints",
        "■ base_link",
        "↓ ■ chassis      base  fixed",
        "├ ■ left_wheel   left_axle  continuous about y",
        "├ ■ right_wheel  right_axle  continuous about y",
        "├ ■ caster       caster_mount  fixed",
        "└ ■ mast         mast_mount  fixed",
        "  ↓ ■ head       pan  revolute about z · -90° to 90°",
        "  ↓ ■ lens       zoom  prismatic along x · 0 to 0.02 m",
    ]
    assert made.links == ("", *rover().links)


def test_a_box_in_ascii() -> None:
    make = RobotMaker()
    make.link("body", Box((4, 4, 2)))
    make.link("lid", Box((2, 2, 1)))
    make.joint("slide", "body", "lid", JointType.PRISMATIC, Pose((0, 0, 1.5)), (1, 0, 0))
    lines = texts(render_views(make.robot, 28, 10, view="side", ascii_only=True))
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


@pytest.mark.parametrize("part", ["link_40", "joint_40"])
def test_a_tree_that_is_too_long_shows_the_row_of_what_is_marked(part: str) -> None:
    robot = many_links(60)
    made = render_text(robot, 60, 12, view="tree", marked=part)
    assert "link_40" in made.links
    [run] = [run for line in made.lines for run in line if run.role == "marked"]
    assert run.text.strip() == part
    counted = [int(line.split()[1]) for line in texts(made.lines) if line.startswith("…")]
    assert sum(counted) + sum(map(bool, made.links)) == 60


def test_what_is_marked_stands_out() -> None:
    plain = render_views(rover(), 60, 20, view="front")
    marked = render_views(rover(), 60, 20, view="front", marked="head")

    def colors(lines: RunLines) -> set[str]:
        return {color for line in lines for run in line for color in (run.color, run.behind)}

    def is_blue(color: str) -> bool:
        return color != "" and int(color[5:], 16) > 0x90 and int(color[1:3], 16) < 0x30

    assert any(map(is_blue, colors(plain) & colors(marked)))
    orange = "#ff9900"
    assert orange in colors(plain) and orange not in colors(marked)
    by_joint = render_views(rover(), 60, 20, view="front", marked="zoom")
    assert "zoom" in [run.text for line in by_joint for run in line if run.role == "marked"]
    assert orange in colors(by_joint)


def test_a_mesh_of_unknown_size_has_a_sign_and_holds_on_to_the_others() -> None:
    make = RobotMaker()
    make.link("base", Mesh("a.stl"))
    make.link("arm", Mesh("b.stl"))
    make.joint("lift", "base", "arm", JointType.REVOLUTE, Pose((0, 0, 1)), (0, 0, 1))
    lines = texts(render_views(make.robot, 30, 14, view="side", ascii_only=True))
    whole = "\n".join(lines)
    assert whole.count("?") == 1 and "^" in whole and whole.count(".") > 5


def test_lines_are_cut_and_filled() -> None:
    line = (Piece("ab", "link"), Piece("漢字", "joint"))
    assert text_of(fitted(line, 8)) == "ab漢字  "
    assert text_of(fitted(line, 6)) == "ab漢字"
    # A character of two columns does not fit in one.
    assert text_of(fitted(line, 5)) == "ab漢…"
    assert text_of(fitted(line, 4)) == "ab… "
    assert text_of(fitted(line, 4, "~")) == "ab~ "
