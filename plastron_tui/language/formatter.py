"""The one way to lay out a program.

One space between words, none before a comma; at most one empty line between statements; what
does not parse stays as it is. A format changes space and nothing else.
"""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from .document import Document
from .tokens import Leaf, leaves

_MARK = b"\xef\xbb\xbf"
"""The byte order mark that some editors put before a text; it stays."""

_TIGHT_BEFORE = frozenset({",", ")", "]", ".", "=", "/", "index"})
_TIGHT_AFTER = frozenset({"(", "[", ".", "=", "/", "index"})


def format_document(document: Document) -> bytes:
    """Return the text of a document as it should be laid out.

    The line ending that the first line has is the line ending of all.
    """
    source = document.text
    mark = _MARK if source.startswith(_MARK) else b""
    ending = b"\r\n" if source[: source.find(b"\n") + 1].endswith(b"\r\n") else b"\n"
    lines: list[bytes] = []
    last_row = None
    for first_row, row, text in _blocks(document):
        if last_row is not None and first_row > last_row + 1:
            lines.append(b"")
        lines.append(text)
        last_row = row
    if not lines:
        return mark
    body = b"\n".join(lines).replace(b"\r\n", b"\n")
    return mark + body.replace(b"\n", ending) + ending


def _blocks(document: Document) -> Iterator[tuple[int, int, bytes]]:
    """Yield what shares lines: its first row, its last row, its text laid out."""
    source = document.text
    group: list[Node] = []
    last_row = -1
    for node in document.tree.root_node.children:
        if group and node.start_point.row > last_row:
            yield group[0].start_point.row, last_row, _lay_out(source, group)
            group = []
        group.append(node)
        last_row = max(last_row, _last_row(node))
    if group:
        yield group[0].start_point.row, last_row, _lay_out(source, group)


def _last_row(node: Node) -> int:
    """Return the last row that a node has text on."""
    end = node.end_point
    return end.row - 1 if end.column == 0 and end.row > node.start_point.row else end.row


def _lay_out(source: bytes, nodes: list[Node]) -> bytes:
    """Lay out the nodes that share lines; lines with a mistake stay as they are."""
    if any(node.has_error or node.is_error for node in nodes):
        start = source.rfind(b"\n", 0, nodes[0].start_byte) + 1
        end = source.find(b"\n", max(node.end_byte for node in nodes) - 1)
        line = source[start : end if end >= 0 else len(source)].rstrip(b"\r\n")
        return line if start else line.removeprefix(_MARK)
    parts: list[bytes] = []
    before = ""
    for leaf in (leaf for node in nodes for leaf in leaves(node)):
        word, kind = leaf.node, _kind(leaf)
        if parts and kind not in _TIGHT_BEFORE and before not in _TIGHT_AFTER:
            parts.append(b" ")
        parts.append(source[word.start_byte : word.end_byte].rstrip())
        before = kind
    return b"".join(parts)


def _kind(leaf: Leaf) -> str:
    """Return what a word is for the space around it."""
    match leaf.node.type, leaf.within:
        case "=", "condition" | "definition" | "setting":
            return "operator"
        case "[", "element" | "definition_type":
            return "index"
        case "<=", "definition_type":
            return "index"
    return leaf.node.type
