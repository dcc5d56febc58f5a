"""Lines that lack the variable of what they make, and what to write."""

from __future__ import annotations

import re

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span, write

from .declaration import Slot
from .keywords import WORDS
from .mistake_place import Place
from .tokens import QUOTED_KINDS

_VARIABLE = re.compile(r"[A-Za-z]\w*", re.ASCII)


def variable_left_out(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `create_robot 'rover'`, and `create_robot 'rover' r`.

    The variable is called like what is named before it; a path by its file, without endings.
    """
    at, before = place.at, place.before
    if before is None or before.kind not in QUOTED_KINDS or not _wants_as(place):
        return None
    if at + 1 == len(place.tokens) and place.is_name(at):
        right = f"as {place.token.text}"
        return found._replace(help=f"write `{right}`", fix=write(right, place.token.span))
    assert place.declaration is not None, "a word of a known sentence is missing"
    clauses = {each.keyword for each in place.declaration.clauses}
    name = _named_after(before.text[1:-1])
    if name is None or (at < len(place.tokens) and place.text(at) not in clauses):
        return None
    fix = Fix(f"write `as {name}`", (Edit(Span(before.end, before.end), f" as {name}"),))
    return found._replace(help=fix.title, fix=fix)


def _wants_as(place: Place) -> bool:
    """Tell whether `as` and a new variable are to stand at a place."""
    if place.declaration is None:
        return False
    elements = place.declaration.elements
    following = elements[place.at : place.at + 2]
    return (
        len(following) == 2
        and following[0] == "as"
        and isinstance(following[1], Slot)
        and following[1].kind.makes is not None
        and place.at - 1 in place.slots
    )


def _named_after(text: str) -> str | None:
    """Return a variable that is called like something; None where it makes none."""
    stem = text.rpartition("/")[2].partition(".")[0]
    name = re.sub(r"\W+", "_", stem, flags=re.ASCII).strip("_")
    return name if _VARIABLE.fullmatch(name) and name not in WORDS else None
