"""How the lines of a form's page are shared out where there are not enough for all."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

LEAST_ROWS = 3
"""At least so many rows of the form are in sight, that with the cursor among them."""

IN_SIGHT = 2
"""So many choices are kept in sight, if need be instead of rows of the form."""


class Wanted(NamedTuple):
    """The lines that the parts of a page would take, with the empty ones around them.

    Attributes:
        about: the sentence above the form.
        rows: the form.
        help: what is said of the row with the cursor, or what is wrong with it.
        choices: the first choices, as many as have to be in sight; 0 where there are none.
    """

    about: int
    rows: int
    help: int
    choices: int


class Room(NamedTuple):
    """What is shown: whether the sentence above the form is, and how many lines of the form."""

    has_about: bool
    rows: int


def room_for(wanted: Wanted, height: int, *, is_read: bool) -> Room:
    """Return what there is room for: what is said of the row comes first, and its choices.

    Args:
        wanted: the lines that the parts take.
        height: the lines that there are.
        is_read: whether somebody has just come to the page, and reads what it is about.
    """
    rest = height - wanted.help - wanted.choices
    rows = LEAST_ROWS if is_read else wanted.rows
    has_about = wanted.about + min(rows, wanted.rows) <= rest
    return Room(has_about, max(LEAST_ROWS, rest - wanted.about * has_about))


def first_choices(heights: Sequence[int]) -> int:
    """Return the lines of the choices that have to be in sight, of those of each."""
    return sum(heights[:IN_SIGHT])
