"""The values that the code of a unit gives to fields of messages: literals, and other fields.

C++ converts numbers into each other: what a field is, is for rules to look up.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.code_facts import FieldValue, MessageField, ValueKind
from plastron_tui.sources.cpp.analysis import Analysis
from plastron_tui.sources.cpp.arguments import call_of
from plastron_tui.sources.cpp.scopes import Scope

from .message_types import MessageTypes
from .places import Conditionals, span_of

_TEXTS = frozenset({"std::string", "string", "std::to_string", "to_string"})
_NUMBER = re.compile(r"[0-9][0-9a-fA-FxXbB']*[uUlLzZ]*")


def field_values(analysis: Analysis, types: MessageTypes) -> Iterator[FieldValue]:
    """Yield the values that are assigned to fields."""
    for file in analysis.unit.files:
        conditionals = Conditionals(file)
        for node, scope in file.assignments:
            left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
            operator = node.child_by_field_name("operator")
            if left is None or right is None or operator is None or operator.type != "=":
                continue
            reach = types.of(left, scope)
            if reach is None or not reach.path or conditionals.has(node.start_byte):
                continue
            kind, source = _kind(analysis, right, scope), None
            if kind is None:
                given = types.of(right, scope)
                if given is None or given.is_list:
                    continue
                kind, source = ValueKind.MESSAGE, MessageField(given.type, given.path)
            is_literal = right.type.endswith(("literal", "string", "true", "false"))
            text = file.syntax.slice(right) if is_literal else ""
            yield FieldValue(
                reach.type, reach.path, kind, span_of(right), file.name, text, source=source
            )


def _kind(analysis: Analysis, node: Node, scope: Scope) -> ValueKind | None:
    """Return what a value is, None where its source does not say it."""
    match node.type:
        case "string_literal" | "concatenated_string" | "raw_string_literal":
            return ValueKind.TEXT
        case "true" | "false":
            return ValueKind.BOOL
        case "null" | "nullptr":
            return ValueKind.NONE
        case "number_literal":
            is_whole = _NUMBER.fullmatch(scope.file.syntax.word(node)) is not None
            return ValueKind.INT if is_whole else ValueKind.FLOAT
        case "unary_expression":
            inner = _kind(analysis, argument, scope) if (argument := _operand(node)) else None
            return inner if inner in (ValueKind.INT, ValueKind.FLOAT) else None
        case "identifier":
            variable = analysis.unit.lookup(scope.file.syntax.word(node), scope, node.start_byte)
            is_text = variable is not None and variable.type == "std::string"
            is_one = variable is not None and not variable.is_pointer and not variable.is_array
            return ValueKind.TEXT if is_text and is_one else None
        case "call_expression":
            call = call_of(node, scope, scope.file.syntax)
            is_text = call is not None and call.receiver is None and call.qualified in _TEXTS
            return ValueKind.TEXT if is_text else None
        case _:
            return None


def _operand(node: Node) -> Node | None:
    operator = node.child_by_field_name("operator")
    if operator is None or operator.type not in ("-", "+"):
        return None
    return node.child_by_field_name("argument")
