"""What else is written along with a part of a robot, where that is wanted."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.language import DECLARATIONS, Statement
from plastron_tui.language import statements as st
from plastron_tui.ros.robots.description import Description, JointType
from plastron_tui.ros.robots.tree import held_by, holders

from .context import free_name
from .extra import Extra
from .filling import Filled
from .form import laid_out
from .robot_kinds import parents

_LIMITS = {
    JointType.REVOLUTE.value: ("-90", "90", "deg"),
    JointType.PRISMATIC.value: ("0", "0.5", "m"),
}
"""What a joint is limited to as long as nobody says more: a quarter turn, half a metre."""

ABOUT_ROBOTS: tuple[type[Statement], ...] = (
    *(st.CreateRobot, st.HasLink, st.HasJoint, st.LimitsJoint, st.NoLongerHasJoint),
    st.NoLongerHasLink,
)
"""The statements that others may follow."""


def robot_extras(filled: Filled) -> Iterator[Extra]:
    """Yield what may follow a statement about a robot, in the order of the program."""
    texts = {name: cell.text for name, cell in filled.cells.items()}
    declaration = filled.form.declaration.type
    workspace = filled.scene.workspace
    if declaration is st.CreateRobot:
        robot = texts["variable"]
        yield _base(robot)
        yield _wheels(robot)
    else:
        robot = texts["robot"]
        known = workspace.robots.get(robot)
        description = Description("") if known is None else known.description
        if declaration is st.HasLink:
            yield from _held(robot, texts, description)
        elif declaration is st.HasJoint:
            yield from _limited(robot, texts, description)
        elif declaration is st.NoLongerHasJoint:
            yield from _unheld(robot, texts, description)
    held = {name for each in workspace.packages.values() for name in each.contents}
    if robot not in {each.robot.variable for each in workspace.written_robots} | held:
        line = _line(st.GenerateRobot, robot=robot)
        yield Extra("write", "write it to its file", (line,))


def _base(robot: str) -> Extra:
    lines = (
        _line(st.HasLink, robot=robot, link="base_link"),
        _line(st.HasLink, robot=robot, link="body", shape="box", size="0.4, 0.3, 0.1",
              weight="5", color="blue"),
        _line(st.HasJoint, robot=robot, joint="body_joint", type="fixed", parent="base_link",
              child="body", position="0, 0, 0.05"),
    )  # fmt: skip
    return Extra("base", "begin with a body: a box, 40 cm long", lines)


def _wheels(robot: str) -> Extra:
    """Return two wheels, one on each side of the body, that turn without end."""
    lines = []
    for side, place in (("left", "0, 0.17, 0"), ("right", "0, -0.17, 0")):
        wheel = f"{side}_wheel"
        lines += [
            _line(st.HasLink, robot=robot, link=wheel, shape="cylinder", size="0.1, 0.04",
                  weight="0.5", color="dark_gray", rotation="90, 0, 0", unit="deg"),
            _line(st.HasJoint, robot=robot, joint=f"{wheel}_joint", type="continuous",
                  parent="body", child=wheel, position=place, axis="0, 1, 0"),
        ]  # fmt: skip
    return Extra("wheels", "with two wheels that turn", tuple(lines))


def _held(robot: str, texts: dict[str, str], description: Description) -> Iterator[Extra]:
    """Yield the joint of a link that would be a second root."""
    link = texts["link"]
    if not description.links or link in description.links:
        return
    parent = parents(description)[0]
    joint = free_name(f"{link}_joint", description.joints)
    line = _line(st.HasJoint, robot=robot, joint=joint, type="fixed", parent=parent, child=link)
    yield Extra("joint", f"hold it to {parent}, fixed", (line,))


def _limited(robot: str, texts: dict[str, str], description: Description) -> Iterator[Extra]:
    """Yield the limits that URDF wants."""
    ends = _LIMITS.get(texts["type"])
    there = description.joints.get(texts["joint"])
    if ends is None or (there is not None and there.limit is not None):
        return
    low, high, unit = ends
    line = _line(st.LimitsJoint, robot=robot, joint=texts["joint"], minimum=low, maximum=high,
                 unit=unit, effort="10", velocity="1")  # fmt: skip
    yield Extra("limits", f"limit it: {low} to {high} {unit}", (line,))


def _unheld(robot: str, texts: dict[str, str], description: Description) -> Iterator[Extra]:
    """Yield the end of a link that nothing would hold any more."""
    joint = description.joints.get(texts["joint"])
    if joint is None or joint.child in held_by(description):
        return
    if holders(description).get(joint.child) is joint:
        line = _line(st.NoLongerHasLink, robot=robot, link=joint.child)
        yield Extra("link", f"take {joint.child} away, too", (line,))


def _line(type_: type[Statement], **texts: str) -> str:
    return laid_out(DECLARATIONS[type_], texts)
