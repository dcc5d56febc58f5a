"""A text that is pasted where none is asked for: a word finds an entry, lines enter the program."""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.diagnostics import Edit, Span

from ..screens.question import Question
from .menu_page import Item

_SHOWN = 8
"""The most lines of a text that a question shows."""


def lines_of(text: str) -> list[str]:
    """Return the lines of a pasted text, without empty ones around it."""
    return text.replace("\r\n", "\n").replace("\r", "\n").strip("\n").split("\n")


def entry_for(text: str, items: Sequence[Item]) -> int | None:
    """Return the first entry of a menu that has a pasted word, None for other texts."""
    word = text.strip().lower()
    if not word or any(map(str.isspace, word)):
        return None
    said = (f"{item.title} {item.term} {item.about}".lower() for item in items)
    return next((n for n, words in enumerate(said) if word in words and not items[n].closed), None)


def insertion(program: bytes, lines: Sequence[str]) -> Edit:
    """Return what puts lines behind all that a program has."""
    before = b"" if not program or program.endswith(b"\n") else b"\n"
    text = before.decode() + "\n".join(lines) + "\n"
    return Edit(Span(len(program), len(program)), text)


def dialog(lines: Sequence[str]) -> Question:
    """Return what asks whether lines are to enter the program: the answer is "insert" then."""
    answers = [("insert", "Insert"), ("cancel", "Leave them out")]
    return Question(f"Insert {_counted(lines)} into the program?", answers, text=preview(lines))


def preview(lines: Sequence[str]) -> str:
    """Return the first of some lines, and how many follow."""
    more = len(lines) - _SHOWN
    shown = [*lines[:_SHOWN], *([f"… and {more} more"] if more > 0 else [])]
    return "\n".join(shown)


def inserted(lines: Sequence[str]) -> str:
    """Return what is said once lines are in the program."""
    count = "the line is" if len(lines) == 1 else f"{len(lines)} lines are"
    return f"{count} in the program now; one undo in the editor takes that back"


def _counted(lines: Sequence[str]) -> str:
    return "this line" if len(lines) == 1 else f"these {len(lines)} lines"
