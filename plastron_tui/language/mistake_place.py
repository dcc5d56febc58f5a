"""Where a line's first mistake is, and what stands around it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span, codes, write

from .declaration import Declaration, Form, SlotKind
from .keywords import KEYWORDS
from .tokens import WORD_KINDS, Token, is_glued, text_at

COMPUTED = frozenset({Form.VALUES, Form.VALUE, Form.RATE, Form.CONDITION})
"""The forms in which what is computed can stand."""


class Place(NamedTuple):
    """Where a line's first mistake is.

    Attributes:
        source: the program.
        tokens: those of the line.
        at: the token that the mistake starts at.
        slots: the slots that were looked for, by the first token of each.
        declaration: the statement that the line was to be, if that is known.
    """

    source: bytes
    tokens: Sequence[Token]
    at: int
    slots: Mapping[int, SlotKind]
    declaration: Declaration | None

    @property
    def token(self) -> Token:
        """The token that the mistake starts at."""
        return self.tokens[self.at]

    @property
    def before(self) -> Token | None:
        """The token before that one."""
        return self.tokens[self.at - 1] if self.at else None

    @property
    def wanted(self) -> SlotKind | None:
        """The slot that the token was to fill."""
        return self.slots.get(self.at)

    @property
    def within(self) -> SlotKind | None:
        """The slot that the token is in, or behind."""
        first = max((index for index in self.slots if index <= self.at), default=None)
        return None if first is None else self.slots[first]

    def text(self, at: int) -> str:
        """Return the text of a token, or nothing beyond their ends."""
        return text_at(self.tokens, at)

    def span(self, first: int, end: int) -> Span:
        """Return where a half-open range of tokens stands."""
        return Span(self.tokens[first].start, self.tokens[end - 1].end)

    def written(self, first: int, end: int) -> str:
        """Return a half-open range of tokens as it is written."""
        span = self.span(first, end)
        return self.source[span.start : span.end].decode("utf-8", "replace")

    def is_name(self, index: int) -> bool:
        """Tell whether a token can be a variable."""
        if not 0 <= index < len(self.tokens):
            return False
        token = self.tokens[index]
        return token.kind in WORD_KINDS and token.text not in KEYWORDS

    def run(self, marks: str) -> tuple[int, int]:
        """Return the half-open range of tokens, joined by marks, that look like one word."""
        first, last = self.at, self.at + 1
        while is_glued(self.tokens, first) and self._joins(first - 1, marks):
            first -= 1
        while is_glued(self.tokens, last) and self._joins(last, marks):
            last += 1
        return first, last

    def _joins(self, index: int, marks: str) -> bool:
        token = self.tokens[index]
        return token.kind in WORD_KINDS or token.kind == "number" or not set(token.text) - {*marks}


def mended(found: Diagnostic, message: str, span: Span, text: str) -> Diagnostic:
    """Say what to write in the place of a span."""
    fix = write(text, span)
    code = codes.SYNTAX_ERROR
    return found._replace(code=code, message=message, span=span, help=fix.title, fix=fix)


def unquoted(message: str, span: Span, text: str) -> Diagnostic:
    """Explain a text that is to be in single quotes."""
    fix = Fix("put it in single quotes", (Edit(span, f"'{text}'"),))
    return Diagnostic(codes.SYNTAX_ERROR, message, span, help=f"write '{shown(text)}'", fix=fix)


def shown(text: str) -> str:
    """Return a word of a program as a message shows it."""
    short = text if len(text) <= 40 else text[:37] + "..."
    return short if short.isprintable() else ascii(short)[1:-1]
