"""What is wrong with a line that is no statement, in terms of the statement it was to be."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby, islice

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span, codes
from plastron_tui.diagnostics.suggest import nearest

from .broken_lines import Broken
from .common_mistakes import completed, recognised
from .declaration import Declaration, Slot, SlotKind
from .keywords import BY_KEYWORD, FIRST_WORDS, KEYWORDS, VERBS
from .missing_words import missing_word
from .mistake_place import Place
from .sentence_errors import SentenceErrors
from .sentence_match import intended, match_sentence
from .token_errors import unexpected
from .tokens import MOST_WORDS, QUOTED_KINDS, UNKNOWN, WORD_KINDS, Token, tokens_of
from .verbs import kindred_verbs, nearest_verb

__all__ = ["MOST_BROKEN_LINES", "explain"]

MOST_BROKEN_LINES = 1_000
"""How many lines are explained; what a machine wrote can have a mistake on each of a million."""


def explain(source: bytes, broken: Sequence[Node]) -> tuple[tuple[Diagnostic, ...], Broken]:
    """Explain the nodes that are no statements: one diagnostic a line."""
    diagnostics: list[Diagnostic] = []
    words: set[str] = set()
    declared: set[str] = set()
    unfinished: set[str] = set()
    lost = 0
    for _, line in groupby(tokens_of(source, broken), key=lambda token: token.row):
        tokens = tuple(islice(line, MOST_WORDS))
        names = set(_names(tokens))
        words |= names
        if not any(token.kind in QUOTED_KINDS for token in tokens):
            unfinished |= names - KEYWORDS or {""}
        declaration = intended(tokens)
        is_explained = len(diagnostics) < MOST_BROKEN_LINES
        if _may_declare(declaration or (_guessed(tokens) if is_explained else None)):
            declared |= names
            lost += declaration is not None and not _has_variable(declaration, tokens)
        if is_explained:
            diagnostics.append(_explain_line(source, tokens, declaration))
    found = Broken(frozenset(words), frozenset(declared), frozenset(unfinished), lost)
    return tuple(diagnostics), found


def _names(tokens: Sequence[Token]) -> Iterator[str]:
    for token in tokens:
        if token.kind in WORD_KINDS:
            yield token.text
        elif token.kind in QUOTED_KINDS or token.kind == "string":
            # A name that stands in the wrong quotes is named all the same.
            yield token.text[1:-1]


def _explain_line(
    source: bytes, tokens: Sequence[Token], declaration: Declaration | None
) -> Diagnostic:
    for token in tokens:
        if token.kind == UNKNOWN and token.text.startswith("/*"):
            end = source.find(b"\n", token.start)
            end = len(source[: end if end >= 0 else None].rstrip())
            fix = Fix("close it", (Edit(Span(end, end), " */"),))
            return unexpected(token)._replace(fix=fix)
    slots: dict[int, SlotKind] = {}
    words: tuple[str, ...] = ()
    if declaration is None:
        found = _unknown_statement(tokens)
    else:
        match = match_sentence(declaration, tokens)
        found = SentenceErrors(declaration, tokens).first(match)
        slots = {filled.first: filled.slot.kind for filled in match.slots}
        if isinstance(match.wanted, Slot):
            slots[match.end] = match.wanted.kind
        first = (match.wanted,) if isinstance(match.wanted, str) else ()
        words = (*first, *match.instead, *match.following)
    start = None if found.span is None else found.span.start
    at = next((index for index, token in enumerate(tokens) if token.start == start), len(tokens))
    place = Place(source, tokens, at, slots, declaration)
    if at == len(tokens):
        return completed(place, found)
    found = recognised(place, found)
    if found.fix is not None or not words:
        return found
    first_byte = tokens[0].start
    line = source[first_byte : tokens[-1].end]
    return found._replace(fix=missing_word(line, tokens[at].start - first_byte, words, first_byte))


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


def _misspelt(tokens: Sequence[Token]) -> tuple[Token, str] | None:
    """Return the token that a keyword was to be, and the keyword."""
    first = tokens[0]
    if first.kind not in WORD_KINDS:
        return None
    name = None if _beginning_with(first.text) else nearest(first.text, FIRST_WORDS)
    if name is not None:
        return first, name
    if len(tokens) < 2 or tokens[1].kind not in WORD_KINDS:
        return None
    name = nearest_verb(tokens[1].text)
    return None if name is None else (tokens[1], name)


def _beginning_with(word: str) -> tuple[str, ...]:
    """Return the words that start a statement and go on, where it ends, with what is made."""
    return tuple(each for each in FIRST_WORDS if each.startswith(f"{word}_"))


def _guessed(tokens: Sequence[Token]) -> Declaration | None:
    found = _misspelt(tokens)
    return None if found is None else BY_KEYWORD[found[1]]


def _unknown_statement(tokens: Sequence[Token]) -> Diagnostic:
    first = tokens[0]
    found = _misspelt(tokens)
    if found is not None:
        token, name = found
        return Diagnostic(
            codes.UNKNOWN_STATEMENT,
            f"`{token.text}` starts no statement",
            token.span,
            help=f"did you mean `{name}`?",
            fix=Fix(f"write `{name}`", (Edit(token.span, name),)),
        )
    if first.kind not in WORD_KINDS:
        return unexpected(first)
    if len(tokens) == 1:
        return Diagnostic(
            codes.UNKNOWN_STATEMENT,
            f"`{first.text}` alone is no statement",
            first.span,
            help=f"after a variable comes {', '.join(VERBS)}",
        )
    wrong = first
    help_ = f"a statement starts with {', '.join(FIRST_WORDS)}, or with a variable"
    if longer := _beginning_with(first.text):
        help_ = _did_you_mean_one_of(longer)
    elif verbs := kindred_verbs(tokens[1].text):
        wrong = tokens[1]
        help_ = _did_you_mean_one_of(verbs)
    return Diagnostic(
        codes.UNKNOWN_STATEMENT, f"`{wrong.text}` starts no statement", wrong.span, help=help_
    )


def _did_you_mean_one_of(words: Sequence[str]) -> str:
    *others, last = (f"`{each}`" for each in words)
    return f"did you mean {', '.join(others)} or {last}?" if others else f"did you mean {last}?"
