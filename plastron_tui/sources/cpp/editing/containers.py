"""Endpoints that a container holds beside others."""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from ..analysis import Analysis
from ..scopes import CppFile, Variable
from .creation import creation_of
from .deletions import Deletions
from .uses import uses_of

_OF_ALL = frozenset({"clear", "reserve", "size", "empty"})


def in_container(
    analysis: Analysis, container: Variable, gone: Deletions
) -> Iterator[tuple[CppFile, int]]:
    """Yield where a container is used in a way that one endpoint less in it would change.

    What is done with each that it holds, or puts others into it, stays right. Each place is a file
    and a line.
    """
    found = [creation_of(analysis, site) for site in analysis.sites]
    puts = [
        (each.file, each.node.start_byte, each.node.end_byte)
        for each in found
        if each is not None and each.container is container
    ]
    for file, node, _ in uses_of(analysis, container):
        is_put = any(file is each and start <= node.start_byte < end for each, start, end in puts)
        if is_put or gone.covers(file, node.start_byte) or _is_of_all(node, file):
            continue
        yield file, node.start_point.row + 1


def _is_of_all(node: Node, file: CppFile) -> bool:
    """Tell whether a container is cleared, or gone through."""
    outer = node.parent
    if outer is None:
        return False
    if outer.type == "field_expression":
        field = outer.child_by_field_name("field")
        if field is not None and field.id != node.id:
            return file.syntax.word(field) in _OF_ALL
        return outer.parent is not None and outer.parent.type == "for_range_loop"
    return outer.type == "for_range_loop"
