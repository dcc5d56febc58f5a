"""Where a part of a quoted text stands in a program."""

from __future__ import annotations

from typing import Final

from plastron_tui.diagnostics import Span

from .declaration import Statement
from .grammar import kind_id

_ESCAPE: Final = kind_id("escape_sequence")
_BEYOND: Final = 0xFFFF


def span_in_text(statement: Statement, slot: str, start: int, end: int) -> Span:
    """Return where some characters of a slot's quoted text stand.

    Args:
        statement: the statement.
        slot: its slot, which is filled with a text in quotes.
        start: the first character, counted in what the text means.
        end: the one behind the last; where it is `start`, the whole slot is meant.
    """
    whole = statement.span_of(slot)
    node = statement.syntax.child_by_field_name(slot)
    if node is None or end <= start:
        return whole
    places = [whole.start + 1]
    text: str = getattr(statement, slot)
    escapes = [
        (each.start_byte + statement.shift, each.end_byte + statement.shift)
        for each in node.named_children
        if each.kind_id == _ESCAPE
    ]
    for character in text:
        at = places[-1]
        size = len(character.encode("utf-8", "surrogatepass"))
        # A character beyond U+FFFF may be written as two escapes.
        for _ in range(2 if ord(character) > _BEYOND else 1):
            if escapes and escapes[0][0] == at:
                at = escapes.pop(0)[1]
                size = 0
        places.append(at + size)
    last = min(end, len(text))
    return Span(places[min(start, last)], places[last])
