"""The nearest of the names that would have been right."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice

from .data import Fix, Span, write

# Beyond this many names a suggestion costs more than it helps.
_MOST_NAMES = 5_000
# Comparing takes the product of the lengths, and nobody slips in the name of a paragraph.
_LONGEST_NAME = 200


def nearest(word: str, names: Iterable[str]) -> str | None:
    """Return the name closest to `word`, or None when none is close."""
    from difflib import get_close_matches  # slow to import, and needed for mistakes only

    if len(word) > _LONGEST_NAME:
        return None
    by_lower: dict[str, str] = {}
    for name in islice(names, _MOST_NAMES):
        if len(name) <= _LONGEST_NAME:
            by_lower.setdefault(name.lower(), name)
    found = get_close_matches(word.lower(), by_lower, n=1, cutoff=0.6)
    return by_lower[found[0]] if found else None


def did_you_mean(word: str, names: Iterable[str]) -> str | None:
    """Return a help line that offers the nearest name, or None when none is close."""
    name = nearest(word, names)
    return f"did you mean `{name}`?" if name is not None else None


def guess(
    word: str, names: Iterable[str], span: Span, *, is_quoted: bool = False
) -> tuple[str | None, Fix | None]:
    """Return the help line that offers the nearest name, and the fix that writes it.

    Both are None when no name is close.

    Args:
        word: what is written.
        names: what would have been right.
        span: where the word stands, with its quotes if it has some.
        is_quoted: whether the word stands in single quotes.
    """
    name = nearest(word, names)
    if name is None:
        return None, None
    return f"did you mean `{name}`?", write(f"'{name}'" if is_quoted else name, span)
