"""Where a list, of fields or of words of quality of service, stops being what it is to be."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from .declaration import Form, SlotKind
from .tokens import QUOTED_KINDS, WORD_KINDS, Token, text_at, token_at

_OPENING, _CLOSING = ("(", "["), (")", "]")


class Unfit(NamedTuple):
    """What is wrong with a list.

    Attributes:
        wanted: what was to stand there.
        token: what stands there instead, None at the end of the line.
        values: the values that are wrong, where it is in them.
    """

    wanted: str
    token: Token | None = None
    values: Sequence[Token] | None = None


def first_unfit(form: Form, tokens: Sequence[Token]) -> Unfit | None:
    """Return what is wrong first in a list of one of these forms.

    Where nothing is, its values may be.
    """
    check = _CHECKS[form]
    doubtful: Unfit | None = None
    parts = list(_parts(tokens))
    for at, part in enumerate(parts):
        unfit = check(part)
        is_last = at == len(parts) - 1
        if unfit is not None and unfit.values is not None:
            doubtful = doubtful or unfit
        elif unfit is not None:
            # Where a part ends too early, a comma stands in its place, or nothing.
            comma = None if is_last else token_at(tokens, _end_of(parts, at))
            return unfit if unfit.token is not None else unfit._replace(token=comma)
    return doubtful


def _parts(tokens: Sequence[Token]) -> Iterator[Sequence[Token]]:
    """Yield what stands between the commas that are in no brackets."""
    first = depth = 0
    for at, token in enumerate(tokens):
        depth += (token.text in _OPENING) - (token.text in _CLOSING)
        if token.text == "," and depth <= 0:
            yield tokens[first:at]
            first = at + 1
    yield tokens[first:]


def _end_of(parts: Sequence[Sequence[Token]], at: int) -> int:
    return sum(len(part) + 1 for part in parts[: at + 1]) - 1


def _policy(part: Sequence[Token]) -> Unfit | None:
    """Look at a word of quality of service, which may have a number."""
    if not part or part[0].kind not in WORD_KINDS:
        return Unfit(SlotKind.QOS.words, token_at(part, 0))
    has_number = len(part) > 1 and part[1].kind == "number"
    beyond = token_at(part, 1 + has_number)
    return None if beyond is None else Unfit("a comma", beyond)


def _field(part: Sequence[Token]) -> Unfit | None:
    """Look at `TYPE NAME`, `TYPE NAME = VALUE` and `TYPE NAME default VALUE`."""
    if not part or part[0].kind not in WORD_KINDS:
        return Unfit("a field, such as `float64 x`", token_at(part, 0))
    at = end_of_type(part, 0)
    name = token_at(part, at)
    if name is None or name.kind not in WORD_KINDS:
        return Unfit("the name of the field", name)
    follows = token_at(part, at + 1)
    if follows is None:
        return None
    if follows.text not in ("=", "default"):
        return Unfit("a comma, `default`, or `=` for a constant", follows)
    return _value(part, at + 2)


def end_of_type(tokens: Sequence[Token], first: int) -> int:
    """Return where the type of a field ends that begins with a word: `string<=10[]`, say."""
    at = first + 1
    while text_at(tokens, at) == "/":
        at += 2
    if text_at(tokens, at) == "<=":
        at += 2
    if text_at(tokens, at) == "[":
        while at < len(tokens) and tokens[at].text != "]":
            at += 1
        at += 1
    return at


def _remap(part: Sequence[Token]) -> Unfit | None:
    """Look at `'FROM' to 'TO'`."""
    for at, wanted in enumerate((None, "`to`", None)):
        token = token_at(part, at)
        is_right = token is not None and (
            token.kind in QUOTED_KINDS if wanted is None else token.text == "to"
        )
        if not is_right:
            return Unfit(wanted or "a name in single quotes", token)
    return Unfit("a comma", part[3]) if len(part) > 3 else None


def _setting(part: Sequence[Token]) -> Unfit | None:
    """Look at `'PARAMETER' = VALUE`."""
    name, equals = token_at(part, 0), token_at(part, 1)
    if name is None or name.kind not in QUOTED_KINDS:
        return Unfit(SlotKind.PARAMETER.words, name)
    if equals is None or equals.text != "=":
        return Unfit("`=`", equals)
    return _value(part, 2)


def _value(part: Sequence[Token], first: int) -> Unfit:
    """Look at a single value; whether it is one, who knows values has to tell."""
    if first >= len(part):
        return Unfit("a value")
    return Unfit("a value", part[first], part[first:])


_CHECKS: dict[Form, Callable[[Sequence[Token]], Unfit | None]] = {
    Form.QOS: _policy,
    Form.FIELDS: _field,
    Form.REMAPS: _remap,
    Form.SETTINGS: _setting,
}
