"""Common slips of the pen in values, conditions and rates, and what was meant."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from fractions import Fraction
from itertools import takewhile

from plastron_tui.diagnostics import Diagnostic, Span, write
from plastron_tui.diagnostics.suggest import nearest

from .declaration import Form, SlotKind
from .mistake_place import COMPUTED, Place, mended, unquoted
from .open_values import ARITHMETIC, end_of_received, is_received
from .tokens import QUOTED_KINDS, WORD_KINDS, Token, is_glued

_SECONDS = {
    **dict.fromkeys(("ms", "milliseconds"), 0.001),
    **dict.fromkeys(("s", "sec", "second", "seconds"), 1),
    **dict.fromkeys(("min", "minutes"), 60),
}
_METRES = {
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1),
    "mm": 0.001,
    "cm": 0.01,
    "km": 1000,
}
_RADIANS = {
    **dict.fromkeys(("deg", "degree", "degrees"), math.pi / 180),
    **dict.fromkeys(("rad", "radian", "radians"), 1),
}
_KILOGRAMS = {
    **dict.fromkeys(("kg", "kilogram", "kilograms", "kilo", "kilos"), 1),
    **dict.fromkeys(("g", "gram", "grams"), 0.001),
}
_UNITS: dict[str, tuple[str, float]] = {
    unit: (base, factor)
    for base, units in (
        ("seconds", _SECONDS),
        ("metres", _METRES),
        ("radians", _RADIANS),
        ("kilograms", _KILOGRAMS),
    )
    for unit, factor in units.items()
}
"""What ROS measures in instead of a unit, and how many of these the unit is (REP 103)."""

_TURNED = {"<": ">", ">": "<", "=": "="}
_VALUE_KINDS = frozenset({"number", "string", "boolean"})

_RECEIVED = frozenset({"request", "req", "msg", "message"})
"""What others call what was received."""

_IN_CODE = (
    "a calculation has no brackets, and begins with `received` or `parameter`; what takes more is "
    "code in the node"
)


def _operand(place: Place, first: int) -> int | None:
    """Return where a field of what is received ends, or a parameter; None for what is neither."""
    tokens = place.tokens
    if is_received(tokens, first):
        end = end_of_received(tokens, first)
        return end if end > first + 1 else None
    is_named = first + 1 < len(tokens) and tokens[first + 1].kind in QUOTED_KINDS
    return first + 2 if is_named and place.text(first) == "parameter" else None


def _is_in(place: Place, *forms: Form) -> bool:
    return place.within is not None and place.within.form in forms


def period(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `every 5 s`, `every 0.1` and `at 500 ms`, where a rate is wanted."""
    declaration, at = place.declaration, place.at
    if declaration is None or all(slot.kind is not SlotKind.RATE for slot in declaration.slots):
        return None
    if place.token.text not in ("every", "each"):
        at -= 2
        if place.text(at) != "at" or (place.before is not None and place.before.kind != "number"):
            return None
    number, unit, end = place.text(at + 1), place.text(at + 2), at + 3
    if number == "second":
        number, unit, end = "1", number, at + 2
    elif place.text(at) != "at" and _has_exact_rate(number) and unit not in _SECONDS:
        unit, end = "s", at + 2
    if place.text(at) != "at" and place.text(at + 2) == "hz":
        span = place.span(at, at + 3)
        return mended(found, "how often is said with `at`", span, f"at {number} hz")
    if unit not in _SECONDS or not re.fullmatch(r"\d*\.?\d+", number) or not float(number):
        return None
    rate = f"at {1 / (float(number) * _SECONDS[unit]):.6g} hz"
    return mended(found, "how often is said in hertz", place.span(at, end), rate)


def _has_exact_rate(number: str) -> bool:
    """Tell whether a number of seconds is a rate in few digits: 0.1 is 10, and 0.3 is none."""
    if not re.fullmatch(r"\d{0,6}\.?\d{1,6}", number) or not float(number):
        return False
    return Fraction(f"{1 / float(number):.6g}") * Fraction(number) == 1


