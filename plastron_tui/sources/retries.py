"""Loops that try again a few times: they sleep only where a try has failed, and soon give up."""

from __future__ import annotations

import re

from tree_sitter import Node

_LONGEST = 1.0
"""How many seconds all tries of a loop sleep that is no mistake."""

_LOOPS = frozenset({"do_statement", "for_range_loop", "for_statement", "while_statement"})
_FUNCTIONS = frozenset({"function_definition", "lambda", "lambda_expression"})
_HANDLERS = frozenset({"catch_clause", "except_clause"})
_TRY = re.compile(rb"\btry(?:_\w+|[A-Z]\w*)\s*\(")
_HEADER = re.compile(rb"(?:<=?|!=)\s*(\d{1,3})\b|\brange\(\s*(\d{1,3})\s*\)")
_EXIT = re.compile(
    rb"\bif\b[^{};:]*(?:>=?|==)\s*(\d{1,3})\b[^{};:]*[{:)]\s*(?:[^{}]*?)\b(?:return|break|throw|raise)\b"
)


def is_short_retry(call: Node, seconds: float | None) -> bool:
    """Tell whether a call sleeps between tries of which there are few, and not for long.

    What is tried is called so (`try_lock`), or raises: `except` is where it sleeps.
    """
    if seconds is None:
        return False
    is_caught = False
    above = call.parent
    while above is not None and above.type not in _LOOPS:
        if above.type in _FUNCTIONS:
            return False
        is_caught = is_caught or above.type in _HANDLERS
        above = above.parent
    body = None if above is None else above.child_by_field_name("body")
    if above is None or above.text is None or body is None:
        return False
    header = above.text[: body.start_byte - above.start_byte]
    found = _HEADER.search(header) or _EXIT.search(above.text)
    if found is None or not (is_caught or _TRY.search(above.text)):
        return False
    return (int(next(filter(None, found.groups()))) + 1) * seconds <= _LONGEST
