"""The tree that the joints of a robot make of its links."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from .description import Description, Joint


class Branch(NamedTuple):
    """A link in the tree.

    Attributes:
        link: its name.
        joint: the joint that holds it, None for a root.
        depth: how many joints are between it and its root.
    """

    link: str
    joint: Joint | None
    depth: int


def holders(robot: Description) -> dict[str, Joint]:
    """Return the joint that holds each link that is held, the first where there are several."""
    found: dict[str, Joint] = {}
    for joint in robot.joints.values():
        found.setdefault(joint.child, joint)
    return found


def roots(robot: Description) -> list[str]:
    """Return the links that no joint holds; a robot has one."""
    held = {joint.child for joint in robot.joints.values()}
    return [name for name in robot.links if name not in held]


def held_by(robot: Description) -> dict[str, list[Joint]]:
    """Return the joints that each link holds others by, in their order."""
    found: dict[str, list[Joint]] = {}
    for joint in robot.joints.values():
        found.setdefault(joint.parent, []).append(joint)
    return found


def branches(robot: Description) -> Iterator[Branch]:
    """Yield the links from each root on, each before those that it holds.

    Links of a circle have no root, and are not among them; a link that two joints hold is there
    once. However deep the tree is, nothing recurs.
    """
    children = held_by(robot)
    seen: set[str] = set()
    stack = [Branch(name, None, 0) for name in reversed(roots(robot))]
    while stack:
        branch = stack.pop()
        if branch.link in seen:
            continue
        seen.add(branch.link)
        yield branch
        stack += [
            Branch(joint.child, joint, branch.depth + 1)
            for joint in reversed(children.get(branch.link, ()))
            if joint.child in robot.links
        ]