def unit(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `0.3 m`, and `30cm`."""
    before, at = place.before, place.at
    if before is None or before.kind != "number" or place.token.text not in _UNITS:
        return None
    if place.within is SlotKind.RATE:
        return None
    base, factor = _UNITS[place.token.text]
    value = float(before.text) * factor
    right = before.text if factor == 1 else f"{value:.6g}"
    what = f"a number has no unit; ROS measures in {base}"
    return mended(found, what, place.span(at - 1, at + 1), right) if math.isfinite(value) else None


def comparison(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `==`, and comparisons that there are not."""
    token, before = place.token, place.text(place.at - 1)
    if token.text != "=" or before not in ("=", "<", ">") or not is_glued(place.tokens, place.at):
        return None
    span = place.span(place.at - 1, place.at + 1)
    if before == "=":
        return mended(found, "one `=` says that two are equal", span, "=")
    return mended(found, f"expected `<`, `>` or `=`, not `{before}=`", span, before)


def turned(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `5 < received.x`."""
    at = place.at
    if not _is_in(place, Form.CONDITION) or place.token.kind not in _VALUE_KINDS:
        return None
    end = end_of_received(place.tokens, at + 2)
    if place.text(at + 1) not in _TURNED or place.text(at + 2) != "received" or end == at + 3:
        return None
    right = f"{place.written(at + 2, end)} {_TURNED[place.text(at + 1)]} {place.token.text}"
    return mended(found, "what is received stands first", place.span(at, end), right)


def without_received(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `when ranges[0] < 5`."""
    is_first = place.text(place.at - 1) in ("when", "any", "all")
    following = place.text(place.at + 1)
    is_compared = following in _TURNED or following == "["
    if not _is_in(place, Form.CONDITION) or not is_first or not is_compared:
        return None
    if place.token.kind not in WORD_KINDS or place.token.text == "received":
        return None
    return mended(found, found.message, place.token.span, f"received.{place.token.text}")


def source(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `recieved.x`, `request.x`, and `parameters 'x'`."""
    tokens, at = place.tokens, place.at
    while place.text(at - 1) == "." and at > 1:
        # Without a name before it, the value looks like the path of a field.
        at -= 2
    token = tokens[at]
    if at + 1 == len(tokens) or token.kind not in WORD_KINDS or not _is_in(place, *COMPUTED):
        return None
    others: frozenset[str] = frozenset()
    right = "parameter"
    if tokens[at + 1].kind not in QUOTED_KINDS:
        right, others = "received", _RECEIVED
    if right == "received" and tokens[at + 1].text != ".":
        return None
    if token.text == right or not (token.text in others or nearest(token.text, [right])):
        return None
    message = found.message if at == place.at else f"expected a value, not `{token.text}`"
    fix = write(right, token.span)
    return found._replace(
        message=message, span=token.span, help=f"did you mean `{right}`?", fix=fix
    )


def of_node(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `patrol.speed` for what a parameter holds."""
    at = place.at
    is_value = place.text(at - 1) == "=" and _is_in(place, Form.VALUES)
    is_path = place.text(at + 1) == "." and place.is_name(at) and place.is_name(at + 2)
    if not is_value or not is_path or place.text(at + 3) in (".", "="):
        return None
    right = f"parameter '{place.text(at + 2)}'"
    return found._replace(
        help=f"what a parameter holds is written `{right}`",
        span=place.span(at, at + 3),
        fix=write(right, place.span(at, at + 3)),
    )


def unquoted_parameter(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `parameter speed`."""
    is_after = place.text(place.at - 1) == "parameter" and place.is_name(place.at)
    if not is_after or not _is_in(place, *COMPUTED):
        return None
    return unquoted(f"expected {SlotKind.PARAMETER.words}", place.token.span, place.token.text)


def sign(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `-received.x`."""
    end = _operand(place, place.at + 1) if place.token.text == "-" else None
    if end is None or not _is_in(place, Form.VALUES, Form.VALUE):
        return None
    right = f"{place.written(place.at + 1, end)} * -1"
    return mended(found, "only a number has a sign", place.span(place.at, end), right)


def number_first(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `2 * received.x`, and other calculations that begin with something else."""
    at, before, operator = place.at, place.before, place.token.text
    if operator not in ARITHMETIC or not _is_in(place, Form.VALUES, Form.VALUE):
        return None
    if before is None or before.kind not in (*_VALUE_KINDS, ")"):
        return None
    end = _operand(place, at + 1)
    if before.kind != "number" or end is None or operator == "/":
        return found._replace(help=_IN_CODE)
    first = place.written(at + 1, end)
    over = end
    while place.text(over) in ARITHMETIC and over + 1 < len(place.tokens):
        over = _operand(place, over + 1) or over + 2
    rest = place.written(end, over) if over > end else ""
    after = f" {rest}" if rest else ""
    right = {
        "*": f"{first} * {before.text}{after}",
        "+": f"{first}{after} + {before.text}",
        "-": f"{first} * -1{after} + {before.text}",
    }[operator]
    return mended(found, found.message, place.span(at - 1, over), right)


def text_in_condition(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `received.x = 'left'`."""
    is_compared = place.text(place.at - 1) in _TURNED and _is_in(place, Form.CONDITION)
    if not is_compared or place.token.kind not in QUOTED_KINDS:
        return None
    right = f'"{place.token.text[1:-1]}"'
    return mended(found, "a text is in double quotes", place.token.span, right)


def more_than_said(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise brackets in a calculation, `received.a < received.b`, and `and`."""
    before = place.text(place.at - 1)
    is_value = _operand(place, place.at) is not None
    if before in _TURNED and is_value and _is_in(place, Form.CONDITION):
        return found._replace(help="what compares two values is code in the node")
    if place.token.text in ("and", "or") and _is_in(place, Form.CONDITION):
        return found._replace(help="what compares more is code in the node")
    if before in ARITHMETIC and place.token.text == "(":
        return found._replace(help=_IN_CODE)
    return None


def called(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `received.x(1)`."""
    at = place.at
    if place.token.text != "(" or not place.text(at + 1).isdigit() or place.text(at + 2) != ")":
        return None
    starts = (first for first in range(at) if is_received(place.tokens, first))
    if all(end_of_received(place.tokens, first) != at for first in starts):
        return None
    what = "the number of an element is in square brackets"
    return mended(found, what, place.span(at, at + 3), f"[{place.text(at + 1)}]")


def loose_list(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `default 1, 2` of a list."""
    first = max((index for index in place.slots if index <= place.at), default=0)
    is_list = any(token.text.endswith("_list") for token in place.tokens[:first])
    if place.within is not SlotKind.DEFAULT or place.token.text != "," or not is_list:
        return None

    def is_part(token: Token) -> bool:
        return token.kind in _VALUE_KINDS or token.text == ","

    end = first + sum(1 for _ in takewhile(is_part, place.tokens[first:]))
    right = f"[{place.written(first, end)}]"
    is_sound = end > place.at + 1 and place.text(end - 1) != ","
    span = Span(place.tokens[first].start, place.tokens[end - 1].end)
    return mended(found, "a list is in brackets", span, right) if is_sound else None


VALUE_SLIPS: tuple[Callable[[Place, Diagnostic], Diagnostic | None], ...] = (
    period,
    unit,
    comparison,
    turned,
    without_received,
    source,
    of_node,
    unquoted_parameter,
    number_first,
    sign,
    text_in_condition,
    more_than_said,
    called,
    loose_list,
)
