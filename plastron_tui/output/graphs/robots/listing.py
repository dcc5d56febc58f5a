"""Robots as rows, boxes and arrows of the formats that have no geometry."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.model.graph import GraphRobot
from plastron_tui.ros.robots.description import Joint, JointType, Link

from .captions import joint_text, link_text, robot_text
from .rows import lead, tree_rows, unheld


class JointEdge(NamedTuple):
    """A joint, and the identifiers of the links that it joins."""

    parent: str
    child: str
    joint: Joint

    @property
    def moves(self) -> bool:
        """Whether it is anything but fixed."""
        return self.joint.type is not JointType.FIXED


def robot_title(robot: GraphRobot) -> str:
    """Return what a robot is, where it comes from, and whether there is more of it."""
    described = robot.description
    parts = [robot_text(described.name, len(described.links), len(described.joints))]
    if robot.file is not None:
        parts.append(visible(robot.file.name))
    if robot.has_macros:
        parts.append("macros not expanded")
    return " · ".join(parts)


def robot_rows(robot: GraphRobot) -> Iterator[tuple[str, str, str]]:
    """Yield the tree of a robot: each link, the joint that holds it, and what both are."""
    described = robot.description
    rows = tree_rows(described)
    for row in rows:
        held = "" if row.joint is None else visible(row.joint.name)
        said = [] if row.joint is None else [joint_text(row.joint)]
        said.append(link_text(described.links[row.link]))
        yield f"{lead(row)}{visible(row.link)}", held, "  ".join(filter(None, said))
    for name in unheld(described, rows):
        yield visible(name), "held by nothing", link_text(described.links[name])


def robot_links(identifier: str, robot: GraphRobot) -> Iterator[tuple[str, Link]]:
    """Yield the links of a robot with identifiers: `r0l0`, `r0l1`."""
    for at, link in enumerate(robot.description.links.values()):
        yield f"{identifier}l{at}", link


def robot_joints(identifier: str, robot: GraphRobot) -> Iterator[JointEdge]:
    """Yield the joints of a robot whose links are there."""
    names = {link.name: name for name, link in robot_links(identifier, robot)}
    for joint in robot.description.joints.values():
        if joint.parent in names and joint.child in names:
            yield JointEdge(names[joint.parent], names[joint.child], joint)
