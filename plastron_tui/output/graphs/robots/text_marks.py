"""The signs of pictures in characters, and what stands for them in ASCII."""

from __future__ import annotations

from collections.abc import Iterable
from math import atan2, hypot, pi

from .views import Point

_ARROWS = "→↗↑↖←↙↓↘"
_FILLS = "#%@O+=*8xWoXHZNS"
"""What bodies are filled with where there are no colours, one after the other."""

_ASCII = str.maketrans({
    "×": "x", "°": " deg", "…": "~", "·": ",", "■": "#", "│": "|", "├": "+", "└": "`", "↓": "v",
    "→": ">", "←": "<", "↑": "^", "↗": "/", "↙": "/", "↖": "\\", "↘": "\\", "⊙": "o", "⊗": "x",
    "◇": "?", "●": "*", "─": "-", "┤": "|", "²": "2",
})  # fmt: skip

TOWARD, AWAY, UNKNOWN, MIDDLE = "⊙", "⊗", "◇", "●"
"""An axis that points at who looks, one that points away, a mesh of unknown size, a joint."""

_ENDWAYS = 0.35
"""An axis that is seen shorter than this has no arrow, but a sign."""


def in_ascii(text: str) -> str:
    """Return a text with what stands for its signs in ASCII."""
    if text.isascii():
        return text
    return text.translate(_ASCII).encode("ascii", "replace").decode("ascii")


def axis_sign(along: Point, depth: float) -> str:
    """Return the sign of an axis: an arrow, or an end."""
    if hypot(along.x, along.y) < _ENDWAYS:
        return TOWARD if depth > 0 else AWAY
    return _ARROWS[round(atan2(along.y, along.x) / (pi / 4)) % len(_ARROWS)]


def fill_chars(links: Iterable[str]) -> dict[str, str]:
    """Return what fills the bodies of each link in ASCII."""
    return {name: _FILLS[at % len(_FILLS)] for at, name in enumerate(links)}
