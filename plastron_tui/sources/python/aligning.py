"""Lines that stand below what is behind a bracket, where a change moves the bracket."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from .splices import Splice, line_end, line_start
from .syntax import Syntax

_OPENING = (b"(", b"[", b"{")


class _Bracket(NamedTuple):
    """A bracket whose items go on in other lines, below the first of them.

    Attributes:
        offset: where it opens.
        rows: the lines that it goes on in.
    """

    offset: int
    rows: range


def realigned(syntax: Syntax, splices: Sequence[Splice]) -> list[Splice]:
    """Return some splices, and what keeps lines aligned with the brackets that they move."""
    moves: dict[int, list[tuple[int, int]]] = defaultdict(list)
    starts = _line_starts(syntax.text)
    for each in splices:
        if b"\n" not in each.text and b"\n" not in syntax.text[each.start : each.end]:
            old = syntax.between(each.start, each.end)
            more = len(each.text.decode(syntax.encoding)) - len(old)
            moves[syntax.text.count(b"\n", 0, each.start)].append((each.end, more))
    shifts: dict[int, int] = {}
    pending = sorted(moves)
    while pending:
        row = pending.pop(0)
        for bracket in _brackets(syntax, starts[row], starts[row + 1]):
            before = (more for end, more in moves[row] if end <= bracket.offset)
            shift = shifts.get(row, 0) + sum(before)
            if shift and _is_aligned(syntax, starts, bracket):
                pending += sorted(set(bracket.rows) - shifts.keys() - {*pending})
                shifts.update(dict.fromkeys(bracket.rows, shift))
    changed = [(each.start, each.end) for each in splices]
    added = (_shifted(syntax, starts[row], shift) for row, shift in shifts.items())
    return [
        *splices,
        *(
            each
            for each in added
            if each is not None
            and not any(start <= each.end and each.start <= end for start, end in changed)
        ),
    ]


def _line_starts(text: bytes) -> list[int]:
    """Return where each line of a text starts, and where the text ends."""
    starts = [0]
    while starts[-1] < len(text):
        starts.append(line_end(text, starts[-1]))
    return [*starts, len(text)]


def _brackets(syntax: Syntax, start: int, end: int) -> Iterator[_Bracket]:
    for offset in range(start, end):
        if syntax.text[offset : offset + 1] not in _OPENING:
            continue
        token = syntax.root.descendant_for_byte_range(offset, offset + 1)
        around = token.parent if token is not None else None
        if token is None or around is None or token.named_child_count or token.is_named:
            continue
        first, row = token.next_sibling, token.start_point.row
        last = around.end_point.row
        if first is not None and first.type != "comment" and first.start_point.row == row < last:
            yield _Bracket(offset, range(row + 1, last + 1))


def _is_aligned(syntax: Syntax, starts: Sequence[int], bracket: _Bracket) -> bool:
    """Whether all lines of a bracket stand as deep as what is behind it, or deeper."""
    column = len(syntax.between(line_start(syntax.text, bracket.offset), bracket.offset))
    for row in bracket.rows:
        line = syntax.text[starts[row] : starts[row + 1]]
        is_code = bool(line.strip()) and not _is_in_string(syntax, starts[row])
        if is_code and len(line) - len(line.lstrip(b" ")) <= column:
            return False
    return True


def _is_in_string(syntax: Syntax, start: int) -> bool:
    node: Node | None = syntax.root.descendant_for_byte_range(start, start + 1)
    return node is not None and node.type.startswith("string") and node.start_byte < start


def _shifted(syntax: Syntax, start: int, shift: int) -> Splice | None:
    """Return what moves a line, None for one that is empty or part of a text."""
    is_empty = not syntax.text[start : line_end(syntax.text, start)].strip()
    if is_empty or _is_in_string(syntax, start):
        return None
    return Splice(start, start + max(-shift, 0), b" " * max(shift, 0))
