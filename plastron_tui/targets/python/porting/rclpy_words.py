"""What a rospy node says and asks of ROS in words that rclpy has others for: logs, name, time."""

from __future__ import annotations

import re
from collections.abc import Mapping

from tree_sitter import Node

from plastron_tui.sources.python.splices import Splice
from plastron_tui.sources.python.syntax import parts_of

from .kinds import kind_of
from .port_state import Work
from .rclpy_node import has_node
from .rewriting import time_module
from .times import is_stamp

LOGS: Mapping[str, str] = {
    "rospy.logdebug": "debug",
    "rospy.loginfo": "info",
    "rospy.logwarn": "warning",
    "rospy.logerr": "error",
    "rospy.logfatal": "fatal",
}
"""The functions of rospy that log, and the methods of a logger of rclpy."""

# One field of a `%` format, or what is no field that a tuple fills in turn.
_FIELD = re.compile(r"%(?:(%)|[-#0 +]*(?:(?!0)\d+)?(?:\.\d+)?[diouxXeEfFgGcrsa]|(.?))", re.DOTALL)
_TEXT = re.compile(r"""(?P<quote>["'])(?P<inside>[^"'\\{}\n]*)(?P=quote)""")
_SIMPLE = re.compile(r"[A-Za-z_][\w.]*")


_NAMES = frozenset({"rospy.get_name", "rospy.get_caller_id"})
_TIMES = frozenset({"rospy.get_time", "rospy.Time.now", "rospy.get_rostime"})
_QUESTIONS = _NAMES | _TIMES | {"rospy.get_namespace"}
_ARGUMENTS = "rospy.myargv"


def port_words(work: Work, node: str) -> None:
    """Rewrite plain logs, the node's name, and the time where it is put into a message."""
    for call in reversed(work.analysis.captures.get("call", [])):
        callee = call.child_by_field_name("function")
        if callee is None or work.is_gone(call):
            continue
        names = {
            name.replace("rospy.core.", "rospy.").replace("rospy.rostime.", "rospy.")
            for name in work.qualified(callee)
        }
        if len(names) != 1:
            continue
        [name] = names
        log, _, often = name.partition("_")
        if log in LOGS and often in ("", "once", "throttle") and has_node(work, call):
            _port_log(work, call, callee, f"{node}.get_logger().{LOGS[log]}", often)
        elif name in ("rospy.sleep", "rospy.wallsleep"):
            _port_sleep(work, call)
        elif name == _ARGUMENTS:
            _port_arguments(work, call, callee)
        elif name in _QUESTIONS:
            _port_question(work, call, name, node)


def _port_arguments(work: Work, call: Node, callee: Node) -> None:
    """Rewrite what takes the arguments of ROS out of those of the program."""
    work.replace(callee, "remove_ros_args")
    work.imports.add("from rclpy.utilities import remove_ros_args")
    for each in parts_of(call.child_by_field_name("arguments")):
        name = each.child_by_field_name("name")
        if name is not None and work.slice(name) == "argv":
            work.replace(name, "args")


def _port_question(work: Work, call: Node, name: str, node: str) -> None:
    """Rewrite a call without arguments."""
    arguments = call.child_by_field_name("arguments")
    if arguments is None or parts_of(arguments) or not has_node(work, call):
        return
    if name == "rospy.get_namespace":
        # That of rospy ends in a slash, that of rclpy only where it is nothing else.
        work.replace(call, f"({node}.get_namespace().rstrip('/') + '/')")
    elif name in _NAMES:
        work.replace(call, f"{node}.get_fully_qualified_name()")
    elif name == "rospy.get_time":
        seconds = f"{node}.get_clock().now().nanoseconds / 1e9"
        work.replace(call, seconds if _stands_alone(call) else f"({seconds})")
    elif is_stamp(work, call):
        work.replace(call, f"{node}.get_clock().now().to_msg()")


def _stands_alone(call: Node) -> bool:
    """Tell whether nothing beside a call binds closer than a division."""
    return call.parent is not None and call.parent.type in ("assignment", "argument_list")


