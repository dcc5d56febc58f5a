"""The text of a program as coloured lines, for where it is only read."""

from __future__ import annotations

from collections.abc import Sequence

from tree_sitter import QueryCursor

from plastron_tui.language import Document
from plastron_tui.language.grammar import highlights_query

from ..editor.palette import tone_of
from .styles import Line, Lines, Piece


def coloured_statements(rows: Sequence[str]) -> Lines:
    """Return the lines of a program in the colours that the editor gives them."""
    source = "\n".join(rows).encode("utf-8", "surrogatepass")
    starts = [0]
    for row in rows:
        starts.append(starts[-1] + len(row.encode("utf-8", "surrogatepass")) + 1)
    spans: list[list[tuple[int, int, str]]] = [[] for _ in rows]
    captures = QueryCursor(highlights_query()).captures(Document(source).tree.root_node)
    for capture, nodes in captures.items():
        for node in nodes:
            first, last = node.start_point.row, node.end_point.row
            for at in range(first, min(last + 1, len(rows))):
                begin = max(node.start_byte, starts[at]) - starts[at]
                end = min(node.end_byte, starts[at + 1] - 1) - starts[at]
                spans[at].append((begin, end, tone_of(capture)))
    return tuple(_line(row, sorted(found)) for row, found in zip(rows, spans, strict=True))


def _line(row: str, spans: Sequence[tuple[int, int, str]]) -> Line:
    """Return a line in pieces; spans are in bytes, in order, and none is in another."""
    text = row.encode("utf-8", "surrogatepass")
    pieces: list[Piece] = []
    at = 0
    for begin, end, tone in (*spans, (len(text), len(text), "")):
        for start, stop, own in ((at, begin, ""), (max(at, begin), end, tone)):
            if start < stop:
                words = text[start:stop].decode("utf-8", "replace")
                pieces.append(Piece(words.expandtabs(4), own))
        at = max(at, end)
    return tuple(pieces)
