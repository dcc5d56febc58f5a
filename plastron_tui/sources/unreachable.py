"""Whether a part of a function can run at all."""

from __future__ import annotations

from tree_sitter import Node

_LEAVING = frozenset(
    {"break_statement", "continue_statement", "goto_statement", "raise_statement",
     "return_statement", "throw_statement"}
)  # fmt: skip
_BLOCKS = frozenset({"block", "case_statement", "compound_statement", "module"})
_FUNCTIONS = frozenset(
    {"class_definition", "class_specifier", "function_definition", "lambda", "lambda_expression"}
)
_LABELS = frozenset({"case_statement", "labeled_statement"})
_NEVER = frozenset({b"False", b"0", b"(false)", b"(0)", b"(False)"})


def is_unreachable(node: Node) -> bool:
    """Tell whether a part of a function never runs, in Python or C++.

    It stands behind what leaves its block in any case, or below a condition that says so itself.
    """
    current = node
    while (parent := current.parent) is not None and current.type not in _FUNCTIONS:
        if parent.type in _BLOCKS and _is_behind_leaving(current):
            return True
        if parent.type in ("if_statement", "while_statement") and _is_never(parent, current):
            return True
        current = parent
    return False


def _is_behind_leaving(statement: Node) -> bool:
    """Tell whether a statement before another one of its block surely leaves the block."""
    before: Node | None = statement
    while before is not None and before.type not in _LABELS:
        before = before.prev_named_sibling
        if before is not None and leaves(before):
            return True
    return False


def leaves(statement: Node | None) -> bool:
    """Tell whether nothing that follows a statement runs."""
    if statement is None:
        return False
    if statement.type in _LEAVING:
        return True
    if statement.type in ("block", "compound_statement"):
        # What a label is before is reached from elsewhere.
        inner = statement.named_children
        return any(map(leaves, inner)) and not any(each.type in _LABELS for each in inner)
    if statement.type == "else_clause":
        return leaves(statement.named_children[-1] if statement.named_children else None)
    if statement.type not in ("if_statement", "elif_clause"):
        return False
    others = statement.children_by_field_name("alternative")
    is_whole = bool(others) and others[-1].type == "else_clause"
    first = statement.child_by_field_name("consequence")
    if statement.type == "elif_clause":
        return leaves(first)
    return is_whole and leaves(first) and all(map(leaves, others))


def _is_never(statement: Node, part: Node) -> bool:
    """Tell whether a part of a statement hangs on a condition that is written as false."""
    condition = statement.child_by_field_name("condition")
    if condition is None or condition.text not in _NEVER:
        return False
    named = "body" if statement.type == "while_statement" else "consequence"
    body = statement.child_by_field_name(named)
    return body is not None and body.id == part.id
