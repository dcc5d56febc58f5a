"""Functions and loops that an edit leaves with nothing to do."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import Change
from plastron_tui.sources.left_behind import idle, taking

from ..analysis import Analysis
from ..scopes import CppFile, scope_at

_LOOPS = frozenset({"while_statement", "for_statement", "do_statement", "for_range_loop"})
_BEGINNING = re.compile(rb"\b(?:while|for|do)\b")
_SLEEPS = frozenset({"sleep", "usleep", "sleep_for", "sleep_until", "nanosleep"})


def tell_idle(before: Analysis, after: Analysis, changes: Sequence[Change]) -> Iterator[Diagnostic]:
    """Warn of what the files still run, and what did something before."""
    if not taking(changes):
        return
    had = Counter(key for key, _ in _idle(before))
    found = []
    for key, what in _idle(after):
        had[key] -= 1
        if had[key] < 0:
            found.append(what)
    told = idle(found, changes)
    if told is not None:
        yield told


def _idle(analysis: Analysis) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield where a function does nothing or a loop only sleeps, and what it is called."""
    for functions in analysis.unit.functions.values():
        for each in functions:
            body = each.node.child_by_field_name("body")
            is_made = each.name.lstrip("~") == each.class_name or each.scope is None
            if body is None or is_made or each.file.is_beside or _does(each.file, body):
                continue
            where = each.file.place_of(each.node.start_point.row + 1)
            yield ("function", each.class_name, each.name), f"`{each.name}` (line {where})"
    for file in analysis.unit.files:
        if file.is_beside:
            continue
        for loop in _loops(file):
            body = loop.child_by_field_name("body")
            if body is not None and _only_sleeps(file, body):
                around = scope_at(file, loop.start_byte).enclosing("function")
                name = "" if around is None else around.name
                where = file.place_of(loop.start_point.row + 1)
                yield ("loop", file.name, name), f"the loop in line {where}"


def _does(file: CppFile, body: Node) -> bool:
    """Tell whether a body does anything but to name what it does not use."""
    for each in body.named_children:
        text = "".join(file.syntax.word(each).split())
        if each.type != "comment" and not text.startswith(("(void)", "static_cast<void>(")):
            return True
    return False


def _loops(file: CppFile) -> Iterator[Node]:
    for found in _BEGINNING.finditer(file.syntax.code):
        node = file.syntax.root.descendant_for_byte_range(found.start(), found.end())
        loop = None if node is None else node.parent
        if loop is not None and loop.type in _LOOPS and loop.start_byte == found.start():
            yield loop


def _only_sleeps(file: CppFile, body: Node) -> bool:
    statements = body.named_children if body.type == "compound_statement" else [body]
    return all(each.type == "comment" or _is_sleep(file, each) for each in statements)


def _is_sleep(file: CppFile, statement: Node) -> bool:
    call = statement.named_children[0] if statement.named_child_count == 1 else None
    if statement.type != "expression_statement" or call is None or call.type != "call_expression":
        return False
    called = call.child_by_field_name("function")
    text = "" if called is None else file.syntax.word(called)
    return text.replace("->", ".").replace("::", ".").rpartition(".")[2] in _SLEEPS
