"""Where what a call creates is kept: the statement of the call, and the variable or member."""

from __future__ import annotations

from tree_sitter import Node

from .analysis import Analysis, Site
from .arguments import Call
from .scopes import Variable, last_name

_STATEMENTS = ("_statement", "declaration", "field_initializer")
_KEEPING = frozenset({"push_back", "emplace_back", "insert", "emplace", "reset"})
_MOST_ABOVE = 64


def statement_of(site: Site) -> Node:
    """Return the statement, declaration or member initializer that a call is in."""
    node = site.call.node
    for _ in range(_MOST_ABOVE):
        if node.type.endswith(_STATEMENTS) or node.parent is None:
            break
        node = node.parent
    return node


def holder_of(analysis: Analysis, site: Site) -> Variable | None:
    """Return the variable or member that has what a call creates, None for none.

    A member is declared in its class, which may be in a header: `Variable.file`. What is put into
    a list is kept by the list.
    """
    return holder_of_call(analysis, site.call)


def holder_of_call(analysis: Analysis, call: Call) -> Variable | None:
    """Return the variable or member that has what a call gives back, None for none."""
    name, at = _held(call)
    if at is None or not name:
        return None
    return analysis.unit.lookup(name, call.scope, at.start_byte)


def _held(call: Call) -> tuple[str, Node | None]:
    """Return the name of what has it, and where that stands."""
    node = call.node
    scope = call.scope
    syntax = scope.file.syntax
    for _ in range(_MOST_ABOVE):
        if node.type == "field_initializer":
            first = node.named_children[0] if node.named_child_count else None
            return (syntax.word(first), first) if first is not None else ("", None)
        if node.type in ("declaration", "field_declaration"):
            return _declared(node, call)
        if node.type == "assignment_expression":
            left = node.child_by_field_name("left")
            if left is not None and left.type == "subscript_expression":
                left = left.child_by_field_name("argument")
            return (last_name(left, scope), left) if left is not None else ("", None)
        if node.type == "call_expression" and node.id != call.node.id:
            function = node.child_by_field_name("function")
            is_method = function is not None and function.type == "field_expression"
            if function is None or not is_method or last_name(function, scope) not in _KEEPING:
                return "", None
            holder = function.child_by_field_name("argument")
            return (last_name(holder, scope), holder) if holder is not None else ("", None)
        if node.type.endswith("_statement") or node.parent is None:
            break
        node = node.parent
    return "", None


def _declared(node: Node, call: Call) -> tuple[str, Node | None]:
    """Return the variable of a declaration that a call is in, or that it makes."""
    inner = call.node
    for scope in call.scope.chain:
        for variables in scope.variables.values():
            for variable in variables:
                if variable.node.id != node.id or variable.declarator is None:
                    continue
                outer = variable.declarator.parent
                is_made = node.id == inner.id
                if is_made or (
                    outer is not None and outer.end_byte >= inner.end_byte > outer.start_byte
                ):
                    return variable.name, variable.declarator
    return "", None
