"""What help says in lines that fit: keys, actions, the statements of the language."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from textwrap import wrap

from plastron_tui.language import DECLARATIONS

from ..actions import grouped
from ..panels.styles import Line, Piece

_KEYS = 16
"""Columns of keys, with the blanks around them."""
_TITLES = 28
"""Columns of what an action is called, where there is room for more beside it."""
_ROOMY = 84
"""From so many columns on, what actions do is said in a column of its own."""
_LEAST = 20
"""Fewer columns are no room for a text."""


def key_lines(keys: Iterable[tuple[str, str]], width: int) -> Iterator[Line]:
    """Yield keys with what each does, under a heading; nothing for no keys."""
    rows = list(keys)
    if not rows:
        return
    yield (Piece("Keys here", "primary"),)
    for key, what in rows:
        yield from _beside(_key(key), what, "", width)
    yield ()


def action_lines(keys: Mapping[str, str], width: int) -> Iterator[Line]:
    """Yield all actions under their headings; `keys` has the key of each by its id."""
    for group, actions in grouped():
        yield (Piece(group, "primary"),)
        for action in actions:
            head, said = _key(keys.get(action.id, "")), action.help.rstrip(".")
            if width >= _ROOMY:
                title = f"{action.title:<{_TITLES}}"
                yield from _beside((*head, Piece(title)), said, "quiet", width)
            else:
                first, *others = _wrapped(f"{action.title}: {said}", width - _KEYS)
                title, rest = first[: len(action.title)], first[len(action.title) :]
                yield (*head, Piece(title), Piece(rest, "quiet"))
                yield from ((Piece(f"{' ' * _KEYS}{each}", "quiet"),) for each in others)
        yield ()


def statement_lines(width: int) -> Iterator[Line]:
    """Yield the statements of the language, as they are declared."""
    yield (Piece("Statements", "primary"),)
    for declaration in DECLARATIONS.values():
        first, *others = _wrapped(declaration.usage, width - 6)
        yield (Piece(f"  {first}", "strong"),)
        yield from ((Piece(f"      {each}", "strong"),) for each in others)
        yield from _indented(declaration.summary, "quiet", 6, width)
        for row in declaration.example.split("\n"):
            yield from _indented(row, "string", 6, width)
    yield ()


def _key(key: str) -> Line:
    return (Piece(f"  {key or 'menu':<{_KEYS - 3}} ", "accent" if key else "dim"),)


def _beside(head: Line, text: str, tone: str, width: int) -> Iterator[Line]:
    """Yield a text beside what it is about, its further lines below its first one."""
    indent = sum(len(piece.text) for piece in head)
    first, *others = _wrapped(text, width - indent)
    yield (*head, Piece(first, tone))
    yield from ((Piece(f"{' ' * indent}{each}", tone),) for each in others)


def _indented(text: str, tone: str, indent: int, width: int) -> Iterator[Line]:
    for each in _wrapped(text, width - indent):
        yield (Piece(f"{' ' * indent}{each}", tone),)


def _wrapped(text: str, width: int) -> list[str]:
    return wrap(text, max(width, _LEAST), break_on_hyphens=False) or [""]
