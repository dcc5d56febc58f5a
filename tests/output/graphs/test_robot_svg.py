"""The SVG of a robot: views that agree, names that stand apart, all of it in the picture."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from itertools import combinations
from math import inf

import pytest
from drawn_robots import (
    SVG,
    Drawn,
    RobotMaker,
    hostile_robots,
    many_links,
    rover,
    shown,
    views_of,
)
from hypothesis import given, settings
from machine import examples

from plastron_tui.model.graph import Graph, GraphRobot
from plastron_tui.output.graphs import render
from plastron_tui.output.graphs.robots import labels
from plastron_tui.output.graphs.robots.solids import scene_of
from plastron_tui.output.graphs.robots.svg_tree import tree_svg
from plastron_tui.output.graphs.robots.views import Frame
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.robots.description import (
    Box,
    Cylinder,
    Description,
    Joint,
    JointType,
    Mesh,
    Pose,
    Vector,
)

_CLOSE = 0.16
"""Numbers in a picture have one decimal."""


def picture(*robots: Description | GraphRobot) -> ET.Element:
    found = tuple(each if isinstance(each, GraphRobot) else shown(each) for each in robots)
    return ET.fromstring(render(Graph((), dict.fromkeys(InterfaceKind, ()), found), "svg"))


def views(robot: Description | GraphRobot) -> dict[str, Drawn]:
    return {view.key: view for view in views_of(picture(robot))}


def frame_of(view: Drawn, link: str) -> Frame:
    xs, ys = zip(*view.bodies[link], strict=True)
    return Frame(min(xs), min(ys), max(xs), max(ys))


@pytest.mark.parametrize("size", [(0.4, 0.3, 0.1), (1e-3, 1e-3, 1e-3), (100, 0.1, 5)])
def test_the_views_have_one_scale_and_stand_above_and_beside_each_other(size: Vector) -> None:
    make = RobotMaker()
    make.link("body", Box(size), Pose((size[0] / 4, size[1] / 3, size[2] / 2)))
    drawn = views(make.robot)
    top, side, front = (frame_of(drawn[key], "body") for key in ("top", "side", "front"))
    scale = max((top.width / size[0], front.width / size[1], front.height / size[2]))
    for frame, wide, high in ((top, 0, 1), (side, 0, 2), (front, 1, 2)):
        assert frame.width == pytest.approx(size[wide] * scale, abs=_CLOSE, rel=0.01)
        assert frame.height == pytest.approx(size[high] * scale, abs=_CLOSE, rel=0.01)
    assert (top.left, top.right) == pytest.approx((side.left, side.right), abs=_CLOSE)
    assert (side.low, side.high) == pytest.approx((front.low, front.high), abs=_CLOSE)
    assert top.high < side.low and side.right < front.left


def check_inside(root: ET.Element) -> None:
    _, _, width, height = map(float, root.get("viewBox", "").split())
    for view in views_of(root):
        frames = [frame for _, frame in view.names]
        frames += [Frame(*point, *point) for points in view.bodies.values() for point in points]
        for frame in frames:
            assert frame.left >= 0 and frame.right <= width, frame
            assert frame.low >= 0 and frame.high <= height, frame


def check_names(view: Drawn) -> None:
    """No name is over another one, and no line to a name runs through another one."""
    for (one, frame), (other, beside) in combinations(view.names, 2):
        assert not (
            frame.left < beside.right
            and beside.left < frame.right
            and frame.low < beside.high
            and beside.low < frame.high
        ), (one, other)
    for line in view.leaders:
        (x, y), (end_x, end_y) = line
        for name, frame in view.names:
            for part in range(1, 10):
                at = x + (end_x - x) * part / 10, y + (end_y - y) * part / 10
                inside = frame.left < at[0] < frame.right and frame.low < at[1] < frame.high
                assert not inside, name


@pytest.mark.parametrize(("count", "size"), [(1, 1e-3), (1, 1), (2, 100), (12, 1e-3), (60, 1)])
def test_pictures_of_robots_of_any_size(count: int, size: float) -> None:
    robot = many_links(count, size)
    root = picture(robot)
    check_inside(root)
    found = list(views_of(root))
    assert [view.key for view in found] == ["top", "side", "front"]
    for view in found:
        check_names(view)
        assert set(view.bodies) == set(robot.links)


def test_every_link_and_joint_has_a_row_in_the_tree() -> None:
    robot = many_links(60)
    lines = tree_svg(robot, scene_of(robot)).lines
    tree = ET.fromstring(f'<svg xmlns="{SVG[1:-1]}">{"".join(lines)}</svg>')
    texts = [text.text for text in tree.iter(f"{SVG}text")]
    for name in (*robot.links, *robot.joints):
        assert texts.count(name) == 1
    spots = [(each.get("cx"), each.get("cy")) for each in tree.iter(f"{SVG}circle")]
    assert len(set(spots)) == len(spots) == 60


def test_a_row_is_below_the_one_that_holds_it() -> None:
    """An only child is straight below its parent; of several, each is one lane to the right."""
    tree = next(each for each in picture(rover()).iter(f"{SVG}g") if each.get("class") == "tree")
    spots = {}
    for row in tree.iter(f"{SVG}g"):
        circle = row.find(f"{SVG}circle")
        if circle is not None:
            name = (row.findtext(f"{SVG}title") or "").partition(":")[0]
            spots[name] = float(circle.get("cx", 0)), float(circle.get("cy", 0))
    assert list(spots) == list(rover().links)
    lanes = {name: round(x / 18) for name, (x, _) in spots.items()}
    assert lanes == {
        "base_link": 0, "chassis": 0, "left_wheel": 1, "right_wheel": 1, "caster": 1, "mast": 1,
        "head": 1, "lens": 1,
    }  # fmt: skip
    heights = [y for _, y in spots.values()]
    assert heights == sorted(heights)


def test_what_is_nearer_is_drawn_later() -> None:
    make = RobotMaker()
    make.link("near", Box((1, 1, 1)))
    make.link("far", Box((1, 1, 1)))
    make.joint("hold", "near", "far", at=Pose((-3, 3, -3)))
    for view in views(make.robot).values():
        assert list(view.bodies) == ["far", "near"]


@pytest.mark.parametrize(
    ("axis", "signs"),
    [
        ((0, 0, 1), {"top": "toward", "side": "arrow", "front": "arrow"}),
        ((0, 1, 0), {"top": "arrow", "side": "away", "front": "arrow"}),
        ((-1, 0, 0), {"top": "arrow", "side": "arrow", "front": "away"}),
        ((0, -2, 0), {"top": "arrow", "side": "toward", "front": "arrow"}),
    ],
)
def test_axes_are_arrows_or_point_at_who_looks(axis: Vector, signs: dict[str, str]) -> None:
    make = RobotMaker()
    make.link("base", Box((1, 1, 1)))
    make.link("arm")
    make.joint("swing", "base", "arm", JointType.CONTINUOUS, axis=axis)
    found = {}
    for view in picture(make.robot).iter(f"{SVG}g"):
        if view.get("class") == "view":
            drawn = next(x for x in view.iter(f"{SVG}g") if x.get("class") == "joint-axis")
            kinds = [part.get("class") for part in drawn if part.tag != f"{SVG}title"]
            found[view.get("data-view")] = {
                ("end", "tip"): "toward",
                ("end", "axis"): "away",
                ("halo", "axis", "tip", "tip"): "arrow",
            }[tuple(kinds)]
    assert found == signs


def test_a_mesh_is_a_diamond_or_the_box_around_it() -> None:
    make = RobotMaker()
    make.link("body", Mesh("package://a/b.stl", (0.001, 0.002, -0.001)), Pose((1, 0, 0)))
    unknown = picture(make.robot)
    assert [each for each in unknown.iter() if each.get("class") == "unknown"]
    assert not any(view.bodies for view in views_of(unknown))
    bounds = {"package://a/b.stl": ((0.0, 0.0, 0.0), (1000.0, 500.0, 250.0))}
    known = views(shown(make.robot, meshes=bounds))
    top, side = frame_of(known["top"], "body"), frame_of(known["side"], "body")
    assert top.width == pytest.approx(top.height, abs=_CLOSE)
    assert side.width == pytest.approx(4 * side.height, abs=4 * _CLOSE)
    texts = [text.text for text in picture(shown(make.robot, meshes=bounds)).iter(f"{SVG}text")]
    assert "dashed is the box around a mesh, or what collides" in texts


def test_a_mesh_whose_points_are_known_is_drawn_as_its_hull() -> None:
    make = RobotMaker()
    make.link("body", Mesh("a.stl", (2.0, 1.0, 1.0)), Pose((1, 0, 0)))
    points = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0.2, 0.2, 0.2))
    there = shown(make.robot, meshes={"a.stl": points})
    top, side, front = (views(there)[key].bodies["body"] for key in ("top", "side", "front"))
    for corners in (top, side, front):
        assert len(corners) == 3
    frame = frame_of(views(there)["side"], "body")
    assert frame.width == pytest.approx(2 * frame.height, abs=2 * _CLOSE)


def test_what_cannot_be_drawn_is_told() -> None:
    make = RobotMaker()
    make.link("base", Box((1, 1, 1)))
    make.link("lost", Cylinder(1e300, 1))
    make.link("one")
    make.link("other")
    make.joint("far", "base", "lost", at=Pose((inf, 0, 0)))
    # A circle has no root.
    make.joints["there"] = Joint("there", JointType.FIXED, "one", "other")
    make.joints["back"] = Joint("back", JointType.FIXED, "other", "one")
    texts = [text.text for text in picture(make.robot).iter(f"{SVG}text")]
    assert "3 links cannot be drawn" in texts
    assert "held by nothing: one, other" in texts


@settings(max_examples=examples(200), deadline=None)
@given(hostile_robots())
def test_any_robot_is_a_picture(robot: Description) -> None:
    text = render(Graph((), dict.fromkeys(InterfaceKind, ()), (shown(robot),)), "svg")
    root = ET.fromstring(text)
    assert text.replace("\n", "").isprintable()
    assert not re.search(r'"[^"]*(?:nan|inf)[^"]*"', re.sub(r">[^<]*<", "><", text))
    check_inside(root)
    for view in views_of(root):
        check_names(view)


def test_a_picture_is_the_same_for_the_same_robot() -> None:
    assert ET.tostring(picture(many_links(8))) == ET.tostring(picture(many_links(8)))


@pytest.mark.long
def test_a_picture_of_500_links() -> None:
    root = picture(many_links(500))
    check_inside(root)
    for view in views_of(root):
        check_names(view)
    assert len(ET.tostring(root)) < 2_000_000


def test_joints_at_one_place_are_marked_there_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each mark is looked at for each name: of 2,000 joints that took 20 s."""
    make = RobotMaker()
    make.link("base")
    for number in range(60):
        make.link(f"l{number}")
        turns = JointType.CONTINUOUS
        make.joint(f"j{number}", "base", f"l{number}", turns, axis=(0.0, 0.0, 1.0))
    kept: list[Frame] = []
    monkeypatch.setattr(labels._Buckets, "add", lambda _, frame, thing: kept.append(frame))
    render(Graph((), dict.fromkeys(InterfaceKind, ()), (shown(make.robot),)), "svg")
    assert 0 < len(kept) < 60
