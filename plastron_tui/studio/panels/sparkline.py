"""A small curve of numbers, in a few characters."""

from __future__ import annotations

from collections.abc import Sequence

_BARS = "▁▂▃▄▅▆▇█"


def sparkline(samples: Sequence[float], cells: int) -> str:
    """Return the latest numbers as bars, between the least and the greatest of them.

    Numbers that are all the same have none.
    """
    shown = list(samples)[-cells:] if cells > 0 else []
    if not shown:
        return ""
    low, high = min(shown), max(shown)
    if high == low:
        return ""
    top = len(_BARS) - 1
    # Halves, so that the span of the greatest floats does not overflow.
    span = high / 2 - low / 2
    return "".join(_BARS[round((each / 2 - low / 2) / span * top)] for each in shown)
