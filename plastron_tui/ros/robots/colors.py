"""Colours by names and by codes.

The names mean what they mean in CSS (CSS Color, "Named Colors"), but for `dark_gray`, which is
lighter than `gray` there.
"""

from __future__ import annotations

import re

from .description import Rgba

NAMES: dict[str, str] = {
    "black": "#000000",
    "dark_gray": "#404040",
    "gray": "#808080",
    "light_gray": "#d3d3d3",
    "silver": "#c0c0c0",
    "white": "#ffffff",
    "red": "#ff0000",
    "dark_red": "#8b0000",
    "orange": "#ffa500",
    "gold": "#ffd700",
    "yellow": "#ffff00",
    "green": "#008000",
    "lime": "#00ff00",
    "dark_green": "#006400",
    "teal": "#008080",
    "cyan": "#00ffff",
    "blue": "#0000ff",
    "navy": "#000080",
    "light_blue": "#add8e6",
    "purple": "#800080",
    "magenta": "#ff00ff",
    "pink": "#ffc0cb",
    "brown": "#a52a2a",
    "tan": "#d2b48c",
}
"""The codes of the colours that have names."""

_CODE = re.compile(r"#(?:[0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})")
_DIGITS = 3
"""Places behind the point: finer than what a code can say."""


def rgba_of(color: str) -> Rgba | None:
    """Return red, green, blue and opacity of a name or of a code, None for neither.

    A code is `#rgb`, `#rgba`, `#rrggbb` or `#rrggbbaa`.
    """
    code = NAMES.get(color, color)
    if not _CODE.fullmatch(code):
        return None
    digits = code[1:]
    if len(digits) < len("rrggbb"):
        digits = "".join(each * 2 for each in digits)
    parts = [round(int(digits[at : at + 2], 16) / 255, _DIGITS) for at in range(0, len(digits), 2)]
    red, green, blue, opacity = (*parts, 1.0)[:4]
    return red, green, blue, opacity


def material_name(color: str) -> str:
    """Return what a material of a colour is called: a code has no `#` there."""
    return color if color in NAMES else f"color_{color.removeprefix('#').lower()}"
