"""Files of languages with a tree-sitter grammar: their bytes, and a tree over these offsets."""

from __future__ import annotations

import re
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import ClassVar

from tree_sitter import Language, Node, Parser, Query, QueryCursor, Tree

AS_LETTERS = bytes(byte if byte < 0x80 else ord("x") for byte in range(256))
"""A byte that is not UTF-8 ends a string or a comment for tree-sitter. In a file of another
encoding every such byte is parsed as a letter, so that no offset moves."""

# A node within more others was made to break readers: a query takes the square of the depth.
_DEEPEST = 1_000

_WIDEST_ERROR = 2_000
_CONTINUED = re.compile(rb"(?:\\\r?\n[ \t]*){1000}")
_PREFIXES = re.compile(rb"(?:[-+~!*&][ \t]*){1000,}")

# The parser asks about every hundred steps. Code that people write takes 15 times for 1000 bytes at
# most; where nothing is a sentence, steps can grow by the cube of the length.
_FEWEST_STEPS = 2_000
_STEPS_PER_BYTE = 0.1
_PIECE = 65_536

_LONE_RETURN = re.compile(rb"\r(?!\n)")


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


def python_lines(text: bytes) -> bytes:
    """Return a Python text of the same length whose lines end where Python ends them.

    At a carriage return, too: for tree-sitter the line goes on, and takes the square of its length.
    """
    return _LONE_RETURN.sub(b"\n", text)


class _Bounding(threading.local):
    depth = 0


_BOUNDING = _Bounding()


@contextmanager
def bounding() -> Iterator[None]:
    """Let parsers give up texts that were made to keep them busy, in this thread.

    For processes that end soon: tree-sitter's binding (0.26) asks in between only of what it gets
    in pieces, and never frees these.
    """
    _BOUNDING.depth += 1
    try:
        yield
    finally:
        _BOUNDING.depth -= 1


class BoundedParser:
    """A parser that, while `bounding`, gives up a text which takes more than any people write.

    Attributes:
        steps: how often it was asked whether to go on, for the last text.
    """

    def __init__(self, language: Language) -> None:
        self._parser = Parser(language)
        self.steps = 0

    def parse(self, text: bytes) -> Tree:
        """Return the tree of a text; where it is given up, that of a text that does not parse."""
        self.steps = 0
        if _CONTINUED.search(text) is not None:
            # A scanner looks past all of these at each of them.
            return self.given_up()
        if not _BOUNDING.depth:
            return self._parser.parse(text)
        most = _FEWEST_STEPS + len(text) * _STEPS_PER_BYTE

        def is_too_much(*_: object) -> bool:
            self.steps += 1
            return self.steps > most

        def piece(start: int, _: object) -> bytes:
            return text[start : start + _PIECE]

        try:
            return self._parser.parse(piece, progress_callback=is_too_much)
        except ValueError:
            self._parser.reset()
            return self.given_up()

    def given_up(self) -> Tree:
        """Return the tree of a text that does not parse."""
        return self._parser.parse(b"(")


def wide_errors(root: Node) -> Iterator[tuple[int, int]]:
    """Yield where what does not parse is so long that a query would take the square of it."""
    stack = [root] if root.has_error else []
    while stack:
        node = stack.pop()
        if node.is_error and node.child_count > _WIDEST_ERROR:
            yield node.start_byte, node.end_byte
        else:
            stack.extend(child for child in node.children if child.has_error)


def is_too_deep(source: bytes, root: Node) -> bool:
    """Tell whether signs before a value are so many that a query would take the square of them."""
    return any(
        "unary" in kind or "pointer" in kind
        for found in _PREFIXES.finditer(source)
        if (node := root.descendant_for_byte_range(found.start(), found.start())) is not None
        for kind in (node.type, "" if node.parent is None else node.parent.type)
    )


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


def first_error(root: Node) -> Node:
    """Return the first node at fault of a text that does not parse.

    What is missing may be a sign that no node shows, such as the end of a line. Then it is the one
    that begins in the line of the one before, or else the one that lacks the sign.
    """
    node = root
    while not (node.is_error or node.is_missing):
        wrong = next((each for each in node.children if each.has_error), None)
        if wrong is None:
            pairs = pairwise(node.children)
            return next((y for x, y in pairs if x.end_point.row == y.start_point.row), node)
        node = wrong
    return node


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
