"""The tokens of parts of a tree, in the order of the text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span

from .keywords import WORDS

COMMENT_KINDS = frozenset({"line_comment", "block_comment"})

UNKNOWN = "unknown"
"""The kind of characters that are no token of the language."""

UNCLOSED_STRING = "unclosed_string"
"""The kind of a string that its line does not close."""

MOST_WORDS = 10_000
"""How many words of a line count; what a machine wrote can have millions, and nobody reads them."""

WORD_KINDS = frozenset(
    {"identifier", "variable", "module", "function", "client_library", "name_kind", "field_name"}
    | {"boolean", "none", "parameter_type", "flag", "section"}
    | {"shape", "color", "unit", "joint_type"}
    | WORDS
)
QUOTED_KINDS = frozenset({"ros_name", "path"})

# A reader sees these as one word, however many nodes they have.
_WHOLE_KINDS = frozenset({"string", "ros_name", "path", "number", "boolean", "none"})

# What the grammar tells apart only in order to get over it.
_KINDS = {
    "unclosed_quote": UNKNOWN,
    "unclosed_comment": UNKNOWN,
    "unexpected": UNKNOWN,
    "quoted": "string",
}


class Token(NamedTuple):
    """A word of the text.

    `kind` is the grammar's name, `UNKNOWN` or `UNCLOSED_STRING`; `row` is that of the line, which
    a block comment may stretch over several rows.
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


def text_at(tokens: Sequence[Token], index: int) -> str:
    """Return the text of a token, or nothing beyond their end."""
    return tokens[index].text if 0 <= index < len(tokens) else ""


def token_at(tokens: Sequence[Token], index: int) -> Token | None:
    """Return a token, None beyond their end."""
    return tokens[index] if 0 <= index < len(tokens) else None


def is_glued(tokens: Sequence[Token], index: int) -> bool:
    """Tell whether a token follows the one before it without a space."""
    return 0 < index < len(tokens) and tokens[index].start == tokens[index - 1].end


class Leaf(NamedTuple):
    """A node that a reader sees as a word, with the kind of the node that it is a child of.

    A node itself looks for its parent from the root of the tree, which may be far.
    """

    node: Node
    within: str
    in_error: bool


def leaves(node: Node) -> Iterator[Leaf]:
    """Yield the nodes that a reader sees as words."""
    # A cursor, because the children of one node may be millions.
    cursor = node.walk()
    errors, kinds = [node.is_error], [""]
    while True:
        part = cursor.node
        assert part is not None
        if part.type not in _WHOLE_KINDS and cursor.goto_first_child():
            errors.append(errors[-1] or _is_error(cursor.node))
            kinds.append(part.type)
            continue
        if not part.is_missing and part.end_byte > part.start_byte:
            yield Leaf(part, kinds[-1], errors[-1])
        while not cursor.goto_next_sibling():
            if not cursor.goto_parent():
                return
            errors.pop()
            kinds.pop()
        errors[-1] = errors[-2] or _is_error(cursor.node)


def _is_error(node: Node | None) -> bool:
    return node is not None and node.is_error


def tokens_of(source: bytes, nodes: Sequence[Node]) -> Iterator[Token]:
    """Yield the tokens of nodes, comments left out, unknown characters between them included.

    Of a node that is all on one line, what comes after `MOST_WORDS` is left out.
    """
    joined: dict[int, int] = {}
    for node in nodes:
        at = node.start_byte
        row = node.start_point.row
        left = MOST_WORDS if node.end_point.row == row else -1
        for leaf, _, in_error in leaves(node):
            yield from _unknown(source, at, leaf.start_byte, row, joined)
            at, row = leaf.end_byte, leaf.end_point.row
            first = leaf.start_point.row
            if leaf.type in COMMENT_KINDS:
                if row > first:
                    joined[row] = joined.get(first, first)
                continue
            kind = leaf.type
            if leaf.is_error:
                yield from _unknown(source, leaf.start_byte, at, first, joined)
                continue
            if kind == "string" and not _is_closed(leaf):
                kind = UNCLOSED_STRING
            text = source[leaf.start_byte : at].decode("utf-8", "replace")
            first = joined.get(first, first)
            yield Token(_KINDS.get(kind, kind), text, leaf.start_byte, at, first, in_error)
            left -= 1
            if left == 0:
                break
        else:
            yield from _unknown(source, at, node.end_byte, row, joined)


def _is_closed(string: Node) -> bool:
    count = string.child_count
    last = string.child(count - 1) if count > 1 else None
    return last is not None and last.type == '"' and not last.is_missing


def _unknown(
    source: bytes, start: int, end: int, row: int, joined: dict[int, int]
) -> Iterator[Token]:
    """Yield what stands between two tokens, line by line, where it is more than space."""
    if not source[start:end].strip():
        return
    for line in source[start:end].split(b"\n"):
        text = line.strip()
        if text:
            at = start + line.index(text)
            shown = text.decode("utf-8", "replace")
            yield Token(UNKNOWN, shown, at, at + len(text), joined.get(row, row), in_error=True)
        start += len(line) + 1
        row += 1
