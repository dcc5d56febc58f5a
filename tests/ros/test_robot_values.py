"""Colours, numbers of another unit, joints of another type, and what macros make."""

from __future__ import annotations

from math import degrees, isnan, pi

import pytest

from plastron_tui.ros.robots.colors import NAMES, material_name, rgba_of
from plastron_tui.ros.robots.description import (
    Body,
    Description,
    Dynamics,
    Joint,
    JointType,
    Limit,
    Link,
    Material,
    Rgba,
)
from plastron_tui.ros.robots.joint_changes import retyped
from plastron_tui.ros.robots.macros import Macro, MacroCall, Macros
from plastron_tui.ros.robots.materials import defined_materials, kept_apart
from plastron_tui.ros.robots.plausible import (
    is_too_far_a_limit,
    is_too_much_turned,
    looks_like_radians,
)
from plastron_tui.ros.robots.transforms import placed, rotation_matrix
from plastron_tui.ros.robots.tree import branches, holders

RED, BLUE = (1.0, 0.0, 0.0, 1.0), (0.0, 0.0, 1.0, 1.0)


@pytest.mark.parametrize(
    ("color", "rgba", "name"),
    [
        ("red", RED, "red"),
        ("#F00", RED, "color_f00"),
        ("#f008", (1.0, 0.0, 0.0, 0.533), "color_f008"),
        ("#ff000080", (1.0, 0.0, 0.0, 0.502), "color_ff000080"),
        ("#ff00", (1.0, 1.0, 0.0, 0.0), "color_ff00"),
        ("#ff000", None, "color_ff000"),
        ("f00", None, "color_f00"),
    ],
)
def test_colours(color: str, rgba: Rgba | None, name: str) -> None:
    assert rgba_of(color) == rgba
    assert material_name(color) == name


def test_named_colours_differ() -> None:
    assert len({rgba_of(each) for each in NAMES}) == len(NAMES)


@pytest.mark.parametrize(
    ("angle", "is_turned", "is_limit"),
    [
        (3.14, False, False),
        (-6.284, False, False),
        (6.29, True, False),
        (-25.13, True, False),
        (25.2, True, True),
    ],
)
def test_radians_that_may_be_degrees(angle: float, is_turned: bool, is_limit: bool) -> None:
    assert is_too_much_turned(angle) is is_turned
    assert is_too_far_a_limit(angle) is is_limit


@pytest.mark.parametrize(
    ("angle", "is_radians"),
    [(1.57, True), (-0.785, True), (6.283, True), (0.0, False), (1.56, False), (7.069, False)],
)
def test_degrees_that_may_be_radians(angle: float, is_radians: bool) -> None:
    assert looks_like_radians(angle) is is_radians
    assert not looks_like_radians(degrees(pi / 3))


@pytest.mark.parametrize(
    ("was", "type_", "limit", "keeps_dynamics"),
    [
        # An angle stays one, a range goes with what has none, and metres are no radians.
        (JointType.REVOLUTE, JointType.CONTINUOUS, Limit(effort=3.0, velocity=4.0), True),
        (JointType.CONTINUOUS, JointType.REVOLUTE, Limit(-1.0, 2.0, 3.0, 4.0), True),
        (JointType.REVOLUTE, JointType.PRISMATIC, None, False),
        (JointType.PRISMATIC, JointType.PLANAR, None, False),
        (JointType.REVOLUTE, JointType.FIXED, None, False),
    ],
)
def test_what_a_joint_of_another_type_keeps(
    was: JointType, type_: JointType, limit: Limit | None, keeps_dynamics: bool
) -> None:
    axis = (0.0, 0.0, 1.0)
    old = Joint(
        "j", was, "a", "b", axis=axis, limit=Limit(-1.0, 2.0, 3.0, 4.0), dynamics=Dynamics(0.1)
    )
    new = retyped(old, type_)
    assert (new.type, new.limit) == (type_, limit)
    assert (new.dynamics is not None) is keeps_dynamics
    assert new.axis == (axis if type_.has_axis else None)


def test_what_macros_make() -> None:
    macros = Macros(
        macros=(
            Macro("wheel", links=1, joints=1),
            Macro("axle", links=1, calls=(MacroCall("wheel"), MacroCall("wheel"))),
            Macro("some", links=1, is_conditional=True),
            Macro("other", calls=(MacroCall("some"),)),
            Macro("itself", calls=(MacroCall("itself"),)),
            Macro("far", calls=(MacroCall("elsewhere"),)),
        )
    )
    made = {each.name: macros.made_by(each.name) for each in macros.macros}
    assert made == {
        "wheel": (1, 1), "axle": (3, 2), "some": None, "other": None, "itself": None, "far": None,
    }  # fmt: skip


def painted(**materials: Material) -> Description:
    links = {name: Link(name, (Body(None, material=each),)) for name, each in materials.items()}
    return Description("r", links)


def looks(robot: Description) -> dict[str, Material | None]:
    return {name: link.visuals[0].material for name, link in robot.links.items()}


def test_a_colour_that_others_mean_is_not_changed_under_them() -> None:
    before = painted(a=Material("paint", RED), b=Material("paint"))
    assert defined_materials(before) == {"paint": Material("paint", RED)}
    # What said the colour has another one: the next of its name says it from then on.
    after = kept_apart(before, painted(a=Material("paint", BLUE), b=Material("paint")))
    assert looks(after) == {"a": Material("paint_2", BLUE), "b": Material("paint", RED)}
    gone = kept_apart(before, painted(b=Material("paint")))
    assert looks(gone) == {"b": Material("paint", RED)}
    # Two that are new, and differ.
    new = kept_apart(painted(), painted(a=Material("paint", RED), b=Material("paint", BLUE)))
    assert looks(new) == {"a": Material("paint", RED), "b": Material("paint_2", BLUE)}
    assert kept_apart(before, before) == before


def test_a_tree_that_is_wrong_is_walked_all_the_same() -> None:
    links = {name: Link(name) for name in "abc"}
    joints = {
        name: Joint(name, JointType.FIXED, *ends)
        for name, ends in {"j": ("a", "b"), "k": ("c", "b"), "l": ("a", "z")}.items()
    }
    robot = Description("r", links, joints)
    assert holders(robot)["b"].name == "j"
    walked = [(each.link, each.depth) for each in branches(robot)]
    assert walked == [("a", 0), ("b", 1), ("c", 0)]
    assert list(placed(robot)) == ["a", "b", "c"]


@pytest.mark.parametrize("angle", [float("inf"), float("nan")])
def test_an_angle_without_end_turns_by_no_number(angle: float) -> None:
    assert isnan(rotation_matrix((0.0, 0.0, angle))[0][0])
