"""The types that parameters get from their defaults, as far as C++ says them for sure.

Source: the constructors of `rclcpp::ParameterValue` of Jazzy.
"""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.sources.cpp.analysis import Analysis
from plastron_tui.sources.cpp.parameter_details import type_of_text, type_of_worth
from plastron_tui.sources.cpp.scopes import Scope, Variable, type_text

_LITERALS = frozenset({"number_literal", "string_literal", "raw_string_literal", "true", "false"})
_NUMBERS = frozenset({"int", "float"})
_CALCULATING = frozenset({"+", "-", "*", "/"})
_COMPARING = frozenset({"==", "!=", "<", ">", "<=", ">=", "&&", "||"})
_MATH = re.compile(r"M_(?:E|LOG2E|LOG10E|LN2|LN10|PI(?:_[24])?|[12]_PI|2_SQRTPI|SQRT(?:2|1_2))")
"""What `<cmath>` defines, each a `double`."""

_NAMED_TYPES = {"BOOL": "bool", "INTEGER": "int", "DOUBLE": "float", "STRING": "string"}
_NAMED_TYPE = re.compile(r"(?:.*::)?PARAMETER_(?P<type>[A-Z]+)(?P<list>_ARRAY)?")
_OF_TEMPLATE = re.compile(
    r"(?:static_cast<(?P<cast>[^<>]+)>|(?:std::)?numeric_limits<(?P<limit>[^<>]+)>::\w+)"
)
_DEEPEST = 8


def type_of_default(analysis: Analysis, node: Node, scope: Scope) -> str | None:
    """Return the type of a default; a number that a variable has says nothing of its type."""
    return _type(analysis, node, scope, _DEEPEST)


def _type(analysis: Analysis, node: Node, scope: Scope, depth: int) -> str | None:
    if depth == 0:
        return None
    syntax = scope.file.syntax
    if node.type in _LITERALS:
        return type_of_worth(analysis.evaluator.fold(node, scope))
    match node.type:
        case "unary_expression":
            return _of_unary(analysis, node, scope, depth)
        case "binary_expression":
            return _of_binary(analysis, node, scope, depth)
        case "parenthesized_expression" if node.named_child_count == 1:
            return _type(analysis, node.named_children[0], scope, depth - 1)
        case "call_expression":
            return _of_call(analysis, node, scope, depth)
        case "compound_literal_expression":
            return _of_braces(analysis, node, scope, depth)
        case "cast_expression":
            cast = node.child_by_field_name("type")
            return None if cast is None else _of_text(type_text(syntax.word(cast)))
        case "identifier" | "qualified_identifier":
            return _of_name(analysis, node, scope, depth)
        case "field_expression" | "subscript_expression":
            return _of_text(analysis.receivers.type_of(node, scope))
    return None


def _of_text(text: str) -> str | None:
    """Return the type of parameter that a type is for; a single `char` counts as a number."""
    return None if text == "char" else type_of_text(text)


def _of_unary(analysis: Analysis, node: Node, scope: Scope, depth: int) -> str | None:
    operator, inner = node.child_by_field_name("operator"), node.child_by_field_name("argument")
    if operator is None or inner is None:
        return None
    if operator.type == "!":
        return "bool"
    found = _type(analysis, inner, scope, depth - 1)
    return found if operator.type in ("-", "+") and found in _NUMBERS else None


def _of_binary(analysis: Analysis, node: Node, scope: Scope, depth: int) -> str | None:
    operator = node.child_by_field_name("operator")
    sides = (node.child_by_field_name("left"), node.child_by_field_name("right"))
    if operator is None:
        return None
    found = {None if each is None else _type(analysis, each, scope, depth - 1) for each in sides}
    if operator.type in _CALCULATING and found <= _NUMBERS:
        return "float" if "float" in found else "int"
    if operator.type == "+" and found == {"string"}:
        return "string"
    return "bool" if operator.type in _COMPARING and None not in found else None


def _of_call(analysis: Analysis, node: Node, scope: Scope, depth: int) -> str | None:
    callee = node.child_by_field_name("function")
    text = type_text(scope.file.syntax.word(callee)) if callee is not None else ""
    given = node.child_by_field_name("arguments")
    if text.rpartition("::")[2] == "ParameterValue" and given and given.named_child_count == 1:
        return _type(analysis, given.named_children[0], scope, depth - 1)
    if (found := _OF_TEMPLATE.fullmatch(text)) is not None:
        return _of_text(found["cast"] or found["limit"])
    is_method = callee is not None and callee.type == "field_expression"
    returned = "" if is_method else analysis.receivers.type_of(node, scope)
    return type_of_text(text) or _of_text(returned)


def _of_braces(analysis: Analysis, node: Node, scope: Scope, depth: int) -> str | None:
    made, given = node.child_by_field_name("type"), node.child_by_field_name("value")
    text = "" if made is None else type_text(scope.file.syntax.word(made))
    if text.rpartition("::")[2] == "ParameterValue" and given and given.named_child_count == 1:
        return _type(analysis, given.named_children[0], scope, depth - 1)
    return type_of_text(text)


def _of_name(analysis: Analysis, node: Node, scope: Scope, depth: int) -> str | None:
    text = "".join(scope.file.syntax.word(node).split())
    named = _NAMED_TYPE.fullmatch(text)
    if named is not None:
        found = _NAMED_TYPES.get(named["type"])
        return f"{found}_list" if found and named["list"] else found
    unit = analysis.unit
    if node.type == "qualified_identifier":
        variables = unit.qualified(text.removeprefix("::"), scope)
    else:
        variable = unit.lookup(text, scope, node.start_byte)
        if variable is None:
            if text in unit.defines:
                return type_of_worth(analysis.evaluator.fold(node, scope))
            return "float" if _MATH.fullmatch(text) else None
        variables = [variable]
    types = {_of_variable(analysis, each, depth) for each in variables}
    return types.pop() if len(types) == 1 else None


def _of_variable(analysis: Analysis, variable: Variable, depth: int) -> str | None:
    if variable.type == "auto" and variable.value is not None and variable.kind != "loop":
        found = _type(analysis, variable.value, variable.scope, depth - 1)
        if found is not None:
            return found
    if variable.type == "char":
        return "string" if variable.is_pointer or variable.is_array else None
    return type_of_text(analysis.receivers.type_of_variable(variable))
