"""The words of a line, matched against the sentence of the statement that they are to be.

What is wrong with a line, and what may stand at a place of it, both follow from the match.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from .declaration import Clause, Declaration, Element, Form, Slot
from .keywords import BY_KEYWORD, FIRST_WORDS, VERBS
from .open_values import NAME_MARKS
from .tokens import QUOTED_KINDS, WORD_KINDS, Token, is_glued, text_at

# Looking a member up in its class costs as much as to match a word.
_VARIABLE, _TYPE, _FILE, _VALUES = Form.VARIABLE, Form.TYPE, Form.FILE, Form.VALUES


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
        wanted: the part of the sentence that is to come next, None after the last one. Where it
            is the slot of an input, all tokens from `end` on are its values.
        optional: the clauses that may come before it.
    """

    slots: tuple[SlotMatch, ...]
    end: int
    wanted: str | Slot | None
    optional: tuple[Clause, ...]


def intended(tokens: Sequence[Token]) -> Declaration | None:
    """Return the statement whose keyword stands where it belongs, or at least at the start."""
    first, second = [*(token.text for token in tokens[:2]), "", ""][:2]
    if first not in FIRST_WORDS and second in VERBS:
        return BY_KEYWORD[second]
    return BY_KEYWORD.get(first)


def match_sentence(declaration: Declaration, tokens: Sequence[Token]) -> SentenceMatch:
    """Match tokens up to a word that is not the sentence's, to values, or to their end.

    A slot takes what stands in its place, also what does not fit: the rest may be right.
    """
    slots: list[SlotMatch] = []
    optional: list[Clause] = []
    at = 0
    rest = [*reversed(declaration.elements)]
    while rest:
        element = rest.pop()
        text = tokens[at].text if at < len(tokens) else None
        end: int | None = None
        if isinstance(element, str):
            end = at + 1 if text == element else None
        elif isinstance(element, Clause):
            if text == element.elements[0]:
                rest.extend(reversed(element.elements))
            else:
                optional.append(element)
            continue
        elif text is not None:
            end = _end_of_slot(element, rest[-1] if rest else None, tokens, at)
            if end is not None:
                slots.append(SlotMatch(element, at, end))
        if end is None:
            return SentenceMatch(tuple(slots), at, element, tuple(optional))
        if end > at:
            optional.clear()
        at = end
    return SentenceMatch(tuple(slots), at, None, tuple(optional))


def _end_of_slot(slot: Slot, after: Element | None, tokens: Sequence[Token], at: int) -> int | None:
    """Return where the word ends that is in the place of a slot, None for values."""
    text, form = tokens[at].text, slot.kind.form
    end = at + 1
    if form is _VALUES:
        return end if text == "none" and text_at(tokens, end) not in NAME_MARKS else None
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
    return end
