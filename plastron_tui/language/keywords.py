"""The words of the language, as the declarations have them."""

from __future__ import annotations

from collections.abc import Iterable

from . import statements as _statements  # noqa: F401 - declares the statements
from .declaration import DECLARATIONS, Clause, Declaration, Element, Form, Slot

_VALUE_WORDS = ("none", "True", "False")
_PLAIN_VALUE_WORDS = ("parameter", "received", "any", "all")


def _words_of(elements: Iterable[Element]) -> Iterable[str]:
    for element in elements:
        if isinstance(element, str):
            yield element
        elif isinstance(element, Slot) and element.kind.form is Form.FLAG:
            yield element.kind.placeholder
        elif isinstance(element, Clause):
            yield from _words_of(element.elements)


WORDS: frozenset[str] = frozenset((*_VALUE_WORDS, *_PLAIN_VALUE_WORDS)).union(
    *(_words_of(declaration.elements) for declaration in DECLARATIONS.values())
)
"""Every word of the language, as it is highlighted where it stands in its place."""

# The plain words of version 0.1.0. Later ones are words only where their clause can stand, so that
# no program that has one for a variable means something else.
_RESERVED = frozenset(
    {
        "load", "subscribe", "unsubscribe", "publish", "as", "using", "of", "and", "with", "input",
        "to", "from", "calling", "at", "hz", *_VALUE_WORDS,
    }
)  # fmt: skip

KEYWORDS: frozenset[str] = frozenset(word for word in WORDS if word in _RESERVED or "_" in word)
"""The words that are no variables."""

BY_KEYWORD: dict[str, Declaration] = {
    declaration.keyword: declaration for declaration in DECLARATIONS.values()
}
"""The statements, each by the word that only it has."""

FIRST_WORDS = tuple(
    word for word, declaration in BY_KEYWORD.items() if declaration.elements[0] == word
)
"""The words that start a statement."""

VERBS = tuple(word for word in BY_KEYWORD if word not in FIRST_WORDS)
"""The words that come second, after the variable of a node."""
