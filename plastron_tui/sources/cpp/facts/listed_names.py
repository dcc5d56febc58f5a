"""The names that a parameter may have which is declared for each element of a container."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.cpp.analysis import Analysis
from plastron_tui.sources.cpp.arguments import call_of
from plastron_tui.sources.cpp.scopes import CppFile, Scope, Variable, scope_at

_READING = frozenset({"at", "begin", "cbegin", "cend", "count", "empty", "end", "find", "size"})
_TAKING_NAMES = frozenset(
    {"declare_parameter", "get_parameter", "get_parameter_or", "has_parameter"}
)
_SAME = frozenset({"c_str", "str"})
_MOST = 200
_DEEPEST = 6


def possible_names(analysis: Analysis, node: Node | None, scope: Scope) -> frozenset[str] | None:
    """Return all texts that an expression may be, among others; None where they are not known.

    Those of a container are the texts of the lists that it is made of, where nothing else may
    change it.
    """
    found = None if node is None else _texts(analysis, node, scope, _DEEPEST)
    return found if found and len(found) <= _MOST else None


def _texts(analysis: Analysis, node: Node, scope: Scope, depth: int) -> frozenset[str] | None:
    if depth == 0:
        return None
    value = analysis.evaluator.fold(node, scope)
    if value is not None:
        is_sure = value.text is not None and not (value.is_default or value.is_guess)
        return frozenset({value.text}) if is_sure and value.text is not None else None
    match node.type:
        case "subscript_expression":
            return _elements(analysis, node.child_by_field_name("argument"), scope)
        case "binary_expression":
            return _sums(analysis, node, scope, depth)
        case "call_expression":
            return _of_call(analysis, node, scope, depth)
        case "field_expression":
            # `each.first`, `each.second`, `each.name`: a part of an element.
            holder = node.child_by_field_name("argument")
            return None if holder is None else _of_loop(analysis, holder, scope)
        case "identifier":
            return _of_loop(analysis, node, scope)
    return None


def _sums(analysis: Analysis, node: Node, scope: Scope, depth: int) -> frozenset[str] | None:
    operator = node.child_by_field_name("operator")
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    if operator is None or operator.type != "+" or left is None or right is None:
        return None
    first = _texts(analysis, left, scope, depth - 1)
    second = _texts(analysis, right, scope, depth - 1)
    if not first or not second or len(first) * len(second) > _MOST:
        return None
    return frozenset(one + other for one in first for other in second)


def _of_call(analysis: Analysis, node: Node, scope: Scope, depth: int) -> frozenset[str] | None:
    call = call_of(node, scope, scope.file.syntax)
    if call is None:
        return None
    if call.receiver is not None and call.name == "at":
        return _elements(analysis, call.receiver, scope)
    if call.receiver is not None and call.name in _SAME and not call.arguments:
        return _texts(analysis, call.receiver, scope, depth - 1)
    if call.qualified in ("std::string", "string") and len(call.arguments) == 1:
        return _texts(analysis, call.arguments[0], scope, depth - 1)
    return None


def _of_loop(analysis: Analysis, node: Node, scope: Scope) -> frozenset[str] | None:
    """Return the texts of what a loop goes through whose variable a name is."""
    if node.type != "identifier":
        return None
    name = scope.file.syntax.word(node)
    variable = analysis.unit.lookup(name, scope, node.start_byte)
    if variable is not None:
        value = variable.value if variable.kind == "loop" else None
        scope = variable.scope
    else:
        value = _bound(node, name, scope)
    if value is None or value.type != "initializer_list":
        return _elements(analysis, value, scope)
    return _literals(analysis, value, scope)


def _bound(node: Node, name: str, scope: Scope) -> Node | None:
    """Return what a loop goes through that binds a name: `for (auto [name, value] : all)`."""
    syntax = scope.file.syntax
    loop = node.parent
    while loop is not None and loop.type not in ("function_definition", "lambda_expression"):
        declarator = loop.child_by_field_name("declarator")
        if loop.type == "for_range_loop" and declarator is not None:
            names = re.findall(r"\w+", syntax.word(declarator))
            if "[" in syntax.word(declarator) and name in names:
                return loop.child_by_field_name("right")
        loop = loop.parent
    return None


def _elements(analysis: Analysis, node: Node | None, scope: Scope) -> frozenset[str] | None:
    """Return the texts in the lists that a container is made of, None where others may be in it."""
    variable = None if node is None else _variable(analysis, node, scope)
    if variable is None or variable.kind not in ("local", "member", "global"):
        return None
    if not variable.is_const and not _is_only_read(analysis, variable):
        return None
    found: set[str] = set()
    for write in analysis.unit.writes(variable):
        listed = write.value
        if listed is not None and listed.type == "compound_literal_expression":
            listed = listed.child_by_field_name("value")
        if listed is None and write.arguments is not None:
            parts = write.arguments
        elif listed is not None and listed.type == "initializer_list":
            parts = [listed]
        else:
            return None
        for part in parts:
            texts = _literals(analysis, part, write.scope)
            if texts is None:
                return None
            found |= texts
    return frozenset(found)


def _variable(analysis: Analysis, node: Node, scope: Scope) -> Variable | None:
    if node.type == "field_expression":
        return analysis.receivers.member(node, scope)
    if node.type != "identifier":
        return None
    return analysis.unit.lookup(scope.file.syntax.word(node), scope, node.start_byte)


def _literals(analysis: Analysis, node: Node, scope: Scope) -> frozenset[str] | None:
    """Return the texts in a list of lists, None where some of it may be a text that is not known.

    A number, an enumerator or a key of another sort is none.
    """
    if node.type in ("initializer_list", "compound_literal_expression"):
        if node.type == "compound_literal_expression":
            inner = node.child_by_field_name("value")
            return None if inner is None else _literals(analysis, inner, scope)
        found: set[str] = set()
        for each in node.named_children:
            texts = _literals(analysis, each, scope) if each.type != "comment" else frozenset()
            if texts is None:
                return None
            found |= texts
        return frozenset(found)
    if node.type in ("number_literal", "true", "false", "unary_expression", "char_literal"):
        return frozenset()
    value = analysis.evaluator.fold(node, scope)
    if value is not None and not (value.is_default or value.is_guess):
        return frozenset() if value.text is None else frozenset({value.text})
    return frozenset() if _is_enumerator(analysis, node, scope) else None


def _is_enumerator(analysis: Analysis, node: Node, scope: Scope) -> bool:
    text = "".join(scope.file.syntax.word(node).split()).removeprefix("::")
    if node.type == "identifier":
        variable = analysis.unit.lookup(text, scope, node.start_byte)
        return variable is not None and variable.node.type == "enumerator"
    if node.type != "qualified_identifier":
        return False
    known = analysis.unit.qualified(text, scope)
    return bool(known) and all(each.node.type == "enumerator" for each in known)


def _is_only_read(analysis: Analysis, variable: Variable) -> bool:
    """Tell whether each use of a container's name reads it, or gives it a whole list."""
    word = re.compile(rb"\b%s\b" % re.escape(variable.name.encode()))
    return all(
        _is_read(node, scope_at(file, node.start_byte))
        for file in analysis.unit.all_files
        for node in _named(file, word)
    )


