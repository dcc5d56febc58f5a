"""What is wrong with a line that is no statement, in terms of the statement it was to be."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby, zip_longest

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span
from plastron_tui.diagnostics.suggest import nearest

from .declaration import DECLARATIONS, Clause, Declaration, Element, Slot, SlotKind
from .tokens import Token, tokens_of

_WORD_KINDS = frozenset(
    {"identifier", "variable", "module", "function", "client_library", "field_name"}
)
_QUOTED_KINDS = frozenset({"ros_name", "path"})
_OPENING = {")": "(", "]": "["}
_VALUE_WORDS = ("none", "True", "False")

# What a machine wrote can have a mistake on each of a million lines; nobody reads that many.
MOST_BROKEN_LINES = 1_000


def _words_of(elements: Iterable[Element]) -> Iterable[str]:
    for element in elements:
        if isinstance(element, str):
            yield element
        elif isinstance(element, Clause):
            yield from _words_of(element.elements)


KEYWORDS: frozenset[str] = frozenset(_VALUE_WORDS).union(
    *(_words_of(declaration.elements) for declaration in DECLARATIONS.values())
)
_BY_KEYWORD = {declaration.keyword: declaration for declaration in DECLARATIONS.values()}
FIRST_WORDS = tuple(
    word for word, declaration in _BY_KEYWORD.items() if declaration.elements[0] == word
)
VERBS = tuple(word for word in _BY_KEYWORD if word not in FIRST_WORDS)


def explain(source: bytes, broken: Sequence[Node]) -> tuple[tuple[Diagnostic, ...], frozenset[str]]:
    """Explain the nodes that are no statements: one diagnostic a line, and the lines' words."""
    diagnostics: list[Diagnostic] = []
    words: set[str] = set()
    for _, line in groupby(tokens_of(source, broken), key=lambda token: token.row):
        tokens = tuple(line)
        words.update(token.text for token in tokens if token.kind in _WORD_KINDS)
        if len(diagnostics) < MOST_BROKEN_LINES:
            diagnostics.append(_explain_line(tokens))
    return tuple(diagnostics), frozenset(words)


def _explain_line(tokens: Sequence[Token]) -> Diagnostic:
    for token in tokens:
        if token.kind == "unknown" and token.text.startswith("/*"):
            return Diagnostic(
                "unclosed-comment",
                "the comment is not closed",
                Span(token.start, token.start + 2),
                help="close it with `*/`",
            )
    declaration = _intended(tokens)
    if declaration is None:
        return _unknown_statement(tokens)
    return _Alignment(declaration, tokens).first_mistake()


def _intended(tokens: Sequence[Token]) -> Declaration | None:
    """Return the statement whose keyword stands where it belongs, or at least at the start."""
    first = tokens[0].text
    second = tokens[1].text if len(tokens) > 1 else ""
    if first in FIRST_WORDS:
        return _BY_KEYWORD[first]
    if second in VERBS:
        return _BY_KEYWORD[second]
    return _BY_KEYWORD.get(first)


def _unknown_statement(tokens: Sequence[Token]) -> Diagnostic:
    first = tokens[0]
    guesses = [(first, FIRST_WORDS)]
    if len(tokens) > 1 and first.kind in _WORD_KINDS:
        guesses.append((tokens[1], VERBS))
    for token, names in guesses:
        name = nearest(token.text, names) if token.kind in _WORD_KINDS else None
        if name is not None:
            return Diagnostic(
                "unknown-statement",
                f"`{token.text}` starts no statement",
                token.span,
                help=f"did you mean `{name}`?",
                fix=Fix(f"write `{name}`", (Edit(token.span, name),)),
            )
    if first.kind == "unknown":
        return _unexpected(first)
    return Diagnostic(
        "unknown-statement",
        f"`{first.text}` starts no statement",
        first.span,
        help=f"a statement starts with {', '.join(FIRST_WORDS)}, or with the variable of a node",
    )


def _unexpected(token: Token) -> Diagnostic:
    if token.text[0] in "'\"":
        return Diagnostic(
            "unclosed-quote",
            f"the quote is not closed on this line: {token.text[0]}",
            Span(token.start, token.start + 1),
            help=f"close it with {token.text[0]}",
        )
    return Diagnostic("syntax-error", f"unexpected `{_shown(token.text)}`", token.span)


def _shown(text: str) -> str:
    shown = text if len(text) <= 40 else text[:37] + "..."
    return shown if shown.isprintable() else ascii(shown)[1:-1]


