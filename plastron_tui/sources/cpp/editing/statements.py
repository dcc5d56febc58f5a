"""Statements of C++ as an editor looks at them."""

from __future__ import annotations

import re

from tree_sitter import Node

from ..analysis import Analysis
from ..scopes import CppFile, Scope, Variable, last_name
from ..syntax import Syntax
from .deletions import Deletions

_LOOPS = frozenset({"while_statement", "do_statement", "for_statement"})
_ENDLESS = re.compile(r"\bok\(|\A\(?\s*(?:true|1)\s*\)?\Z")
_BLOCKS = frozenset(
    {"compound_statement", "translation_unit", "declaration_list", "field_declaration_list"}
)


def is_inside(node: Node, outer: Node | None) -> bool:
    """Tell whether a node is a part of another one of its file, or that itself."""
    return outer is not None and outer.start_byte <= node.start_byte < outer.end_byte


def statement_of(node: Node) -> Node | None:
    """Return the statement that a node is in, whatever block that is in."""
    inner: Node | None = node
    while inner is not None and inner.parent is not None:
        if inner.parent.type in _BLOCKS or inner.type.endswith("statement"):
            return inner
        inner = inner.parent
    return None


def calls_method(statement: Node, node: Node, syntax: Syntax, names: frozenset[str]) -> bool:
    """Tell whether a statement is the call of a method of some names on what a node names."""
    call = statement.named_children[0] if statement.named_child_count == 1 else None
    if call is None or call.type != "call_expression":
        return False
    callee = call.child_by_field_name("function")
    if callee is None or callee.type != "field_expression":
        return False
    field, holder = callee.child_by_field_name("field"), callee.child_by_field_name("argument")
    if field is None or holder is None or syntax.word(field) not in names:
        return False
    return holder.start_byte <= node.start_byte and node.end_byte <= holder.end_byte


def sets_what_stays(analysis: Analysis, statement: Node, scope: Scope) -> bool:
    """Tell whether what a call is given sets a member or a variable of the file on the way.

    As in `pub.publish(last_ = message)`.
    """
    stack = [statement]
    while stack:
        each = stack.pop()
        if each.type in ("assignment_expression", "update_expression"):
            target = each.child_by_field_name("left") or each.child_by_field_name("argument")
            name = last_name(target, scope) if target and target.type == "identifier" else ""
            variable = analysis.unit.lookup(name, scope, each.start_byte) if name else None
            if variable is None or variable.kind != "local":
                return True
        if each.type != "lambda_expression":
            stack += each.named_children
    return False


def only_sets(statement: Node, node: Node) -> bool:
    """Tell whether a statement does nothing but give what a node names, or a part of it, a value.

    What calls a function may do more.
    """
    inner = statement.named_children[0] if statement.named_child_count == 1 else None
    if statement.type != "expression_statement" or inner is None:
        return False
    if inner.type != "assignment_expression":
        return False
    left = inner.child_by_field_name("left")
    return is_inside(node, left) and inner.child_by_field_name("right") is not None


def only_calls(statement: Node, node: Node) -> bool:
    """Tell whether a statement does nothing but call a method of what a node names, or a part."""
    inner = statement.named_children[0] if statement.named_child_count == 1 else None
    if statement.type != "expression_statement" or inner is None:
        return False
    callee = inner.child_by_field_name("function") if inner.type == "call_expression" else None
    return callee is not None and callee.start_byte == node.start_byte


def local_of(analysis: Analysis, statement: Node, scope: Scope) -> Variable | None:
    """Return the local variable that alone is given to a statement's call."""
    call = statement.named_children[0]
    listed = call.child_by_field_name("arguments")
    given = listed.named_children if listed is not None else []
    if len(given) != 1:
        return None
    node = given[0]
    if node.type == "pointer_expression":
        node = node.child_by_field_name("argument") or node
    if node.type == "call_expression":
        # `std::move(message)`
        inner = node.child_by_field_name("arguments")
        node = (
            inner.named_children[0] if inner is not None and inner.named_child_count == 1 else node
        )
    name = last_name(node, scope)
    variable = analysis.unit.lookup(name, scope, node.start_byte) if name else None
    return variable if variable is not None and variable.kind == "local" else None


def emptied(node: Node, file: CppFile, gone: Deletions) -> Node | None:
    """Return the `if` around a use that only asks, where nothing is left of what it guards."""
    inner: Node | None = node
    while inner is not None and inner.type != "if_statement":
        if inner.type.endswith("statement"):
            return None
        inner = inner.parent
    if inner is None or inner.child_by_field_name("alternative") is not None:
        return None
    body = inner.child_by_field_name("consequence")
    if body is None:
        return None
    parts = body.named_children if body.type == "compound_statement" else [body]
    return inner if all(gone.covers(file, each.start_byte) for each in parts) else None


def is_endless(file: CppFile, statement: Node) -> bool:
    """Tell whether a statement is a loop that ends with the node: `while (ros::ok())`."""
    if statement.type not in _LOOPS:
        return False
    condition = statement.child_by_field_name("condition")
    return condition is None or _ENDLESS.search(file.syntax.word(condition)) is not None


def above(statement: Node) -> Node | None:
    """Return the statement above another one, None for none."""
    found = statement.prev_named_sibling
    while found is not None and found.type == "comment":
        found = found.prev_named_sibling
    return found
