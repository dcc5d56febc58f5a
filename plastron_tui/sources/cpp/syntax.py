"""A C++ file as bytes, and its syntax tree over exactly these offsets."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import tree_sitter_cpp
from tree_sitter import Language, Node, Parser, Query, QueryCursor, Tree

from .macros import join_macros, mask_macros
from .preprocessing import Define, Include, blank, preprocess

# A node within more others was made to break readers: a query takes the square of the depth.
_DEEPEST = 1_000
_WIDEST_ERROR = 2_000
# A byte that is not UTF-8 ends a string or a comment for tree-sitter.
_AS_LETTERS = bytes(byte if byte < 0x80 else ord("x") for byte in range(256))


@cache
def language() -> Language:
    """Return the C++ grammar."""
    return Language(tree_sitter_cpp.language())


@cache
def query(name: str) -> Query:
    """Return a compiled query of this package; compiling is slow, so each is compiled once."""
    file = Path(__file__).with_name("queries") / f"{name}.scm"
    return Query(language(), file.read_text("utf-8"))


@dataclass(frozen=True, slots=True)
class Syntax:
    """A parsed file.

    Attributes:
        text: what is on the disk.
        code: the text that was parsed, of the same length: without comments, directives, and the
            macros that no parser sees through.
        encoding: the encoding of both.
        tree: the tree of `code`.
        errors: at how many places it does not parse.
        includes: the includes of the file.
        defines: its macros without arguments.
        overrides_qos: whether it lets parameters change a quality of service.
    """

    text: bytes
    code: bytes
    encoding: str
    tree: Tree
    errors: int
    includes: tuple[Include, ...]
    defines: tuple[Define, ...]
    overrides_qos: bool

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

    def word(self, node: Node) -> str:
        """Return the source of a node that is a name, or a type without comments in it."""
        return self.code[node.start_byte : node.end_byte].decode(self.encoding, "replace")

    def captures(self, name: str) -> dict[str, list[Node]]:
        """Run a query over the whole file."""
        cursor = QueryCursor(query(name))
        cursor.set_max_start_depth(_DEEPEST)
        return cursor.captures(self.root)


def parse(text: bytes) -> Syntax:
    """Parse a file, whatever its encoding, without moving an offset."""
    prepared = preprocess(text)
    code = prepared.code
    mask_macros(code)
    join_macros(code, prepared.defines, text)
    encoding = "utf-8"
    try:
        text.decode()
    except UnicodeDecodeError:
        encoding = "latin-1"
    parser = Parser(language())
    for _ in range(3):
        source = bytes(code)
        tree = parser.parse(source if encoding == "utf-8" else source.translate(_AS_LETTERS))
        wide = list(_wide_errors(tree.root_node))
        if not wide:
            break
        for start, end in wide:
            blank(code, start, end)
    else:
        tree = parser.parse(b"")
    errors = count_errors(tree.root_node)
    overrides = b"QosOverridingOptions" in source or b"qos_overriding_options" in source
    includes, defines = prepared.includes, prepared.defines
    return Syntax(text, source, encoding, tree, errors, includes, defines, overrides)


def _wide_errors(root: Node) -> Iterator[tuple[int, int]]:
    """Yield where what does not parse is so long that a query would take the square of it."""
    stack = [root] if root.has_error else []
    while stack:
        node = stack.pop()
        if node.is_error and node.child_count > _WIDEST_ERROR:
            yield node.start_byte, node.end_byte
        else:
            stack.extend(child for child in node.children if child.has_error)


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
