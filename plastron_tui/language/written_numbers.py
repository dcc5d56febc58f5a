"""Numbers as other people write them: with names, units, `pi` or a comma for the point."""

from __future__ import annotations

import math
import re
from typing import NamedTuple

from plastron_tui.diagnostics import Span

from .mistake_place import Place
from .tokens import Token

_MOST = 400
"""How many bytes of a line are looked at; nobody slips over more."""

_UNSIGNED = r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
_PI = rf"(?:{_UNSIGNED}\s*\*\s*)?(?:math\.|np\.|M_)?(?:pi|PI|π)\b(?:\s*/\s*{_UNSIGNED})?"
TERM = rf"[+-]?(?:{_PI}|{_UNSIGNED})"
"""The pattern of a number, or of a part of a circle."""

_UNIT = r"°|deg(?:rees?)?|rad(?:ians?)?|mm|cm|m(?:et(?:er|re)s?)?"
_PART = re.compile(
    rf"(?:(x|y|z|roll|pitch|yaw)\s*[=:]?\s*)?({TERM})(?:\s*({_UNIT})(?![\w/²³]))?", re.IGNORECASE
)
_OF_PI = re.compile(rf"([+-]?)(?:({_UNSIGNED})\s*\*\s*)?[a-zA-Z_.]*(?:pi|PI|π)(?:\s*/\s*(.+))?")

_DECIMAL = r"[+-]?\d+(?:,\d+)?"
_DECIMALS = re.compile(rf"{_DECIMAL}(?:(?:,|\s*;)\s+{_DECIMAL})*")

_SIGNED = rf"[+-]?{_UNSIGNED}"
_ENCLOSED = re.compile(
    rf"""(?:size\s*=\s*)?[(\["]\s*({_SIGNED}(?:(?:\s*,\s*|\s+){_SIGNED})*)\s*[)\]"]"""
)

METRES = {"m": 1, "cm": 0.01, "mm": 0.001}
"""How many metres a unit is."""


class WrittenNumber(NamedTuple):
    """A number as somebody wrote it, with its name and its unit, "" for none."""

    name: str
    text: str
    unit: str

    @property
    def in_metres(self) -> str | None:
        """The number in metres; None where its unit is none of lengths."""
        factor = METRES.get(self.unit or "m")
        if factor is None:
            return None
        return self.text if factor == 1 else rounded(float(self.text) * factor)


def rounded(number: float) -> str | None:
    """Return a number as a program has it; None for one too large."""
    return f"{number:.6g}" if math.isfinite(number) else None


def number_at(text: str, at: int) -> tuple[WrittenNumber, int] | None:
    """Return a number that begins at a place of a text, and where it ends; None for none."""
    found = _PART.match(text, at)
    number = None if found is None else in_digits(found[2])
    if found is None or number is None:
        return None
    name, unit = found[1] or "", found[3] or ""
    return WrittenNumber(name.lower(), number, _unit(unit.lower())), found.end()


def _unit(word: str) -> str:
    if word.startswith(("d", "°")):
        return "deg"
    return "rad" if word.startswith("r") else "m" if word.startswith("me") else word


def is_unit(word: str) -> bool:
    """Tell whether a word is a unit of angles or of lengths."""
    return re.fullmatch(_UNIT, word, re.IGNORECASE) is not None


def in_digits(number: str) -> str | None:
    """Return a number as the language has it: `pi` is written in digits.

    None for what is no number, as `pi/0`.
    """
    found = _OF_PI.fullmatch(number)
    if found is None:
        return number
    value, divisor = float(found[2] or 1) * math.pi, float(found[3] or 1)
    digits = rounded(value / divisor) if divisor else None
    return None if digits is None else f"{found[1]}{digits}"


def with_points(text: str) -> str | None:
    """Return numbers that have a comma for the point, as in `0,4, 0,3`, as the language has them.

    None for numbers that have none.
    """
    if len(text) > _MOST or not re.search(r"\d,\d", text) or not _DECIMALS.fullmatch(text):
        return None
    return ", ".join(each.replace(",", ".") for each in re.findall(_DECIMAL, text))


def without_enclosure(text: str) -> str | None:
    """Return numbers that stand in brackets, or in quotes as in URDF, as the language has them.

    None for numbers that do not.
    """
    found = _ENCLOSED.fullmatch(text) if len(text) <= _MOST else None
    return None if found is None else ", ".join(found[1].replace(",", " ").split())


def written_from(place: Place, token: Token) -> str:
    """Return what is written from a token on, on its line."""
    line = place.source[token.start : token.start + _MOST].partition(b"\n")[0]
    return line.decode("utf-8", "ignore")


def span_from(token: Token, text: str) -> Span:
    """Return where a text stands that begins with a token."""
    return Span(token.start, token.start + len(text.encode()))


def is_same(right: str, written: str) -> bool:
    """Tell whether two texts differ in no more than space."""
    return "".join(right.split()) == "".join(written.split())
