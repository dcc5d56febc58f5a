"""From rclpy to rospy: times, durations and helpers that rospy writes otherwise everywhere."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.splices import Splice
from plastron_tui.sources.python.syntax import parts_of

from .port_state import Work, walk
from .rospy_words import methods_of

_MADE = {
    "rclpy.time.Time": "rospy.Time",
    "rclpy.time.Duration": "rospy.Duration",
    "rclpy.duration.Duration": "rospy.Duration",
    "builtin_interfaces.msg.Time": "rospy.Time",
    "builtin_interfaces.msg.Duration": "rospy.Duration",
}
_PARTS = ({"seconds", "sec"}, {"nanoseconds", "nanosec"})
_OF_NODE = {
    "tf2_ros.TransformListener": 1,
    "tf2_ros.TransformBroadcaster": 0,
    "tf2_ros.StaticTransformBroadcaster": 0,
    "tf2_ros.transform_listener.TransformListener": 1,
    "tf2_ros.transform_broadcaster.TransformBroadcaster": 0,
    "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster": 0,
}
"""Classes that take the node, and where they take it."""

_SAME = frozenset(
    f"tf2_ros.{name}"
    for name in (
        "Buffer",
        "buffer.Buffer",
        "TransformException",
        "LookupException",
        "ConnectivityException",
        "ExtrapolationException",
        "InvalidArgumentException",
        "TimeoutException",
    )
)
"""What rospy has as it is."""


def port_rospy_values(work: Work) -> None:
    """Rewrite calls that the other library has by another name, inner ones first."""
    for call in reversed(work.analysis.captures.get("call", [])):
        callee = call.child_by_field_name("function")
        if callee is None or call.id in work.done or work.is_gone(call):
            continue
        names = set(work.qualified(callee))
        made = {_MADE.get(name) for name in names}
        if len(made) == 1 and None not in made:
            _port_made(work, call, callee, str(made.pop()))
        elif names and names <= {f"{each}.from_msg" for each in _MADE}:
            _port_message(work, call, callee)
        elif names == {"rclpy.utilities.remove_ros_args"}:
            _port_arguments(work, call, callee)
        elif names and names <= _OF_NODE.keys():
            _leave_node(work, call, callee, _OF_NODE[names.pop()])
        elif methods_of(work, call)[-2:] == ["get_clock", "now"]:
            _put(work, call, "rospy.Time.now()")
    _keep_imports(work)
    for call in work.analysis.captures.get("call", []):
        _leave_to_msg(work, call)
    for node in walk(work.analysis.syntax.root):
        if node.type in ("identifier", "attribute") and _SAME & set(work.qualified(node)):
            work.done.add(node.id)
        elif node.type == "type":
            _port_annotation(work, node)
        elif node.type == "attribute":
            _port_nanoseconds(work, node)


def _keep_imports(work: Work) -> None:
    """Keep the imports of tf2 whose names rospy has as well; each other use has its own mark."""
    for node in work.analysis.captures.get("import", []):
        if node.named_child_count == 1 and work.slice(node.named_children[0]) == "tf2_ros":
            work.done.add(node.id)
    for node in work.analysis.captures.get("import_from", []):
        module = node.child_by_field_name("module_name")
        names = node.children_by_field_name("name")
        items = [work.slice(each.child_by_field_name("name") or each) for each in names]
        if module is not None and items:
            given = {f"{work.slice(module)}.{name}" for name in items}
            if given <= _SAME | _OF_NODE.keys():
                work.done.add(node.id)


def _put(work: Work, node: Node, text: str) -> None:
    work.done.update(each.id for each in walk(node))
    work.replace(node, text)


def _port_made(work: Work, call: Node, callee: Node, made: str) -> None:
    """Rewrite what makes a time or a duration of seconds and nanoseconds."""
    parts: list[Node | None] = [None, None]
    for each in parts_of(call.child_by_field_name("arguments")):
        name, value = each.child_by_field_name("name"), each.child_by_field_name("value")
        known = [i for i, names in enumerate(_PARTS) if name and work.slice(name) in names]
        if not known or value is None:
            return
        parts[known[0]] = value
    seconds, nanoseconds = parts
    is_whole = (
        seconds is None or seconds.type == "integer" or "builtin" in work.qualified(callee)[0]
    )
    if nanoseconds is not None and not is_whole:
        return
    written = [work.text(seconds) if seconds is not None else "0"] if any(parts) else []
    written += [work.text(nanoseconds)] if nanoseconds is not None else []
    work.done.update((call.id, *(each.id for each in walk(callee))))
    work.freed.add(work.slice(callee).partition(".")[0])
    work.replace(call, f"{made}({', '.join(written)})")


def _port_message(work: Work, call: Node, callee: Node) -> None:
    """Rewrite `Time.from_msg(x)`: a time in a message is one of rospy."""
    given = parts_of(call.child_by_field_name("arguments"))
    if len(given) == 1 and given[0].type in ("identifier", "attribute", "subscript", "call"):
        work.done.update((call.id, *(each.id for each in walk(callee))))
        work.cut(Splice(call.start_byte, given[0].start_byte))
        work.cut(Splice(given[0].end_byte, call.end_byte))


def _port_arguments(work: Work, call: Node, callee: Node) -> None:
    _put(work, callee, "rospy.myargv")
    for each in parts_of(call.child_by_field_name("arguments")):
        name = each.child_by_field_name("name")
        if name is not None and work.slice(name) == "args":
            work.replace(name, "argv")


def _leave_node(work: Work, call: Node, callee: Node, position: int) -> None:
    """Leave out the node that a class of tf2 takes, and the thread that rospy has anyway."""
    items = parts_of(call.child_by_field_name("arguments"))
    wanted: list[Node] = []
    for index, each in enumerate(items):
        name = each.child_by_field_name("name")
        word = work.slice(name) if name is not None else ""
        is_node = word == "node" or (not word and index == position)
        if not is_node and word != "spin_thread":
            wanted.append(each)
    if len(wanted) > position or any("splat" in each.type for each in items):
        return
    work.done.update(each.id for each in (call, *walk(callee)))
    text = ", ".join(work.text(each) for each in wanted)
    work.replace(call, f"{work.slice(callee)}({text})")


def _leave_to_msg(work: Work, call: Node) -> None:
    """Leave out `to_msg()` of what is a time or a duration of rospy now."""
    callee = call.child_by_field_name("function")
    holder = callee.child_by_field_name("object") if callee is not None else None
    part = callee.child_by_field_name("attribute") if callee is not None else None
    if callee is None or holder is None or part is None or work.slice(part) != "to_msg":
        return
    if _is_made(work, holder) and call.id not in work.done:
        work.done.update((call.id, callee.id, part.id))
        work.cut(Splice(holder.end_byte, call.end_byte))


def _port_nanoseconds(work: Work, node: Node) -> None:
    holder, part = node.child_by_field_name("object"), node.child_by_field_name("attribute")
    if holder is None or part is None or work.slice(part) != "nanoseconds":
        return
    if _is_made(work, holder) and part.id not in work.done:
        work.replace(part, "to_nsec()")
        work.done.add(node.id)


def _port_annotation(work: Work, node: Node) -> None:
    """Rewrite the class of times or durations where it says what a name holds."""
    [held, *others] = node.named_children
    names = set(work.qualified(held)) if held.type in ("identifier", "attribute") else set()
    if not others and len(names) == 1 and (made := _MADE.get(*names)) is not None:
        work.freed.add(work.slice(held).partition(".")[0])
        _put(work, held, made)


def _is_made(work: Work, node: Node) -> bool:
    """Tell whether an expression is a call that was rewritten as a time or a duration."""
    callee = node.child_by_field_name("function") if node.type == "call" else None
    if callee is None or node.id not in work.done:
        return False
    names = {name.removesuffix(".from_msg") for name in work.qualified(callee)}
    is_now = methods_of(work, node)[-2:] == ["get_clock", "now"]
    return is_now or bool(names and names <= _MADE.keys())
