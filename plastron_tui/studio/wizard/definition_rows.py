"""The fields of a definition as rows of a form: one for each, and an empty one at the end."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.language import Slot
from plastron_tui.language.declaration import Form as Written

from .definition_kinds import EXAMPLES, field_problem
from .form import Form
from .values import Path

MOST_ROWS = 200
"""The most fields that a form takes; a definition with more of them is written by hand."""


def row_path(slot: Slot, number: int) -> Path:
    """Return the key by which a form has what was entered for a field."""
    return slot.name, str(number)


def rows_of(form: Form, slot: Slot) -> list[str]:
    """Return what is in the rows; the first one has an example as long as nobody wrote there."""
    given = {
        int(path[1]): text
        for path, text in form.values.items()
        if len(path) == 2 and path[0] == slot.name
    }
    last = min(max(given, default=0), MOST_ROWS - 1)
    rows = [given.get(number, "") for number in range(last + 1)]
    if 0 not in given:
        rows[0] = EXAMPLES.get(slot.name, "")
    while len(rows) > 1 and not (rows[-1].strip() or rows[-2].strip()):
        rows.pop()
    if rows[-1].strip() and len(rows) < MOST_ROWS:
        rows.append("")
    return rows


def fields_text(rows: list[str]) -> str:
    """Return the fields as the program has them."""
    return ", ".join(text.strip() for text in rows if text.strip()) or "none"


def filled_rows(rows: list[str]) -> tuple[int, ...]:
    """Return the numbers of the rows that have a field, in order."""
    return tuple(number for number, text in enumerate(rows) if text.strip())


def row_problems(rows: list[str]) -> Iterator[tuple[int, str]]:
    """Yield what is wrong with the shape of a field, with the number of its row."""
    for number in filled_rows(rows):
        problem = field_problem(rows[number])
        if problem is not None:
            yield number, problem


def field_slots(form: Form) -> list[Slot]:
    """Return the slots that have fields."""
    return [slot for slot in form.declaration.slots if slot.kind.form is Written.FIELDS]
