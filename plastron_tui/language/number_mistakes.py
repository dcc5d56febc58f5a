"""Common slips of the pen in the numbers of robots: places, angles, limits, and their units."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Edit, Fix, Span

from .declaration import Form, SlotKind
from .mistake_place import Place, mended
from .statements.robots import LimitsJoint
from .tokens import Token, is_glued

_MOST = 400
"""How many bytes of a line are looked at; nobody slips over more."""

_UNSIGNED = r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
_PI = rf"(?:{_UNSIGNED}\s*\*\s*)?(?:math\.|np\.|M_)?(?:pi|PI|π)\b(?:\s*/\s*{_UNSIGNED})?"
_TERM = rf"[+-]?(?:{_PI}|{_UNSIGNED})"
_UNIT = r"°|deg(?:rees?)?|rad(?:ians?)?|mm|cm|m(?:et(?:er|re)s?)?"
_PART = re.compile(
    rf"(?:(x|y|z|roll|pitch|yaw)\s*[=:]?\s*)?({_TERM})(?:\s*({_UNIT})(?![\w/²³]))?", re.IGNORECASE
)
_BY = re.compile(r"\s*[x×*,;]\s*(?=[\d.])|\s+(?=[\d.])")
_COMMA = re.compile(r"\s*[,;]\s*|\s+")
_DECIMAL = r"([+-]?\d+(?:,\d+)?)"
_DECIMALS = re.compile(r"(?:\s*;\s*|,?\s+)".join([_DECIMAL] * 3) + r"(?!\s*[,;.\w])")
_OF_PI = re.compile(rf"([+-]?)(?:({_UNSIGNED})\s*\*\s*)?[a-zA-Z_.]*(?:pi|PI|π)(?:\s*/\s*(.+))?")
_LIMITS = re.compile(r"(?:between|from)?\s*")
_AND = re.compile(r"\s*(?:\band\b|\bto\b|\.\.+|[,;…–])\s*|\s+")

_FORCE = r"N\s?m|N·m|N|rad/s|deg/s|°/s|m/s|radians/s|degrees/s"
_GIVEN = rf"([a-z]+)\s*[=:]?\s*({_TERM})(?:\s*({_FORCE})(?![\w/]))?"
_PAIR = re.compile(rf"with\s+{_GIVEN}\s*(?:,|&|\band\b)?\s*(?:\bwith\s+)?{_GIVEN}")
_PAIRS = (("effort", "velocity"), ("damping", "friction"))
_SAME = {"torque": "effort", "force": "effort", "speed": "velocity"}

_MOST_SIZES = 3
FIRST_CLAUSE = 3
"""Where the first clause of a link, or of a joint's limits, begins."""

_METRES = {"m": 1, "cm": 0.01, "mm": 0.001}
_NAMES = (("x", "y", "z"), ("roll", "pitch", "yaw"))
_TURN = 2 * math.pi


class _Number(NamedTuple):
    """A number as somebody wrote it, with its name and its unit, "" for none."""

    name: str
    text: str
    unit: str


def _written_from(place: Place, token: Token) -> str:
    """Return what is written from a token on, on its line."""
    line = place.source[token.start : token.start + _MOST].partition(b"\n")[0]
    return line.decode("utf-8", "ignore")


def _span(token: Token, text: str) -> Span:
    return Span(token.start, token.start + len(text.encode()))


def _is_same(right: str, written: str) -> bool:
    """Tell whether two texts differ in no more than space."""
    return "".join(right.split()) == "".join(written.split())


def _number(text: str, at: int) -> tuple[_Number, int] | None:
    """Return a number that begins at a place of a text, and where it ends."""
    found = _PART.match(text, at)
    if found is None:
        return None
    name, number, unit = found[1] or "", found[2], found[3] or ""
    return _Number(name.lower(), _in_digits(number), _unit(unit.lower())), found.end()


def _unit(word: str) -> str:
    if word.startswith(("d", "°")):
        return "deg"
    return "rad" if word.startswith("r") else "m" if word.startswith("me") else word


def _is_unit(word: str) -> bool:
    return re.fullmatch(_UNIT, word, re.IGNORECASE) is not None


def _in_digits(number: str) -> str:
    """Return a number as the language has it: `pi` is written in digits."""
    found = _OF_PI.fullmatch(number)
    if found is None:
        return number
    value = float(found[2] or 1) * math.pi
    divisor = float(found[3] or 1)
    return f"{found[1]}{value / divisor:.6g}" if divisor else number


