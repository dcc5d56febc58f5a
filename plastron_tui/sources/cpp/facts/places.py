"""Where the code of a unit stands: the scopes of nodes, and what is compiled only sometimes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.sources.cpp.scopes import CppFile, Scope
from plastron_tui.sources.cpp.scopes import scope_at as scope_at

_GUARD = 0.8
"""A conditional over this much of a file keeps it from being included twice."""


def span_of(node: Node) -> Span:
    """Return the bytes of a node."""
    return Span(node.start_byte, node.end_byte)


def with_scopes(file: CppFile, nodes: Iterable[Node]) -> Iterator[tuple[Node, Scope]]:
    """Yield nodes, in the order of the text, each with the innermost scope that it is in."""
    scopes = iter(file.scopes)
    stack = [next(scopes)]
    coming = next(scopes, None)
    for node in nodes:
        at = node.start_byte
        while coming is not None and coming.start <= at:
            while len(stack) > 1 and stack[-1].end <= coming.start:
                stack.pop()
            stack.append(coming)
            coming = next(scopes, None)
        while len(stack) > 1 and stack[-1].end <= at:
            stack.pop()
        yield node, stack[-1]


class Conditionals:
    """The parts of a file that may not be compiled; who builds it elsewhere has others."""

    def __init__(self, file: CppFile) -> None:
        size = len(file.syntax.text)
        self._spans = [
            each for each in file.syntax.conditionals if each[1] - each[0] < size * _GUARD
        ]

    def has(self, at: int) -> bool:
        """Tell whether an offset is in one of them."""
        return any(start <= at < end for start, end in self._spans)


def is_guarded(node: Node) -> bool:
    """Tell whether a call stands in a `try`."""
    around = node.parent
    while around is not None and around.type != "function_definition":
        if around.type == "try_statement":
            return True
        around = around.parent
    return False
