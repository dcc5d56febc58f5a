"""Common slips of the pen in the numbers of robots: places, angles, limits, and their units."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span

from .declaration import Form, SlotKind
from .mistake_place import Place, mended
from .tokens import Token, is_glued
from .written_numbers import (
    WrittenNumber,
    is_same,
    is_unit,
    number_at,
    span_from,
    written_from,
)

_BY = re.compile(r"\s*[x×*,;]\s*(?=[\d.])|\s+(?=[\d.])")
_COMMA = re.compile(r"\s*[,;]\s*|\s+")
_CLOSING = re.compile(r"\s*[)\]]")
_DECIMAL = r"([+-]?\d+(?:,\d+)?)"
_DECIMALS = re.compile(r"(?:\s*;\s*|,?\s+)".join([_DECIMAL] * 3) + r"(?!\s*[,;.\w])")

_MOST_SIZES = 3
_NAMES = (("x", "y", "z"), ("roll", "pitch", "yaw"))
_TURN = 2 * math.pi


def vector(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `0 0 1`, `(0, 0, 1)`, `x=0, y=0, z=1`, `0 m, 0 m, 1 m` and `pi/2`."""
    token = _first_of_vector(place)
    if token is None:
        return None
    text = written_from(place, token)
    numbers: list[WrittenNumber] = []
    is_open = text[:1] in ("(", "[")
    at = int(is_open)
    for _ in range(3):
        if numbers or is_open:
            comma = _COMMA.match(text, at)
            at = at if comma is None else comma.end()
        number = number_at(text, at)
        if number is None:
            return None
        numbers.append(number[0])
        at = number[1]
    closing = _CLOSING.match(text, at) if is_open else None
    at = at if closing is None else closing.end()
    if text[at:].lstrip()[:1] in tuple(",;."):
        return None
    is_angle = place.within is SlotKind.ROTATION
    right = _as_vector(numbers, is_angle=is_angle)
    if right is None or is_same(right, text[:at]):
        return None
    return mended(
        found, _what_differs(numbers, text[:at], is_angle), span_from(token, text[:at]), right
    )


