"""Whether something that the file only gives `None` has another value where it is used."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.scopes import BindingKind
from plastron_tui.sources.python.syntax import FUNCTIONS, parts_of
from plastron_tui.sources.unreachable import leaves

from .base_files import read_bases
from .message_values import MessageValues

_DEEPEST = 32
_MOST_BEFORE = 200


def is_checked(node: Node) -> bool:
    """Tell whether a name, or an attribute, is used only where a check says that it is not None."""
    said = node.text or b""
    current = node
    while (parent := current.parent) is not None and parent.type not in FUNCTIONS:
        if _holds(parent, current, said):
            return True
        if parent.type in ("block", "module") and _is_left_before(current, said):
            return True
        current = parent
    return parent is not None and _is_left_before(current, said)


def is_filled_elsewhere(messages: MessageValues, node: Node) -> bool:
    """Tell whether another file may give an attribute a value: the placeholder is no value then.

    It does in a base class of another file, or in a class that derives from one that the file
    makes no object of.
    """
    holder, name_node = (node.child_by_field_name(each) for each in ("object", "attribute"))
    owner = messages.object_class(holder) if holder is not None else None
    if owner is None or name_node is None:
        return False
    analysis = messages.analysis
    family = (owner, *analysis.resolver.classes.derived(owner))
    names = {each.name for each in family}
    calls = analysis.captures.get("call", [])
    if not any(analysis.syntax.called_name(each) in names for each in calls):
        return True
    name = analysis.syntax.slice(name_node)
    for each in family:
        bases = read_bases(analysis, each)
        if bases is None:
            return True
        for base in bases:
            given = base.file.resolver.classes.attribute(base.owner, name)
            if any(x.kind is not BindingKind.VALUE or not _is_none(x.value) for x in given):
                return True
    return False


def _is_none(node: Node | None) -> bool:
    return node is not None and node.type == "none"


def _holds(parent: Node, part: Node, said: bytes) -> bool:
    """Tell whether a part of an expression or statement runs only where a value is not None."""
    if parent.type in ("if_statement", "elif_clause", "while_statement"):
        condition = parent.child_by_field_name("condition")
        body = parent.child_by_field_name(
            "body" if parent.type == "while_statement" else "consequence"
        )
        if body is not None and part.id == body.id:
            return _says(condition, said, is_true=True)
        is_other = parent.type == "if_statement" and part.type in ("elif_clause", "else_clause")
        return is_other and _says_of_others(parent, part, said)
    if parent.type == "conditional_expression":
        parts = parts_of(parent)
        at = next((at for at, each in enumerate(parts) if each.id == part.id), 1)
        return at != 1 and len(parts) == 3 and _says(parts[1], said, is_true=at == 0)
    if parent.type == "boolean_operator":
        left, operator = (parent.child_by_field_name(each) for each in ("left", "operator"))
        is_right = left is not None and left.id != part.id and operator is not None
        return is_right and operator is not None and _says(left, said, operator.type == "and")
    return False


def _says_of_others(statement: Node, part: Node, said: bytes) -> bool:
    """Tell whether the conditions before a branch, all of which are false, exclude None."""
    before = [statement, *statement.children_by_field_name("alternative")]
    conditions = [
        each.child_by_field_name("condition")
        for each in before
        if each.id == statement.id or each.start_byte < part.start_byte
    ]
    return any(_says(each, said, is_true=False) for each in conditions)


def _is_left_before(statement: Node, said: bytes) -> bool:
    """Tell whether a statement before another one of its block goes no further with None."""
    before = statement.prev_named_sibling
    for _ in range(_MOST_BEFORE):
        if before is None:
            return False
        if before.type == "assert_statement":
            if _says(next(iter(parts_of(before)), None), said, is_true=True):
                return True
        elif before.type == "if_statement":
            condition = before.child_by_field_name("condition")
            others = before.children_by_field_name("alternative")
            first = before.child_by_field_name("consequence")
            if leaves(first) and _says(condition, said, is_true=False):
                return True
            is_plain = len(others) == 1 and others[0].type == "else_clause"
            if is_plain and leaves(others[0]) and _says(condition, said, is_true=True):
                return True
        before = before.prev_named_sibling
    return False


def _says(condition: Node | None, said: bytes, is_true: bool, depth: int = 0) -> bool:
    """Tell whether something is not None where a condition is true, or is false."""
    if condition is None or depth > _DEEPEST:
        return False
    if condition.text == said:
        return is_true
    parts = parts_of(condition)
    match condition.type:
        case "parenthesized_expression":
            return len(parts) == 1 and _says(parts[0], said, is_true, depth + 1)
        case "not_operator":
            return len(parts) == 1 and _says(parts[0], said, not is_true, depth + 1)
        case "boolean_operator":
            operator = condition.child_by_field_name("operator")
            is_and = operator is not None and operator.type == "and"
            # Both sides hold of `and` that is true, and neither of `or` that is false.
            return is_and is is_true and any(
                _says(each, said, is_true, depth + 1) for each in parts
            )
        case "comparison_operator":
            signs = [each.type for each in condition.children if not each.is_named]

            is_of = len(parts) == 2 and parts[1].type == "none" and parts[0].text == said
            wanted = ("is not", "!=") if is_true else ("is", "==")
            return is_of and len(signs) == 1 and signs[0] in wanted
        case "call":
            function = condition.child_by_field_name("function")
            given = parts_of(condition.child_by_field_name("arguments"))
            is_check = function is not None and function.text in (b"isinstance", b"hasattr")
            return is_true and is_check and bool(given) and given[0].text == said
    return False
