"""From rclpy to rospy: what uses the node, which is no object in rospy."""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.splices import Splice
from plastron_tui.sources.python.syntax import parts_of

from .port_state import Work, comment_place, walk

_WAIT = "it takes `timeout`, and raises a `rospy.ROSException` where the time is up"
_METHODS = re.compile(r"\.(create|declare|destroy|get|set|add_on_set)_\w+")
"""Marks of what a node has in rclpy."""

_NONE = "`rospy.init_node` returns None"


def port_node_uses(work: Work) -> None:
    """Leave out the name of a node that nothing uses any more, and mark what uses it."""
    marked = {_line(work, mark.node) for mark in work.marks}
    for site in work.analysis.nodes:
        made = site.call
        statement = made.parent if made is not None else None
        if made is None or statement is None or statement.type != "assignment":
            continue
        left, right = statement.child_by_field_name("left"), statement.child_by_field_name("right")
        is_name = left is not None and left.type in ("identifier", "attribute")
        if left is None or right is None or right.id != made.id or not is_name:
            continue
        uses = [each for each in _uses(work, left) if work.is_written(each)]
        if not uses and statement.parent is not None:
            if statement.parent.type == "expression_statement":
                work.cut(Splice(left.start_byte, made.start_byte))
            continue
        for use in uses:
            if _line(work, use) not in marked:
                work.mark(use, f"{work.slice(use)}, which is None", _NONE)


def mark_waits(work: Work) -> None:
    """Mark what reads whether a service is there: rospy tells it by an exception."""
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        part = callee.child_by_field_name("attribute") if callee is not None else None
        if part is None or work.slice(part) != "wait_for_service" or work.is_gone(call):
            continue
        is_alone = call.parent is not None and call.parent.type == "expression_statement"
        if not is_alone or parts_of(call.child_by_field_name("arguments")):
            work.mark(call, "wait_for_service returns None, and raises on a timeout", _WAIT)


def mark_helpers(work: Work) -> None:
    """Mark where a node hands itself to an object of the file that uses what rospy has not."""
    owners = [
        owner
        for owner in work.analysis.scopes.classes()
        if any(
            owner.start <= mark.node.start_byte < owner.end and _METHODS.fullmatch(mark.what)
            for mark in work.marks
        )
    ]
    nodes = {site.owner.node.id for site in work.analysis.nodes if site.owner is not None}
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        given = parts_of(call.child_by_field_name("arguments"))
        if callee is None or work.is_gone(call) or "self" not in map(work.slice, given):
            continue
        made = {each.owner for each in work.bindings(callee)}
        is_helper = any(owner in made and owner.node.id not in nodes for owner in owners)
        if is_helper:
            work.mark(call, f"{work.slice(callee)}(self)", "it uses methods of a node of rclpy")


def _line(work: Work, node: Node) -> int:
    return comment_place(node, work.analysis.syntax.text).start_byte


def _uses(work: Work, target: Node) -> list[Node]:
    """Return what reads a name or an attribute of the file, and what binds it globally."""
    text = work.slice(target)
    owner = _owner(work, target)
    return [
        node
        for node in walk(work.analysis.syntax.root)
        if node.type == target.type
        and node.id != target.id
        and work.slice(node) == text
        and not _is_bound(node)
        and _owner(work, node) is owner
    ]


def _owner(work: Work, name: Node) -> Scope | None:
    """Return the scope that a name is of, or the class whose attribute is meant."""
    if name.type == "attribute":
        return work.scope(name).enclosing("class")
    found = work.scope(name).lookup(work.slice(name))
    return found[0] if found is not None else None


def _is_bound(node: Node) -> bool:
    """Tell whether a name is assigned to, or is no name that is looked up."""
    parent = node.parent
    if parent is None or parent.type in ("global_statement", "nonlocal_statement"):
        return True
    field = {"assignment": "left", "keyword_argument": "name", "attribute": "attribute"}
    part = parent.child_by_field_name(field[parent.type]) if parent.type in field else None
    return part is not None and part.id == node.id
