"""What kind of value an expression gives, as far as the file says it for sure."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.ros.interfaces import FieldType, Section
from plastron_tui.sources.python.constants import without_none
from plastron_tui.sources.python.scopes import Binding, BindingKind
from plastron_tui.sources.python.syntax import parts_of

from .message_types import constructed, typed
from .port_state import Work

MESSAGE = "a message"
PLAIN = "plain"
"""A value of Python that is no message, and nothing more is known of it."""

NUMBER = "number"
REAL = "real"
"""A number with a fraction, which may be one of numpy's instead of a `float`."""

LIST = "list"
_NUMBERS = frozenset({"int", "float", "bool", NUMBER, REAL})

_LITERALS = {
    "concatenated_string": "str",
    "integer": "int",
    "float": "float",
    "true": "bool",
    "false": "bool",
    "comparison_operator": "bool",
    "not_operator": "bool",
    "list": LIST,
    "tuple": LIST,
    "list_comprehension": LIST,
    "dictionary": "dict",
    "dictionary_comprehension": "dict",
}
_BUILT_IN = {"str": "str", "repr": "str", "int": "int", "len": "int", "float": "float"}
_BUILT_IN |= {"bool": "bool", "abs": NUMBER, "round": NUMBER, "sum": NUMBER, "ord": "int"}
_BUILT_IN |= {"list": LIST, "sorted": LIST, "range": LIST, "dict": "dict", "chr": "str"}
_FUNCTIONS = {
    "time.time": "float",
    "random.random": "float",
    "random.uniform": "float",
    "random.gauss": "float",
    "random.randint": "int",
    "random.randrange": "int",
    "math.sin": "float",
    "math.cos": "float",
    "math.tan": "float",
    "math.sqrt": "float",
    "math.radians": "float",
    "math.degrees": "float",
    "math.floor": "int",
    "math.ceil": "int",
    "json.dumps": "str",
    "rospy.get_time": "float",
    "rospy.get_name": "str",
    "rospy.get_param": PLAIN,
    "rospy.get_caller_id": "str",
}
_OF_TEXT = frozenset({"format", "join", "upper", "lower", "strip", "lstrip", "rstrip", "replace"})
_OF_TEXT |= {"title", "capitalize", "zfill", "ljust", "rjust"}


def is_plain(kind: str | None) -> bool:
    """Tell whether a value is no message for sure."""
    return kind is not None and kind != MESSAGE


def kind_of(work: Work, node: Node | None) -> str | None:
    """Return what an expression gives, None where the file does not say it.

    It is `str`, `bytes`, `int`, `float`, `bool`, `dict`, `NUMBER`, `REAL`, `LIST`, `MESSAGE` or
    `PLAIN`.
    """
    if node is None:
        return None
    if node.id not in work.kinds:
        # What depends on itself, as in `x = x + 1`, is not known while it is looked at.
        work.kinds[node.id] = None
        work.kinds[node.id] = _kind(work, node)
    return work.kinds[node.id]


def _kind(work: Work, node: Node) -> str | None:
    if node.type in _LITERALS:
        return _LITERALS[node.type]
    match node.type:
        case "string":
            prefix = work.slice(node).partition('"')[0].partition("'")[0].lower()
            return "bytes" if "b" in prefix else "str"
        case "parenthesized_expression":
            return kind_of(work, node.named_children[0])
        case "unary_operator":
            kind = kind_of(work, node.child_by_field_name("argument"))
            return kind if kind in ("int", "float", REAL) else NUMBER
        case "conditional_expression" | "boolean_operator":
            parts = parts_of(node)
            return _common([kind_of(work, each) for each in (parts[0], parts[-1])])
        case "binary_operator":
            return _of_operator(work, node)
        case "call":
            return _of_call(work, node)
        case "identifier" | "attribute":
            return _of_name(work, node)
        case "subscript":
            return _of_subscript(work, node)
    return None


def _of_subscript(work: Work, node: Node) -> str | None:
    """Return what a part of a text or list is, or an element of a sequence of floats.

    That of a fixed array is numpy's.
    """
    items, index = (node.child_by_field_name(each) for each in ("value", "subscript"))
    kind = kind_of(work, items)
    if index is not None and index.type == "slice" and kind in ("str", "bytes", LIST):
        return kind
    type_ = typed(work, items) if items is not None else None
    if not isinstance(type_, FieldType) or index is None or index.type == "slice":
        return None
    is_sequence = type_.is_array and type_.length is None
    return "float" if is_sequence and type_.name.startswith("float") else None


