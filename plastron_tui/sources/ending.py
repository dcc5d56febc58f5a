"""Whether what follows in a function surely ends the program, or its node."""

from __future__ import annotations

import re

from tree_sitter import Node

_ENDING = re.compile(
    rb"\b(?:\w*[Ss]hutdown\w*|_?exit|quick_exit|quit|abort|destroy_node|SystemExit|"
    rb"KeyboardInterrupt)\b"
)
_WORD = re.compile(rb"\b\w+(?=\()")
_SLEEP = re.compile(rb"(?:^|\W)u?sleep(?:_for)?$")
_LOG = re.compile(
    rb"^(?:RCLCPP|ROS)_(?:DEBUG|INFO|WARN|ERROR)\w*$|^(?:print|printf|rospy\.log\w+)$"
    rb"|[gG]et_?[lL]ogger\(\)\.\w+$|logger\.\w+$"
)
_NAME = re.compile(rb"[A-Za-z_]\w*")
_TEXTS = re.compile(rb"\"[^\"\n]*\"|'[^'\n]*'")
_BLOCKS = frozenset({"block", "compound_statement", "module"})
_FUNCTIONS = frozenset(
    {"function_definition", "lambda", "lambda_expression", "class_definition", "class_specifier"}
)
_CONDITIONAL = _FUNCTIONS | {
    "decorated_definition", "do_statement", "for_range_loop", "for_statement", "if_statement",
    "match_statement", "switch_statement", "while_statement",
}  # fmt: skip
_LEAVING = frozenset(
    {"break_statement", "continue_statement", "raise_statement", "return_statement",
     "throw_statement"}
)  # fmt: skip


def is_pause(function: Node) -> bool:
    """Tell whether a function logs, sleeps and does nothing else, as demonstrations do.

    One that uses what it is called with does something.
    """
    body = function.child_by_field_name("body")
    given = function.child_by_field_name("parameters") or function.child_by_field_name("declarator")
    if body is None or _words(given) & _words(body):
        return False
    statements = body.named_children if body.type in _BLOCKS else []
    kinds = [_kind(each) for each in statements if each.type != "comment"]
    return "" not in kinds and {"sleep", "log"} <= set(kinds)


def _words(node: Node | None) -> set[bytes]:
    return set() if node is None else set(_NAME.findall(node.text or b"")) - {b"self"}


def _kind(statement: Node) -> str:
    """Return whether a statement sleeps or logs, "" for anything else."""
    call = next(iter(statement.named_children), None)
    is_call = call is not None and call.type in ("call", "call_expression")
    if call is None or not is_call or statement.type != "expression_statement":
        return ""
    callee = call.child_by_field_name("function")
    name = b"" if callee is None or callee.text is None else callee.text
    if _SLEEP.search(name):
        return "sleep"
    return "log" if _LOG.search(name) else ""


def is_end(statement: Node, ending: frozenset[bytes] = frozenset()) -> bool:
    """Tell whether a statement surely ends the program or the node, or sets about it.

    Args:
        statement: the statement; what hangs on a condition is not sure.
        ending: the names of further functions that do.
    """
    text = _TEXTS.sub(b"", statement.text or b"")
    if statement.type in _CONDITIONAL:
        return False
    return _ENDING.search(text) is not None or not ending.isdisjoint(_WORD.findall(text))


def ends_after(node: Node, ending: frozenset[bytes] = frozenset()) -> bool:
    """Tell whether a part of a function is followed by what ends the program or the node."""
    current = node
    while current.parent is not None and current.type not in _FUNCTIONS:
        after = current.next_named_sibling if current.parent.type in _BLOCKS else None
        while after is not None:
            if is_end(after, ending):
                return True
            if after.type in _LEAVING:
                return False
            after = after.next_named_sibling
        current = current.parent
    return False
