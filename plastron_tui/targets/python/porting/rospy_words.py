"""What an rclpy node says and asks of ROS in words that rospy has others for."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.sources.python.splices import Splice
from plastron_tui.sources.python.syntax import parts_of

from .port_state import Work, walk
from .rewriting import replace_by_opposite
from .times import is_stamp
from .types import target_type

_LOGS = {
    "debug": "rospy.logdebug",
    "info": "rospy.loginfo",
    "warn": "rospy.logwarn",
    "warning": "rospy.logwarn",
    "error": "rospy.logerr",
    "fatal": "rospy.logfatal",
}
_CLOCKS = {"rclpy.clock.Clock", "rclpy.clock.ROSClock"}


def port_rospy_words(work: Work) -> None:
    """Rewrite plain logs, the time where it is a stamp, and the classes of a service's sides."""
    for call in reversed(work.analysis.captures.get("call", [])):
        callee = call.child_by_field_name("function")
        arguments = call.child_by_field_name("arguments")
        if callee is None or arguments is None or work.is_gone(call):
            continue
        if "rclpy.ok" in work.qualified(callee):
            replace_by_opposite(work, call, "rospy.is_shutdown()")
        chain = methods_of(work, call)
        given = parts_of(arguments)
        if chain[-1:] == ["to_msg"] and chain[-3:-1] == ["get_clock", "now"] and not given:
            if is_stamp(work, call):
                _replace(work, call, "rospy.Time.now()")
        elif len(chain) == 2 and chain[0] == "get_logger" and chain[1] in _LOGS:
            is_text = len(given) == 1 and given[0].type not in ("keyword_argument", "list_splat")
            if is_text and given[0].type != "dictionary_splat":
                _replace(work, callee, _LOGS[chain[1]])
            elif len(given) == 2:
                _port_rare_log(work, callee, _LOGS[chain[1]], *given)
    for node in walk(work.analysis.syntax.root):
        if node.type == "attribute":
            _port_side(work, node)


def _port_rare_log(work: Work, callee: Node, log: str, text: Node, option: Node) -> None:
    """Rewrite a log with `once=True`, or with the seconds that pass before the next one."""
    name, value = option.child_by_field_name("name"), option.child_by_field_name("value")
    if name is None or value is None or text.type.endswith(("keyword_argument", "splat")):
        return
    word = work.slice(name)
    if word == "once" and work.slice(value) == "True":
        _replace(work, callee, f"{log}_once")
    elif word == "throttle_duration_sec":
        _replace(work, callee, f"{log}_throttle")
        work.insert(text.start_byte, f"{work.text(value)}, ")
    else:
        return
    work.done.add(name.id)
    work.cut(Splice(text.end_byte, option.end_byte))


def _replace(work: Work, node: Node, text: str) -> None:
    """Rewrite a node that holds nothing but names and calls without arguments."""
    work.done.update(each.id for each in walk(node))
    work.replace(node, text)


def methods_of(work: Work, call: Node) -> list[str]:
    """Return the methods of `node.get_logger().info(…)`; all but the last take nothing.

    A clock that is made there is the node's.
    """
    methods: list[str] = []
    current: Node | None = call
    while current is not None and current.type == "call":
        callee = current.child_by_field_name("function")
        arguments = current.child_by_field_name("arguments")
        part = callee.child_by_field_name("attribute") if callee is not None else None
        if callee is not None and set(work.qualified(callee)) & _CLOCKS and not parts_of(arguments):
            return ["get_clock", *methods]
        if callee is None or part is None or arguments is None:
            return []
        if current is not call and parts_of(arguments):
            return []
        methods.insert(0, work.slice(part))
        current = callee.child_by_field_name("object")
    return methods


def _port_side(work: Work, node: Node) -> None:
    """Rewrite `SetBool.Request`, which is a class of its own in rospy."""
    names = work.qualified(node)
    parts = names[0].split(".") if len(names) == 1 else []
    if len(parts) != 4 or parts[1] != "srv" or parts[3] not in ("Request", "Response"):
        return
    written = InterfaceName(parts[0], parts[2])
    found = target_type(work, written, InterfaceKind.SERVICE)[0]
    if found is None:
        return
    class_ = f"{found.name}{parts[3]}"
    if work.scope(node).lookup(class_) is None:
        work.imports.add(f"from {found.package}.srv import {class_}")
        work.freed.add(found.name)
        _replace(work, node, class_)
