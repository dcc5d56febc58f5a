"""A slot as several rows of a form: the numbers of a place, the lengths of a shape."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from plastron_tui.language.sentence import quoted

from .values import NUMBER, Path

VECTOR = re.compile(rf"\s*({NUMBER.pattern})" + rf"\s*,\s*({NUMBER.pattern})" * 2 + r"\s*")
"""Three numbers with commas between them, as somebody writes them in one row."""


class Part(NamedTuple):
    """What one row is for.

    Attributes:
        name: what it is called.
        note: what its number is in, or what the text is.
        usual: what is in it as long as nothing was entered.
        without: what is meant where it is left out beside others, "" where it is not written then.
        example: a number that could stand there, "" where it is a text.
        is_needed: whether it cannot be left out.
    """

    name: str
    note: str
    usual: str = ""
    without: str = ""
    example: str = "0.2"
    is_needed: bool = False


class FilledPart(NamedTuple):
    """A row, the key of what was entered in it, and what is in it."""

    part: Part
    path: Path
    text: str

    @property
    def written(self) -> str:
        """It as the program has it."""
        text = self.text.strip() or self.part.without
        return quoted(text) if text and not self.part.example else text


def filled_parts(slot: str, parts: Sequence[Part], given: Mapping[Path, str]) -> list[FilledPart]:
    """Return the rows of a slot, with what was entered; `given` has that by path."""
    keys = ((part, (slot, part.name)) for part in parts)
    return [FilledPart(part, path, given.get(path, part.usual)) for part, path in keys]


def parts_text(parts: Sequence[FilledPart]) -> str:
    """Return what the program has in the slot: "" where all rows are empty."""
    if not any(each.text.strip() for each in parts):
        return ""
    texts = [each.written for each in parts]
    while texts and not texts[-1]:
        texts.pop()
    return ", ".join(texts)


def part_problems(parts: Sequence[FilledPart]) -> Iterator[tuple[Path, str]]:
    """Yield what is wrong with rows, each with its key."""
    for each in parts:
        name, example, text = each.part.name, each.part.example, each.text.strip()
        if not text and each.part.is_needed:
            yield each.path, f"{name} is needed" + (f", such as {example}" if example else "")
        elif text and example and NUMBER.fullmatch(text) is None:
            yield each.path, f"{name} is a number, such as {example}"


def used_paths(parts: Sequence[FilledPart]) -> tuple[Path, ...]:
    """Return the keys of the rows that stand in the program, in order."""
    return tuple(each.path for each in parts if each.written)
