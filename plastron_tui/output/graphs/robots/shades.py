"""The colours of bodies: darker where they are turned away, mixed where they stand back."""

from __future__ import annotations

from functools import lru_cache

from plastron_tui.ros.robots.description import Rgba

PLAIN = (0.66, 0.72, 0.78)
"""The colour of what has none: one that is seen on dark and on light."""

DARKEST = 0.7
"""How bright a face is that is nearly edge-on."""


@lru_cache(maxsize=4096)
def color_of(rgba: Rgba | None, facing: float = 1.0) -> str:
    """Return the colour of a face as `#rrggbb`, by how far it is turned to who looks."""
    bright = DARKEST + (1 - DARKEST) * facing
    red, green, blue = PLAIN if rgba is None else rgba[:3]
    return _code(red * bright, green * bright, blue * bright)


@lru_cache(maxsize=4096)
def edge_of(rgba: Rgba | None) -> str:
    """Return the colour of the edges of a body: darker, or lighter where it is dark."""
    red, green, blue = PLAIN if rgba is None else rgba[:3]
    if luma(color_of(rgba)) < _DARK:
        return _code(*(value + (1 - value) * 0.4 for value in (red, green, blue)))
    return _code(red * 0.5, green * 0.5, blue * 0.5)


_DARK = 0.25
_DARK_GREY = 0.2


@lru_cache(maxsize=4096)
def dimmed(color: str) -> str:
    """Return a colour that stands back."""
    grey = luma(color) * 0.5 + 0.15
    return _code(*(value * 0.25 + grey * 0.75 for value in _parts(color)))


@lru_cache(maxsize=4096)
def lifted(color: str) -> str:
    """Return a colour that is seen on black: what is darker than that becomes dark grey."""
    bright = luma(color)
    if bright >= _DARK_GREY:
        return color
    more = _DARK_GREY - bright
    return _code(*(value + more for value in _parts(color)))


@lru_cache(maxsize=4096)
def contrast(color: str) -> str:
    """Return the colour that is read best on another one: black or white."""
    return "#000000" if luma(color) > 0.5 else "#ffffff"


def luma(color: str) -> float:
    """Return how bright a colour is, from 0 to 1 (ITU-R BT.601)."""
    red, green, blue = _parts(color)
    return 0.299 * red + 0.587 * green + 0.114 * blue


def _parts(color: str) -> tuple[float, float, float]:
    red, green, blue = (int(color[at : at + 2], 16) / 255 for at in (1, 3, 5))
    return red, green, blue


def _code(red: float, green: float, blue: float) -> str:
    parts = (round(255 * min(max(value, 0.0), 1.0)) for value in (red, green, blue))
    return "#" + "".join(f"{part:02x}" for part in parts)
