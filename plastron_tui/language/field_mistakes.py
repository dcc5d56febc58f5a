"""Common slips of the pen in the fields of a type, and what was meant."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from plastron_tui.diagnostics import Diagnostic, Edit, Fix

from .declaration import Declaration, Form, Slot, SlotKind
from .list_errors import end_of_type
from .mistake_place import Place, mended


def _is_in_fields(place: Place) -> bool:
    return place.within is not None and place.within.form is Form.FIELDS


def colon(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `left: float64`, as other languages have it."""
    at = place.at
    is_pair = place.token.text == ":" and place.is_name(at - 1) and place.is_name(at + 1)
    if not is_pair or not _is_in_fields(place):
        return None
    end = min(end_of_type(place.tokens, at + 1), len(place.tokens))
    right = f"{place.written(at + 1, end)} {place.text(at - 1)}"
    what = "the type of a field comes before its name, without a `:`"
    return mended(found, what, place.span(at - 1, end), right)


def brackets(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `float64 left[3]`, as C has it, and `left float64[3]`."""
    at = place.at
    is_behind = place.token.text == "[" and place.is_name(at - 1) and place.is_name(at - 2)
    if not is_behind or not _is_in_fields(place):
        return None
    what = "the brackets of an array stand behind its type, which comes before the name"
    return found._replace(message=what, help="write it as `float64[3] x`, or `float64[] x`")


FIELD_SLIPS: tuple[Callable[[Place, Diagnostic], Diagnostic | None], ...] = (colon, brackets)


def without_fields(declaration: Declaration, word: str, found: Diagnostic) -> Diagnostic | None:
    """Say what to write where a line ends before a word that fields come after.

    Args:
        declaration: the statement.
        word: the word of it that is missing.
        found: what is wrong so far, at the end of the line.
    """
    words = [
        element
        for element, slot in pairwise(declaration.elements)
        if isinstance(slot, Slot) and slot.kind is SlotKind.FIELDS and isinstance(element, str)
    ]
    if word not in words or found.span is None:
        return None
    missing = words[words.index(word) :]
    none = " ".join(f"{each} none" for each in missing)
    # Who wrote some fields may have none for the others; who wrote none has yet to begin.
    has_some = len(missing) < len(words)
    fix = Fix(f"write `{none}`", (Edit(found.span, f" {none}"),)) if has_some else None
    return found._replace(
        help=f"write `{none}`, or fields for `none`, such as `float64 x, float64 y`", fix=fix
    )
