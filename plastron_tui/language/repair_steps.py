"""What may be changed at the first mistake of a line, so that it becomes a statement.

These are only trials: which of them is right, if any, the grammar tells (`line_repair.py`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from enum import IntEnum
from itertools import pairwise
from typing import Literal, NamedTuple

from plastron_tui.diagnostics.suggest import nearest

from .declaration import Declaration, Element, Form
from .keywords import FIRST_WORDS, VERBS, WORDS
from .line_mistakes import LineMistake
from .open_values import NAME_MARKS
from .sentence_match import intended
from .tokens import WORD_KINDS, Token, text_at


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

_LEAST_STEM = 2

_SYNONYMS = {
    "subscribe": ("listen", "listens", "receive", "receives", "hear", "hears", "subscriber"),
    "unsubscribe": ("unlisten",),
    "publish": ("send", "sends", "emit", "emits", "publisher", "write", "writes", "post"),
    "client_requests": ("call", "calls", "ask", "asks", "client", "query", "queries"),
    "provides_service": ("serve", "serves", "offer", "offers", "answer", "answers", "server"),
    "repeats": ("call", "calls", "runs", "run", "timer", "every", "does", "loop", "loops"),
    "load": ("import", "open", "read", "include", "use"),
    "has_parameter": ("param", "parameters"),
    "renames": ("remap", "remaps"),
    "described_as": ("description", "describes", "describe", "described", "documented_as"),
    "calling": ("callback", "handler", "with"),
    "using": ("library",),
}
"""What others write for words of the language."""

_SAYING_NOTHING = frozenset({"ha", "has", "no", "to", "stop"})
"""Parts of words, as `_stem` leaves them, that do not tell one word from another."""

_FILLERS = frozenset(
    {"a", "an", "the", "topic", "node", "named", "called", "message", "service", "action", "type"}
    | {"parameter", "rate", "function", "callback", "library", "variable", "name", "value"}
)
"""Words that say what follows, and that a sentence has no place for."""

MARKS = frozenset({"=", ":", "-", ">", "<", "&", "|", ";", "+"})
"""Signs that are written in the place of words and commas."""

_LOOSE = (
    MARKS
    | _FILLERS
    | frozenset(
        {"is", "in", "on", "for", "by", "into", "onto", "over", "via", "per", "if"}
        | {"where", "while", "then", "so", "has", "have", "values", "data", "use", "uses", "using"}
        | {"respond", "reply", "returns", "return", "gives", "run", "runs", "calls", "call", "do"}
        | {"initially", "starting", "initial", "times", "hertz", "second", "into", "until", "when"}
    )
)
"""What is written in the place of a word of a sentence, by who does not remember it."""

_EQUALS = frozenset({":", "is", "equals", "equal", "to"})
_COMMAS = frozenset({"and", ";", "&", "|", "+"})


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
            elif is_word and len(tokens) >= _LEAST_WORDS:
                yield Step(at, at + 1, word)
            if len(tokens) >= _LEAST_WORDS:
                yield Step(at, at, word)
    # What comes first is second, or what comes second is first.
    for word in FIRST_WORDS:
        if is_like(second, word):
            yield Step(0, 2, f"{word} {begun}", Likelihood.PLAIN)
    for word in VERBS:
        if is_like(begun, word) and second:
            yield Step(0, 2, f"{second} {word}", Likelihood.PLAIN)


def is_like(text: str, word: str) -> bool:
    """Tell whether a word may stand for one of the language: a synonym, or a part of it."""
    text = text.lower()
    if text in _SYNONYMS.get(word, ()):
        return True
    parts = {_stem(part) for part in word.split("_")} - _SAYING_NOTHING
    return any(_stem(part) in parts for part in text.split("_"))


def _stem(word: str) -> str:
    """Return a word without the ending that it has in `publishes` and `listening`."""
    for ending in ("ing", "s", "e"):
        if word.endswith(ending) and len(word) > len(ending) + _LEAST_STEM:
            word = word.removesuffix(ending)
    return word


def _of_known(
    tokens: Sequence[Token], mistake: LineMistake, declaration: Declaration
) -> Iterator[Step]:
    at = mistake.at
    yield from _marks(tokens, at, declaration)
    flags = {each.keyword for each in declaration.clauses if not isinstance(each.elements[0], str)}
    words = [word for word in mistake.words if word not in flags]
    phrases = dict.fromkeys(_phrases(declaration, words))
    for phrase in phrases:
        # Any words can be words of quality of service.
        if phrase != "with qos":
            yield Step(at, at, phrase)
    yield from _taken_away(tokens, at)
    behind = [each for each in (at - 1, at) if _is_loose(tokens, each)]
    others = dict.fromkeys((*phrases, *_phrases(declaration, _beginnings(declaration))))
    for first in behind:
        for end in (first + 1, first + 2):
            if end <= max(at + 1, first + 1) and all(
                _is_loose(tokens, i) for i in range(first, end)
            ):
                for phrase in others:
                    yield Step(first, end, phrase)
    if at < len(tokens) and tokens[at].kind in WORD_KINDS:
        expected = [*mistake.words, *_beginnings(declaration)]
        near = nearest(tokens[at].text, expected)
        for word in expected:
            if word == near or is_like(tokens[at].text, word):
                yield Step(at, at + 1, word)
        if mistake.wanted is not None and mistake.wanted.form is Form.TEXT:
            yield Step(at, len(tokens), f'"{_written(tokens[at:])}"')
    yield from _swapped(tokens, at)
    yield from _moved(tokens, at, mistake.words)


def _phrases(declaration: Declaration, words: Iterable[str]) -> Iterator[str]:
    """Yield words of a sentence, each with those that always follow it as well."""
    sequences = (declaration.elements, *(each.elements for each in declaration.clauses))
    for word in words:
        yield word
        for elements in sequences:
            for at in range(len(elements)):
                if elements[at] == word:
                    yield " ".join(_words_from(elements, at))


def _words_from(elements: Sequence[Element], first: int) -> Iterator[str]:
    for element in elements[first:]:
        if not isinstance(element, str):
            return
        yield element


def _beginnings(declaration: Declaration) -> list[str]:
    """Return the words that clauses begin with; what is one word alone, nobody means by another."""
    return [each.keyword for each in declaration.clauses if isinstance(each.elements[0], str)]


def _is_loose(tokens: Sequence[Token], at: int) -> bool:
    text = text_at(tokens, at)
    return 0 < at < len(tokens) and (text.lower() in _LOOSE or text in WORDS)


def _taken_away(tokens: Sequence[Token], at: int) -> Iterator[Step]:
    """Yield what a sentence has no place for, or has once."""
    for first in (at - 1, at):
        text = text_at(tokens, first)
        if text and text == text_at(tokens, first + 1):
            yield Step(first, first + 1, "", Likelihood.PLAIN)
        if text in _FILLERS:
            yield Step(first, first + 1, "", Likelihood.PLAIN)
    if _is_loose(tokens, at):
        yield Step(at, at + 1, "")


def _marks(tokens: Sequence[Token], at: int, declaration: Declaration) -> Iterator[Step]:
    """Yield commas that are missing between values, and `=` for other words and marks."""
    if all(slot.kind.form not in _LISTS for slot in declaration.slots):
        return
    if text_at(tokens, at) in _COMMAS:
        yield Step(at, at + 1, ",", joins="before")
    if 0 < at < len(tokens) and not _is_unnamed_behind_named(tokens, at):
        yield Step(at, at, ",", joins="before")
    for place in (at, at + 1):
        text = text_at(tokens, place)
        if text in _EQUALS and place + 1 < len(tokens):
            yield Step(place, place + 1, "=", joins="both" if text == ":" else "")


def _is_unnamed_behind_named(tokens: Sequence[Token], at: int) -> bool:
    """Tell whether a value without a name would follow one that has a name, which cannot be."""
    before = [token.text for token in tokens[:at]]
    return "=" in before and text_at(tokens, at + 1) not in NAME_MARKS


def _swapped(tokens: Sequence[Token], at: int) -> Iterator[Step]:
    for first in (at - 1, at):
        if 0 < first < len(tokens) - 1:
            yield Step(first, first + 2, f"{tokens[first + 1].text} {tokens[first].text}")


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
