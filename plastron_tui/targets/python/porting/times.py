"""Times and durations of a file, all of whose uses the other ROS has as well."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Literal

from tree_sitter import Node

from plastron_tui.ros.interfaces import FieldType, Section
from plastron_tui.sources.python.constants import without_none
from plastron_tui.sources.python.references import identifiers, is_member
from plastron_tui.sources.python.syntax import parts_of

from .message_types import typed
from .port_state import Work, walk

Kind = Literal["time", "duration"]

_RESULTS: dict[tuple[str, Kind | None, Kind | None], Kind] = {
    ("-", "time", "time"): "duration",
    ("-", "time", "duration"): "time",
    ("+", "time", "duration"): "time",
}


def is_stamp(work: Work, value: Node) -> bool:
    """Tell whether a time goes into the stamp of a header, as it is."""
    parent = value.parent
    if parent is None:
        return False
    if parent.type == "assignment":
        left = parent.child_by_field_name("left")
        if left is None or left == value:
            return False
        type_ = typed(work, left)
        if isinstance(type_, FieldType):
            return type_.name in ("time", "Time") and not type_.is_array
        return f".{work.slice(left)}".endswith(".header.stamp")
    if parent.type != "keyword_argument" or parent.parent is None or parent.parent.parent is None:
        return False
    name = parent.child_by_field_name("name")
    made = parent.parent.parent.child_by_field_name("function")
    is_header = made is not None and "std_msgs.msg.Header" in work.qualified(made)
    return is_header and name is not None and work.slice(name) == "stamp"


def is_lasting(work: Work, value: Node) -> bool:
    """Tell whether a duration goes into a field of a message, as it is."""
    parent = value.parent
    type_: object = None
    if parent is not None and parent.type == "assignment":
        left = parent.child_by_field_name("left")
        type_ = typed(work, left) if left is not None and left != value else None
    elif parent is not None and parent.type == "keyword_argument":
        call = parent.parent.parent if parent.parent is not None else None
        section = typed(work, call) if call is not None and call.type == "call" else None
        name = parent.child_by_field_name("name")
        for each in section.fields if isinstance(section, Section) else ():
            if name is not None and each.name == work.slice(name):
                type_ = each.type
    return (
        isinstance(type_, FieldType)
        and type_.name in ("duration", "Duration")
        and not type_.is_array
        and type_.package in (None, "builtin_interfaces")
    )


def of_message(work: Work, node: Node) -> Kind | None:
    """Return whether an expression is a time or a duration in a message for sure."""
    type_ = typed(work, node) if node.type == "attribute" else None
    if isinstance(type_, FieldType) and not type_.is_array:
        kinds: dict[str, Kind] = {"time": "time", "duration": "duration"}
        is_own = type_.package in (None, "builtin_interfaces")
        return kinds.get(type_.name.lower()) if is_own else None
    return "time" if f".{work.slice(node)}".endswith(".header.stamp") else None


def rename_parts(work: Work, names: dict[str, str]) -> None:
    """Rename the seconds and nanoseconds of times in messages."""
    for node in walk(work.analysis.syntax.root):
        holder, part = (node.child_by_field_name(each) for each in ("object", "attribute"))
        if node.type != "attribute" or holder is None or part is None or work.is_gone(node):
            continue
        new = names.get(work.slice(part))
        if new is not None and of_message(work, holder) is not None:
            work.replace(part, new)
            work.done.add(node.id)


class Times(ABC):
    """What of a file are times and durations, all of whose uses the other library has as well."""

    def __init__(self, work: Work) -> None:
        self.work = work
        self._variables: dict[tuple[str, str], bool] = {}
        self._open: set[tuple[int, ...]] = set()
        self.read: list[Node] = []
        """What reads the seconds or nanoseconds of them."""
        self.stamps: list[Node] = []
        """Those that go into the header of a message."""
        self.fields: list[Node] = []
        """Those of messages that others are compared with, or taken from."""

    @abstractmethod
    def kind_of_call(self, call: Node) -> Kind | None:
        """Return whether a call makes a time or a duration that the other library has."""

    @abstractmethod
    def reader(self, attribute: Node) -> Node | None:
        """Return what reads all of a time by an attribute of it: seconds, or nanoseconds."""

    def stamp(self, node: Node) -> Node | None:
        """Return what goes into the stamp of a message, None where nothing does."""
        return node if is_stamp(self.work, node) else None

    def field_kind(self, node: Node) -> Kind | None:
        """Return what a field of a message is that may stand beside a time; none may."""
        return None

    def _side_kind(self, node: Node) -> Kind | None:
        return self.field_kind(node) or self.kind(node)

    def settle(self) -> list[Node]:
        """Find out which variables are known: one that is not may be what another depends on.

        Returns:
            the calls that make times and durations whose every use is known.
        """
        calls = self.work.analysis.captures.get("call", [])
        made = [call for call in calls if self.kind_of_call(call) is not None]
        unknown = -1
        known: list[Node] = []
        while unknown != list(self._variables.values()).count(False):
            unknown = list(self._variables.values()).count(False)
            self._variables = {key: False for key, is_so in self._variables.items() if not is_so}
            self.read.clear()
            self.stamps.clear()
            self.fields.clear()
            known = [call for call in made if self.is_known(call)]
        return known

    def kind(self, node: Node) -> Kind | None:
        """Return whether an expression is a time or a duration for sure."""
        if node.type == "parenthesized_expression":
            return self.kind(node.named_children[0])
        if node.type == "call":
            return self.kind_of_call(node)
        if node.type == "binary_operator":
            sign = node.child_by_field_name("operator")
            left, right = (self._side_kind(each) for each in parts_of(node))
            return _RESULTS.get((self.work.slice(sign) if sign is not None else "", left, right))
        if node.type in ("identifier", "attribute"):
            return self._kind_of_variable(node)
        return None

    def _kind_of_variable(self, node: Node) -> Kind | None:
        bindings = without_none(self.work.bindings(node))
        key = tuple(sorted(each.node.id for each in bindings))
        # What depends on itself, as in `x = x + step`, is what the other values are.
        if key in self._open:
            return None
        self._open.add(key)
        own = (each.value for each in bindings)
        values = [each for each in own if each is None or not self._is_step(each, node)]
        kinds = {self.kind(each) if each is not None else None for each in values}
        self._open.discard(key)
        return kinds.pop() if len(kinds) == 1 else None

    def _is_step(self, value: Node, target: Node) -> bool:
        """Tell whether a variable is moved on by a duration: `x = x + step`."""
        parts = parts_of(value) if value.type == "binary_operator" else []
        return (
            len(parts) == 2
            and self.work.slice(parts[0]) == self.work.slice(target)
            and self.kind(parts[1]) == "duration"
        )

    def is_known(self, node: Node) -> bool:
        """Tell whether all that is done with a value means the same in the other library."""
        parent = node.parent
        if parent is None:
            return False
        stamp = self.stamp(node)
        if stamp is not None and self.kind(node) is not None:
            self.stamps += [stamp] if stamp not in self.stamps else []
            return True
        match parent.type:
            case "parenthesized_expression":
                return self.is_known(parent)
            case "binary_operator":
                return (
                    self._has_known_sides(parent) and self.is_known(parent) and self._note(parent)
                )
            case "comparison_operator":
                kinds = {self._side_kind(each) for each in parts_of(parent) if each.type != "none"}
                return len(kinds) == 1 and self._has_known_sides(parent) and self._note(parent)
            case "attribute":
                read = self.reader(parent)
                if read is not None and read not in self.read:
                    self.read.append(read)
                return read is not None
            case "assignment":
                left = parent.child_by_field_name("left")
                return left is not None and left.id != node.id and self._is_variable(left)
        return False

    def _note(self, operation: Node) -> bool:
        """Note the fields of messages in an operation that is known."""
        found = [each for each in parts_of(operation) if self.field_kind(each) is not None]
        self.fields += [each for each in found if each not in self.fields]
        return True

    def _has_known_sides(self, operation: Node) -> bool:
        """Tell whether an operation is of times and durations that are rewritten, or of None."""
        for each in parts_of(operation):
            side = each
            while side.type == "parenthesized_expression":
                side = side.named_children[0]
            is_operation = side.type == "binary_operator" and self._has_known_sides(side)
            if self.field_kind(each) is not None:
                continue
            if side.type != "none" and (
                self.kind(side) is None
                or not (is_operation or side.type == "call" or self._is_variable(side))
            ):
                return False
        return operation.type == "comparison_operator" or self.kind(operation) is not None

    def _is_variable(self, target: Node) -> bool:
        """Tell whether a variable holds times only, and every use of it is known."""
        if target.type not in ("identifier", "attribute") or typed(self.work, target) is not None:
            return False
        if self.kind(target) is None:
            return False
        # All that has the name is looked at, so that variables of one name share the answer.
        part = target.child_by_field_name("attribute") or target
        key = target.type, self.work.slice(part)
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
        nodes = identifiers(self.work.slice(part), self.work.analysis)
        if target.type != "attribute":
            return [node for node in nodes if not is_member(node)]
        holders = (node.parent for node in nodes if is_member(node))
        return [each for each in holders if each is not None and each.type == "attribute"]
