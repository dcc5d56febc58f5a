"""A line's tokens held against the sentence that they were to be."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span, codes, escapes, write
from plastron_tui.diagnostics.suggest import nearest

from .declaration import Clause, Declaration, Element, Slot, SlotKind
from .keywords import KEYWORDS
from .tokens import QUOTED_KINDS, UNCLOSED_STRING, UNKNOWN, WORD_KINDS, Token

_CLOSING = {"(": ")", "[": "]"}
_LITERAL_KINDS = frozenset({"number", "string"})
_MOST_TYPE_PARTS = 3
_BOOLEANS = {
    **dict.fromkeys(("true", "on", "yes"), "True"),
    **dict.fromkeys(("false", "off", "no"), "False"),
}


def unexpected(token: Token) -> Diagnostic:
    """Explain a token that stands where no token of its kind can stand."""
    first = token.text[0]
    start = token.start
    if token.kind == UNCLOSED_STRING or (token.kind == UNKNOWN and first in "'\""):
        return Diagnostic(
            codes.UNCLOSED_QUOTE,
            f"the quote is not closed on this line: {first}",
            Span(start, start + 1),
            help=f"close it with {first}",
        )
    if token.kind == UNKNOWN and token.text.startswith("/*"):
        return Diagnostic(
            codes.UNCLOSED_COMMENT,
            "the comment is not closed",
            Span(start, start + 2),
            help="close it with `*/`",
        )
    return Diagnostic(codes.SYNTAX_ERROR, f"unexpected `{_shown(token.text)}`", token.span)


def _shown(text: str) -> str:
    shown = text if len(text) <= 40 else text[:37] + "..."
    return shown if shown.isprintable() else ascii(shown)[1:-1]


class Alignment:
    """Goes through a sentence and a line side by side, up to the first token that does not fit.

    `slots` has the slots that were looked for, by the first token of each.
    """

    def __init__(self, declaration: Declaration, tokens: Sequence[Token]) -> None:
        self._declaration = declaration
        self._tokens = tokens
        self._at = 0
        self.slots: dict[int, SlotKind] = {}

    @property
    def _token(self) -> Token | None:
        return self._tokens[self._at] if self._at < len(self._tokens) else None

    @property
    def _is_glued(self) -> bool:
        """Whether the token at hand follows the one before it without a space."""
        token = self._token
        return token is not None and self._at > 0 and token.start == self._tokens[self._at - 1].end

    def first_mistake(self) -> Diagnostic:
        """Return what is wrong at the first token that does not fit."""
        mistake = self._align(self._declaration.elements)
        if mistake is not None:
            return mistake
        token = self._token
        if token is None:
            return Diagnostic(
                codes.SYNTAX_ERROR,
                "a statement stands on a line of its own",
                Span(self._tokens[0].start, self._tokens[-1].end),
            )
        if token.kind in (UNKNOWN, UNCLOSED_STRING):
            return unexpected(token)
        return self._syntax_error(f"unexpected `{_shown(token.text)}`", token.span)

    def _align(self, elements: Iterable[Element]) -> Diagnostic | None:
        for element in elements:
            match element:
                case Clause(elements=parts):
                    token = self._token
                    mistake = (
                        self._align(parts) if token is not None and token.text == parts[0] else None
                    )
                case Slot(kind=SlotKind.INPUT):
                    mistake = self._fill_input()
                case Slot(kind=kind):
                    mistake = self._fill(kind)
                case word:
                    mistake = self._word(word)
            if mistake is not None:
                return mistake
        return None

    def _word(self, word: str) -> Diagnostic | None:
        token = self._token
        if token is not None and token.text == word:
            self._at += 1
            return None
        if token is not None and token.kind in WORD_KINDS and nearest(token.text, [word]):
            return Diagnostic(
                codes.SYNTAX_ERROR,
                f"expected `{word}`, not `{_shown(token.text)}`",
                token.span,
                help=f"did you mean `{word}`?",
                fix=Fix(f"write `{word}`", (Edit(token.span, word),)),
            )
        return self._expected(f"`{word}`")

    def _fill(self, kind: SlotKind) -> Diagnostic | None:
        token = self._token
        self.slots[self._at] = kind
        if token is None:
            return self._expected(kind.words)
        if self._fits(token, kind):
            self._at += 1
            if kind is SlotKind.FILE:
                return self._end_of_file(token)
            if kind in (SlotKind.MESSAGE_TYPE, SlotKind.SERVICE_TYPE):
                return self._rest_of_type(kind)
            return None
        if kind.is_variable and token.text in KEYWORDS and token.text != self._declaration.keyword:
            return Diagnostic(
                codes.KEYWORD_AS_VARIABLE,
                f"`{token.text}` is a keyword and cannot be a variable",
                token.span,
                help="choose another name",
            )
        is_bare = token.kind in WORD_KINDS and token.text not in KEYWORDS
        if kind.is_quoted and (is_bare or token.kind == "string"):
            bare = token.text.strip('"')
            return Diagnostic(
                codes.SYNTAX_ERROR,
                f"expected {kind.words}",
                token.span,
                help=f"write '{_shown(bare)}'",
                fix=Fix("put it in single quotes", (Edit(token.span, f"'{bare}'"),)),
            )
        return self._expected(kind.words)

    def _fits(self, token: Token, kind: SlotKind) -> bool:
        if kind.is_quoted:
            return token.kind in QUOTED_KINDS
        if kind is SlotKind.RATE:
            return token.kind == "number"
        if kind is SlotKind.FILE and token.kind in QUOTED_KINDS:
            return True
        return token.kind in WORD_KINDS and token.text not in KEYWORDS

    def _end_of_file(self, first: Token) -> Diagnostic | None:
        """See whether what looked like a bare file name goes on, as a path does."""
        if first.kind in QUOTED_KINDS or not self._is_glued:
            return None
        text = first.text
        while self._is_glued:
            text += self._tokens[self._at].text
            self._at += 1
        span = Span(first.start, self._tokens[self._at - 1].end)
        return Diagnostic(
            codes.SYNTAX_ERROR,
            "a bare file name is one word; a path, or a name with its ending, is quoted",
            span,
            help=f"write '{_shown(text)}'",
            fix=Fix("put it in single quotes", (Edit(span, f"'{text}'"),)),
        )

    def _rest_of_type(self, kind: SlotKind) -> Diagnostic | None:
        """Go over `/Name` and `/msg/Name` after the first word of a type."""
        parts = 1
        while (token := self._token) is not None and token.text == "/":
            if not self._is_glued:
                return self._syntax_error("a type has no space in it", token.span)
            self._at += 1
            following = self._token
            if following is None or not self._is_glued or following.kind not in WORD_KINDS:
                return self._syntax_error(f"expected {kind.words} after the `/`", token.span)
            parts += 1
            if parts > _MOST_TYPE_PARTS:
                return self._syntax_error("a type has at most three parts", following.span)
            self._at += 1
        return None

    def _fill_input(self) -> Diagnostic | None:
        """Look for what is wrong in the values, which go on to the end of the line."""
        token = self._token
        self.slots[self._at] = SlotKind.INPUT
        if token is None:
            return self._expected(SlotKind.INPUT.words)
        opened: list[Token] = []
        if token.text == "none" and self._following() not in ("=", "."):
            self._at += 1
            return None
        wants_value = True
        while (token := self._token) is not None:
            self._at += 1
            if token.kind in (UNKNOWN, UNCLOSED_STRING):
                return self._broken_text(token)
            if token.kind in _CLOSING.values() and (
                not wants_value or self._tokens[self._at - 2].kind in _CLOSING
            ):
                if not opened:
                    return self._syntax_error(f"`{token.kind}` closes nothing", token.span)
                if _CLOSING[opened[-1].kind] != token.kind:
                    break
                opened.pop()
                wants_value = False
            elif wants_value:
                mistake = self._value(token, opened)
                if mistake is not None:
                    return mistake
                wants_value = token.kind in _CLOSING
            elif token.kind == ",":
                wants_value = True
            else:
                return self._syntax_error(
                    f"unexpected `{_shown(token.text)}` in the values", token.span
                )
        if opened:
            kind = opened[-1].kind
            return self._syntax_error(f"`{kind}` is not closed", opened[-1].span)
        if wants_value:
            return self._syntax_error("expected a value after this", self._tokens[-1].span)
        return None

    def _following(self) -> str:
        after = self._at + 1
        return self._tokens[after].text if after < len(self._tokens) else ""

    def _value(self, token: Token, opened: list[Token]) -> Diagnostic | None:
        """Look at a token that stands where a value is to start, or the name of its field."""
        if token.kind in _CLOSING:
            opened.append(token)
            return None
        self._at -= 1
        is_word = token.kind in WORD_KINDS
        if is_word and self._following() in ("=", "."):
            if opened and opened[-1].kind == "[":
                return self._syntax_error("the elements of a list have no names", token.span)
            return self._named(opened)
        self._at += 1
        if token.kind in _LITERAL_KINDS or token.text in ("True", "False"):
            return None
        if token.text in ("true", "false"):
            right = token.text.capitalize()
            return self._instead(token, f"`{token.text}` is no value", right)
        if token.text.lower() in _BOOLEANS:
            right = _BOOLEANS[token.text.lower()]
            found = self._instead(token, f"`{token.text}` is no value", right)
            return found._replace(help=f'write `{right}`; or, for a text, "{token.text}"')
        if token.kind in QUOTED_KINDS:
            return self._no_value(token, token.text[1:-1])
        if token.text == "none":
            return self._syntax_error("`none` stands alone, and for no values at all", token.span)
        if is_word:
            return self._no_value(token, token.text)
        return self._syntax_error(f"expected a value, not `{_shown(token.text)}`", token.span)

    def _named(self, opened: list[Token]) -> Diagnostic | None:
        """Go over `a.b=` and what starts the value after it."""
        while True:
            self._at += 1
            mark, word = self._token, self._following()
            assert mark is not None
            self._at += 1
            if mark.text == "=":
                break
            name = self._token
            if mark.text != "." or name is None or name.kind not in WORD_KINDS:
                return self._syntax_error(
                    f"expected a field after `{_shown(mark.text)}`", mark.span
                )
            if self._following() not in (".", "="):
                return self._syntax_error(f"expected `=` after `{_shown(word)}`", name.span)
        token = self._token
        if token is None:
            return self._syntax_error("expected a value after this", mark.span)
        self._at += 1
        if token.kind in (UNKNOWN, UNCLOSED_STRING):
            return self._broken_text(token)
        if token.kind in WORD_KINDS and self._tokens[self._at : self._at + 1]:
            following = self._tokens[self._at]
            if following.text in ("=", "."):
                return self._syntax_error(f"expected a value, not `{token.text}`", token.span)
        return self._value(token, opened)

    def _broken_text(self, token: Token) -> Diagnostic:
        """Explain a string that does not end, or that an escape broke off."""
        after = self._token
        if token.kind == UNCLOSED_STRING and after is not None and after.text.startswith("\\"):
            escape = after.text[:2]
            end = after.start + len(escape.encode())
            return Diagnostic(
                codes.UNKNOWN_ESCAPE,
                f"`{_shown(escape)}` is no escape",
                Span(after.start, end),
                help=f"the escapes are {escapes.listed()}; a backslash is written \\\\",
                fix=write(f"\\{escape}", Span(after.start, end)),
            )
        return unexpected(token)

    def _no_value(self, token: Token, text: str) -> Diagnostic:
        return self._instead(token, f"`{_shown(token.text)}` is no value", f'"{text}"')

    def _instead(self, token: Token, message: str, right: str) -> Diagnostic:
        what = f"a number is written in digits, text in double quotes: {_shown(right)}"
        return Diagnostic(
            codes.SYNTAX_ERROR,
            message,
            token.span,
            help=what if right.startswith('"') else f"did you mean `{right}`?",
            fix=Fix(f"write {_shown(right)}", (Edit(token.span, right),)),
        )

    def _expected(self, what: str) -> Diagnostic:
        token = self._token
        if token is None:
            end = self._tokens[-1].end
            return self._syntax_error(f"expected {what} here", Span(end, end))
        if token.kind in (UNKNOWN, UNCLOSED_STRING) and token.text[0] in "'\"":
            return unexpected(token)
        return self._syntax_error(f"expected {what}, not `{_shown(token.text)}`", token.span)

    def _syntax_error(self, message: str, span: Span) -> Diagnostic:
        return Diagnostic(
            codes.SYNTAX_ERROR, message, span, help=f"the sentence is: {self._declaration.usage}"
        )
