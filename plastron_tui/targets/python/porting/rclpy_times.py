"""From rospy to rclpy: times that a node asks for, compares, and takes from each other."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.constants import without_none
from plastron_tui.sources.python.splices import Splice
from plastron_tui.sources.python.syntax import parts_of

from .message_types import typed
from .port_state import Work, walk
from .rclpy_node import has_node

_NOW = frozenset({"rospy.Time.now", "rospy.get_rostime"})
_DURATION = frozenset({"rospy.Duration", "rospy.Duration.from_sec"})
_TIME, _LENGTH = "time", "duration"


def port_times(work: Work, node: str) -> None:
    """Rewrite each time whose every use is known, with what is done with it."""
    times = _Times(work)
    times.settle(work.analysis.captures.get("call", []))
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        names = set(work.qualified(callee)) if callee is not None else set()
        if callee is None or not names or work.is_gone(call) or call.id in work.done:
            continue
        if names <= _NOW and times.is_known(call) and has_node(work, call):
            work.replace(call, f"{node}.get_clock().now()")
            work.done.update(each.id for each in walk(call))
        elif names <= _DURATION and times.kind(call) == _LENGTH and times.is_known(call):
            [given] = parts_of(call.child_by_field_name("arguments"))
            work.replace(callee, "Duration")
            work.insert(given.start_byte, "seconds=")
            work.done.add(call.id)
            work.imports.add("from rclpy.duration import Duration")
    for call in times.seconds:
        callee = call.child_by_field_name("function")
        holder = callee.child_by_field_name("object") if callee is not None else None
        if callee is None or holder is None:
            continue
        work.done.update((callee.id, *(each.id for each in callee.named_children)))
        stands_alone = call.parent is not None and call.parent.type in (
            "assignment",
            "argument_list",
            "return_statement",
        )
        opening, closing = ("", "") if stands_alone else ("(", ")")
        encode = work.analysis.syntax.encode
        work.insert_first(call.start_byte, opening)
        seconds = encode(f".nanoseconds / 1e9{closing}")
        work.cut(Splice(holder.end_byte, call.end_byte, seconds))


class _Times:
    """What of a file are times and durations of rospy, all of whose uses rclpy has as well."""

    def __init__(self, work: Work) -> None:
        self._work = work
        self._variables: dict[tuple[int, ...], bool] = {}
        self.seconds: list[Node] = []
        """The calls of `to_sec` on them."""

    def settle(self, calls: list[Node]) -> None:
        """Find out which variables are known: one that is not may be what another depends on."""
        unknown = -1
        while unknown != list(self._variables.values()).count(False):
            unknown = list(self._variables.values()).count(False)
            self._variables = {key: False for key, known in self._variables.items() if not known}
            self.seconds.clear()
            for call in calls:
                if self.kind(call) is not None:
                    self.is_known(call)

    def kind(self, node: Node) -> str | None:
        """Return whether an expression is a time or a duration for sure."""
        if node.type == "parenthesized_expression":
            return self.kind(node.named_children[0])
        if node.type == "call":
            callee = node.child_by_field_name("function")
            names = set(self._work.qualified(callee)) if callee is not None else set()
            given = parts_of(node.child_by_field_name("arguments"))
            if names and names <= _NOW and not given and has_node(self._work, node):
                return _TIME
            is_one = len(given) == 1 and given[0].type not in ("keyword_argument", "list_splat")
            return _LENGTH if names and names <= _DURATION and is_one else None
        if node.type == "binary_operator" and any(each.type == "-" for each in node.children):
            sides = [self.kind(each) for each in parts_of(node)]
            return {(_TIME, _TIME): _LENGTH, (_TIME, _LENGTH): _TIME}.get(tuple(sides))  # type: ignore[arg-type]
        if node.type in ("identifier", "attribute"):
            values = [each.value for each in without_none(self._work.bindings(node))]
            is_time = bool(values) and all(
                each is not None and each.type == "call" and self.kind(each) == _TIME
                for each in values
            )
            return _TIME if is_time else None
        return None

    def is_known(self, node: Node) -> bool:
        """Tell whether all that is done with a value means the same in rclpy."""
        parent = node.parent
        if parent is None:
            return False
        match parent.type:
            case "parenthesized_expression":
                return self.is_known(parent)
            case "binary_operator":
                return self._has_known_sides(parent) and self.is_known(parent)
            case "comparison_operator":
                kinds = {self.kind(each) for each in parts_of(parent) if each.type != "none"}
                return len(kinds) == 1 and self._has_known_sides(parent)
            case "attribute":
                call = parent.parent
                part = parent.child_by_field_name("attribute")
                is_seconds = part is not None and self._work.slice(part) == "to_sec"
                if not is_seconds or call is None or call.type != "call":
                    return False
                if call not in self.seconds:
                    self.seconds.append(call)
                return True
            case "assignment":
                left = parent.child_by_field_name("left")
                return left is not None and left.id != node.id and self._is_variable(left)
        return False

    def _has_known_sides(self, operation: Node) -> bool:
        """Tell whether an operation is of times and durations that are rewritten, or of None."""
        for each in parts_of(operation):
            side = each
            while side.type == "parenthesized_expression":
                side = side.named_children[0]
            is_operation = side.type == "binary_operator" and self._has_known_sides(side)
            if side.type != "none" and (
                self.kind(side) is None
                or not (is_operation or side.type == "call" or self._is_variable(side))
            ):
                return False
        return operation.type == "comparison_operator" or self.kind(operation) is not None

    def _is_variable(self, target: Node) -> bool:
        """Tell whether a variable holds times only, and every use of it is known."""
        if target.type not in ("identifier", "attribute") or typed(self._work, target) is not None:
            return False
        if self.kind(target) != _TIME:
            return False
        key = tuple(sorted(each.node.id for each in self._work.bindings(target)))
        if key not in self._variables:
            self._variables[key] = True
            self._variables[key] = all(map(self._is_used_well, self._uses(target)))
        return self._variables[key]

    def _is_used_well(self, use: Node) -> bool:
        parent = use.parent
        left = parent.child_by_field_name("left") if parent is not None else None
        is_target = parent is not None and parent.type == "assignment" and left is not None
        return (is_target and left is not None and left.id == use.id) or self.is_known(use)

    def _uses(self, target: Node) -> list[Node]:
        """Return all that may be the variable: what has its name in the file."""
        part = target.child_by_field_name("attribute") or target
        return [
            node.parent if node.parent is not None and target.type == "attribute" else node
            for node in walk(self._work.analysis.syntax.root)
            if node.type == "identifier"
            and self._work.slice(node) == self._work.slice(part)
            and (
                node.parent is not None
                and node.parent.type == "attribute"
                and node.parent.child_by_field_name("attribute") == node
            )
            == (target.type == "attribute")
        ]
