"""The tokens of parts of a tree, in the order of the text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span

COMMENT_KINDS = frozenset({"line_comment", "block_comment"})

# A reader sees these as one word, however many nodes they have.
_WHOLE_KINDS = frozenset({"string", "ros_name", "path", "number", "boolean", "none"})

# What the grammar knows only as a mistake, as the kinds that a reader tells apart.
_MISTAKEN_KINDS = {
    "quoted": "string",
    "unclosed_quote": "unknown",
    "unclosed_comment": "unknown",
    "unexpected": "unknown",
}


class Token(NamedTuple):
    """A word of the text.

    `kind` is the grammar's name, or `unknown` for characters that are no token of the language.
    """

    kind: str
    text: str
    start: int
    end: int
    row: int
    in_error: bool = False

    @property
    def span(self) -> Span:
        """Where it stands."""
        return Span(self.start, self.end)


def leaves(node: Node) -> Iterator[tuple[Node, bool]]:
    """Yield the nodes that a reader sees as words, and whether an ERROR is around each."""
    stack = [(node, node.is_error)]
    while stack:
        part, in_error = stack.pop()
        if part.children and (part.type not in _WHOLE_KINDS or part.has_error):
            stack.extend((child, in_error or child.is_error) for child in reversed(part.children))
        elif not part.is_missing and part.end_byte > part.start_byte:
            yield part, in_error


def tokens_of(source: bytes, nodes: Sequence[Node]) -> Iterator[Token]:
    """Yield the tokens of nodes, comments left out, unknown characters between them included."""
    for node in nodes:
        at = node.start_byte
        row = node.start_point.row
        for leaf, in_error in leaves(node):
            yield from _unknown(source, at, leaf.start_byte, row)
            at, row = leaf.end_byte, leaf.end_point.row
            if leaf.type in COMMENT_KINDS:
                continue
            if leaf.is_error:
                yield from _unknown(source, leaf.start_byte, at, leaf.start_point.row)
                continue
            text = source[leaf.start_byte : at].decode("utf-8", "replace")
            kind = _MISTAKEN_KINDS.get(leaf.type, leaf.type)
            yield Token(kind, text, leaf.start_byte, at, leaf.start_point.row, in_error)
        yield from _unknown(source, at, node.end_byte, row)


def _unknown(source: bytes, start: int, end: int, row: int) -> Iterator[Token]:
    """Yield what stands between two tokens, line by line, where it is more than space."""
    if not source[start:end].strip():
        return
    for line in source[start:end].split(b"\n"):
        text = line.strip()
        if text:
            at = start + line.index(text)
            yield Token(
                "unknown", text.decode("utf-8", "replace"), at, at + len(text), row, in_error=True
            )
        start += len(line) + 1
        row += 1
