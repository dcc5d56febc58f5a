"""What may stand at a place of a program, from the declarations: for completion and for help.

It works on lines that are only half there: the tokens of the line before the place are held
against the sentence that they begin.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from tree_sitter import Node

from plastron_tui.diagnostics import Span

from .declaration import Declaration, Element, Form, Slot
from .document import Document
from .keywords import BY_KEYWORD, FIRST_WORDS, VERBS
from .list_errors import first_unfit
from .open_values import ARITHMETIC, OpenValues
from .sentence_match import SentenceMatch, intended, match_sentence
from .tokens import COMMENT_KINDS, UNCLOSED_STRING, UNKNOWN, Token, tokens_of

_COMMENTS = COMMENT_KINDS | {"unclosed_comment"}
_JOINTS = frozenset({"/", "."})
_COMPARING = frozenset({"=", "<", ">"})


@dataclass(frozen=True, slots=True)
class ValuePlace:
    """A place within values.

    Attributes:
        path: the way from the whole input to the values around the place, by the fields' names,
            dotted as they are written, or by their positions.
        index: how many values stand before it, in these values.
        name: the field that the value at the place is for, None where no name is written.
        used: the names that these values have so far.
        is_list: whether the values around it are a list's.
        is_text: whether the place is within a string.
    """

    path: tuple[str | int, ...] = ()
    index: int = 0
    name: str | None = None
    used: frozenset[str] = frozenset()
    is_list: bool = False
    is_text: bool = False


@dataclass(frozen=True, slots=True)
class Expectation:
    """What may stand at a place.

    Attributes:
        span: the word around the place, which is empty between words; quotes belong to it.
        prefix: the part of the word before the place.
        keywords: the words of the language that may stand there.
        slot: the slot that may be filled there, None where only keywords can stand.
        declaration: the statement of the line, None as long as it could be several.
        element: the part of its sentence that the place belongs to.
        filled: the text of the slots before the place, by their names.
        values: where among the values the place is, for the slot of an input.
        starts_line: whether a statement begins there.
        written: what stands before the place, word by word, in the slot that may be filled.
    """

    span: Span
    prefix: str = ""
    keywords: tuple[str, ...] = ()
    slot: Slot | None = None
    declaration: Declaration | None = None
    element: Element | None = None
    filled: Mapping[str, str] = field(default_factory=dict)
    values: ValuePlace | None = None
    starts_line: bool = False
    written: tuple[str, ...] = ()


NODE_OF_STATEMENT = next(
    element
    for declaration in BY_KEYWORD.values()
    for element in declaration.elements[:1]
    if isinstance(element, Slot)
)
"""The slot that a line begins with when no keyword does."""

_NO_MATCH = SentenceMatch((), 0, None, ())


def expected_at(document: Document, offset: int) -> Expectation:
    """Return what may stand at an offset of a program.

    Within a comment, and after a mistake, nothing is expected.
    """
    text = document.text
    offset = min(max(offset, 0), len(text))
    excerpt = document.excerpt(offset, offset)
    here = offset - excerpt.start
    root = excerpt.tree.root_node
    nothing = Expectation(Span(offset, offset))
    if _is_in_comment(root.descendant_for_byte_range(max(0, here - 1), here), here):
        return nothing
    tokens = _line_of(tokens_of(excerpt.text, root.children), excerpt.text, here)
    word = next((token for token in tokens if _touches(token, here)), None)
    before = [token for token in tokens if token.end <= here and token is not word]
    span = nothing.span
    prefix = ""
    if word is not None:
        span = Span(word.start + excerpt.start, word.end + excerpt.start)
        prefix = excerpt.text[word.start : here].decode("utf-8", "replace")
    return _expected(span, prefix, intended(tokens), before, word) or nothing


def _is_in_comment(node: Node | None, here: int) -> bool:
    if node is None or node.type not in _COMMENTS:
        return False
    return node.start_byte < here and (here < node.end_byte or node.type != "block_comment")


def _touches(token: Token, here: int) -> bool:
    """Tell whether the word of a token is still being written at a place."""
    if not token.start < here <= token.end:
        return False
    if here < token.end:
        return True
    if token.kind in (UNKNOWN, UNCLOSED_STRING):
        return token.text[0] in "'\"" or token.text[0].isalnum()
    last = token.text[-1]
    return last.isalnum() or last in "_/." or ord(last) >= 0x80


def _line_of(tokens: Iterable[Token], text: bytes, here: int) -> list[Token]:
    """Return the tokens of the line at a place, what is written without space as one."""
    start = text.rfind(b"\n", 0, here) + 1
    end = text.find(b"\n", here)
    end = len(text) if end < 0 else end
    found = list(tokens)
    rows = {token.row for token in found if start <= token.start <= end}
    joined: list[Token] = []
    for token in found:
        if token.row not in rows:
            continue
        if joined and joined[-1].end == token.start and _belong_together(joined[-1], token):
            last = joined.pop()
            token = last._replace(text=last.text + token.text, end=token.end)
        joined.append(token)
    return joined


def _belong_together(last: Token, token: Token) -> bool:
    if last.text[0] in "'\"" or last.text[0].isdigit():
        return False
    if token.text in _JOINTS:
        return last.text[-1].isalnum() or last.text[-1] == "_"
    starts_word = token.text[0].isalpha() or token.text[0] == "_"
    return last.text[-1] in _JOINTS and len(last.text) > 1 and starts_word


def _expected(
    span: Span,
    prefix: str,
    declaration: Declaration | None,
    before: Sequence[Token],
    word: Token | None,
) -> Expectation | None:
    """Return what may stand at a place after tokens of its line, None after a mistake."""
    match = _NO_MATCH if declaration is None else match_sentence(declaration, before)
    slot = match.wanted if isinstance(match.wanted, Slot) else None
    keywords = match.following
    written = tuple([token.text for token in before[match.end :]])
    values = None
    if not before:
        slot, keywords = NODE_OF_STATEMENT, FIRST_WORDS
    elif len(before) == 1 and before[0].text not in BY_KEYWORD:
        keywords = VERBS
    elif slot is not None and slot.kind.form in (Form.VALUE, Form.VALUES):
        values, is_over = _place_in_values(before[match.end :], word)
        is_first = len(before) == match.end and slot.kind.may_be_none
        keywords = keywords if is_over else ("none",) if is_first and not values.is_text else ()
    elif slot is not None and slot.kind.form is Form.FIELDS and not written:
        keywords = ("none",)
    elif slot is not None and slot.kind.form.is_open and written:
        keywords = keywords if _is_over(slot.kind.form, before[match.end :]) else ()
    elif written:
        return None
    elif _wants_parameter(match, before):
        slot, keywords, written = match.slots[-1].slot, (), ("parameter",)
        match = match._replace(wanted=slot)
    elif isinstance(match.wanted, str):
        keywords = (*keywords, match.wanted, *match.instead)
    return Expectation(
        span,
        prefix,
        keywords,
        slot,
        declaration,
        match.wanted or next(iter(match.optional), None),
        {
            slot.name: "".join([token.text for token in before[first:end]])
            for slot, first, end in match.slots
            if end > first
        },
        values,
        starts_line=not before,
        written=written,
    )


def _wants_parameter(match: SentenceMatch, before: Sequence[Token]) -> bool:
    """Tell whether a rate is only the word `parameter` so far."""
    if not match.slots or match.slots[-1].slot.kind.form is not Form.RATE:
        return False
    _, first, end = match.slots[-1]
    return end == match.end and [token.text for token in before[first:]] == ["parameter"]


def _is_over(form: Form, tokens: Sequence[Token]) -> bool:
    """Tell whether a condition, or a list of something, may end behind some words."""
    written = [token.text for token in tokens]
    if form is Form.CONDITION:
        return written[-1] not in _COMPARING and not _COMPARING.isdisjoint(written)
    if form is Form.VECTOR:
        return False
    if form in (Form.FIELDS, Form.REMAPS, Form.SETTINGS):
        unfit = first_unfit(form, tokens)
        return unfit is None or unfit.values is not None
    return written[-1] != ","


def _place_in_values(tokens: Sequence[Token], word: Token | None) -> tuple[ValuePlace, bool]:
    """Return where among values a place is, and whether they may be over there."""
    values = OpenValues()
    for token in tokens:
        values.take(token)
    *_, level = values.levels
    place = ValuePlace(
        tuple(level.key for level in values.levels if level.key is not None),
        level.index,
        level.name,
        frozenset(level.used),
        level.is_list,
        is_text=word is not None and word.text.startswith('"'),
    )
    is_broken_off = values.wants_value or (
        values.last is not None and values.last.text in ARITHMETIC
    )
    return place, len(values.levels) == 1 and not is_broken_off and not place.is_text
