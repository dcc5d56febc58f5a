"""From rclpy to rospy: times that a node asks for, compares, and takes from each other."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.splices import Splice
from plastron_tui.sources.python.syntax import parts_of

from .port_state import Work, walk
from .rospy_words import methods_of
from .times import Kind, Times, is_stamp, rename_parts

_PARTS = {"sec": "secs", "nanosec": "nsecs"}
_READ = {"nanoseconds": "to_nsec()", **_PARTS}


def port_rospy_times(work: Work) -> None:
    """Rewrite each time whose every use is known, with what is done with it."""
    times = _Times(work)
    for call in times.settle():
        if work.is_gone(call) or call.id in work.done:
            continue
        if times.kind_of_call(call) == "duration":
            [given] = parts_of(call.child_by_field_name("arguments"))
            callee, value = call.child_by_field_name("function"), given.child_by_field_name("value")
            if callee is not None and value is not None:
                work.replace(callee, "rospy.Duration")
                work.cut(Splice(given.start_byte, value.start_byte))
        else:
            work.done.update(each.id for each in walk(call))
            work.replace(call, "rospy.Time.now()")
    for attribute in times.read:
        part = attribute.child_by_field_name("attribute")
        if part is not None:
            work.replace(part, _READ[work.slice(part)])
    for each in times.stamps:
        callee = each.child_by_field_name("function")
        holder = callee.child_by_field_name("object") if callee is not None else None
        if callee is not None and holder is not None and each.id not in work.done:
            work.done.update((callee.id, *(part.id for part in callee.named_children)))
            work.cut(Splice(holder.end_byte, each.end_byte))
    rename_parts(work, _PARTS)


class _Times(Times):
    """The times and durations of rclpy that rospy has as well.

    What `to_msg` makes of a time is the time itself in rospy.
    """

    def kind_of_call(self, call: Node) -> Kind | None:
        """Return whether a call asks a clock for the time, or makes a duration of seconds."""
        methods = methods_of(self.work, call)
        is_empty = not parts_of(call.child_by_field_name("arguments"))
        is_message = methods[-1:] == ["to_msg"]
        if is_empty and (methods[:-1] if is_message else methods)[-2:] == ["get_clock", "now"]:
            return "time"
        callee = call.child_by_field_name("function")
        given = parts_of(call.child_by_field_name("arguments"))
        if callee is None or set(self.work.qualified(callee)) != {"rclpy.duration.Duration"}:
            return None
        name = given[0].child_by_field_name("name") if len(given) == 1 else None
        return "duration" if name is not None and self.work.slice(name) == "seconds" else None

    def reader(self, attribute: Node) -> Node | None:
        """Return the attribute, where rospy has one like it."""
        part = attribute.child_by_field_name("attribute")
        return attribute if part is not None and self.work.slice(part) in _READ else None

    def stamp(self, node: Node) -> Node | None:
        """Return what goes into a stamp: a message already, or what `to_msg` makes one."""
        attribute = node.parent
        part = attribute.child_by_field_name("attribute") if attribute is not None else None
        call = attribute.parent if attribute is not None else None
        if part is not None and call is not None and self.work.slice(part) == "to_msg":
            return call if call.type == "call" and is_stamp(self.work, call) else None
        return super().stamp(node)
