"""From rospy to rclpy: times that a node asks for, compares, and takes from each other."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.splices import Splice
from plastron_tui.sources.python.syntax import parts_of

from .port_state import Work, walk
from .rclpy_node import has_node
from .times import Kind, Times, is_lasting, of_message

_NOW = frozenset({"rospy.Time.now", "rospy.get_rostime"})
_DURATION = frozenset({"rospy.Duration", "rospy.Duration.from_sec"})
_TIME = frozenset({"rospy.Time", "rospy.Time.from_sec"})
_PAIRS = frozenset({"rospy.Time", "rospy.Duration"})
PARTS = {"secs": "sec", "nsecs": "nanosec"}
_CLASSES = {"time": "rclpy.time.Time", "duration": "rclpy.duration.Duration"}


def port_times(work: Work, node: str) -> None:
    """Rewrite each time whose every use is known, with what is done with it."""
    times = _Times(work)
    before = set(work.done)
    for call in times.settle():
        callee = call.child_by_field_name("function")
        if callee is None or work.is_gone(call) or call.id in work.done:
            continue
        names = set(work.qualified(callee))
        given = parts_of(call.child_by_field_name("arguments"))
        if names <= _NOW:
            work.replace(call, f"{node}.get_clock().now()")
            work.done.update(each.id for each in walk(call))
        elif names <= _DURATION:
            work.replace(callee, _duration(work))
            if given:
                work.insert(given[0].start_byte, "seconds=")
            if given[1:]:
                work.insert(given[1].start_byte, "nanoseconds=")
            work.done.add(call.id)
        else:
            words = zip(("seconds", "nanoseconds"), given, strict=False)
            seconds = "".join(f"{word}={work.text(each)}, " for word, each in words)
            clock = f"clock_type={node}.get_clock().clock_type"
            work.replace(call, f"rclpy.time.Time({seconds}{clock})")
            work.done.update(each.id for each in walk(call))
            work.imports.add("import rclpy.time")
    for call in times.read:
        callee = call.child_by_field_name("function")
        holder = callee.child_by_field_name("object") if callee is not None else None
        if callee is not None and holder is not None:
            work.done.update((callee.id, *(each.id for each in callee.named_children)))
            _write_seconds(work, call, holder)
    for each in times.stamps:
        if each.id not in before:
            is_operation = each.type == "binary_operator"
            work.insert_first(each.start_byte, "(" if is_operation else "")
            work.insert_last(each.end_byte, ").to_msg()" if is_operation else ".to_msg()")
    for each in times.fields:
        work.insert(each.start_byte, "rclpy.time.Time.from_msg(")
        work.insert_last(each.end_byte, ")")
        work.imports.add("import rclpy.time")
    _port_messages(work)


def _duration(work: Work) -> str:
    """Return how the file gets at rclpy's durations, whatever else it calls so."""
    is_free = all("Duration" not in scope.bindings for scope in work.analysis.scopes.all)
    work.imports.add("from rclpy.duration import Duration" if is_free else "import rclpy.duration")
    return "Duration" if is_free else "rclpy.duration.Duration"


def _port_messages(work: Work) -> None:
    """Rewrite `to_sec` and `to_nsec` of times in messages."""
    encode = work.analysis.syntax.encode
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        part = callee.child_by_field_name("attribute") if callee is not None else None
        holder = callee.child_by_field_name("object") if callee is not None else None
        name = work.slice(part) if part is not None else ""
        if callee is None or holder is None or name not in ("to_sec", "to_nsec"):
            continue
        kind = of_message(work, holder)
        if kind is None or work.is_gone(call):
            continue
        work.done.update((callee.id, *(each.id for each in callee.named_children)))
        made = _CLASSES[kind]
        work.imports.add(f"import {made.rpartition('.')[0]}")
        if name == "to_sec":
            _write_seconds(work, call, holder, f"{made}.from_msg(", ")")
        else:
            work.insert(holder.start_byte, f"{made}.from_msg(")
            work.cut(Splice(holder.end_byte, call.end_byte, encode(").nanoseconds")))


def _write_seconds(
    work: Work, call: Node, holder: Node, before: str = "", behind: str = ""
) -> None:
    """Write what `to_sec` gives; a division binds less closely than a call."""
    stands_alone = call.parent is not None and call.parent.type in (
        "assignment",
        "argument_list",
        "return_statement",
    )
    opening, closing = ("", "") if stands_alone else ("(", ")")
    work.insert_first(call.start_byte, f"{opening}{before}")
    seconds = work.analysis.syntax.encode(f"{behind}.nanoseconds / 1e9{closing}")
    work.cut(Splice(holder.end_byte, call.end_byte, seconds))


class _Times(Times):
    """The times and durations of rospy that rclpy has as well."""

    def kind_of_call(self, call: Node) -> Kind | None:
        """Return whether a call asks for the time, or makes one, or a duration, of seconds."""
        callee = call.child_by_field_name("function")
        names = set(self.work.qualified(callee)) if callee is not None else set()
        given = parts_of(call.child_by_field_name("arguments"))
        is_plain = all(
            each.type not in ("keyword_argument", "list_splat", "dictionary_splat")
            for each in given
        )
        if not names or not is_plain:
            return None
        is_made = len(given) <= 1 + (names <= _PAIRS)
        if (names <= _NOW and not given) or (names <= _TIME and is_made):
            return "time" if has_node(self.work, call) else None
        return "duration" if names <= _DURATION and is_made else None

    def field_kind(self, node: Node) -> Kind | None:
        """Return whether a field of a message is a time, which rclpy makes one of its own of."""
        return (
            "time" if node.type == "attribute" and of_message(self.work, node) == "time" else None
        )

    def stamp(self, node: Node) -> Node | None:
        """Return what goes into the stamp of a message, or into a field for a duration."""
        return node if is_lasting(self.work, node) else super().stamp(node)

    def reader(self, attribute: Node) -> Node | None:
        """Return the call of `to_sec`."""
        part, call = attribute.child_by_field_name("attribute"), attribute.parent
        is_seconds = part is not None and self.work.slice(part) == "to_sec"
        return call if is_seconds and call is not None and call.type == "call" else None
