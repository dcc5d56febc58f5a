"""Where the links and joints of a program's robots are, from its tree."""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.language import Document
from plastron_tui.ros.robots.names import NAME_RULE, is_name

from .names import Variable

_LINKS, _JOINTS = ("link", "parent", "child"), ("joint", "mimicked")
"""The fields of the grammar that name a link, or a joint."""

_MAKING = {"link": "has_link_statement", "joint": "has_joint_statement"}


def part_at(document: Document, offset: int) -> Variable | None:
    """Return the link or the joint that is named at an offset, None where none is."""
    root = document.tree.root_node
    for start, end in ((offset, offset + 1), (offset - 1, offset)):
        node = root.descendant_for_byte_range(start, end) if start >= 0 else None
        fields = None if node is None else _fields_of(node)
        if node is None or fields is None or node.parent is None:
            continue
        robot = node.parent.child_by_field_name("robot")
        if robot is not None:
            return _part(root, robot.text, node.text, fields)
    return None


def _fields_of(node: Node) -> tuple[str, ...] | None:
    """Return the fields that name what a node names, None where it is no part of a robot."""
    parent = node.parent if node.type == "ros_name" else None
    for fields in (_LINKS, _JOINTS) if parent is not None else ():
        for field in fields:
            if parent is not None and parent.child_by_field_name(field) == node:
                return fields
    return None


def _part(
    root: Node, robot: bytes | None, name: bytes | None, fields: tuple[str, ...]
) -> Variable | None:
    named = [
        (statement, field, found)
        for statement in _about(root, robot)
        for field in fields
        if (found := statement.child_by_field_name(field)) is not None and found.text == name
    ]
    making = _MAKING[fields[0]]
    made = (
        _within(each)
        for statement, field, each in named
        if statement.type == making and field == fields[0]
    )
    places = tuple(_within(each) for _, _, each in named)
    text = (name or b"").decode("utf-8", "replace").strip("'")
    return Variable(text, next(made, None), places) if text else None


def _about(root: Node, robot: bytes | None) -> Iterator[Node]:
    for statement in root.named_children:
        owner = statement.child_by_field_name("robot")
        if owner is not None and owner.text == robot:
            yield statement


def _within(node: Node) -> Span:
    """Return where a name is, without its quotes."""
    return Span(node.start_byte + 1, node.end_byte - 1)


def wrong_part_name(document: Document, offset: int, new: str) -> str | None:
    """Return why the part of a robot at an offset cannot have a name, None when it can."""
    if not is_name(new):
        return f"`{new}` cannot be one: {NAME_RULE}"
    root = document.tree.root_node
    for start in (offset, offset - 1):
        node = root.descendant_for_byte_range(max(start, 0), max(start, 0) + 1)
        fields = None if node is None else _fields_of(node)
        if node is None or fields is None or node.parent is None:
            continue
        owner = node.parent.child_by_field_name("robot")
        robot = None if owner is None else owner.text
        if not _is_created(root, robot):
            return "a file names it: no statement gives it another name there"
        taken = _part(root, robot, f"'{new}'".encode(), fields)
        if taken is not None and taken.places:
            return f"the robot has a {fields[0]} `{new}` already"
        return None
    return None


def _is_created(root: Node, robot: bytes | None) -> bool:
    """Tell whether the program describes a robot, and no file does."""
    return any(
        statement.type == "create_robot_statement"
        and (variable := statement.child_by_field_name("variable")) is not None
        and variable.text == robot
        for statement in root.named_children
    )
