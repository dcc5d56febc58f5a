"""The words of a line, matched against the sentence of the statement that they are to be.

What is wrong with a line, and what may stand at a place of it, both follow from the match.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import takewhile
from typing import NamedTuple

from .declaration import Clause, Declaration, Element, Form, Slot, SlotKind
from .keywords import BY_KEYWORD, FIRST_WORDS, VERBS
from .open_values import NAME_MARKS
from .tokens import QUOTED_KINDS, WORD_KINDS, Token, is_glued, text_at

# Looking a member up in its class costs as much as to match a word.
_VARIABLE, _TYPE, _FILE = Form.VARIABLE, Form.TYPE, Form.FILE
_RATE, _VECTOR = Form.RATE, Form.VECTOR
_UNITS = frozenset({SlotKind.ANGLE_UNIT, SlotKind.LIMIT_UNIT})
_OPENING, _CLOSING = ("(", "["), (")", "]")
_WITHIN_VECTOR = frozenset({",", "="})
_VECTOR_LENGTH = 5
BEHIND_NUMBERS = WORD_KINDS | QUOTED_KINDS | {"string"}
"""The kinds of tokens that three numbers end before."""


class SlotMatch(NamedTuple):
    """A slot, and the half-open range of the tokens in its place, whether they fit or not.

    The range is empty where the slot is left out.
    """

    slot: Slot
    first: int
    end: int


class SentenceMatch(NamedTuple):
    """How far a line follows a sentence.

    Attributes:
        slots: the slots that are passed.
        end: how many tokens are matched.
        wanted: the part of the sentence that is to come next, None after the last one. Where its
            form is open, all tokens from `end` on are in its place.
        optional: the clauses that may come before it, or after what is open.
        passed: the words of clauses that cannot come any more.
        ending: the word that has to come after what is open, "" where nothing has to.
        instead: words of other clauses that may stand in the place of the wanted one.
    """

    slots: tuple[SlotMatch, ...]
    end: int
    wanted: str | Slot | None
    optional: tuple[Clause, ...]
    passed: frozenset[str] = frozenset()
    ending: str = ""
    instead: tuple[str, ...] = ()

    @property
    def following(self) -> tuple[str, ...]:
        """The words that may come next, or after what is open."""
        keywords = tuple(dict.fromkeys(clause.keyword for clause in self.optional))
        return (*keywords, self.ending) if self.ending else keywords


def intended(tokens: Sequence[Token]) -> Declaration | None:
    """Return the statement whose keyword stands where it belongs, or at least at the start."""
    first, second = [*(token.text for token in tokens[:2]), "", ""][:2]
    if first not in FIRST_WORDS and second in VERBS:
        return BY_KEYWORD[second]
    return BY_KEYWORD.get(first)


def match_sentence(declaration: Declaration, tokens: Sequence[Token]) -> SentenceMatch:
    """Match tokens up to a word that is not the sentence's, to what is open, or to their end.

    A slot takes what stands in its place, also what does not fit: the rest may be right.
    """
    matcher = _Matcher(tokens)
    matcher.sequence(declaration.elements, ())
    return matcher.result()


class _Matcher:
    def __init__(self, tokens: Sequence[Token]) -> None:
        self._tokens = tokens
        self._at = 0
        self._slots: list[SlotMatch] = []
        self._wanted: str | Slot | None = None
        self._optional: dict[Sequence[Element], Clause] = {}
        self._passed: set[str] = set()
        self._ending = ""
        self._instead: tuple[str, ...] = ()

    def result(self) -> SentenceMatch:
        optional = tuple(self._optional.values())
        passed = frozenset(self._passed.difference(each.keyword for each in optional))
        return SentenceMatch(
            tuple(self._slots),
            self._at,
            self._wanted,
            optional,
            passed,
            self._ending,
            self._instead,
        )

    def sequence(self, elements: Sequence[Element], outer: Sequence[Clause]) -> bool:
        """Match elements, which clauses may follow; tell whether to go on behind them."""
        at = 0
        while at < len(elements):
            element = elements[at]
            at += not isinstance(element, Clause)
            clauses = [*takewhile(lambda each: isinstance(each, Clause), elements[at:])]
            after = elements[at + len(clauses) :][:1]
            left = [each for each in clauses if isinstance(each, Clause)]
            left += () if after else outer
            if isinstance(element, Clause):
                at += len(clauses)
                if not self._clauses(left, len(clauses)):
                    return False
            elif not self._part(element, left, elements[at] if at < len(elements) else None):
                return False
            elif _is_name_or_none(element) and text_at(self._tokens, self._at - 1) == "none":
                at += len(clauses)  # nothing is said of none
        return True

    def _clauses(self, left: list[Clause], own: int) -> bool:
        """Match the first ones of some clauses, in any order; the others are for who called."""
        mine = left[:own]
        outer = left[own:]
        used: set[Sequence[Element]] = set()
        while True:
            self._may_follow((*mine, *outer))
            first, second = (text_at(self._tokens, self._at + offset) for offset in (0, 1))
            fitting = [each for each in mine if each.keyword == first]
            # Two clauses may begin with the same word: the second one tells them apart.
            exact = [each for each in fitting if each.elements[1:2] == (second,)]
            if not exact and (first, second) in used:
                self._optional = {
                    start: each for start, each in self._optional.items() if each.keyword != first
                }
                return True
            if not fitting:
                return True
            clause, *others = exact or fitting
            used.add(clause.elements[:2])
            self._passed.update(each.keyword for each in mine if each.bracket == clause.bracket)
            mine = [each for each in mine if each.bracket != clause.bracket]
            after = self._at + 1
            if not self.sequence(clause.elements, (*mine, *outer)):
                if self._at == after:
                    seconds = [each.elements[1] for each in others]
                    self._instead = tuple(word for word in seconds if isinstance(word, str))
                return False

    def _may_follow(self, clauses: Iterable[Clause]) -> None:
        self._optional.update((each.elements[:2], each) for each in clauses)

    def _part(self, part: str | Slot, left: Sequence[Clause], after: Element | None) -> bool:
        """Match a word, or what is in a slot; tell whether it was there, and is over."""
        text = text_at(self._tokens, self._at)
        end: int | None = None
        if isinstance(part, str):
            end = self._at + 1 if text == part else None
        elif text and part.kind.form is _VECTOR:
            end = self._end_of_vector({each.keyword for each in left})
        elif part.kind in _UNITS and any(each.keyword == text for each in left):
            end = None  # it is left out, and the next clause begins
        elif text and part.kind.form.is_open:
            words = {each.keyword for each in left}
            end = self._end_of_open(part, {*words, after} if isinstance(after, str) else words)
        elif text:
            end = self._end_of_slot(part, after)
        if end is None:
            self._wanted = part
            if isinstance(part, Slot) and part.kind.form.is_open and text:
                self._may_follow(left)
                self._ending = after if isinstance(after, str) else ""
            return False
        if isinstance(part, Slot):
            self._slots.append(SlotMatch(part, self._at, end))
        if end > self._at:
            self._optional.clear()
        self._at = end
        return True

    def _end_of_open(self, slot: Slot, words: set[str]) -> int | None:
        """Return where one of the words that may follow stands, None where none does."""
        tokens, first = self._tokens, self._at
        if slot.kind.may_be_none and _is_none(tokens, first):
            return first + 1
        depth = 0
        for at in range(first, len(tokens)):
            text = tokens[at].text
            is_name = text_at(tokens, at + 1) in NAME_MARKS or text_at(tokens, at - 1) == "."
            if depth == 0 and text in words and not is_name:
                return at
            depth += (text in _OPENING) - (text in _CLOSING)
        return None

    def _end_of_vector(self, words: set[str]) -> int | None:
        """Return where numbers end, None where the line ends before there are three."""
        tokens, first = self._tokens, self._at
        end = next((at for at in range(first, len(tokens)) if self._ends(at, words)), len(tokens))
        is_over = end < len(tokens) or is_vector(tokens[first : first + _VECTOR_LENGTH])
        return end if is_over else None

    def _ends(self, at: int, words: set[str]) -> bool:
        """Tell whether a token is behind a vector: a word in the place of none of its numbers."""
        tokens = self._tokens
        if tokens[at].kind not in BEHIND_NUMBERS or at == self._at:
            return tokens[at].text in words
        around = {text_at(tokens, at - 1), text_at(tokens, at + 1)}
        return tokens[at].text in words or around.isdisjoint(_WITHIN_VECTOR)

    def _end_of_slot(self, slot: Slot, after: Element | None) -> int:
        """Return where what is in the place of a slot ends."""
        tokens, at, form = self._tokens, self._at, slot.kind.form
        text = tokens[at].text
        end = at + 1
        # In `of of` the first one is a keyword that somebody wants for a variable.
        if form is _VARIABLE and text == after != text_at(tokens, end):
            return at
        if form is _TYPE:
            while text_at(tokens, end) == "/" and is_glued(tokens, end):
                end += 1
                if not is_glued(tokens, end) or tokens[end].kind not in WORD_KINDS:
                    break
                end += 1
        elif form is _FILE and tokens[at].kind not in QUOTED_KINDS:
            while is_glued(tokens, end):
                end += 1
        elif form is _RATE and text == "parameter" and text_at(tokens, end) != "hz":
            end += end < len(tokens)
        return end


def _is_name_or_none(element: Element) -> bool:
    if not isinstance(element, Slot):
        return False
    return element.kind.may_be_none and not element.kind.form.is_open


def _is_none(tokens: Sequence[Token], at: int) -> bool:
    return tokens[at].text == "none" and text_at(tokens, at + 1) not in NAME_MARKS


def is_vector(tokens: Sequence[Token]) -> bool:
    """Tell whether tokens are three numbers with commas between them."""
    numbers, commas = tokens[::2], tokens[1::2]
    is_right = all(token.kind == "number" for token in numbers)
    return len(tokens) == _VECTOR_LENGTH and is_right and all(each.text == "," for each in commas)
