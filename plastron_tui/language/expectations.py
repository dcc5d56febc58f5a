"""What may stand at a place of a program, from the declarations: for completion and for help.

It works on lines that are only half there: the tokens of the line before the place are held
against the sentence that they begin.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from plastron_tui.diagnostics import Span

from .declaration import Clause, Declaration, Element, Slot, SlotKind
from .document import Document
from .keywords import BY_KEYWORD, FIRST_WORDS, VERBS
from .tokens import COMMENT_KINDS, UNCLOSED_STRING, UNKNOWN, Token, tokens_of

_JOINTS = frozenset({"/", "."})
_OPENING = frozenset({"(", "["})
_CLOSING = frozenset({")", "]"})


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


NODE_OF_STATEMENT = next(
    element
    for declaration in BY_KEYWORD.values()
    for element in declaration.elements[:1]
    if isinstance(element, Slot)
)
"""The slot that a line begins with when no keyword does."""


def expected_at(document: Document, offset: int) -> Expectation:
    """Return what may stand at an offset of a program.

    Within a comment, and after a mistake, nothing is expected.
    """
    text = document.text
    offset = min(max(offset, 0), len(text))
    excerpt = document.excerpt(offset, offset)
    here = offset - excerpt.start
    nothing = Expectation(Span(offset, offset))
    if _is_in_comment(
        excerpt.tree.root_node.descendant_for_byte_range(max(0, here - 1), here), here
    ):
        return nothing
    tokens = _line_of(tokens_of(excerpt.text, excerpt.tree.root_node.children), excerpt.text, here)
    before = [token for token in tokens if token.end <= here and not _touches(token, here)]
    word = next((token for token in tokens if _touches(token, here)), None)
    span = Span(offset, offset)
    prefix = ""
    if word is not None:
        span = Span(word.start + excerpt.start, word.end + excerpt.start)
        prefix = excerpt.text[word.start : here].decode("utf-8", "replace")
    found = _Sentence(tokens, before).expected(Expectation(span, prefix), word)
    return found or nothing


def _is_in_comment(node: object, here: int) -> bool:
    kind, start, end = (getattr(node, name, 0) for name in ("type", "start_byte", "end_byte"))
    if kind not in COMMENT_KINDS and kind != "unclosed_comment":
        return False
    return start < here and (here < end or kind != "block_comment")


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
        last = joined[-1] if joined else None
        if last is not None and last.end == token.start and _belong_together(last, token):
            both = last.text + token.text
            joined[-1] = Token(last.kind, both, last.start, token.end, last.row)
        else:
            joined.append(token)
    return joined


def _belong_together(last: Token, token: Token) -> bool:
    is_word = last.text[-1].isalnum() or last.text[-1] == "_"
    if last.text[0] in "'\"" or last.text[0].isdigit():
        return False
    if token.text in _JOINTS:
        return is_word
    return (
        last.text[-1] in _JOINTS
        and len(last.text) > 1
        and (token.text[0].isalpha() or token.text[0] == "_")
    )


class _Sentence:
    """The tokens of a line before a place, held against the sentence of its statement."""

    def __init__(self, tokens: Sequence[Token], before: Sequence[Token]) -> None:
        self._tokens = tokens
        self._before = before
        self._at = 0
        self._filled: dict[str, str] = {}

    def expected(self, place: Expectation, word: Token | None) -> Expectation | None:
        declaration = self._declaration()
        count = len(self._before)
        if count == 0:
            element = declaration.elements[0] if declaration else None
            return self._with(
                place,
                declaration,
                keywords=FIRST_WORDS,
                slot=NODE_OF_STATEMENT,
                element=element,
                starts_line=True,
            )
        first = self._before[0].text
        if count == 1 and first not in FIRST_WORDS:
            if first in VERBS:
                return None
            element = declaration.elements[1] if declaration else None
            return self._with(place, declaration, keywords=VERBS, element=element)
        if declaration is None:
            return None
        return self._align(declaration, place, word)

    def _declaration(self) -> Declaration | None:
        texts = [token.text for token in self._tokens[:2]]
        if texts and texts[0] in FIRST_WORDS:
            return BY_KEYWORD[texts[0]]
        if len(texts) == 2 and texts[1] in VERBS:
            return BY_KEYWORD[texts[1]]
        return None

    def _with(
        self,
        place: Expectation,
        declaration: Declaration | None,
        *,
        keywords: tuple[str, ...] = (),
        slot: Slot | None = None,
        element: Element | None = None,
        values: ValuePlace | None = None,
        starts_line: bool = False,
    ) -> Expectation:
        return Expectation(
            place.span,
            place.prefix,
            keywords,
            slot,
            declaration,
            element,
            self._filled,
            values,
            starts_line,
        )

    def _align(
        self, declaration: Declaration, place: Expectation, word: Token | None
    ) -> Expectation | None:
        keywords: list[str] = []
        element: Element | None = None
        for part in declaration.elements:
            if isinstance(part, Clause):
                if self._at < len(self._before):
                    if self._before[self._at].text != part.elements[0]:
                        continue
                    for inner in part.elements:
                        if self._at >= len(self._before):
                            return self._open(declaration, place, inner, [], word)
                        if not self._take(inner):
                            return None
                    continue
                keywords.append(str(part.elements[0]))
                element = element or part
                continue
            if self._at >= len(self._before) or _is_input(part):
                return self._open(declaration, place, part, keywords, word)
            if not self._take(part):
                return None
        if self._at < len(self._before):
            return None
        return self._with(place, declaration, keywords=tuple(keywords), element=element)

    def _take(self, part: str | Slot) -> bool:
        token = self._before[self._at]
        self._at += 1
        if isinstance(part, str):
            return token.text == part
        self._filled[part.name] = token.text
        return True

    def _open(
        self,
        declaration: Declaration,
        place: Expectation,
        part: str | Slot,
        keywords: list[str],
        word: Token | None,
    ) -> Expectation:
        """Expect a part of the sentence that is not there yet, or at which the place is."""
        if isinstance(part, str):
            return self._with(place, declaration, keywords=(*keywords, part), element=part)
        if part.kind is not SlotKind.INPUT:
            return self._with(place, declaration, keywords=tuple(keywords), slot=part, element=part)
        written = self._before[self._at :]
        values = _place_in_values(written, word)
        words = ("none",) if not written and not values.is_text else ()
        return self._with(
            place, declaration, keywords=words, slot=part, element=part, values=values
        )


def _is_input(part: Element) -> bool:
    return isinstance(part, Slot) and part.kind is SlotKind.INPUT


@dataclass(slots=True)
class _Around:
    """Values that are open at a place: a list's, a nested message's, or all of an input's."""

    key: str | int | None = None
    is_list: bool = False
    index: int = 0
    name: str | None = None
    used: set[str] = field(default_factory=set)


def _place_in_values(tokens: Sequence[Token], word: Token | None) -> ValuePlace:
    open_values = [_Around()]
    last_word = ""
    for token in tokens:
        around = open_values[-1]
        if token.text in _OPENING and token.kind == token.text:
            key = around.index if around.name is None else around.name
            open_values.append(_Around(key, token.text == "["))
        elif token.text in _CLOSING and token.kind == token.text:
            if len(open_values) > 1:
                open_values.pop()
        elif token.text == "," and token.kind == ",":
            around.index += 1
            around.name = None
        elif token.text == "=" and token.kind == "=":
            around.name = last_word
            around.used.add(last_word)
        last_word = token.text
    around = open_values[-1]
    return ValuePlace(
        tuple(inner.key for inner in open_values[1:] if inner.key is not None),
        around.index,
        around.name,
        frozenset(around.used),
        around.is_list,
        word is not None and word.text.startswith('"'),
    )