def vector(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `0 0 1`, `(0, 0, 1)`, `x=0, y=0, z=1`, `0 m, 0 m, 1 m` and `pi/2`."""
    token = _first_of_vector(place)
    if token is None:
        return None
    text = _written_from(place, token)
    numbers: list[_Number] = []
    at = len(text[:1].strip("([")) ^ 1
    is_open = at > 0
    for _ in range(3):
        if numbers or is_open:
            comma = _COMMA.match(text, at)
            at = at if comma is None else comma.end()
        number = _number(text, at)
        if number is None:
            return None
        numbers.append(number[0])
        at = number[1]
    closing = re.compile(r"\s*[)\]]").match(text, at) if is_open else None
    at = at if closing is None else closing.end()
    if text[at:].lstrip()[:1] in tuple(",;."):
        return None
    is_angle = place.within is SlotKind.ROTATION
    right = _as_vector(numbers, is_angle=is_angle)
    if right is None or _is_same(right, text[:at]):
        return None
    return mended(
        found, _what_differs(numbers, text[:at], is_angle), _span(token, text[:at]), right
    )


def sizes(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `box 1 2 3`, `box 1 x 2 x 3` and `box 1 m, 2 m, 3 m`."""
    first = max((index for index in place.slots if index <= place.at), default=place.at)
    if place.within is not SlotKind.SIZE or found.span is None:
        return None
    token = place.tokens[first]
    text = _written_from(place, token)
    numbers: list[str | None] = []
    end = at = 0
    while (number := _number(text, at)) is not None and not number[0].name:
        numbers.append(_in_metres(number[0]))
        end = number[1]
        by = _BY.match(text, end)
        at = end if by is None else by.end()
    is_known = None not in numbers and len(numbers) <= _MOST_SIZES
    right = ", ".join(filter(None, numbers)) if is_known else None
    is_here = found.span.start < token.start + len(text[:end].encode())
    if not right or _is_same(right, text[:end]) or not is_here:
        return None
    is_unit = re.search("[a-wyz]", text[:end].lower().replace("e", "")) is not None
    what = "a number has no unit; ROS measures in metres"
    what = what if is_unit else "numbers have commas between them"
    return mended(found, what, _span(token, text[:end]), right)


def _first_of_vector(place: Place) -> Token | None:
    first = max((index for index in place.slots if index <= place.at), default=None)
    if first is None or first >= len(place.tokens):
        return None
    return place.tokens[first] if place.slots[first].form is Form.VECTOR else None


def _as_vector(numbers: Sequence[_Number], *, is_angle: bool) -> str | None:
    """Return three numbers as the language has them, None where they are not of one kind."""
    names = tuple(each.name for each in numbers)
    if any(names):
        order = next((each for each in _NAMES if sorted(each) == sorted(names)), None)
        if order is None:
            return None
        numbers = sorted(numbers, key=lambda each: order.index(each.name))
    units = {each.unit for each in numbers} - {""}
    if not is_angle:
        texts = [_in_metres(each) for each in numbers]
        return None if None in texts else ", ".join(filter(None, texts))
    if len(units) > 1 or not units <= {"deg", "rad"}:
        return None
    return " ".join([", ".join(each.text for each in numbers), *units])


def _in_metres(number: _Number) -> str | None:
    factor = _METRES.get(number.unit or "m")
    if factor is None:
        return None
    return number.text if factor == 1 else f"{float(number.text) * factor:.6g}"


def _what_differs(numbers: Sequence[_Number], text: str, is_angle: bool) -> str:
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
        parts = _DECIMALS.match(_written_from(place, token))
        if parts is None or "," not in "".join(parts.groups()):
            return None
        right = ", ".join(each.replace(",", ".") for each in parts.groups())
        return mended(found, what, _span(token, parts[0]), right)
    at, tokens = place.at, place.tokens
    is_number = place.within is not None and place.within.form in (Form.NUMBER, Form.RATE)
    if not is_number or place.token.text != "," or not place.text(at + 1).isdigit():
        return None
    is_one = is_glued(tokens, at) and is_glued(tokens, at + 1)
    whole = place.text(at - 1)
    if not is_one or not whole.lstrip("+-").isdigit():
        return None
    return mended(found, what, place.span(at - 1, at + 2), f"{whole}.{place.text(at + 1)}")


def limits(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `between -90 deg and 90 deg`, `from -90 to 90 deg`, `between -pi and pi rad`."""
    at = place.at
    if not _is_limits(place) or at < FIRST_CLAUSE or place.token.text == "with":
        return None
    first = next(
        (i for i in range(at, FIRST_CLAUSE - 1, -1) if place.text(i) in ("between", "from")), at
    )
    token = place.tokens[first]
    text = _written_from(place, token)
    begun = _LIMITS.match(text)
    least = _number(text, 0 if begun is None else begun.end())
    comma = None if least is None else _AND.match(text, least[1])
    most = None if comma is None else _number(text, comma.end())
    if least is None or most is None or (least[0].name or most[0].name):
        return None
    units = {least[0].unit, most[0].unit} - {""}
    if len(units) > 1:
        return None
    unit = next(iter(units), "")
    ends = [each[0]._replace(unit=unit) for each in (least, most)]
    numbers = [each.text if unit in ("", "deg", "rad") else _in_metres(each) for each in ends]
    units = {"m"} if unit in _METRES else units
    right = " ".join([f"between {numbers[0]} and {numbers[1]}", *units])
    written = text[: most[1]]
    span = _span(token, written)
    is_within = found.span is not None and span.start <= found.span.start <= span.end
    if _is_same(right, written) or not is_within:
        return None
    what = "limits are two numbers with `and` between them, and then their unit"
    return mended(found, what, span, right)


def _is_limits(place: Place) -> bool:
    return place.declaration is not None and place.declaration.type is LimitsJoint


def effort(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `with velocity 1 and effort 2`, `with effort 2, velocity 1`, and their units."""
    if not _is_limits(place):
        return None
    begun_with = range(place.at, FIRST_CLAUSE - 1, -1)
    first = next((i for i in begun_with if place.text(i) == "with"), None)
    if first is None or place.text(first - 1) == "with":
        return None
    token = place.tokens[first]
    pair = _PAIR.match(_written_from(place, token))
    if pair is None:
        return None
    given = {}
    for name, number, unit in (pair.groups()[:3], pair.groups()[3:]):
        given[_SAME.get(name, name)] = _per_second(_in_digits(number), unit or "")
    names = next((each for each in _PAIRS if {*each} == given.keys()), None)
    if names is None:
        return None
    right = f"with {names[0]} {given[names[0]]} and {names[1]} {given[names[1]]}"
    if _is_same(right, pair[0]):
        return None
    what = f"`{names[0]}` stands first, and `and {names[1]}` behind it"
    if pair[3] or pair[6]:
        what = "these numbers have no units; ROS measures in N m or N, and rad/s or m/s"
    return mended(found, what, _span(token, pair[0]), right)


def _per_second(number: str, unit: str) -> str:
    if not unit.startswith(("deg", "°")):
        return number
    return f"{math.radians(float(number)):.6g}"


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
    if text in (",", ";", ".") or _is_unit(text):
        return None
    fix = Fix("write `, 0`", (Edit(Span(end, end), ", 0"),))
    return found._replace(
        help=f"write `{place.written(first, at)}, 0`, if it is not raised", fix=fix
    )


def one_angle(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `turned 90 deg`, and a unit behind the first of two limits."""
    at, text, before = place.at, place.token.text, place.before
    if before is None or before.kind != "number" or not _is_unit(text):
        return None
    if _is_limits(place) and place.within is SlotKind.BOUND:
        return found._replace(help="the unit stands once, behind the second number", fix=None)
    if place.slots.get(at - 1) is SlotKind.ROTATION:
        help_ = f"there are three: `0, 0, {before.text} {text}` turns about what points up"
        return found._replace(help=help_, fix=None)
    return None


def second_pair(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `with effort 1 and velocity 2, damping 3 and friction 4`."""
    at, before = place.at, place.before
    firsts = [first for first, _ in _PAIRS]
    is_joined = place.token.text in (",", "and") and place.text(at + 1) in firsts
    is_bare = place.token.text in firsts and place.text(at - 1) != "with"
    if not _is_limits(place) or at < FIRST_CLAUSE or not (is_joined or is_bare) or before is None:
        return None
    word = place.text(at + is_joined)
    right = "with" if is_joined else f"with {word}"
    if is_glued(place.tokens, at):
        right = f" {right}"
    what = f"`{word}` has the word `with` before it"
    return mended(found, what, place.token.span, right)._replace(help=f"write `{right.strip()}`")


LEFT_OUT: tuple[Callable[[Place, Diagnostic], Diagnostic | None], ...] = (
    unit_left_out,
    third_left_out,
)
"""Those that look at what is not there: also behind the last word of a line."""

NUMBER_SLIPS: tuple[Callable[[Place, Diagnostic], Diagnostic | None], ...] = (
    decimals,
    vector,
    sizes,
    second_pair,
    limits,
    effort,
    one_angle,
    *LEFT_OUT,
)
