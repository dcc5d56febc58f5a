"""What numbers of robots are likely to be of another unit."""

from __future__ import annotations

from math import pi

LONGEST = 100.0
"""Metres: what is longer may be in millimetres."""

HEAVIEST = 100_000.0
"""Kilograms: what is heavier may be in grams. An excavator has 5,000 to 100,000."""

WHOLE_TURN = 2 * pi
"""Nothing is turned by more, as it is written with few digits."""

MOST_TURNS = 4
"""How often a joint turns from its middle that has limits at all, cables and all."""

_NEAR = 2e-3
"""People write 3.14 and 1.571."""


def is_too_much_turned(angle: float) -> bool:
    """Tell whether a pose in radians may be in degrees."""
    return abs(angle) > WHOLE_TURN + _NEAR


def is_too_far_a_limit(angle: float) -> bool:
    """Tell whether the limit of a joint in radians may be in degrees."""
    return abs(angle) > MOST_TURNS * WHOLE_TURN + _NEAR


def looks_like_radians(angle: float) -> bool:
    """Tell whether a number of degrees is an eighth of a turn, or several, in radians."""
    eighths = round(abs(angle) / (pi / 4))
    return 0 < eighths <= 8 and abs(abs(angle) - eighths * pi / 4) < _NEAR
