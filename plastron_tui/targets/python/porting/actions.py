"""Actions: the classes of ROS 1 are messages, those of ROS 2 are interfaces of their own."""

from __future__ import annotations

import re
from collections.abc import Iterable

from tree_sitter import Node

from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .port_state import Work, is_imported, is_inner, walk
from .types import target_type

_OF_ROS_1 = re.compile(r"(\w+)\.msg\.(\w+?)(Action|(?:Action)?(?:Goal|Result|Feedback))$", re.ASCII)
_OF_ROS_2 = re.compile(r"(?!rclpy\.)(\w+)\.action\.(\w+)", re.ASCII)
_MOVED = {
    InterfaceName("move_base_msgs", "MoveBase"): InterfaceName("nav2_msgs", "NavigateToPose"),
}
_STATUS = {
    "action_msgs.msg.GoalStatus.STATUS_SUCCEEDED": "SUCCEEDED",
    "action_msgs.msg.GoalStatus.STATUS_ABORTED": "ABORTED",
    "action_msgs.msg.GoalStatus.STATUS_CANCELED": "PREEMPTED",
}
"""The ends of a goal, as the `GoalStatus` of `actionlib_msgs` calls them."""


def mark_actions(work: Work) -> None:
    """Mark the import and each use of a class of an action, which the other ROS has not."""
    find = _class_of_ros_1 if work.catalog.ros_version == 2 else _class_of_ros_2
    known = _actions(work)
    for statement in walk(work.analysis.syntax.root):
        if statement.type == "import_from_statement" and not work.is_gone(statement):
            module = statement.child_by_field_name("module_name")
            for each in statement.children_by_field_name("name"):
                name = each.child_by_field_name("name") or each
                path = f"{work.slice(module)}.{work.slice(name)}" if module is not None else ""
                _mark(work, statement, find(work, [path], known))
        elif statement.type in ("identifier", "attribute") and not (
            is_inner(statement) or is_imported(statement) or work.is_gone(statement)
        ):
            _mark(work, statement, find(work, work.qualified(statement), known))
    if work.catalog.ros_version == 1:
        _port_status(work)


_Class = tuple[str, str]
"""What a class is called, and what to write instead."""


def _mark(work: Work, node: Node, found: _Class | None) -> None:
    if found is not None:
        work.mark(node, *found)


def _actions(work: Work) -> frozenset[str]:
    """Return the actions of ROS 1 whose own class the file imports: `MoveBaseAction`."""
    return frozenset(
        each.target.removesuffix("Action")
        for scope in work.analysis.scopes.all
        for bindings in scope.bindings.values()
        for each in bindings
        if each.target is not None and ".msg." in each.target and each.target.endswith("Action")
    )


def _class_of_ros_1(work: Work, names: Iterable[str], known: frozenset[str]) -> _Class | None:
    for name in names:
        found = _OF_ROS_1.match(name)
        if found is None:
            continue
        package, action, side = found.groups()
        type_ = InterfaceName(package, action)
        # What is generated for an action has two words: a message may be any `Goal`.
        is_made = side.startswith("Action") or f"{package}.msg.{action}" in known
        is_own = is_made or type_ in _MOVED
        if not is_own and work.before.find(type_, InterfaceKind.ACTION) is None:
            continue
        target = _MOVED.get(type_) or target_type(work, type_, InterfaceKind.ACTION)[0]
        part = "" if side == "Action" else f".{side}"
        words = name.rpartition(".")[2]
        if side.startswith("Action") and side != "Action":
            return words, "the topics of an action are hidden in ROS 2: use an `ActionClient`"
        if target is None:
            return words, f"an action of ROS 2 is `{action}{part}` of a package's `action`"
        return words, f"`{target.name}{part}` of `{target.package}.action`"
    return None


def _class_of_ros_2(work: Work, names: Iterable[str], known: frozenset[str]) -> _Class | None:
    for name in names:
        found = _OF_ROS_2.match(name)
        if found is not None:
            package, action = found.groups()
            return action, f"`{action}Action`, `{action}Goal` of `{package}.msg`"
    return None


def _port_status(work: Work) -> None:
    for node in walk(work.analysis.syntax.root):
        part = node.child_by_field_name("attribute") if node.type == "attribute" else None
        if part is None or work.is_gone(node):
            continue
        [name, *others] = work.qualified(node) or ("",)
        if others or not name.startswith("action_msgs.msg.GoalStatus.STATUS_"):
            continue
        if name in _STATUS:
            work.replace(part, _STATUS[name])
        else:
            work.mark(node, work.slice(part), "`actionlib_msgs` has other states")
