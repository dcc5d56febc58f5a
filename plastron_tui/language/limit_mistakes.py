"""Common slips of the pen in the limits of joints, and what was meant."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

from plastron_tui.diagnostics import Diagnostic

from .declaration import SlotKind
from .mistake_place import Place, mended
from .statements.parameters import HasParameter
from .statements.robots import LimitsJoint
from .tokens import is_glued
from .written_numbers import (
    METRES,
    TERM,
    in_digits,
    is_same,
    is_unit,
    number_at,
    rounded,
    span_from,
    written_from,
)

_LIMITS = re.compile(r"(?:between|from)?\s*")
_AND = re.compile(r"\s*(?:\band\b|\bto\b|\.\.+|[,;…–])\s*|\s+")

_BOUNDS_WORDS = ("between", "from", "in", "range", "within", "limits")
_BOUND = r"([-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?)"
_BOUNDS = re.compile(
    rf"\w+\s*(?:range\s+)?[\[(]?\s*{_BOUND}\s*(?:,|;|\bto\b|\band\b|\.\.+|–|\s)\s*{_BOUND}"
    r"\s*[\])]?(?![^\s])"
)
_BOUNDS_BEGIN = 4
"""How many tokens before a mistake in bounds they can begin: `between`, `-`, a number, `to`."""

_FORCE = r"N\s?m|N·m|N|rad/s|deg/s|°/s|m/s|radians/s|degrees/s"
_GIVEN = rf"([a-z]+)\s*[=:]?\s*({TERM})(?:\s*({_FORCE})(?![\w/]))?"
_PAIR = re.compile(rf"with\s+{_GIVEN}\s*(?:,|&|\band\b)?\s*(?:\bwith\s+)?{_GIVEN}")
_PAIRS = (("effort", "velocity"), ("damping", "friction"))
_SAME = {"torque": "effort", "force": "effort", "speed": "velocity"}

FIRST_CLAUSE = 3
"""Where the first clause of a link, or of a joint's limits, begins."""


def limits(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `between -90 deg and 90 deg`, `from -90 to 90 deg`, `between -pi and pi rad`."""
    at = place.at
    if not _is_limits(place) or at < FIRST_CLAUSE or place.token.text == "with":
        return None
    first = next(
        (i for i in range(at, FIRST_CLAUSE - 1, -1) if place.text(i) in ("between", "from")), at
    )
    token = place.tokens[first]
    text = written_from(place, token)
    begun = _LIMITS.match(text)
    least = number_at(text, 0 if begun is None else begun.end())
    comma = None if least is None else _AND.match(text, least[1])
    most = None if comma is None else number_at(text, comma.end())
    if least is None or most is None or (least[0].name or most[0].name):
        return None
    units = {least[0].unit, most[0].unit} - {""}
    if len(units) > 1:
        return None
    unit = next(iter(units), "")
    ends = [each[0]._replace(unit=unit) for each in (least, most)]
    numbers = [each.text if unit in ("", "deg", "rad") else each.in_metres for each in ends]
    units = {"m"} if unit in METRES else units
    right = " ".join([f"between {numbers[0]} and {numbers[1]}", *units])
    written = text[: most[1]]
    span = span_from(token, written)
    is_within = found.span is not None and span.start <= found.span.start <= span.end
    if None in numbers or is_same(right, written) or not is_within:
        return None
    what = "limits are two numbers with `and` between them, and then their unit"
    return mended(found, what, span, right)


def bounds(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `from 0 to 1`, `range [0, 1]` and `between 0 to 1` behind a parameter's default."""
    if place.declaration is None or place.declaration.type is not HasParameter:
        return None
    back = range(place.at, max(place.at - _BOUNDS_BEGIN, -1), -1)
    first = next((at for at in back if place.text(at) in _BOUNDS_WORDS), None)
    if first is None:
        return None
    token = place.tokens[first]
    given = _BOUNDS.match(written_from(place, token))
    if given is None:
        return None
    right, span = f"between {given[1]} and {given[2]}", span_from(token, given[0])
    is_within = found.span is not None and span.start <= found.span.start < span.end
    if is_same(right, given[0]) or not is_within:
        return None
    what = "the bounds stand behind `between`, with `and` between them"
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
    pair = _PAIR.match(written_from(place, token))
    if pair is None:
        return None
    given = {}
    for name, number, unit in (pair.groups()[:3], pair.groups()[3:]):
        given[_SAME.get(name, name)] = _per_second(in_digits(number), unit or "")
    names = next((each for each in _PAIRS if {*each} == given.keys()), None)
    if names is None or None in given.values():
        return None
    right = f"with {names[0]} {given[names[0]]} and {names[1]} {given[names[1]]}"
    if is_same(right, pair[0]):
        return None
    what = f"`{names[0]}` stands first, and `and {names[1]}` behind it"
    if pair[3] or pair[6]:
        what = "these numbers have no units; ROS measures in N m or N, and rad/s or m/s"
    return mended(found, what, span_from(token, pair[0]), right)


def _per_second(number: str | None, unit: str) -> str | None:
    if number is None or not unit.startswith(("deg", "°")):
        return number
    return rounded(math.radians(float(number)))


def second_pair(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise `with effort 1 and velocity 2, damping 3 and friction 4`."""
    at, before = place.at, place.before
    firsts = [first for first, _ in _PAIRS]
    is_joined = place.token.text in (",", "and") and place.text(at + 1) in firsts
    is_bare = place.token.text in firsts and place.text(at - 1) not in ("with", *firsts)
    if not _is_limits(place) or at < FIRST_CLAUSE or not (is_joined or is_bare) or before is None:
        return None
    word = place.text(at + is_joined)
    right = "with" if is_joined else f"with {word}"
    if is_glued(place.tokens, at):
        right = f" {right}"
    what = f"`{word}` has the word `with` before it"
    return mended(found, what, place.token.span, right)._replace(help=f"write `{right.strip()}`")


def unit_twice(place: Place, found: Diagnostic) -> Diagnostic | None:
    """Recognise a unit behind the first of two limits, where the second is not there yet."""
    before = place.before
    if before is None or before.kind != "number" or not is_unit(place.token.text):
        return None
    if not _is_limits(place) or place.within is not SlotKind.BOUND:
        return None
    return found._replace(help="the unit stands once, behind the second number", fix=None)


LIMIT_SLIPS: tuple[Callable[[Place, Diagnostic], Diagnostic | None], ...] = (
    second_pair,
    limits,
    effort,
    unit_twice,
)
