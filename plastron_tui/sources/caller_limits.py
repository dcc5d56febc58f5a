"""How far callers are asked what they give a function: their own callers are asked in turn."""

from __future__ import annotations

MOST_STEPS = 8
"""How many names are followed one behind the other."""
_MOST_CALLS = 16
_MOST_BRANCHED = 2


def are_followed(count: int, depth: int) -> bool:
    """Tell whether so many callers are asked, that many steps from where one began.

    Each of several asks several again, unless an end is put to it.
    """
    return count <= (_MOST_CALLS if depth <= _MOST_BRANCHED else 1)
