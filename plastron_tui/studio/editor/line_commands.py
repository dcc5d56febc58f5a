"""Edits of whole lines: comment, duplicate, move, delete, insert; pure functions."""

from __future__ import annotations

from .buffer import Buffer
from .history import Selection
from .state import Splice, shifted

COMMENT = b"// "

Plan = tuple[list[Splice], Selection]
"""Edits, and the selection after them."""


def rows_of(buffer: Buffer, selection: Selection) -> range:
    """Return the rows that a selection touches; one that ends at a row's start leaves it out."""
    first, last = buffer.row(selection.start), buffer.row(selection.end)
    if last > first and selection.end == buffer.start(last):
        last -= 1
    return range(first, last + 1)


def toggle_comment(buffer: Buffer, selection: Selection) -> Plan:
    """Comment the selected rows out, or in again when all of them are comments."""
    rows = [row for row in rows_of(buffer, selection) if buffer.line_bytes(row).strip()]
    rows = rows or list(rows_of(buffer, selection))
    is_out = all(buffer.line_bytes(row).lstrip().startswith(b"//") for row in rows)
    splices: list[Splice] = []
    for row in rows:
        line = buffer.line_bytes(row)
        at = buffer.start(row) + len(line) - len(line.lstrip())
        if is_out:
            length = 3 if buffer.text[at : at + 3] == COMMENT else 2
            splices.append((at, at + length, b""))
        else:
            splices.append((at, at, COMMENT))
    return splices, Selection(*(shifted(splices, offset) for offset in selection))


def duplicate(buffer: Buffer, selection: Selection) -> Plan:
    """Repeat the selected rows below themselves, with the selection in the copy."""
    rows = rows_of(buffer, selection)
    start, end = buffer.start(rows[0]), buffer.end(rows[-1])
    copy = buffer.ending + buffer.text[start:end]
    return [(end, end, copy)], _moved(selection, len(copy))


def move(buffer: Buffer, selection: Selection, by: int) -> Plan | None:
    """Swap the selected rows with the one above (`by` -1) or below (1); None at the text's end."""
    rows = rows_of(buffer, selection)
    other = rows[0] - 1 if by < 0 else rows[-1] + 1
    if not 0 <= other < buffer.row_count:
        return None
    block = buffer.text[buffer.start(rows[0]) : buffer.end(rows[-1])]
    passed = buffer.line_bytes(other)
    if by < 0:
        between = buffer.text[buffer.end(other) : buffer.start(rows[0])]
        start, end = buffer.start(other), buffer.end(rows[-1])
        return [(start, end, block + between + passed)], _moved(
            selection, -len(passed) - len(between)
        )
    between = buffer.text[buffer.end(rows[-1]) : buffer.start(other)]
    start, end = buffer.start(rows[0]), buffer.end(other)
    return [(start, end, passed + between + block)], _moved(selection, len(passed) + len(between))


def delete(buffer: Buffer, selection: Selection) -> Plan:
    """Delete the selected rows with their line endings."""
    rows = rows_of(buffer, selection)
    start, end = buffer.start(rows[0]), buffer.next_start(rows[-1])
    if end == buffer.end(rows[-1]) and rows[0]:
        start = buffer.end(rows[0] - 1)
    return [(start, end, b"")], Selection(start, start)


def insert_statement(buffer: Buffer, cursor: int, statement: bytes) -> Plan:
    """Put a statement on a line of its own below the cursor's, or on that line if it is empty."""
    row = buffer.row(cursor)
    end = buffer.end(row)
    if buffer.line_bytes(row).strip():
        new = buffer.ending + statement
        at = end + len(new)
        return [(end, end, new)], Selection(at, at)
    start = buffer.start(row)
    is_last = row == buffer.row_count - 1
    new = statement + (buffer.ending if is_last else b"")
    at = start + len(statement)
    return [(start, end, new)], Selection(at, at)


def _moved(selection: Selection, by: int) -> Selection:
    return Selection(selection.anchor + by, selection.head + by)
