"""Whether a statement that a line may become says surely no other thing than the line does."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import pairwise

from .declaration import Form, Slot, SlotKind
from .keywords import WORDS
from .repair_words import FILLERS, QOS_WORDS, is_like
from .sentence_match import SlotMatch, intended, match_sentence
from .tokens import QUOTED_KINDS, WORD_KINDS, Token, text_at
from .undoing import is_undoing, nearest_keyword

LIBRARIES = frozenset({"rospy", "rclpy", "roscpp", "nodelet", "rclcpp", "component"})
"""The client libraries."""

_OPERATORS = frozenset("+-*/<>%")
_ANY_WORD = frozenset({SlotKind.FUNCTION, SlotKind.COLOR})
"""What any word could be; it is it only where it stood in that place."""


def is_certain(tokens: Sequence[Token], made: Sequence[Token]) -> bool:
    """Tell whether a statement that a line was made leaves its meaning.

    Args:
        tokens: those of the line.
        made: those of the statement.
    """
    before = Counter(token.text for token in tokens)
    after = Counter(token.text for token in made)
    if any(before[each] != after[each] for each in _OPERATORS):
        return False
    return (
        keeps_undoing(tokens, made)
        and not _is_quoted_otherwise(before, after)
        and all(_is_filled(tokens, made, each) for each in _slots(made))
    )


def has_known_words(made: Sequence[Token]) -> bool:
    """Tell whether a statement has only words of quality of service where those stand."""
    return all(
        each.slot.kind.form is not Form.QOS or _is_filled(made, made, each) for each in _slots(made)
    )


def _slots(made: Sequence[Token]) -> tuple[SlotMatch, ...]:
    declaration = intended(made)
    if declaration is None:
        return ()
    match = match_sentence(declaration, made)
    if match.end < len(made) and isinstance(match.wanted, Slot):
        return (*match.slots, SlotMatch(match.wanted, match.end, len(made)))
    return match.slots


def keeps_undoing(tokens: Sequence[Token], made: Sequence[Token]) -> bool:
    """Tell whether a statement takes back as much as the line that it was made of."""
    before, after = (
        Counter(each.text for each in line if each.kind not in _TEXTS and is_undoing(each.text))
        for line in (tokens, made)
    )
    declaration = intended(made)
    undoes = declaration is not None and is_undoing(declaration.keyword)
    if undoes:
        return bool(before)
    return not before - after


_TEXTS = QUOTED_KINDS | {"string"}


def _is_quoted_otherwise(before: Counter[str], after: Counter[str]) -> bool:
    """Tell whether names got quotes and lost them at once, or words of the language got some."""
    gained = {each for each in after - before if each[:1] == "'" and before[each[1:-1]]}
    lost = {each for each in before - after if each[:1] == "'" and after[each[1:-1]]}
    return bool(gained and lost) or any(each[1:-1] in WORDS for each in gained)


def _is_filled(tokens: Sequence[Token], made: Sequence[Token], filled: SlotMatch) -> bool:
    """Tell whether what fills a slot is surely meant for it."""
    kind = filled.slot.kind
    words = [each for each in made[filled.first : filled.end] if each.kind in WORD_KINDS]
    if kind.form is Form.QOS:
        said = [each for each in made[filled.first : filled.end] if each.kind != "number"]
        return bool(said) and all(each.text in QOS_WORDS or each.text == "," for each in said)
    if kind is SlotKind.LIBRARY:
        return all(each.text in LIBRARIES for each in words)
    if kind is SlotKind.FOLLOWED:
        return _was_behind(tokens, made[filled.first].text, text_at(made, filled.first - 1))
    if not words:
        return True
    text, keyword = words[0].text, text_at(made, filled.first - 1)
    if kind.is_variable and (text in WORDS or text in FILLERS):
        return False
    if kind.form is Form.TYPE:
        return (
            text[0].isupper() or filled.end > filled.first + 1 or _was_behind(tokens, text, keyword)
        )
    return kind not in _ANY_WORD or _was_behind(tokens, text, keyword)


def _was_behind(tokens: Sequence[Token], text: str, keyword: str) -> bool:
    """Tell whether a word stood behind a keyword, or behind a slip of it."""
    return any(
        token.text == text
        and (
            before.text == keyword
            or is_like(before.text, keyword)
            or nearest_keyword(before.text, [keyword]) is not None
        )
        for before, token in pairwise(tokens)
    )