def sizes(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `box 1 2 3`, `box 1 x 2 x 3` and `box 1 m, 2 m, 3 m`."""
    first = max((index for index in place.slots if index <= place.at), default=place.at)
    if place.within is not SlotKind.SIZE or found.span is None:
        return None
    token = place.tokens[first]
    text = written_from(place, token)
    numbers: list[str | None] = []
    end = at = 0
    while (number := number_at(text, at)) is not None and not number[0].name:
        numbers.append(number[0].in_metres)
        end = number[1]
        by = _BY.match(text, end)
        at = end if by is None else by.end()
    is_known = None not in numbers and len(numbers) <= _MOST_SIZES
    right = ", ".join(filter(None, numbers)) if is_known else None
    is_here = found.span.start < token.start + len(text[:end].encode())
    if not right or is_same(right, text[:end]) or not is_here:
        return None
    is_unit = re.search("[a-wyz]", text[:end].lower().replace("e", "")) is not None
    what = "a number has no unit; ROS measures in metres"
    what = what if is_unit else "numbers have commas between them"
    return mended(found, what, span_from(token, text[:end]), right)


def _first_of_vector(place: Place) -> Token | None:
    first = max((index for index in place.slots if index <= place.at), default=None)
    if first is None or first >= len(place.tokens):
        return None
    return place.tokens[first] if place.slots[first].form is Form.VECTOR else None


def _as_vector(numbers: Sequence[WrittenNumber], *, is_angle: bool) -> str | None:
    """Return three numbers as the language has them, None where they are not of one kind."""
    names = tuple(each.name for each in numbers)
    if any(names):
        order = next((each for each in _NAMES if sorted(each) == sorted(names)), None)
        if order is None:
            return None
        numbers = sorted(numbers, key=lambda each: order.index(each.name))
    units = {each.unit for each in numbers} - {""}
    if not is_angle:
        texts = [each.in_metres for each in numbers]
        return None if None in texts else ", ".join(filter(None, texts))
    if len(units) > 1 or not units <= {"deg", "rad"}:
        return None
    return " ".join([", ".join(each.text for each in numbers), *units])


def _what_differs(numbers: Sequence[WrittenNumber], text: str, is_angle: bool) -> str:
    if text[0] in "([":
        return "three numbers stand without brackets"
    if any(each.name for each in numbers):
        return f"three numbers stand without names, {'roll' if is_angle else 'x'} first"
    if "°" in text:
        return "degrees are written as `deg`"
    if re.search("pi|π", text, re.IGNORECASE):
        return "a number is written in digits"
    if any(each.unit for each in numbers[:2]) or (numbers[2].unit and not is_angle):
        once = "the unit stands once, behind the three angles"
        return once if is_angle else "a number has no unit; ROS measures in metres"
    return "numbers have commas between them"


def decimals(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `0,4, 0,3, 0,1` where three numbers are wanted, and `1,5` where one is."""
    what = "a fraction has a point, not a comma"
    token = _first_of_vector(place)
    if token is not None:
        parts = _DECIMALS.match(written_from(place, token))
        if parts is None or "," not in "".join(parts.groups()):
            return None
        right = ", ".join(each.replace(",", ".") for each in parts.groups())
        return mended(found, what, span_from(token, parts[0]), right)
    at, tokens = place.at, place.tokens
    is_number = place.within is not None and place.within.form in (Form.NUMBER, Form.RATE)
    if not is_number or place.token.text != "," or not place.text(at + 1).isdigit():
        return None
    is_one = is_glued(tokens, at) and is_glued(tokens, at + 1)
    whole = place.text(at - 1)
    if not is_one or not whole.lstrip("+-").isdigit():
        return None
    return mended(found, what, place.span(at - 1, at + 2), f"{whole}.{place.text(at + 1)}")


def missing_unit(kind: SlotKind | None, numbers: Sequence[str]) -> str | None:
    """Return the unit that numbers without one are in, None where that cannot be told.

    Nobody writes 90 rad. A fraction that is small is no number of degrees; where lengths may stand
    as well, it might be one.
    """
    if not numbers:
        return None
    values = [float(each) for each in numbers]
    if any(abs(each) > _TURN for each in values):
        return "deg"
    if kind is SlotKind.ANGLE_UNIT and not all(each.is_integer() for each in values):
        return "rad"
    return None


def unit_left_out(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `turned 0, 0, 90` and `between -90 and 90`, at their ends and before a clause."""
    at = place.at
    kind = place.slots.get(at)
    if kind not in (SlotKind.ANGLE_UNIT, SlotKind.LIMIT_UNIT):
        return None
    before = place.tokens[:at]
    first = max((index for index in place.slots if index < at), default=at)
    if kind is SlotKind.LIMIT_UNIT:
        first -= 2
    numbers = [token.text for token in before[first:] if token.kind == "number"]
    if len(numbers) != (3 if kind is SlotKind.ANGLE_UNIT else 2):
        return None
    unit = missing_unit(kind, numbers)
    if unit is None:
        help_ = "angles are in `deg` or `rad`"
        if kind is SlotKind.LIMIT_UNIT:
            help_ += ", what slides is in `m`"
        return found._replace(help=help_)
    end = before[-1].end
    fix = Fix(f"write `{unit}`", (Edit(Span(end, end), f" {unit}"),))
    return found._replace(help=f"write `{numbers[-1]} {unit}`", fix=fix)


def third_left_out(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `at 1, 2`, of somebody who thinks of the ground."""
    at = place.at
    first = max((index for index in place.slots if index < at), default=at)
    between = [token.text for token in place.tokens[first + 1 : at : 2]]
    is_place = place.slots.get(first) is SlotKind.POSITION and at == first + 3
    if not is_place or between != [","]:
        return None
    end = place.tokens[at - 1].end
    text = place.text(at)
    if text in (",", ";", ".") or is_unit(text):
        return None
    fix = Fix("write `, 0`", (Edit(Span(end, end), ", 0"),))
    return found._replace(
        help=f"write `{place.written(first, at)}, 0`, if it is not raised", fix=fix
    )


def one_angle(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `turned 90 deg`."""
    text, before = place.token.text, place.before
    if before is None or before.kind != "number" or not is_unit(text):
        return None
    if place.slots.get(place.at - 1) is not SlotKind.ROTATION:
        return None
    help_ = f"there are three: `0, 0, {before.text} {text}` turns about what points up"
    return found._replace(help=help_, fix=None)


LEFT_OUT: tuple[Callable[[Place, Diagnostic], Diagnostic | None], ...] = (
    unit_left_out,
    third_left_out,
)
"""Those that look at what is not there: also behind the last word of a line."""

NUMBER_SLIPS: tuple[Callable[[Place, Diagnostic], Diagnostic | None], ...] = (
    decimals,
    vector,
    sizes,
    one_angle,
    *LEFT_OUT,
)
