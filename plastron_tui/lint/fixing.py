"""Applying the fixes of what was found to a text."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from plastron_tui.diagnostics import Edit, Fix
from plastron_tui.sources.splices import Splice, apply, newline_of


class Fixed(NamedTuple):
    """A text with fixes.

    Attributes:
        text: the text.
        applied: the fixes that it has; those that overlap them have their turn later.
    """

    text: bytes
    applied: tuple[Fix, ...]


def with_fixes(text: bytes, fixes: Iterable[Fix]) -> Fixed:
    """Return a text with fixes that do not overlap, those that come first in it before others.

    Of what stands between the edits no byte changes; new lines end as those of the text do.
    """
    taken: list[Splice] = []
    applied: list[Fix] = []
    for fix in sorted(dict.fromkeys(fixes), key=lambda fix: [edit.span for edit in fix.edits]):
        splices = [_splice(edit, text) for edit in fix.edits]
        if not any(_overlap(one, other) for one in splices for other in taken):
            taken += splices
            applied.append(fix)
    return Fixed(apply(text, taken), tuple(applied))


def _splice(edit: Edit, text: bytes) -> Splice:
    new = edit.text.encode()
    if newline_of(text) == b"\r\n":
        new = new.replace(b"\r\n", b"\n").replace(b"\n", b"\r\n")
    return Splice(edit.span.start, edit.span.end, new)


def _overlap(one: Splice, other: Splice) -> bool:
    """Tell whether two splices touch the same bytes, or insert at one place."""
    if one.start == other.start:
        return True
    return one.start < other.end and other.start < one.end
