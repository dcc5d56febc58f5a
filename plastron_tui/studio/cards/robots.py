"""What is said about robots, their links and their joints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from plastron_tui.model.robot_words import mass_words, numbers
from plastron_tui.ros.robots.tree import roots

from ..editor.card import CardRow
from ..panels.robot_entries import joint_text, link_text, shape_text

if TYPE_CHECKING:
    from plastron_tui.model.robots import Robot
    from plastron_tui.ros.robots.description import Joint, Link


def robot_rows(robot: Robot) -> Iterator[CardRow]:
    """Yield what a robot consists of."""
    shown = robot.shown
    if robot.variable != robot.name:
        yield CardRow("in the program", robot.variable)
    if robot.source is not None:
        yield CardRow("file", robot.source.path.name)
    if robot.home:
        yield CardRow("package", robot.home)
    found = roots(shown)
    if len(found) == 1:
        yield CardRow("root", found[0])
    mass = sum(each.inertial.mass for each in shown.links.values() if each.inertial is not None)
    if mass:
        yield CardRow("mass", mass_words(mass))
    for link in shown.links.values():
        yield CardRow("link", link.name, link_text(link))
    for joint in shown.joints.values():
        yield CardRow("joint", joint.name, joint_text(joint))
    if not shown.links:
        yield CardRow("it has no links yet", is_warning=True)


def link_rows(link: Link, robot: Robot) -> Iterator[CardRow]:
    """Yield the shapes of a link, its mass, and the joints at it."""
    for what, bodies in (("seen as", link.visuals), ("collides as", link.collisions)):
        for body in bodies:
            note = "" if body.material is None else body.material.name
            yield CardRow(what, shape_text(body.shape), note)
    if link.inertial is not None:
        yield CardRow("mass", mass_words(link.inertial.mass))
    if not (link.visuals or link.collisions):
        yield CardRow("it has no shape: it is a place", "")
    for joint in robot.shown.joints.values():
        if joint.child == link.name:
            yield CardRow("held by", joint.parent, f"{joint.name}, {joint_text(joint)}")
        elif joint.parent == link.name:
            yield CardRow("holds", joint.child, f"{joint.name}, {joint_text(joint)}")


def joint_rows(joint: Joint) -> Iterator[CardRow]:
    """Yield what a joint connects, and how it moves."""
    yield CardRow("from", joint.parent)
    yield CardRow("to", joint.child)
    yield CardRow("moves", joint_text(joint))
    if any(joint.pose.position):
        yield CardRow("at", f"{numbers(joint.pose.position)} m", "seen from the parent")
