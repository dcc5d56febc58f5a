"""What may be changed at the first mistake of a line, so that it becomes a statement.

These are only trials: which of them is right, if any, the grammar tells (`line_repair.py`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from enum import IntEnum
from itertools import pairwise
from typing import Literal, NamedTuple

from .declaration import Declaration, Element, Form
from .keywords import FIRST_WORDS, VERBS, WORDS
from .line_mistakes import LineMistake
from .open_values import NAME_MARKS
from .repair_words import DIRECTIONS, FILLERS, NOUNS, QOS_WORDS, is_like, is_written_for
from .sentence_match import intended
from .tokens import QUOTED_KINDS, WORD_KINDS, Token, is_glued, text_at, token_at
from .undoing import nearest_keyword


class Likelihood(IntEnum):
    """How much speaks for a change, the most first."""

    PLAIN = 0
    POSSIBLE = 1


class Step(NamedTuple):
    """Tokens that are replaced by words.

    Attributes:
        first: the first token that is replaced.
        end: the token behind the last one; `first`, where only words are put in.
        text: what is written there, "" where the tokens are only taken away.
        likelihood: how much speaks for it.
        joins: on which sides of the text there is no space: "", "before" or "both".
    """

    first: int
    end: int
    text: str
    likelihood: Likelihood = Likelihood.POSSIBLE
    joins: Literal["", "before", "both"] = ""


_LISTS = frozenset({Form.VALUES, Form.QOS, Form.FIELDS, Form.REMAPS, Form.SETTINGS, Form.VECTOR})
_LEAST_WORDS = 5
"""A line of fewer words says too little for a whole word of it to be guessed that is not there."""

MARKS = frozenset({"=", ":", "&", ";"})
"""Signs that are written in the place of words and commas; no operators, which values have."""

_EQUALS = frozenset({":", "is", "equals", "equal"})
_COMMAS = frozenset({"and", ";", "&"})
SIGNS = frozenset({"+", "-", "*", "/", "<", ">"})


def steps(tokens: Sequence[Token], mistake: LineMistake) -> Iterator[Step]:
    """Yield what may be changed at the first mistake of a line, each change once."""
    declaration = intended(tokens)
    found = _of_unknown(tokens) if declaration is None else _of_known(tokens, mistake, declaration)
    yield from dict.fromkeys(found)


def _of_unknown(tokens: Sequence[Token]) -> Iterator[Step]:
    """Yield words that a statement begins with, for one that is written, or that is not there."""
    begun, second = tokens[0].text, text_at(tokens, 1)
    first_words = [word for word in FIRST_WORDS if word.startswith(f"{begun}_")] or FIRST_WORDS
    for at, words in ((0, first_words), (1, VERBS)):
        text = text_at(tokens, at)
        is_word = at < len(tokens) and tokens[at].kind in WORD_KINDS
        for word in words:
            if is_word and is_like(text, word):
                yield Step(at, at + 1, word, Likelihood.PLAIN)
            if len(tokens) >= _LEAST_WORDS:
                yield Step(at, at, word)
    # What comes first is second, or what comes second is first.
    for word in FIRST_WORDS:
        if is_like(second, word):
            yield Step(0, 2, f"{word} {begun}", Likelihood.PLAIN)
    for word in VERBS:
        if is_like(begun, word) and second:
            yield Step(0, 2, f"{second} {word}", Likelihood.PLAIN)


def _of_known(
    tokens: Sequence[Token], mistake: LineMistake, declaration: Declaration
) -> Iterator[Step]:
    at = mistake.at
    yield from _marks(tokens, at, declaration)
    flags = {each.keyword for each in declaration.clauses if not isinstance(each.elements[0], str)}
    words = [word for word in mistake.words if word not in flags]
    phrases = dict.fromkeys(_phrases(declaration, words))
    for phrase in phrases:
        yield Step(at, at, phrase)
    yield from _taken_away(tokens, at, _words(declaration))
    others = dict.fromkeys((*phrases, *_phrases(declaration, _beginnings(declaration))))
    for first in (at - 1, at):
        for end in (first + 1, first + 2):
            written = " ".join(token.text for token in tokens[first:end])
            if first < 1 or end > min(at + 1, len(tokens)):
                continue
            for phrase in others:
                if written != phrase and _is_for(tokens[first:end], phrase, declaration.keyword):
                    yield Step(first, end, phrase)
    if at < len(tokens) and tokens[at].kind in WORD_KINDS:
        expected = [*mistake.words, *_beginnings(declaration)]
        near = nearest_keyword(tokens[at].text, expected)
        for word in expected:
            if word == near or is_like(tokens[at].text, word):
                yield Step(at, at + 1, word)
        if mistake.wanted is not None and mistake.wanted.form is Form.TEXT:
            yield Step(at, len(tokens), f'"{_written(tokens[at:])}"')
    yield from _swapped(tokens, at)
    if declaration.keyword != "renames":
        yield from _moved(tokens, at, mistake.words)


def _is_for(written: Sequence[Token], phrase: str, keyword: str) -> bool:
    """Tell whether one or two tokens are surely written for words of a sentence."""
    first, *rest = (token.text for token in written)
    if not is_written_for(first, phrase, keyword):
        return False
    return not rest or rest[0] in ("=", ":", *phrase.split(" "))


def _phrases(declaration: Declaration, words: Iterable[str]) -> Iterator[str]:
    """Yield words of a sentence, each with those that always follow it as well."""
    sequences = (declaration.elements, *(each.elements for each in declaration.clauses))
    for word in words:
        yield word
        for elements in sequences:
            for at in range(len(elements)):
                if elements[at] == word:
                    yield " ".join(_words_from(elements, at))


def _words(declaration: Declaration) -> list[str]:
    """Return the words of a sentence."""
    sequences = (declaration.elements, *(each.elements for each in declaration.clauses))
    return [each for elements in sequences for each in elements if isinstance(each, str)]


def _words_from(elements: Sequence[Element], first: int) -> Iterator[str]:
    for element in elements[first:]:
        if not isinstance(element, str):
            return
        yield element


def _beginnings(declaration: Declaration) -> list[str]:
    """Return the words that clauses begin with; what is one word alone, nobody means by another."""
    return [each.keyword for each in declaration.clauses if isinstance(each.elements[0], str)]


def _taken_away(tokens: Sequence[Token], at: int, words: Sequence[str]) -> Iterator[Step]:
    """Yield what says nothing, and what is said twice."""
    for first in (at - 1, at):
        text, after = text_at(tokens, first), token_at(tokens, first + 1)
        if after is None or first < 0 or tokens[first].kind not in WORD_KINDS | MARKS:
            continue
        if "." in (after.text, text_at(tokens, first - 1)):
            continue
        before = text_at(tokens, first - 1)
        if (
            text == after.text
            or text in FILLERS
            or (text in NOUNS and after.kind in QUOTED_KINDS)
            or (text == "rate" and after.kind == "number")
        ):
            yield Step(first, first + 1, "", Likelihood.PLAIN)
        elif (text == "and" and after.text in words) or (
            text in MARKS and (before in WORDS or before in QOS_WORDS)
        ):
            yield Step(first, first + 1, "")


def _marks(tokens: Sequence[Token], at: int, declaration: Declaration) -> Iterator[Step]:
    """Yield commas that are missing between values, and `=` for other words and marks."""
    if all(slot.kind.form not in _LISTS for slot in declaration.slots):
        return
    is_calculated = any(token.text in SIGNS for token in tokens)
    if text_at(tokens, at) in _COMMAS and not is_calculated:
        yield Step(at, at + 1, ",", joins="before")
    if 0 < at < len(tokens) and not is_calculated and _are_values(tokens, at):
        yield Step(at, at, ",", joins="before")
    for place in (at, at + 1):
        text = text_at(tokens, place)
        if text in _EQUALS and place + 1 < len(tokens):
            yield Step(place, place + 1, "=", joins="both" if text == ":" else "")


def _are_values(tokens: Sequence[Token], at: int) -> bool:
    """Tell whether two values, or words of a list, stand beside one another."""
    before = [token.text for token in tokens[:at]]
    is_named = "=" in before and text_at(tokens, at + 1) not in NAME_MARKS
    is_field = text_at(tokens, at + 1) == "." and all(each.text != "=" for each in tokens[at:])
    # What is written as `5-3` is calculated.
    return not (is_named or is_field or is_glued(tokens, at)) and all(
        token.text not in MARKS | {"."}
        and (token.text not in WORDS or token.text in ("True", "False"))
        for token in tokens[at - 1 : at + 1]
    )


def _swapped(tokens: Sequence[Token], at: int) -> Iterator[Step]:
    for first in (at - 1, at):
        if not 0 < first < len(tokens) - 1:
            continue
        pair = tokens[first : first + 2]
        is_turned = any(token.text in DIRECTIONS for token in pair)
        if not is_turned and any(token.text in WORDS for token in pair):
            yield Step(first, first + 2, f"{pair[1].text} {pair[0].text}")


def _moved(tokens: Sequence[Token], at: int, words: Iterable[str]) -> Iterator[Step]:
    """Yield a part of the sentence that stands later than it should, put before the mistake."""
    for word in words:
        first = next((i for i in range(at + 1, len(tokens)) if tokens[i].text == word), None)
        if first is None:
            continue
        end = first + 1
        while end < len(tokens) and tokens[end].text in WORDS:
            end += 1
        end += 1
        while end < len(tokens) and tokens[end].text not in WORDS:
            end += 1
        later, between = tokens[first:end], tokens[at:first]
        yield Step(at, min(end, len(tokens)), f"{_written(later)} {_written(between)}")


def _written(tokens: Sequence[Token]) -> str:
    """Return tokens in one line, with spaces where they had some."""
    parts = [tokens[0].text]
    for before, token in pairwise(tokens):
        parts.append(token.text if before.end == token.start else f" {token.text}")
    return "".join(parts)
