"""What is wrong with a line that is no statement, in terms of the statement it was to be."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, islice

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic

from .broken_lines import Broken, Undecided
from .declaration import Declaration
from .keywords import KEYWORDS
from .line_mistakes import first_mistake, guessed, undecided
from .line_repair import fixed
from .sentence_match import intended
from .tokens import MOST_WORDS, QUOTED_KINDS, WORD_KINDS, Token, tokens_of

__all__ = ["MOST_BROKEN_LINES", "MOST_REPAIRED_LINES", "explain"]

MOST_BROKEN_LINES = 1_000
"""How many lines are explained; what a machine wrote can have a mistake on each of a million."""


MOST_REPAIRED_LINES = 20
"""How many lines are tried with changes, some milliseconds each: a text of more is no program."""


def explain(source: bytes, broken: Sequence[Node]) -> tuple[tuple[Diagnostic, ...], Broken]:
    """Explain the nodes that are no statements: one diagnostic a line."""
    diagnostics: list[Diagnostic] = []
    words: set[str] = set()
    declared: set[str] = set()
    unfinished: set[str] = set()
    open_ends: list[Undecided] = []
    lost = 0
    for _, line in groupby(tokens_of(source, broken), key=lambda token: token.row):
        tokens = tuple(islice(line, MOST_WORDS))
        names = set(_names(tokens))
        words |= names
        if not any(token.kind in QUOTED_KINDS for token in tokens):
            unfinished |= names - KEYWORDS or {""}
        declaration = intended(tokens)
        is_explained = len(diagnostics) < MOST_BROKEN_LINES
        if _may_declare(declaration or (guessed(tokens) if is_explained else None)):
            declared |= names
            lost += declaration is not None and not _has_variable(declaration, tokens)
        if is_explained:
            mistake = first_mistake(source, tokens, declaration)
            is_tried = len(diagnostics) < MOST_REPAIRED_LINES
            diagnostics.append(fixed(source, tokens, mistake, is_tried=is_tried))
            open_ends += filter(None, [undecided(tokens)])
    found = Broken(
        frozenset(words), frozenset(declared), frozenset(unfinished), lost, tuple(open_ends)
    )
    return tuple(diagnostics), found


def _names(tokens: Sequence[Token]) -> Iterator[str]:
    for token in tokens:
        if token.kind in WORD_KINDS:
            yield token.text
        elif token.kind in QUOTED_KINDS or token.kind == "string":
            # A name that stands in the wrong quotes is named all the same.
            yield token.text[1:-1]


def _may_declare(declaration: Declaration | None) -> bool:
    """Tell whether a statement was to declare a variable; of an unknown one, it may."""
    if declaration is None:
        return True
    return any(slot.kind.makes is not None for slot in declaration.slots)


def _has_variable(declaration: Declaration, tokens: Sequence[Token]) -> bool:
    """Tell whether a broken declaration has a word that can be its variable."""
    first = next(
        index
        for index, slot in enumerate(declaration.slots, start=1)
        if slot.kind.makes is not None
    )
    words = (token for token in tokens[first:] if token.kind in WORD_KINDS)
    return any(token.text not in KEYWORDS for token in words)
