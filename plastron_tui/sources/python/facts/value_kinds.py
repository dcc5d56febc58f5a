"""What kind of value an expression is, where all that may give it its value agrees."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import MessageField, MessageType, ValueKind
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.references import function_of, identifiers
from plastron_tui.sources.python.runs import result_of
from plastron_tui.sources.python.scopes import Binding, BindingKind
from plastron_tui.sources.python.syntax import parts_of

from .message_values import MessageValues, field_of
from .none_checks import is_checked, is_filled_elsewhere
from .python_functions import BUILTINS, FLOATS, FUNCTIONS, TEXT_METHODS, TIMES
from .returns import is_special

_DEEPEST = 12
_MOST_ITEMS = 256
_NUMBERS = frozenset({ValueKind.BOOL, ValueKind.INT, ValueKind.FLOAT})
_WHOLE = frozenset({ValueKind.BOOL, ValueKind.INT})
_ARITHMETIC = frozenset({"+", "-", "*", "//", "%"})
_LITERALS = {
    "integer": ValueKind.INT,
    "float": ValueKind.FLOAT,
    "true": ValueKind.BOOL,
    "false": ValueKind.BOOL,
    "none": ValueKind.NONE,
}
_BYTES = re.compile(r"[rR]?[bB]")
_DECIMAL = re.compile(rb"-?[0-9]+")
_LONGEST_NUMBER = 40
"""The most digits of a literal that are looked at; no type holds half of them."""

_TIME = MessageField(MessageType(InterfaceName("builtin_interfaces", "Time")))
_DURATION = MessageField(MessageType(InterfaceName("builtin_interfaces", "Duration")))


class Known(NamedTuple):
    """What is known of a value.

    Attributes:
        kind: what it is.
        text: the source of a literal.
        elements: what the elements of a list are, as far as each is known.
        items: where an element is a plain decimal literal.
        sources: the messages, or fields of messages, that it is, one or another.
        extremes: the least and the greatest of the plain decimal literals among its elements.
    """

    kind: ValueKind
    text: str = ""
    elements: tuple[ValueKind, ...] = ()
    items: tuple[Span, ...] = ()
    sources: tuple[MessageField, ...] = ()
    extremes: tuple[int, ...] = ()


class ValueKinds:
    """Answers what kinds of values the expressions of a file are."""

    def __init__(self, messages: MessageValues) -> None:
        """Answer with the help of what is known of messages."""
        self._messages = messages
        self._analysis = messages.analysis
        self._syntax = messages.analysis.syntax
        self._is_rospy = messages.analysis.library.ros_version == 1
        self._known: dict[int, Known | None] = {}

    @cached_property
    def _elsewhere(self) -> frozenset[str]:
        """The attributes that get a value on an object that may be one of the file's."""
        return _given_elsewhere(self._messages)

    def of(self, node: Node | None, depth: int = 0) -> Known | None:
        """Return what is known of a value, None where it may be of several kinds."""
        if node is None or depth > _DEEPEST:
            return None
        if node.id not in self._known:
            self._known[node.id] = None
            self._known[node.id] = self._of(node, depth + 1)
        return self._known[node.id]

    def _of(self, node: Node, depth: int) -> Known | None:
        if node.type in _LITERALS:
            return Known(_LITERALS[node.type], self._syntax.slice(node))
        match node.type:
            case "string" | "concatenated_string":
                is_bytes = _BYTES.match(self._syntax.slice(node)) is not None
                return Known(ValueKind.BYTES if is_bytes else ValueKind.TEXT)
            case "parenthesized_expression":
                parts = parts_of(node)
                return self.of(parts[0], depth) if len(parts) == 1 else None
            case "list" | "tuple":
                return self._list(parts_of(node), depth)
            case "list_comprehension":
                return self._list(parts_of(node)[:1], depth)
            case "dictionary" | "dictionary_comprehension":
                return Known(ValueKind.DICT)
            case "set" | "set_comprehension":
                return Known(ValueKind.SET)
            case "not_operator":
                return Known(ValueKind.BOOL)
            case "unary_operator":
                return self._unary(node, depth)
            case "binary_operator":
                return self._binary(node, depth)
            case "conditional_expression":
                parts = parts_of(node)
                return _agreed([self.of(parts[0], depth), self.of(parts[-1], depth)])
        held = self._messages.held(node)
        if held and not any(each.behind or each.is_said for each in held):
            return Known(ValueKind.MESSAGE, sources=tuple(map(field_of, held)))
        match node.type:
            case "identifier" | "attribute" if self._messages.class_of(node) is not None:
                return Known(ValueKind.CLASS)
            case "identifier" | "attribute":
                return self._named(node, depth)
            case "call":
                return self._call(node, depth)
        return None

    def _list(self, parts: Sequence[Node], depth: int) -> Known | None:
        if len(parts) > _MOST_ITEMS or any("splat" in each.type for each in parts):
            return Known(ValueKind.LIST)
        values = [(each, self.of(each, depth)) for each in parts]
        kinds = tuple(value.kind for _, value in values if value is not None and _is_plain(value))
        literals = [each for each in parts if _DECIMAL.fullmatch(each.text or b"")]
        places = tuple(Span(each.start_byte, each.end_byte) for each in literals)
        numbers = [int((each.text or b"")[:_LONGEST_NUMBER]) for each in literals]
        ends = _extremes(numbers)
        return Known(ValueKind.LIST, elements=kinds, items=places, extremes=ends)

    def _unary(self, node: Node, depth: int) -> Known | None:
        operand = self.of(node.child_by_field_name("argument"), depth)
        if operand is None or operand.kind not in _NUMBERS:
            return None
        kind = ValueKind.INT if operand.kind is ValueKind.BOOL else operand.kind
        return Known(kind, self._syntax.slice(node) if operand.text else "")

    def _binary(self, node: Node, depth: int) -> Known | None:
        left = self.of(node.child_by_field_name("left"), depth)
        right = self.of(node.child_by_field_name("right"), depth)
        operator = node.child_by_field_name("operator")
        sign = operator.type if operator is not None else ""
        if left is not None and left.kind is ValueKind.TEXT and sign == "%":
            return Known(ValueKind.TEXT)
        return None if left is None or right is None else self._combined(left, sign, right)

    def _combined(self, left: Known, sign: str, right: Known) -> Known | None:
        kinds = {left.kind, right.kind}
        if kinds <= _NUMBERS:
            if sign == "/":
                # In Python 2, which rospy had for long, that of two integers is one.
                return None if self._is_rospy and kinds <= _WHOLE else Known(ValueKind.FLOAT)
            if sign in _ARITHMETIC:
                return Known(ValueKind.INT if kinds <= _WHOLE else ValueKind.FLOAT)
            if sign == "**" and ValueKind.FLOAT not in kinds and right.text.isdecimal():
                return Known(ValueKind.INT)
            return None
        if sign == "+" and len(kinds) == 1 and left.kind in (ValueKind.TEXT, ValueKind.LIST):
            elements, items = left.elements + right.elements, left.items + right.items
            ends = _extremes((*left.extremes, *right.extremes))
            return Known(left.kind, elements=elements, items=items, extremes=ends)
        if sign == "*" and ValueKind.INT in kinds:
            other = left if right.kind is ValueKind.INT else right
            if other.kind in (ValueKind.LIST, ValueKind.TEXT):
                return other._replace(text="")
        return None

    def _named(self, node: Node, depth: int) -> Known | None:
        if node.type == "attribute":
            name_node = node.child_by_field_name("attribute")
            name = self._syntax.slice(name_node) if name_node is not None else ""
            if name in self._elsewhere:
                return None
            if name == "nanoseconds" and not self._is_rospy:
                holder = self.of(node.child_by_field_name("object"), depth)
                is_time = holder is not None and holder.kind is ValueKind.TIME
                return Known(ValueKind.INT) if is_time else None
            names = self._analysis.resolver.qualified(node, self._messages.scope(node))
            if names and all(each in FLOATS for each in names):
                return Known(ValueKind.FLOAT)
        name, bindings = self._messages.bindings(node)
        plain = [each for each in bindings if each.node.type != "augmented_assignment"]
        found = _agreed([self._binding(name, each, depth) for each in plain])
        for each in bindings:
            if found is not None and each.node.type == "augmented_assignment":
                found = self._augmented(found, each, depth)
        if found is None:
            return None
        if found.kind is ValueKind.NONE and (
            is_checked(node)
            or (node.type == "attribute" and is_filled_elsewhere(self._messages, node))
        ):
            return None
        if found.kind is ValueKind.LIST and len(bindings) == 1 and self._is_used_once(name):
            return found
        # A list may get other elements where nobody looks, and a literal stands elsewhere.
        return Known(found.kind, sources=found.sources)

    def _is_used_once(self, name: str) -> bool:
        """Whether a name is only used once in the file, besides where it gets its value."""
        return len(identifiers(name, self._analysis)) == 2

    def _augmented(self, known: Known, binding: Binding, depth: int) -> Known | None:
        """Return what `x += 1` leaves of what a name is."""
        operator = binding.node.child_by_field_name("operator")
        right = self.of(binding.node.child_by_field_name("right"), depth)
        if right is None or operator is None:
            return None
        after = self._combined(known, operator.type.removesuffix("="), right)
        return known if after is not None and after.kind is known.kind else None

    def _binding(self, name: str, binding: Binding, depth: int) -> Known | None:
        if binding.kind is BindingKind.VALUE:
            return self.of(binding.value, depth)
        if binding.kind is not BindingKind.UNKNOWN:
            return None
        loop = self._messages.loop(binding, name)
        if loop is None:
            return None
        if loop.is_number:
            return Known(ValueKind.INT)
        taken = loop.taken
        is_range = taken is not None and taken.type == "call" and self._messages.is_builtin(taken)
        if taken is not None and is_range and self._syntax.called_name(taken) == "range":
            return Known(ValueKind.INT)
        return None

    def _call(self, call: Node, depth: int) -> Known | None:
        callee = call.child_by_field_name("function")
        if callee is None:
            return None
        name = self._syntax.called_name(call)
        if self._messages.is_builtin(call):
            return self._builtin(call, name, depth)
        names = self._analysis.resolver.qualified(callee, self._messages.scope(call))
        if names:
            kinds = {FUNCTIONS.get(each) or (TIMES.get(each)) for each in names}
            kind = kinds.pop() if len(kinds) == 1 else None
            is_old = self._is_rospy and names[0] in ("math.floor", "math.ceil")
            if kind is not None:
                return None if is_old else Known(kind)
        if callee.type == "attribute":
            found = self._method(callee, name, depth)
            if found is not None:
                return found
        function = function_of(callee, self._analysis)
        if function is None or function.kind != "function" or is_special(function):
            return None
        found = self.of(result_of(function), depth)
        return None if found is None else Known(found.kind, sources=found.sources)

    def _method(self, callee: Node, name: str, depth: int) -> Known | None:
        """Return what a method of a text or of a time gives."""
        receiver = callee.child_by_field_name("object")
        if name == "now" and not self._is_rospy and receiver is not None:
            is_clock = self._syntax.called_name(receiver) in ("get_clock", "Clock")
            return Known(ValueKind.TIME) if is_clock else None
        if name in TEXT_METHODS:
            holder = self.of(receiver, depth)
            is_text = holder is not None and holder.kind is ValueKind.TEXT
            return Known(TEXT_METHODS[name]) if is_text else None
        if name == "to_msg":
            return self._time_message(receiver, depth)
        return None

    def _time_message(self, receiver: Node | None, depth: int) -> Known | None:
        holder = self.of(receiver, depth)
        if receiver is None or holder is None or holder.kind is not ValueKind.TIME:
            return None
        made = receiver if receiver.type == "call" else None
        called = self._syntax.called_name(made)
        source = {"Duration": _DURATION, "now": _TIME, "Time": _TIME}.get(called)
        return None if source is None else Known(ValueKind.MESSAGE, sources=(source,))

    def _builtin(self, call: Node, name: str, depth: int) -> Known | None:
        arguments = Arguments.of(call, self._syntax)
        if name in BUILTINS:
            return Known(BUILTINS[name])
        if arguments.is_open or arguments.keywords or not arguments.positional:
            return None
        values = [self.of(each, depth) for each in arguments.positional]
        first = values[0]
        if name == "round":
            # Python 2 gives a float.
            is_whole = len(values) == 1 and not self._is_rospy
            return Known(ValueKind.INT) if is_whole else None
        if name == "abs" and len(values) == 1 and first is not None and first.kind in _NUMBERS:
            return Known(first.kind)
        if name in ("min", "max") and len(values) > 1:
            found = _agreed(values)
            return Known(found.kind) if found is not None and found.kind in _NUMBERS else None
        return None


