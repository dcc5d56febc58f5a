"""What a page of the wizard shows, found out without a screen."""

from __future__ import annotations

from dataclasses import dataclass

from .ask import Choice
from .flow import Course
from .form import Form
from .form_rows import Key
from .menu import Offer
from .pages import Look
from .values import Path

Asked = tuple[Form, str, "Path | None", str]
"""The row that choices are wanted for: its form, its slot, its field, and what was written."""


@dataclass(frozen=True, slots=True)
class View:
    """What was found out, in a thread."""

    look: Look
    helps: dict[Key, str]
    choices: list[Choice]
    offers: list[Offer]


def view_of(course: Course, asked: Asked | None, *, is_done: bool) -> View:
    """Find out what the page that is shown has.

    Args:
        course: the state of the wizard.
        asked: the row that choices are wanted for, None for none.
        is_done: whether the statements are in the program.
    """
    look = course.look()
    page = course.page
    offers: list[Offer] = []
    helps: dict[Key, str] = {}
    choices: list[Choice] = []
    if is_done:
        return View(look, helps, choices, offers)
    if page.form is None:
        return View(look, helps, choices, course.offers())
    filled = look.of(page.form)
    if filled is not None:
        helps = course.helps(filled)
        if asked is not None and asked[0] is page.form:
            choices = course.choices(filled, *asked[1:])
    return View(look, helps, choices, offers)
