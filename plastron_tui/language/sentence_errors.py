"""What is wrong with a line that was to be a certain statement."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span, codes, write

from .declaration import Declaration, Element, Form, Slot, SlotKind
from .field_mistakes import without_fields
from .keywords import KEYWORDS
from .list_errors import first_unfit
from .mistake_place import shown, unquoted
from .open_values import ARITHMETIC, NAME_MARKS, OpenValues, end_of_received, is_received
from .sentence_match import BEHIND_NUMBERS, SentenceMatch, SlotMatch
from .token_errors import broken_text, unexpected
from .tokens import QUOTED_KINDS, UNCLOSED_STRING, UNKNOWN, WORD_KINDS, Token, text_at, token_at
from .undoing import nearest_keyword

SENTENCE_IS = "the sentence is: "
"""What a help begins with that says how the whole statement is written."""

_CLOSED_BY = {"(": ")", "[": "]"}
_VALUE_KINDS = frozenset({"number", "string", "(", "["})
_KINDS = {
    Form.QUOTED: QUOTED_KINDS,
    Form.FILE: QUOTED_KINDS | WORD_KINDS,
    Form.NUMBER: frozenset({"number"}),
    Form.RATE: frozenset({"number", "parameter"}),
    Form.TEXT: frozenset({"string"}),
    Form.COLOR: WORD_KINDS | {"string"},
}
"""The tokens that begin what is written in a form that is no word."""

_VECTOR_PARTS = (
    "a comma, and two more numbers",
    "a second number",
    "a comma, and a third number",
    "a third number",
)
_MOST_TYPE_PARTS = 3
_GOING_ON = frozenset({",", "=", ".", "(", "["})
_TRUTHS = frozenset({"True", "False"})
_BOOLEANS = {
    **dict.fromkeys(("true", "on", "yes"), "True"),
    **dict.fromkeys(("false", "off", "no"), "False"),
}


class SentenceErrors:
    """Explains the first token of a line that does not fit the sentence of a statement."""

    def __init__(self, declaration: Declaration, tokens: Sequence[Token]) -> None:
        self._declaration = declaration
        self._tokens = tokens
        self._part: Element | None = None

    def first(self, match: SentenceMatch) -> Diagnostic:
        """Return what is wrong, as the match of the tokens tells."""
        for filled in match.slots:
            self._part = filled.slot
            mistake = self._in_slot(filled)
            if mistake is not None:
                return mistake
        self._part = match.wanted
        token = self._tokens[match.end] if match.end < len(self._tokens) else None
        match match.wanted:
            case Slot(kind=kind) if token is None:
                return self._expected(kind.words)
            case Slot(kind=kind) if not kind.form.is_open:
                return self._expected(kind.words, token)
            case Slot(kind=kind):
                mistake = self._in_open(kind, self._tokens[match.end :])
                if mistake is not None:
                    return self._in_clause(match, mistake) or mistake
                if match.ending:
                    return self._not_the_word(match.ending, None)
                token = None
            case str() as word:
                return self._not_the_word(word, token, *match.instead)
        if token is None:
            return Diagnostic(
                codes.SYNTAX_ERROR,
                "a statement stands on a line of its own",
                Span(self._tokens[0].start, self._tokens[-1].end),
            )
        if token.kind in (UNKNOWN, UNCLOSED_STRING):
            return unexpected(token)
        clause = nearest_keyword(token.text, match.following)
        if clause is not None and token.kind in WORD_KINDS:
            return self._not_the_word(clause, token)
        if token.text in match.passed:
            return self._no_more(token)
        return self._error(f"unexpected `{shown(token.text)}`", token.span)

    def _in_clause(self, match: SentenceMatch, mistake: Diagnostic) -> Diagnostic | None:
        """Explain a mistake in what is open that was to begin the clause after it."""
        for before, token in pairwise(self._tokens[match.end :]):
            if token.span != mistake.span or before.text in _GOING_ON:
                continue
            if token.text in match.passed:
                return self._no_more(token)
            clause = nearest_keyword(token.text, match.following)
            # The word itself stands in a bracket that is not closed.
            if token.kind in WORD_KINDS and clause not in (None, token.text):
                return self._not_the_word(clause, token)
        return None

    def _no_more(self, token: Token) -> Diagnostic:
        return self._error(f"`{token.text}` cannot stand here any more", token.span)

    def _not_the_word(self, word: str, token: Token | None, *others: str) -> Diagnostic:
        found = self._expected(" or ".join(f"`{each}`" for each in (word, *others)), token)
        if token is not None and token.kind in WORD_KINDS:
            meant = nearest_keyword(token.text, [word, *others])
            if meant is not None:
                help_ = f"did you mean `{meant}`?"
                return found._replace(help=help_, fix=write(meant, token.span))
        if token is None:
            return without_fields(self._declaration, word, found) or found
        return found

    def _in_slot(self, filled: SlotMatch) -> Diagnostic | None:
        kind = filled.slot.kind
        token = self._tokens[filled.first]
        if filled.first == filled.end:
            return self._error(f"expected {kind.words} before `{token.text}`", token.span)
        is_none = kind.may_be_none and token.text == "none"
        if not (is_none or _fits(token, kind.form)):
            return self._wrong_form(token, kind)
        if kind.form is Form.VECTOR:
            # The word behind it stands in the place of a number that is missing.
            return self._in_open(kind, self._tokens[filled.first : filled.end + 1])
        if kind.form.is_open and not is_none:
            return self._in_open(kind, self._tokens[filled.first : filled.end])
        match kind.form:
            case Form.RATE if token.text == "parameter":
                return self._in_parameter(self._tokens[filled.first : filled.end])
            case Form.TYPE:
                return self._in_type(filled)
            case Form.FILE if filled.end > filled.first + 1:
                parts = self._tokens[filled.first : filled.end]
                return unquoted(
                    "a bare file name is one word; a path, or a name with its ending, is quoted",
                    Span(token.start, parts[-1].end),
                    "".join(part.text for part in parts),
                )
        return None

    def _wrong_form(self, token: Token, kind: SlotKind) -> Diagnostic:
        if kind.is_variable and token.text in KEYWORDS:
            return Diagnostic(
                codes.KEYWORD_AS_VARIABLE,
                f"`{token.text}` is a keyword and cannot be a variable",
                token.span,
                help="choose another name",
            )
        is_clause = any(token.text == clause.keyword for clause in self._declaration.clauses)
        is_word = _fits(token, Form.WORD) and not is_clause
        if kind.is_quoted and (is_word or token.kind == "string"):
            return unquoted(f"expected {kind.words}", token.span, token.text.strip('"'))
        return self._expected(kind.words, token)

    def _in_type(self, filled: SlotMatch) -> Diagnostic | None:
        """Look at `package/Name` and `package/msg/Name`."""
        parts = self._tokens[filled.first : filled.end : 2]
        if len(parts) > _MOST_TYPE_PARTS:
            return self._error("a type has at most three parts", parts[_MOST_TYPE_PARTS].span)
        last = self._tokens[filled.end - 1]
        if last.text == "/":
            return self._error(f"expected {filled.slot.kind.words} after the `/`", last.span)
        if text_at(self._tokens, filled.end) == "/":
            return self._error("a type has no space in it", self._tokens[filled.end].span)
        return None

    def _in_open(self, kind: SlotKind, tokens: Sequence[Token]) -> Diagnostic | None:
        """Look at what goes on to another clause, or to the end of the line."""
        match kind.form:
            case Form.CONDITION:
                return self._in_condition(tokens)
            case Form.VECTOR:
                return self._in_vector(kind, tokens)
            case Form.QOS | Form.FIELDS | Form.REMAPS | Form.SETTINGS as form:
                return self._in_list(form, tokens)
        mistake = self._in_values(tokens)
        if mistake is None and kind.form is Form.VALUE:
            mark = next((token for token in _outermost(tokens) if token.text in ",="), None)
            if mark is not None:
                what = "this takes one value" + ("" if mark.text == "," else ", which has no name")
                return self._error(what, mark.span)
            return None
        return mistake

    def _in_list(self, form: Form, tokens: Sequence[Token]) -> Diagnostic | None:
        """Look at what commas part: fields, say, or words of quality of service."""
        unfit = first_unfit(form, tokens)
        if unfit is None:
            return None
        if unfit.values is not None:
            return self._in_values(unfit.values)
        return self._expected(unfit.wanted, unfit.token)

    def _in_vector(self, kind: SlotKind, tokens: Sequence[Token]) -> Diagnostic | None:
        """Look at three numbers, and at the token behind them."""
        for at, wanted in enumerate((kind.words, *_VECTOR_PARTS)):
            token = token_at(tokens, at)
            if token is None or not (token.text == "," if at % 2 else token.kind == "number"):
                return self._expected(wanted, token)
        beyond = token_at(tokens, len(_VECTOR_PARTS) + 1)
        is_last = len(tokens) == len(_VECTOR_PARTS) + 2
        if beyond is None or (is_last and beyond.kind in BEHIND_NUMBERS):
            return None
        return self._error(f"three numbers are enough, without `{shown(beyond.text)}`", beyond.span)

    def _in_condition(self, tokens: Sequence[Token]) -> Diagnostic | None:
        """Look at a condition: `[any | all] received.FIELD < VALUE`."""
        first = 1 if tokens[0].text in ("any", "all") else 0
        if text_at(tokens, first) != "received":
            return self._expected("`received` and a field", token_at(tokens, first))
        end = end_of_received(tokens, first)
        mistake = self._in_received(tokens, first, end)
        if mistake is not None:
            return mistake
        if text_at(tokens, end) not in ("<", ">", "="):
            return self._expected("`<`, `>` or `=`", token_at(tokens, end))
        value = token_at(tokens, end + 1)
        if value is None or not (value.kind in ("number", "string") or value.text in _TRUTHS):
            return self._expected("a number, a text, `True` or `False`", value)
        beyond = token_at(tokens, end + 2)
        return None if beyond is None else self._error("a condition compares once", beyond.span)

    def _in_received(self, tokens: Sequence[Token], first: int, end: int) -> Diagnostic | None:
        """Look at `received.FIELD` and `received.FIELD[INDEX]`, which ends where it breaks off."""
        follows = text_at(tokens, end)
        if text_at(tokens, end - 1) == "]":
            is_over = follows not in (".", "[")
            what = "an element is taken as a whole"
            return None if is_over else self._error(what, tokens[end].span)
        if follows == "." or end == first + 1:
            return self._expected(
                "a field of what is received", token_at(tokens, end + (follows == "."))
            )
        if follows == "[":
            is_number = text_at(tokens, end + 1).isdigit()
            what = "`]`" if is_number else "the number of an element, from 0"
            return self._expected(what, token_at(tokens, end + 1 + is_number))
        return None

    def _in_parameter(self, tokens: Sequence[Token]) -> Diagnostic | None:
        """Look at `parameter 'NAME'`."""
        name = tokens[1] if len(tokens) > 1 else None
        if name is not None and name.kind in QUOTED_KINDS:
            return None
        return self._expected(SlotKind.PARAMETER.words, name)

    def _in_values(self, tokens: Sequence[Token]) -> Diagnostic | None:
        """Look at values."""
        values = OpenValues()
        mistake, tokens = self._calculated(tokens)
        if mistake is not None:
            return mistake
        for token, following in pairwise((*tokens, None)):
            assert token is not None
            mistake = self._in_value(values, token, following)
            if mistake is not None:
                return mistake
            values.take(token)
        opening = values.levels[-1].opening
        if values.wants_value and (opening is None or tokens[-1].text == "="):
            return self._error("expected a value after this", tokens[-1].span)
        if opening is not None:
            return self._error(f"`{opening.kind}` is not closed", opening.span)
        return None

    def _calculated(self, tokens: Sequence[Token]) -> tuple[Diagnostic | None, Sequence[Token]]:
        """Look at parameters, at what is received, and at what is calculated with them.

        Each is one value in the tokens that are returned.
        """
        made: list[Token] = []
        at = 0
        while at < len(tokens):
            token, first = tokens[at], at
            mistake, at = self._in_origin(tokens, first)
            if mistake is None and at == first:
                made.append(token)
                at += 1
                continue
            while mistake is None and text_at(tokens, at) in ARITHMETIC:
                mistake, at = self._in_operand(tokens, at + 1)
            if mistake is not None:
                return mistake, tokens
            made.append(token._replace(kind="number", end=tokens[at - 1].end))
        return None, made

    def _in_origin(self, tokens: Sequence[Token], first: int) -> tuple[Diagnostic | None, int]:
        """Look at a parameter, or at what is received; it ends where it begins if it is neither."""
        if is_received(tokens, first):
            end = end_of_received(tokens, first)
            return self._in_received(tokens, first, end), end
        if text_at(tokens, first) != "parameter" or text_at(tokens, first + 1) in NAME_MARKS:
            return None, first
        return self._in_parameter(tokens[first:]), min(first + 2, len(tokens))

    def _in_operand(self, tokens: Sequence[Token], first: int) -> tuple[Diagnostic | None, int]:
        """Look at what stands behind an operator, and return where that ends."""
        token = token_at(tokens, first)
        if token is not None and token.kind == "number":
            return None, first + 1
        mistake, end = self._in_origin(tokens, first)
        if mistake is None and end == first:
            mistake = self._expected("a number, `received` or `parameter`", token)
        return mistake, end

    def _in_value(
        self, values: OpenValues, token: Token, following: Token | None
    ) -> Diagnostic | None:
        """Look at a token of values, those before it being right."""
        last, level = values.last, values.levels[-1]
        text, kind = token.text, token.kind
        is_named = following is not None and following.text in NAME_MARKS
        if last is not None and last.kind in WORD_KINDS and text in NAME_MARKS:
            is_name = text == "=" or (following is not None and following.kind in WORD_KINDS)
            return None if is_name else self._error("expected a field after `.`", token.span)
        if last is not None and last.text == ".":
            what = f"expected `=` after `{shown(text)}`"
            return None if is_named else self._error(what, token.span)
        if text in ARITHMETIC and not values.wants_value:
            what = "a calculation begins with `parameter` or `received`"
            return self._error(what, token.span)
        if kind in (UNKNOWN, UNCLOSED_STRING):
            return broken_text(token, following)
        if kind in _CLOSED_BY.values() and last is not None and last.kind not in (",", "="):
            if level.opening is None:
                return self._error(f"`{kind}` closes nothing", token.span)
            opened = level.opening
            is_pair = _CLOSED_BY[opened.kind] == kind
            return None if is_pair else self._error(f"`{opened.kind}` is not closed", opened.span)
        if not values.wants_value:
            what = f"unexpected `{shown(text)}` in the values"
            return None if kind == "," else self._error(what, token.span)
        if kind in WORD_KINDS and is_named:
            if last is not None and last.text == "=":
                return self._error(f"expected a value, not `{text}`", token.span)
            what = "the elements of a list have no names"
            return self._error(what, token.span) if level.is_list else None
        is_value = kind in _VALUE_KINDS or text in ("True", "False")
        return None if is_value else self._no_value(token)

    def _no_value(self, token: Token) -> Diagnostic:
        """Explain a word or a mark in the place of a value."""
        text = token.text
        if text == "none":
            return self._error("`none` stands alone, and for no values at all", token.span)
        if token.kind not in QUOTED_KINDS and token.kind not in WORD_KINDS:
            return self._error(f"expected a value, not `{shown(text)}`", token.span)
        right = _BOOLEANS.get(text.lower())
        if right is None:
            right = f'"{text[1:-1] if token.kind in QUOTED_KINDS else text}"'
            help_ = f"a number is written in digits, text in double quotes: {shown(right)}"
        elif text in ("true", "false"):
            help_ = f"did you mean `{right}`?"
        else:
            help_ = f'write `{right}`; or, for a text, "{text}"'
        fix = Fix(f"write {shown(right)}", (Edit(token.span, right),))
        what = f"`{shown(text)}` is no value"
        return Diagnostic(codes.SYNTAX_ERROR, what, token.span, help=help_, fix=fix)

    def _expected(self, what: str, token: Token | None = None) -> Diagnostic:
        if token is None:
            end = self._tokens[-1].end
            return self._error(f"expected {what} here", Span(end, end))
        if token.kind in (UNKNOWN, UNCLOSED_STRING) and token.text[0] in "'\"":
            return unexpected(token)
        return self._error(f"expected {what}, not `{shown(token.text)}`", token.span)

    def _error(self, message: str, span: Span) -> Diagnostic:
        help_ = f"{SENTENCE_IS}{self._declaration.usage_around(self._part)}"
        if any(slot.kind is SlotKind.FIELDS for slot in self._declaration.slots):
            help_ += f"; for example: {self._declaration.example}"
        return Diagnostic(codes.SYNTAX_ERROR, message, span, help=help_)


def _outermost(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yield the tokens that stand in no brackets."""
    depth = 0
    for token in tokens:
        depth -= token.text in _CLOSED_BY.values()
        if depth == 0:
            yield token
        depth += token.text in _CLOSED_BY


def _fits(token: Token, form: Form) -> bool:
    """Tell whether a token is, or begins, what is written in such a form."""
    if form.is_open:
        return True
    return token.kind in _KINDS.get(form, WORD_KINDS) and token.text not in KEYWORDS
