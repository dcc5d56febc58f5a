"""The word of a sentence that is left out, where a line is right once it is there."""

from __future__ import annotations

from collections.abc import Iterable

from plastron_tui.diagnostics import Edit, Fix, Span

from .grammar import new_parser

_LONGEST = 500
"""Bytes of a line that is tried with each word that may be missing."""


def missing_word(line: bytes, at: int, words: Iterable[str], start: int) -> Fix | None:
    """Return what writes a word that is left out, None where none is, or several may be.

    Args:
        line: the whole statement.
        at: the byte of it before which a word may be missing.
        words: the words that may stand there.
        start: where the line starts in the program.
    """
    if len(line) > _LONGEST:
        return None
    parser = new_parser()
    fitting = [
        word
        for word in dict.fromkeys(words)
        if not parser.parse(line[:at] + f"{word} ".encode() + line[at:]).root_node.has_error
    ]
    if len(fitting) != 1:
        return None
    place = Span(start + at, start + at)
    return Fix(f"write `{fitting[0]}` before it", (Edit(place, f"{fitting[0]} "),))
