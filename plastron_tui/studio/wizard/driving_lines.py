"""Lines that drive a robot whatever arrives, and give way to what stops it, unless kept."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from plastron_tui.diagnostics import codes, listed
from plastron_tui.language import statements as st

from .menu import Option
from .program_trial import Placed

REPLACES = "replaces"
"""The key of taking away what drives a robot whatever arrives."""

LIVED_WITH = frozenset({codes.UNCONDITIONAL_MOTION})
"""What somebody is not told of who keeps such a line."""


def is_asked(placed: Sequence[Placed]) -> bool:
    """Tell whether lines give way that could stay: a timer cannot be there twice."""
    forms = (each.form for each in placed if each.replaces)
    return any(form is not None and form.declaration.type is st.Publish for form in forms)


def kept(placed: Iterable[Placed]) -> list[Placed]:
    """Return statements that take nothing away."""
    return [replace(each, replaces=()) for each in placed]


def numbers_of(text: bytes, placed: Iterable[Placed]) -> tuple[int, ...]:
    """Return the numbers of the lines that give way, from 1."""
    starts = sorted({span.start for each in placed for span in each.replaces})
    return tuple(text.count(b"\n", 0, start) + 1 for start in starts)


def option(text: bytes, numbers: Sequence[int], *, is_wanted: bool) -> Option:
    """Return the question whether lines give way, with what is in the first of them."""
    lines = "lines" if len(numbers) > 1 else "line"
    said = text.splitlines()[numbers[0] - 1].decode("utf-8", "replace").strip()
    more = ", …" if len(numbers) > 1 else ""
    words = f"take the place of {lines} {listed([str(each) for each in numbers])}: {said}{more}"
    return Option(REPLACES, words, is_wanted)


def explained(numbers: Sequence[int], *, is_kept: bool) -> str:
    """Return what is said of lines that drive whatever arrives."""
    those, drive = ("Lines", "drive") if len(numbers) > 1 else ("Line", "drives")
    said = f"{those} {listed([str(each) for each in numbers])} {drive} whatever arrives"
    end = "the robot will not stop" if is_kept else "with both, the robot would not stop"
    return f"{said}: {end}."
