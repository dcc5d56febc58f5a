"""The words of the language, as the declarations have them."""

from __future__ import annotations

from collections.abc import Iterable

from . import statements as _statements  # noqa: F401 - declares the statements
from .declaration import DECLARATIONS, Clause, Declaration, Element

_VALUE_WORDS = ("none", "True", "False")


def _words_of(elements: Iterable[Element]) -> Iterable[str]:
    for element in elements:
        if isinstance(element, str):
            yield element
        elif isinstance(element, Clause):
            yield from _words_of(element.elements)


KEYWORDS: frozenset[str] = frozenset(_VALUE_WORDS).union(
    *(_words_of(declaration.elements) for declaration in DECLARATIONS.values())
)
"""Every word that is no variable."""

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
