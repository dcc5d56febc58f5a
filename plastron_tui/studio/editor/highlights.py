"""The colours of the rows in a window, from the grammar's highlight query."""

from __future__ import annotations

from typing import NamedTuple

from tree_sitter import QueryCursor

from plastron_tui.language.grammar import highlights_query

from .buffer import Buffer


class Painted(NamedTuple):
    """A piece of a row, in byte columns, and the name of its capture."""

    start: int
    end: int
    capture: str


RowPaint = tuple[Painted, ...]

LONGEST = 32 * 1024
"""Rows of more bytes than this, all in all, are shown plain: to colour them takes too long."""


def highlight(buffer: Buffer, first: int, last: int) -> dict[int, RowPaint]:
    """Return what the rows from `first` to `last`, inclusive, are painted with."""
    start, end = buffer.start(first), buffer.end(last)
    if end - start > LONGEST and any(
        buffer.end(row) - buffer.start(row) > LONGEST // 4 for row in range(first, last + 1)
    ):
        return dict.fromkeys(range(first, last + 1), ())
    excerpt = buffer.session.document.excerpt(start, end)
    top = buffer.row(excerpt.start)
    cursor = QueryCursor(highlights_query())
    cursor.set_byte_range(start - excerpt.start, max(end, start + 1) - excerpt.start)
    rows: dict[int, list[Painted]] = {row: [] for row in range(first, last + 1)}
    for capture, nodes in cursor.captures(excerpt.tree.root_node).items():
        for node in nodes:
            begin, until = node.start_point, node.end_point
            if begin.row == until.row:
                painted = rows.get(top + begin.row)
                if painted is not None:
                    painted.append(Painted(begin.column, until.column, capture))
                continue
            for row in range(max(first, top + begin.row), min(last, top + until.row) + 1):
                left = begin.column if row == top + begin.row else 0
                size = buffer.end(row) - buffer.start(row)
                right = until.column if row == top + until.row else size
                rows[row].append(Painted(left, min(right, size), capture))
    return {row: tuple(sorted(painted)) for row, painted in rows.items()}