class _Alignment:
    """A line's tokens held against the sentence that they were to be."""

    def __init__(self, declaration: Declaration, tokens: Sequence[Token]) -> None:
        self._declaration = declaration
        self._tokens = tokens
        self._at = 0

    @property
    def _token(self) -> Token | None:
        return self._tokens[self._at] if self._at < len(self._tokens) else None

    def first_mistake(self) -> Diagnostic:
        """Return what is wrong at the first token that does not fit."""
        mistake = self._align(self._declaration.elements)
        if mistake is not None:
            return mistake
        token = self._token
        if token is None:
            whole = Span(self._tokens[0].start, self._tokens[-1].end)
            return self._syntax_error("this is no statement", whole)
        if token.kind == "unknown":
            return _unexpected(token)
        return self._syntax_error(f"unexpected `{_shown(token.text)}`", token.span)

    def _align(self, elements: Iterable[Element]) -> Diagnostic | None:
        for element in elements:
            match element:
                case Clause(elements=parts):
                    token = self._token
                    mistake = (
                        self._align(parts) if token is not None and token.text == parts[0] else None
                    )
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
        if token is not None and token.kind in _WORD_KINDS and nearest(token.text, [word]):
            return Diagnostic(
                "syntax-error",
                f"expected `{word}`, not `{token.text}`",
                token.span,
                help=f"did you mean `{word}`?",
                fix=Fix(f"write `{word}`", (Edit(token.span, word),)),
            )
        return self._expected(f"`{word}`")

    def _fill(self, kind: SlotKind) -> Diagnostic | None:
        if kind is SlotKind.INPUT:
            return self._fill_input()
        token = self._token
        if token is None:
            return self._expected(kind.words)
        if self._fits(token, kind):
            self._at += 1
            if kind in (SlotKind.MESSAGE_TYPE, SlotKind.SERVICE_TYPE):
                self._skip_type_rest()
            return None
        if kind.is_variable and token.text in KEYWORDS and token.text != self._declaration.keyword:
            return Diagnostic(
                "keyword-as-variable",
                f"`{token.text}` is a keyword and cannot be a variable",
                token.span,
                help="choose another name",
            )
        if kind.is_quoted and (token.kind in _WORD_KINDS or token.kind == "string"):
            bare = token.text.strip('"')
            return Diagnostic(
                "syntax-error",
                f"expected {kind.words}",
                token.span,
                help=f"write '{bare}'",
                fix=Fix("put it in single quotes", (Edit(token.span, f"'{bare}'"),)),
            )
        return self._expected(kind.words)

    def _fits(self, token: Token, kind: SlotKind) -> bool:
        if kind.is_quoted:
            return token.kind in _QUOTED_KINDS
        if kind is SlotKind.RATE:
            return token.kind == "number"
        if kind is SlotKind.FILE and token.kind in _QUOTED_KINDS:
            return True
        return token.kind in _WORD_KINDS and token.text not in KEYWORDS

    def _skip_type_rest(self) -> None:
        tokens = self._tokens
        while self._at + 1 < len(tokens) and tokens[self._at].text == "/":
            if tokens[self._at + 1].kind not in _WORD_KINDS:
                return
            self._at += 2

    def _fill_input(self) -> Diagnostic | None:
        """Look for what is wrong in the values, which go on to the end of the line."""
        values = self._tokens[self._at :]
        if not values:
            return self._expected(SlotKind.INPUT.words)
        opened: list[Token] = []
        for token, following in zip_longest(values, values[1:]):
            if token.kind == "unknown":
                return _unexpected(token)
            if token.kind in _WORD_KINDS and (following is None or following.text not in "=."):
                return self._no_value(token)
            if token.kind in ("(", "["):
                opened.append(token)
            elif token.kind in _OPENING and (
                not opened or opened.pop().kind != _OPENING[token.kind]
            ):
                return self._syntax_error(f"`{token.kind}` closes nothing", token.span)
        if opened:
            return self._syntax_error(f"`{opened[-1].kind}` is not closed", opened[-1].span)
        wrong = next((token for token in values if token.in_error), None)
        if wrong is None:
            return self._expected("a value", at=values[-1])
        return self._syntax_error(f"unexpected `{_shown(wrong.text)}` in the values", wrong.span)

    def _no_value(self, token: Token) -> Diagnostic:
        return Diagnostic(
            "syntax-error",
            f"`{token.text}` is no value",
            token.span,
            help=f'text is written in double quotes: "{token.text}"',
            fix=Fix("put it in double quotes", (Edit(token.span, f'"{token.text}"'),)),
        )

    def _expected(self, what: str, at: Token | None = None) -> Diagnostic:
        token = at or self._token
        if token is None:
            end = self._tokens[-1].end
            return self._syntax_error(f"expected {what} here", Span(end, end))
        if token.kind == "unknown":
            return _unexpected(token)
        return self._syntax_error(f"expected {what}, not `{_shown(token.text)}`", token.span)

    def _syntax_error(self, message: str, span: Span) -> Diagnostic:
        return Diagnostic(
            "syntax-error", message, span, help=f"the sentence is: {self._declaration.usage}"
        )
