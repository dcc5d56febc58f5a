"""No call of tree-sitter's bindings that Plastron makes keeps memory."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
import tree_sitter_python
from tree_sitter import (
    Language,
    Node,
    Parser,
    Query,
    QueryCursor,
    Tree,
    TreeCursor,
)

import plastron_tui

TEXT = b"""\
import os, sys
from a import (b, c as d)


class Node:
    def __init__(self, name="x", *others):
        self.value = name.strip(others[0], key=1)
"""
LANGUAGE = Language(tree_sitter_python.language())
PARSER = Parser(LANGUAGE)
FIELD = LANGUAGE.field_id_for_name("name") or 0
QUERY = Query(LANGUAGE, '((call function: (_) @f) (#not-eq? @f "x")) (identifier) @i')


def every(node: Node) -> Iterator[Node]:
    yield node
    for child in node.children:
        yield from every(child)


def walk(tree: Tree) -> None:
    cursor = tree.walk()
    cursor.goto_first_child()
    cursor.goto_parent()
    assert cursor.goto_first_child_for_byte(3) is not None
    while cursor.goto_next_sibling():
        assert cursor.node is not None
        assert cursor.field_name is None
    cursor.reset(tree.root_node)


def edit(tree: Tree) -> None:
    tree.edit(0, 0, 1, (0, 0), (0, 0), (0, 1))
    PARSER.parse(b"\n" + TEXT, tree)


CALLS: dict[str, Callable[[Tree], object]] = {
    "parse": lambda tree: PARSER.parse(TEXT),
    "walk": walk,
    "goto_first_child": walk,
    "goto_first_child_for_byte": walk,
    "goto_next_sibling": walk,
    "goto_parent": walk,
    "reset": walk,
    "edit": edit,
    "copy": lambda tree: tree.copy(),
    "captures": lambda tree: QueryCursor(QUERY).captures(tree.root_node),
    "matches": lambda tree: QueryCursor(QUERY).matches(tree.root_node),
    "child_by_field_name": lambda tree: [
        node.child_by_field_name("name") for node in every(tree.root_node)
    ],
    "children_by_field_name": lambda tree: [
        node.children_by_field_name("name") for node in every(tree.root_node)
    ],
    "child": lambda tree: tree.root_node.child(0),
    "field_name_for_child": lambda tree: [
        node.field_name_for_child(0) for node in every(tree.root_node) if node.children
    ],
    "child_by_field_id": lambda tree: [
        node.child_by_field_id(FIELD) for node in every(tree.root_node)
    ],
    "set_byte_range": lambda tree: QueryCursor(QUERY).set_byte_range(3, 9).captures(tree.root_node),
    "set_max_start_depth": lambda tree: (
        QueryCursor(QUERY).set_max_start_depth(2).captures(tree.root_node)
    ),
    "descendant_for_byte_range": lambda tree: tree.root_node.descendant_for_byte_range(3, 9),
    "named_descendant_for_byte_range": lambda tree: tree.root_node.named_descendant_for_byte_range(
        3, 9
    ),
    # Of a query; code that changes C++ has a function of this name.
    "string_value": lambda _: QUERY.string_value(0),
}
MOST = 100
"""How many bytes a call may leave; a tree is some ten thousand."""

WITH_CALLBACK = "parse with a callback"


def _measured(call: Callable[[Tree], object], count: int = 2_000) -> float:
    """Return how many bytes of memory a call leaves behind, with the tree that it is made in."""

    def resident() -> int:
        return int(Path("/proc/self/statm").read_text().split()[1]) * 4096

    for _ in range(count // 4):
        call(PARSER.parse(TEXT))
    before = resident()
    for _ in range(count):
        call(PARSER.parse(TEXT))
    return (resident() - before) / count


def _main(name: str) -> None:
    calls = CALLS | {
        WITH_CALLBACK: lambda _: PARSER.parse(lambda at, _: TEXT[at : at + 100]),
    }
    print(_measured(calls[name]))


def left_by(name: str) -> float:
    command = [sys.executable, __file__, name]
    return float(subprocess.run(command, check=True, capture_output=True).stdout)


@pytest.mark.parametrize("name", CALLS)
def test_a_call_lets_its_tree_go(name: str) -> None:
    tree = PARSER.parse(TEXT)
    before = sys.getrefcount(tree)
    CALLS[name](tree)
    assert sys.getrefcount(tree) == before


@pytest.mark.long
@pytest.mark.parametrize("name", CALLS)
def test_a_call_keeps_no_memory(name: str) -> None:
    assert left_by(name) < MOST


@pytest.mark.long
def test_a_leak_would_be_seen() -> None:
    """The bindings keep what a callback returned, which is why Plastron parses whole texts."""
    assert left_by(WITH_CALLBACK) > MOST


def test_the_calls_that_plastron_makes_are_these() -> None:
    classes = (Node, Parser, Query, QueryCursor, Tree, TreeCursor)
    known = {name for each in classes for name in dir(each) if callable(getattr(each, name))}
    others = {name for name in known if not name.startswith("_")} - CALLS.keys()
    texts = [path.read_bytes() for path in Path(plastron_tui.__file__).parent.rglob("*.py")]
    # Where no word is one of these before a parenthesis there is no such call, nor need to parse.
    called = re.compile(rb"\b(?:%s)\s*\(" % "|".join(others).encode())
    made = {
        node.func.attr
        for text in texts
        if called.search(text)
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)
    }
    assert others & made == set()


if __name__ == "__main__":
    _main(sys.argv[1])
