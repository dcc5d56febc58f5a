"""Robots in every format of the graph, below the nodes or alone."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from math import inf, pi

import pytest
from drawn_robots import SVG, hostile_robots, rover, shown
from graph_workspaces import tour
from hypothesis import given, settings
from machine import examples

from plastron_tui.model.graph import Graph, graph_of
from plastron_tui.output.graphs import FORMATS, render
from plastron_tui.output.graphs.robots.captions import axis_text, joint_text, link_text
from plastron_tui.output.graphs.robots.rows import MOST_LANES, tree_rows
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.robots.description import (
    Body,
    Box,
    Cylinder,
    Description,
    Inertial,
    Joint,
    JointType,
    Limit,
    Link,
    Mesh,
    Mimic,
    Shape,
    Sphere,
    Tensor,
    Vector,
)


def graph(*robots: Description) -> Graph:
    return Graph((), dict.fromkeys(InterfaceKind, ()), tuple(map(shown, robots)))


def test_text() -> None:
    assert render(graph(rover()), "text") == (
        "rover: 8 links, 7 joints\n"
        "  base_link\n"
        "  ↓ chassis      base          fixed  box 0.4 × 0.3 × 0.12 m · 5 kg\n"
        "  ├ left_wheel   left_axle     continuous about y  cylinder r 0.08, l 0.05 m · 0.5 kg\n"
        "  ├ right_wheel  right_axle    continuous about y  cylinder r 0.08, l 0.05 m · 0.5 kg\n"
        "  ├ caster       caster_mount  fixed  sphere r 0.04 m\n"
        "  └ mast         mast_mount    fixed  cylinder r 0.015, l 0.3 m\n"
        "    ↓ head       pan           revolute about z · -90° to 90°  box 0.06 × 0.12 × 0.04 m\n"
        "    ↓ lens       zoom          prismatic along x · 0 to 0.02 m  mesh lens.dae\n"
    )


def test_json_has_all_of_a_robot() -> None:
    [robot] = json.loads(render(graph(rover()), "json"))["robots"]
    assert (robot["name"], robot["root"], robot["file"]) == ("rover", "base_link", None)
    assert [link["name"] for link in robot["links"]] == list(rover().links)
    pan = next(joint for joint in robot["joints"] if joint["name"] == "pan")
    assert (pan["parent"], pan["child"], pan["type"]) == ("mast", "head", "revolute")
    limit = {"lower": -pi / 2, "upper": pi / 2, "effort": 1, "velocity": 1}
    assert pan["limit"] == pytest.approx(limit)


def test_dot_and_mermaid_have_each_link_and_joint_once() -> None:
    for format_, arrows in (("dot", ("->",)), ("mermaid", ("==>", "-->"))):
        lines = render(graph(rover(), rover()), format_).splitlines()
        joints = [line for line in lines if any(arrow in line for arrow in arrows)]
        assert len(joints) == 2 * len(rover().joints)
        links = [line for line in lines if line.startswith(('    r1l3["', "    r1l3 ["))]
        assert len(links) == 1 and "right_wheel" in links[0]


def test_robots_stand_below_the_nodes() -> None:
    both = graph_of(tour())._replace(robots=graph(rover()).robots)
    root = ET.fromstring(render(both, "svg"))
    identifiers = [each.get("id") for each in root.iter() if each.get("id")]
    assert len(set(identifiers)) == len(identifiers)
    assert root.findtext(f"{SVG}title", "").endswith("; rover: 8 links, 7 joints")
    alone = ET.fromstring(render(graph_of(tour()), "svg"))
    heights = [float(each.get("height", 0)) for each in (root, alone)]
    moved = [each.get("transform") for each in root if each.get("transform")]
    assert heights[0] > heights[1] and len(moved) == 2
    # The graph is drawn as it is without a robot, but for where its middle is.
    assert render(both, "text").startswith(render(graph_of(tour()), "text").rstrip("\n"))


def test_a_graph_without_robots_has_nothing_of_them() -> None:
    assert "robot" not in render(graph_of(tour()), "svg")
    assert json.loads(render(graph_of(tour()), "json"))["robots"] == []


def test_macros_that_are_not_expanded_are_told() -> None:
    there = graph(rover())._replace(robots=(shown(rover(), has_macros=True),))
    for format_ in ("text", "dot", "mermaid", "svg"):
        assert "macros not expanded" in render(there, format_)
    [robot] = json.loads(render(there, "json"))["robots"]
    assert robot["macros"] is True


@settings(max_examples=examples(100), deadline=None)
@given(hostile_robots())
def test_every_format_is_printable_text_of_any_robot(robot: Description) -> None:
    for format_ in FORMATS[:-1]:
        text = render(graph(robot), format_)
        assert text.endswith("\n")
        assert text.replace("\n", "").isprintable()


@pytest.mark.parametrize(
    ("axis", "text"),
    [
        (None, "x"),
        ((0, 0, 1), "z"),
        ((0, -3, 0), "-y"),
        ((0.6, 0, 0.8), "(0.6, 0, 0.8)"),
        ((1, -1, 0), "(0.707, -0.707, 0)"),
        ((1, 1e-6, -1e-6), "x"),
        ((0, 0, 0), "no axis"),
        ((inf, 0, 0), "no axis"),
    ],
)
def test_axes(axis: Vector | None, text: str) -> None:
    assert axis_text(axis) == text


_LIMIT = Limit(-0.5, 1.5, 10, 1)


@pytest.mark.parametrize(
    ("type_", "axis", "limit", "mimic", "text"),
    [
        (JointType.FIXED, (0, 0, 1), None, None, "fixed"),
        (JointType.FLOATING, None, None, None, "floating"),
        (JointType.CONTINUOUS, (0, 1, 0), _LIMIT, None, "continuous about y"),
        (JointType.REVOLUTE, None, _LIMIT, None, "revolute about x · -28.65° to 85.94°"),
        (JointType.REVOLUTE, None, None, None, "revolute about x"),
        (JointType.PRISMATIC, (0, 0, -1), _LIMIT, None, "prismatic along -z · -0.5 to 1.5 m"),
        (JointType.PLANAR, (0, 0, 1), None, None, "planar across z"),
        (JointType.PRISMATIC, None, None, Mimic("left", -1), "prismatic along x · follows left"),
    ],
)
def test_captions_of_joints(
    type_: JointType, axis: Vector | None, limit: Limit | None, mimic: Mimic | None, text: str
) -> None:
    joint = Joint("j", type_, "a", "b", axis=axis, limit=limit, mimic=mimic)
    assert joint_text(joint) == text


@pytest.mark.parametrize(
    ("shapes", "mass", "text"),
    [
        ([], None, ""),
        ([], 2.5, "2.5 kg"),
        ([Box((1, 0.25, 0.1))], 2.0, "box 1 × 0.25 × 0.1 m · 2 kg"),
        ([Cylinder(0.1, 0.5)], None, "cylinder r 0.1, l 0.5 m"),
        ([Sphere(1e-4)], 1e-05, "sphere r 0.0001 m · 1e-05 kg"),
        ([Mesh("package://a/meshes/wheel.stl")], None, "mesh wheel.stl"),
        ([Sphere(1), Sphere(2)], None, "2 shapes"),
    ],
)
def test_captions_of_links(shapes: list[Shape], mass: float | None, text: str) -> None:
    inertial = None if mass is None else Inertial(mass, Tensor(1, 0, 0, 1, 0, 1))
    assert link_text(Link("a", tuple(map(Body, shapes)), (), inertial)) == text


def test_a_tree_goes_no_farther_to_the_right_than_there_is_room() -> None:
    names = [f"l{at}" for at in range(3 * MOST_LANES)]
    # Each second link is a leaf beside the one that goes on.
    parents = {name: names[max(0, at - 1 - at % 2)] for at, name in enumerate(names) if at}
    joints = {
        f"j{name}": Joint(f"j{name}", JointType.FIXED, parent, name)
        for name, parent in parents.items()
    }
    rows = tree_rows(Description("r", {name: Link(name) for name in names}, joints))
    assert [row.link for row in rows if row.joint is None] == ["l0"]
    assert max(row.lane for row in rows) == MOST_LANES
    assert len(rows) == len(names)
