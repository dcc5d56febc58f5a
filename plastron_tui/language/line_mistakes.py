"""What is wrong first with a line that is no statement, and what may stand in that place."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span, codes

from .broken_lines import Undecided
from .common_mistakes import completed, recognised
from .declaration import Declaration, Slot, SlotKind
from .keywords import BY_KEYWORD, FIRST_WORDS, VERBS
from .mistake_place import Place
from .sentence_errors import SentenceErrors
from .sentence_match import match_sentence
from .token_errors import unexpected
from .tokens import UNKNOWN, WORD_KINDS, Token
from .undoing import nearest_keyword
from .verbs import kindred_verbs, nearest_verb


class LineMistake(NamedTuple):
    """The first mistake of a line.

    Attributes:
        diagnostic: what is wrong; its fix may leave another mistake of the line.
        at: the token that it starts at, or how many tokens there are where the line ends too early.
        words: the words of the sentence that may stand there.
        wanted: the slot that was to be filled there, if one was.
    """

    diagnostic: Diagnostic
    at: int
    words: tuple[str, ...] = ()
    wanted: SlotKind | None = None


def first_mistake(
    source: bytes, tokens: Sequence[Token], declaration: Declaration | None
) -> LineMistake:
    """Return what is wrong first with a line.

    Args:
        source: the program.
        tokens: those of the line, one at least.
        declaration: the statement that the line was to be, if that is known.
    """
    for at, token in enumerate(tokens):
        if token.kind == UNKNOWN and token.text.startswith("/*"):
            end = source.find(b"\n", token.start)
            end = len(source[: end if end >= 0 else None].rstrip())
            fix = Fix("close it", (Edit(Span(end, end), " */"),))
            return LineMistake(unexpected(token)._replace(fix=fix), at)
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
    explained = completed if at == len(tokens) else recognised
    return LineMistake(explained(place, found), at, words, slots.get(at))


def _misspelt(tokens: Sequence[Token]) -> tuple[Token, str] | None:
    """Return the token that a keyword was to be, and the keyword."""
    first = tokens[0]
    if first.kind not in WORD_KINDS:
        return None
    name = None if _beginning_with(first.text) else nearest_keyword(first.text, FIRST_WORDS)
    if name is not None:
        return first, name
    if len(tokens) < 2 or tokens[1].kind not in WORD_KINDS:
        return None
    name = nearest_verb(tokens[1].text)
    return None if name is None else (tokens[1], name)


def undecided(tokens: Sequence[Token]) -> Undecided | None:
    """Return which statements a line may be, where what its variable stands for decides."""
    words = _beginning_with(tokens[0].text)
    if len(tokens) != 2 or len(words) < 2 or tokens[1].kind not in WORD_KINDS:
        return None
    return Undecided(tokens[0].span, words, tokens[1].text)


def _beginning_with(word: str) -> tuple[str, ...]:
    """Return the words that start a statement and go on, where it ends, with what is made."""
    return tuple(each for each in FIRST_WORDS if each.startswith(f"{word}_"))


def guessed(tokens: Sequence[Token]) -> Declaration | None:
    """Return the statement whose keyword a word of a line looks like."""
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
