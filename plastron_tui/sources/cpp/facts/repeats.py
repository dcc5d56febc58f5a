"""Whether a part of a function is done each time that the function is called."""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.sources.cpp.scopes import Function, Scope

_THROUGH = frozenset(
    {
        "argument_list", "assignment_expression", "call_expression", "compound_statement",
        "declaration", "else_clause", "expression_statement", "field_expression",
        "init_declarator", "parenthesized_expression", "pointer_expression", "try_statement",
    }
)  # fmt: skip
_LEAVING = re.compile(rb"\b(?:return|throw|break|continue|goto|exit|co_return)\b")
_NAME = re.compile(rb"(?<![\w.>])[A-Za-z_]\w*")
_CALLED = re.compile(rb"(?<![\w.>])(?:\w+::)*\w+\s*\(")
_TEXT = re.compile(rb'"(?:[^"\\\n]|\\.)*"')
_STATIC = re.compile(rb"\bstatic\b")


def runs_each_time(node: Node, body: Node, taken: frozenset[bytes], code: bytes) -> bool:
    """Tell whether a part of a body runs whenever the body does, at least for some messages.

    Args:
        node: the part.
        body: the block of a function or of a loop.
        taken: the parameters of the function: what hangs on them alone comes again.
        code: the text that both are in.
    """
    if node.type == "declaration" and _STATIC.match(code, node.start_byte):
        return False
    while node.id != body.id:
        parent = node.parent
        if parent is None:
            return False
        is_static = parent.type == "declaration" and _STATIC.match(code, parent.start_byte)
        if parent.type == "if_statement":
            if not _hangs_on(parent, node, taken, code):
                return False
        elif is_static or (parent.type not in _THROUGH and parent.id != body.id):
            return False
        if parent.type == "compound_statement" and any(
            _may_leave(before, taken, code)
            for before in parent.named_children
            if before.start_byte < node.start_byte
        ):
            return False
        node = parent
    return True


def _hangs_on(branch: Node, node: Node, taken: frozenset[bytes], code: bytes) -> bool:
    """Tell whether a branch is taken or not by what its function is given, and by that alone."""
    branches = (branch.child_by_field_name(name) for name in ("consequence", "alternative"))
    is_branch = any(each is not None and each.id == node.id for each in branches)
    return is_branch and _asks_only(branch, taken, code)


def _may_leave(statement: Node, taken: frozenset[bytes], code: bytes) -> bool:
    """Tell whether a statement may end its function for more reasons than what that is given."""
    if _LEAVING.search(code, statement.start_byte, statement.end_byte) is None:
        return False
    return statement.type != "if_statement" or not _asks_only(statement, taken, code)


def _asks_only(branch: Node, taken: frozenset[bytes], code: bytes) -> bool:
    """Tell whether a condition asks for nothing but what its function is given."""
    condition = branch.child_by_field_name("condition")
    if condition is None:
        return False
    text = _TEXT.sub(b"", code[condition.start_byte : condition.end_byte])
    names = set(_NAME.findall(_CALLED.sub(b"(", text)))
    return bool(names) and names <= taken | {b"true", b"false", b"nullptr"}


def parameters_of(scope: Scope) -> frozenset[bytes]:
    """Return the names of what a function is given."""
    function: Function | None = scope.function
    found = function.parameters if function is not None else []
    return frozenset(each.name.encode() for each in found if each.name)