def _is_plain(value: Known) -> bool:
    """Whether a value is of its kind whatever the definitions say: a field may hold anything."""
    return all(not each.path for each in value.sources)


def _agreed(values: Sequence[Known | None]) -> Known | None:
    """Return what several values are alike, None where they are not."""
    if not values or any(each is None for each in values):
        return None
    known = [each for each in values if each is not None]
    if len({each.kind for each in known}) != 1:
        return None
    sources = tuple(dict.fromkeys(source for each in known for source in each.sources))
    if len(known) == 1:
        return known[0]
    return Known(known[0].kind, sources=sources)


def _given_elsewhere(messages: MessageValues) -> frozenset[str]:
    """Return the attributes that get a value on an object that may be one of the file's."""
    found = set()
    for tag in ("assignment", "augmented"):
        for node in messages.analysis.captures.get(tag, []):
            target = node.child_by_field_name("left")
            if target is None or target.type != "attribute":
                continue
            holder, name = (target.child_by_field_name(each) for each in ("object", "attribute"))
            if holder is None or name is None:
                continue
            if holder.type == "identifier" and messages.object_class(holder) is not None:
                continue
            if not messages.held(holder):
                found.add(messages.analysis.syntax.slice(name))
    return frozenset(found)


def _extremes(numbers: Sequence[int]) -> tuple[int, ...]:
    """Return the least and the greatest of numbers."""
    return (min(numbers), max(numbers)) if numbers else ()
