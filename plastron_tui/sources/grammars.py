"""Files of languages with a tree-sitter grammar: their bytes, and a tree over these offsets."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import ClassVar

from tree_sitter import Language, Node, Query, QueryCursor, Tree

AS_LETTERS = bytes(byte if byte < 0x80 else ord("x") for byte in range(256))
"""A byte that is not UTF-8 ends a string or a comment for tree-sitter. In a file of another
encoding every such byte is parsed as a letter, so that no offset moves."""

# A node within more others was made to break readers: a query takes the square of the depth.
_DEEPEST = 1_000


class Grammar:
    """A grammar, and the queries that a folder has for it; each is made once, when asked for."""

    def __init__(self, load: Callable[[], object], folder: Path) -> None:
        self.language = cache(lambda: Language(load()))
        # `importlib.resources` would load `zipfile`, which takes as long as reading a node.
        self._query = cache(
            lambda name: Query(self.language(), (folder / f"{name}.scm").read_text("utf-8"))
        )

    def captures(self, name: str, root: Node) -> dict[str, list[Node]]:
        """Run a query over a tree; the nodes of a capture are in the order of the text."""
        cursor = QueryCursor(self._query(name))
        cursor.set_max_start_depth(_DEEPEST)
        found = cursor.captures(root)
        for nodes in found.values():
            nodes.sort(key=lambda node: (node.start_byte, -node.end_byte))
        return found


@dataclass(frozen=True, slots=True)
class ParsedFile:
    """A parsed file: `text` is what is on the disk, `tree` is over the same offsets.

    Attributes:
        text: what is on the disk.
        encoding: its encoding.
        tree: the tree.
        errors: at how many places it does not parse.
    """

    grammar: ClassVar[Grammar]

    text: bytes
    encoding: str
    tree: Tree
    errors: int

    @property
    def root(self) -> Node:
        """The whole file."""
        return self.tree.root_node

    def slice(self, node: Node) -> str:
        """Return the source of a node, comments and all."""
        return self.between(node.start_byte, node.end_byte)

    def between(self, start: int, end: int) -> str:
        """Return the source between two offsets."""
        return self.text[start:end].decode(self.encoding, "replace")

    def captures(self, name: str) -> dict[str, list[Node]]:
        """Run a query over the whole file; the nodes of a capture are in the order of the text."""
        return self.grammar.captures(name, self.root)


def count_errors(root: Node) -> int:
    """Count the places where a text does not parse."""
    if not root.has_error:
        return 0
    found = 0
    stack = [root]
    while stack:
        node = stack.pop()
        if node.is_error or node.is_missing:
            found += 1
        stack.extend(child for child in node.children if child.has_error)
    return found


def is_inside(node: Node, outer: Node) -> bool:
    """Whether a node is another one, or in it."""
    return bool(outer.start_byte <= node.start_byte and node.end_byte <= outer.end_byte)
