"""The links and joints of a program's robots: where its tree names them, and renaming them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.language import Document
from plastron_tui.model.robots import Robot
from plastron_tui.ros.robots.description import Description
from plastron_tui.ros.robots.names import NAME_RULE, is_name

from .names import Variable

_FIELDS = {"link": ("link", "parent", "child"), "joint": ("joint", "mimicked")}
"""The fields of the grammar that name a part, by what it is; the first is that which makes it."""


class Part(NamedTuple):
    """A link or a joint.

    Attributes:
        robot: the variable of its robot.
        kind: `link` or `joint`.
        name: what it is called.
    """

    robot: str
    kind: str
    name: str

    def is_of(self, description: Description) -> bool:
        """Tell whether a robot has a part of its kind and name."""
        if self.kind == "link":
            return self.name in description.links
        return self.name in description.joints


def part_at(document: Document, offset: int) -> Part | None:
    """Return the link or the joint that is named at an offset, None where none is."""
    root = document.tree.root_node
    for start, end in ((offset, offset + 1), (offset - 1, offset)):
        node = root.descendant_for_byte_range(start, end) if start >= 0 else None
        if node is None or node.parent is None or node.type != "ros_name":
            continue
        robot = node.parent.child_by_field_name("robot")
        for kind, fields in _FIELDS.items() if robot is not None else ():
            if any(node.parent.child_by_field_name(field) == node for field in fields):
                name = _text(node).strip("'")
                return Part(_text(robot), kind, name) if name else None
    return None


def find_part(document: Document, part: Part) -> Variable:
    """Return where the program makes a part, and all the places where it names it."""
    fields = _FIELDS[part.kind]
    making = f"has_{part.kind}_statement"
    definition, places = None, []
    for statement in _about(document, part.robot):
        for field in fields:
            node = statement.child_by_field_name(field)
            if node is None or _text(node) != f"'{part.name}'":
                continue
            # Without its quotes.
            place = Span(node.start_byte + 1, node.end_byte - 1)
            places.append(place)
            if definition is None and statement.type == making and field == fields[0]:
                definition = place
    return Variable(part.name, definition, tuple(places))


def wrong_part_name(document: Document, part: Part, new: str, robot: Robot | None) -> str | None:
    """Return why a part cannot have another name, None when it can.

    Args:
        document: the program.
        part: the part.
        new: its other name.
        robot: its robot as it was last understood, None where nobody has yet.
    """
    wrong = wrong_robot_name(new)
    if wrong is not None:
        return wrong
    kept = kept_name(part, robot)
    if kept is not None:
        return kept
    other = part._replace(name=new)
    is_there = robot is not None and other.is_of(robot.shown)
    if is_there or find_part(document, other).places:
        return f"the robot has a {part.kind} `{new}` already"
    return None


def kept_name(part: Part, robot: Robot | None) -> str | None:
    """Return why a part keeps the name that it has, whatever the other one; None when it need not.

    The robot is as it was last understood, None where nobody has yet.
    """
    source = None if robot is None else robot.source
    if source is not None and part.is_of(source.whole or source.description):
        return f"`{source.path.name}` has the name: change it there"
    return None


def wrong_robot_name(new: str) -> str | None:
    """Return why nothing of a robot can have a name, None when it can."""
    return None if is_name(new) else f"`{new}` cannot be one: {NAME_RULE}"


def _about(document: Document, robot: str) -> Iterator[Node]:
    """Yield the statements about a robot."""
    for statement in document.tree.root_node.named_children:
        owner = statement.child_by_field_name("robot")
        if owner is not None and _text(owner) == robot:
            yield statement


def _text(node: Node | None) -> str:
    text = None if node is None else node.text
    return (text or b"").decode("utf-8", "replace")
