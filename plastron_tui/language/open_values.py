"""Where among the values of an input one is, after some of its tokens."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from .tokens import WORD_KINDS, Token, text_at

NAME_MARKS = frozenset({".", "="})
"""What follows a word among values that names a field, or a part of it."""

ARITHMETIC = frozenset({"+", "-", "*", "/"})
"""What stands between the parts of a calculation."""

_BEFORE_VALUE = frozenset({"(", "[", ",", "="})


def is_received(tokens: Sequence[Token], at: int) -> bool:
    """Tell whether a field of what was received begins at a token, and not a field's name."""
    if text_at(tokens, at) != "received" or text_at(tokens, at - 1) == ".":
        return False
    return text_at(tokens, end_of_received(tokens, at)) != "="


def end_of_received(tokens: Sequence[Token], at: int) -> int:
    """Return where `received.FIELD` or `received.FIELD[INDEX]` ends, or breaks off."""
    at += 1
    while text_at(tokens, at) == "." and at + 1 < len(tokens) and tokens[at + 1].kind in WORD_KINDS:
        at += 2
    if text_at(tokens, at) == "[" and text_at(tokens, at + 1).isdigit():
        at += 3 * (text_at(tokens, at + 2) == "]")
    return at


@dataclass(slots=True)
class Level:
    """Values that are open: a list's, a nested message's, or all of an input's.

    Attributes:
        opening: the bracket before them.
        key: what they are in the values around them: a field, or a position.
        index: how many values stand before the next one.
        name: the field that the next one is for, None where no name is written.
        used: the names so far.
    """

    opening: Token | None = None
    key: str | int | None = None
    index: int = 0
    name: str | None = None
    used: set[str] = field(default_factory=set)

    @property
    def is_list(self) -> bool:
        """Whether they are the elements of a list."""
        return self.opening is not None and self.opening.kind == "["


class OpenValues:
    """The values that are open after the tokens that were taken, the innermost last."""

    def __init__(self) -> None:
        self.levels = [Level()]
        self.last: Token | None = None

    @property
    def wants_value(self) -> bool:
        """Whether a value, or its name, comes next."""
        return self.last is None or self.last.kind in _BEFORE_VALUE

    def take(self, token: Token) -> None:
        """Go over a token, whether it fits or not."""
        level = self.levels[-1]
        match token.kind:
            case "(" | "[":
                key = level.index if level.name is None else level.name
                self.levels.append(Level(token, key))
            case ")" | "]" if len(self.levels) > 1:
                self.levels.pop()
            case ",":
                level.index += 1
                level.name = None
            case "=" if self.last is not None:
                level.name = self.last.text
                level.used.add(level.name)
        self.last = token
