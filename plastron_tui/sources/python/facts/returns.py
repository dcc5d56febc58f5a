"""What calls of a function of a file give."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.syntax import parts_of

_DEFINITIONS = frozenset({"function_definition", "class_definition", "lambda"})
_LEAVING = frozenset({"return_statement", "raise_statement", "while_statement", "yield"})


def is_decorated(function: Scope) -> bool:
    """Whether something else may stand in the place of a function."""
    parent = function.node.parent
    return parent is not None and parent.type == "decorated_definition"


def is_special(function: Scope) -> bool:
    """Whether a call of a function gives something else than its `return`, or may do so."""
    return is_decorated(function) or any(each.type == "async" for each in function.node.children)


def gives_nothing(function: Scope) -> bool:
    """Whether a function comes to its end and gives None: it has no `return`, `raise` or `yield`.

    One that only stands for another one (`pass`, `...`) may be anything.
    """
    body = function.node.child_by_field_name("body")
    is_stub = body is None or b"=" not in (body.text or b"")
    if function.node.type != "function_definition" or is_stub:
        return False
    pending = [body]
    while pending:
        node = pending.pop()
        if node is None or node.type in _DEFINITIONS:
            continue
        if node.type in _LEAVING:
            return False
        pending += node.named_children
    return True


def returned_values(function: Scope) -> list[Node]:
    """Return the expressions of the `return` statements of a function; none for a generator."""
    return [each for statement in return_statements(function) for each in parts_of(statement)]


def return_statements(function: Scope) -> list[Node]:
    """Return the `return` statements of a function; none for a generator."""
    found: list[Node] = []
    pending = [function.node.child_by_field_name("body")]
    while pending:
        node = pending.pop()
        if node is None or node.type in _DEFINITIONS:
            continue
        if node.type == "yield":
            return []
        if node.type == "return_statement":
            found.append(node)
        pending += node.named_children
    return found