def _port_sleep(work: Work, call: Node) -> None:
    """Rewrite a sleep of a number of seconds, or of a duration of them."""
    given = parts_of(call.child_by_field_name("arguments"))
    if len(given) != 1 or given[0].type == "keyword_argument" or "splat" in given[0].type:
        return
    callee = given[0].child_by_field_name("function")
    inner = parts_of(given[0].child_by_field_name("arguments"))
    names = set(work.qualified(callee)) if callee is not None else set()
    is_duration = names and names <= {"rospy.Duration", "rospy.Duration.from_sec"}
    if is_duration and len(inner) == 1 and inner[0].type != "keyword_argument":
        work.done.add(given[0].id)
        work.cut(Splice(given[0].start_byte, inner[0].start_byte))
        work.cut(Splice(inner[0].end_byte, given[0].end_byte))
    elif not is_number(work, given[0]):
        return
    work.replace(call.children[0], f"{time_module(work)}.sleep")


def is_number(work: Work, node: Node) -> bool:
    """Tell whether a value is a number for sure, or one that the file says nothing else of."""
    text = work.slice(node).lower()
    is_duration = "duration" in text or "rospy." in text or "sleep(" in text
    return kind_of(work, node) in ("int", "float", "number", "real") or (
        not is_duration and node.type in ("identifier", "attribute") and not _may_last(work, node)
    )


def _may_last(work: Work, node: Node) -> bool:
    """Tell whether a name may hold a duration."""
    bindings = work.bindings(node)
    values = [work.slice(each.value) for each in bindings if each.value is not None]
    return not values or len(values) < len(bindings) or any("uration" in each for each in values)


def _port_log(work: Work, call: Node, callee: Node, log: str, often: str = "") -> None:
    """Rewrite a log whose text is sure: rclpy takes one text, and fills in nothing.

    `often` is how often it is logged: `once`, or `throttle`, whose seconds come first.
    """
    arguments = call.child_by_field_name("arguments")
    given = parts_of(arguments) if arguments is not None else []
    option = "once=True" if often == "once" else ""
    seconds = given.pop(0) if often == "throttle" and given else None
    if seconds is not None:
        option = f"throttle_duration_sec={work.text(seconds)}"
    if not given or any("splat" in each.type for each in given):
        return
    if any(each.type in ("keyword_argument", "generator_expression") for each in given):
        return
    first, *rest = given
    if rest and _fields(work, first) != len(rest):
        return
    if seconds is not None:
        work.cut(Splice(seconds.start_byte, first.start_byte))
    options = f", {option}" if option else ""
    written = _formatted(work, first, rest) if rest else None
    if written is not None:
        work.replace(callee, log)
        work.replace_between(first.start_byte, given[-1].end_byte, written + options)
        return
    # What comes behind the text closes it first.
    work.insert_last(given[-1].end_byte, options)
    if not rest:
        if kind_of(work, first) != "str":
            work.insert(first.start_byte, "str(")
            work.insert(first.end_byte, ")")
        work.replace(callee, log)
        return
    work.replace(callee, log)
    opening, closing = ("(", ",)") if len(rest) == 1 else ("(", ")")
    if first.type == "binary_operator":
        work.insert_first(first.start_byte, "(")
        work.insert(first.end_byte, ")")
    work.cut(Splice(first.end_byte, rest[0].start_byte, f" % {opening}".encode("ascii")))
    work.insert(rest[-1].end_byte, closing)


def _fields(work: Work, text: Node) -> int | None:
    """Return how many values a literal format takes, None for what is no such literal."""
    if text.type == "binary_operator" and b" + " in (text.text or b""):
        counts = [_fields(work, each) for each in parts_of(text)]
        return None if None in counts else sum(filter(None, counts))
    callee = text.child_by_field_name("function")
    if callee is not None and set(work.qualified(callee)) & _NAMES:
        return 0
    parts = text.named_children if text.type == "concatenated_string" else [text]
    count = 0
    for part in parts:
        prefix = work.slice(part).partition('"')[0].partition("'")[0].lower()
        if part.type != "string" or set(prefix) & {"b", "f"}:
            return None
        for found in _FIELD.finditer(work.slice(part)):
            if found[2] is not None:
                return None
            count += found[1] is None
    return count


def _formatted(work: Work, text: Node, values: list[Node]) -> str | None:
    """Write an f-string, where the text and the values are simple enough to be read in one."""
    found = _TEXT.fullmatch(work.slice(text))
    names = [work.text(each) for each in values]
    if found is None or not all(map(_SIMPLE.fullmatch, names)):
        return None
    if any(each.type not in ("identifier", "attribute") for each in values):
        return None
    parts = found["inside"].split("%s")
    if len(parts) != len(names) + 1 or any("%" in part for part in parts):
        return None
    pairs = zip(parts[1:], names, strict=True)
    inside = parts[0] + "".join(f"{{{name}}}{part}" for part, name in pairs)
    return f"f{found['quote']}{inside}{found['quote']}"