def _named(file: CppFile, word: re.Pattern[bytes]) -> Iterator[Node]:
    for found in word.finditer(file.syntax.code):
        node = file.syntax.root.descendant_for_byte_range(found.start(), found.end())
        if node is not None and node.type.endswith("identifier"):
            yield node


def _is_read(node: Node, scope: Scope) -> bool:
    """Tell whether a name of a container is declared, read or given a whole list."""
    around = node.parent
    if around is not None and around.type == "field_expression" and node.type != "identifier":
        node, around = around, around.parent
    if around is None or node.type == "type_identifier":
        return False
    match around.type:
        case "subscript_expression":
            return _is_value(around, scope)
        case "field_expression":
            field = around.child_by_field_name("field")
            return field is not None and scope.file.syntax.word(field) in _READING
        case "for_range_loop":
            return _copies(around, scope)
        case "assignment_expression":
            return around.child_by_field_name("left") == node
        case "init_declarator" if around.child_by_field_name("value") == node:
            return False
    return around.type.endswith(("declaration", "declarator", "field_initializer"))


def _is_value(node: Node, scope: Scope) -> bool:
    """Tell whether an element is only read: as the name of a parameter, or a part of a text."""
    around = node.parent
    if around is None or around.type != "argument_list":
        return around is not None and around.type == "binary_expression"
    call = None if around.parent is None else call_of(around.parent, scope, scope.file.syntax)
    return call is not None and call.name in _TAKING_NAMES and call.argument(0) == node


def _copies(loop: Node, scope: Scope) -> bool:
    """Tell whether a loop gets its elements as they are, to read them."""
    declarator = loop.child_by_field_name("declarator")
    if declarator is None or declarator.type != "reference_declarator":
        return True
    return b"const" in scope.file.syntax.code[loop.start_byte : declarator.start_byte]