def _common(kinds: list[str | None]) -> str | None:
    """Return what all of some values are."""
    found = set(kinds)
    if not found or None in found:
        return None
    if len(found) == 1:
        return kinds[0]
    if found <= _NUMBERS:
        return NUMBER
    return None if MESSAGE in found else PLAIN


def _of_operator(work: Work, node: Node) -> str:
    """Return what an operator gives; messages have none."""
    left = kind_of(work, node.child_by_field_name("left"))
    right = kind_of(work, node.child_by_field_name("right"))
    operator = node.child_by_field_name("operator")
    sign = work.slice(operator) if operator is not None else ""
    if left == "str" and sign == "%":
        return "str"
    if sign in ("+", "*") and "str" in (left, right):
        return "str"
    if "str" in (left, right) or LIST in (left, right):
        return PLAIN
    if sign in "+-*/" and ({"float", REAL} & {left, right} or sign == "/"):
        return "float" if {left, right} <= {"int", "float", "bool"} else REAL
    if {left, right} <= {"int", "bool"} and sign in ("+", "-", "*", "//", "%"):
        return "int"
    return NUMBER if left in _NUMBERS and right in _NUMBERS else PLAIN


def _of_call(work: Work, call: Node) -> str | None:
    callee = call.child_by_field_name("function")
    if callee is None:
        return None
    name = work.slice(callee)
    if name in _BUILT_IN and work.scope(callee).lookup(name) is None:
        return _BUILT_IN[name]
    if name in ("min", "max") and work.scope(callee).lookup(name) is None:
        # Messages have no order: only a key compares them.
        arguments = parts_of(call.child_by_field_name("arguments"))
        return None if any(each.type == "keyword_argument" for each in arguments) else PLAIN
    for found in work.qualified(callee):
        if found in _FUNCTIONS:
            return _FUNCTIONS[found]
    if constructed(work, callee) is not None:
        return MESSAGE
    part, holder = callee.child_by_field_name("attribute"), callee.child_by_field_name("object")
    if part is not None and holder is not None and work.slice(part) in _OF_TEXT:
        return "str" if kind_of(work, holder) == "str" else None
    return None


def _of_name(work: Work, node: Node) -> str | None:
    type_ = typed(work, node)
    if isinstance(type_, Section):
        return MESSAGE
    if type_ is not None:
        return _of_field(type_)
    bindings = work.bindings(node)
    given = [each for each in without_none(bindings) if not _augments(each)]
    return _common([_of_binding(work, each) for each in given])


def _of_field(type_: FieldType) -> str | None:
    """Return what a field of a message that came in holds."""
    if type_.package is not None or type_.name in ("time", "duration"):
        return None
    if type_.is_array:
        return None if type_.name in ("uint8", "char") else LIST
    if type_.name in ("bool", "string"):
        return {"bool": "bool", "string": "str"}[type_.name]
    return "float" if type_.name.startswith("float") else "int"


def _augments(binding: Binding) -> bool:
    """Tell whether a binding is an `x += 1`, which leaves a message no message."""
    return binding.node.type == "augmented_assignment"


def _of_binding(work: Work, binding: Binding) -> str | None:
    if binding.kind is BindingKind.VALUE:
        return kind_of(work, binding.value)
    if binding.node.type == "for_statement":
        items = binding.node.child_by_field_name("right")
        left = binding.node.child_by_field_name("left")
        if items is None or left is None or left.type != "identifier":
            return None
        callee = items.child_by_field_name("function")
        if callee is not None and work.slice(callee) in ("range", "xrange"):
            return "int"
        if items.type in ("list", "tuple"):
            return _common([kind_of(work, each) for each in parts_of(items)])
    return None


def some_plain(work: Work, node: Node) -> bool:
    """Tell whether a name is bound to something plain in one place, whatever it is in others."""
    if is_plain(kind_of(work, node)):
        return True
    if node.type == "identifier":
        found = work.scope(node).lookup(work.slice(node))
        values = [each.value for each in found[1]] if found is not None else []
        return any(is_plain(kind_of(work, each)) for each in values if each)
    if node.type in ("conditional_expression", "boolean_operator"):
        parts = parts_of(node)
        return any(is_plain(kind_of(work, each)) for each in (parts[0], parts[-1]))
    return False
