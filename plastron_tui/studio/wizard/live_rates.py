"""How often a message is sent to a running node: once, or so many times a second."""

from __future__ import annotations

import re
from collections.abc import Mapping

from plastron_tui.ros.interfaces import FieldType

from .sent_values import Wrong
from .values import NUMBER, Entry, Path

MOST = 500.0
"""The most messages a second that a monitor sends beside its other work."""
_HZ = re.compile(rf"({NUMBER.pattern})\s*(?:hz)?", re.ASCII | re.IGNORECASE)
RATE = Entry(
    # No field of a message has a space in its name.
    ("how often",),
    FieldType("string"),
    str,
    "once, or 10 hz",
    "once, or so many times a second until x in Live, or the end of the nodes, stops it",
    default="once",
)
"""The field that is not one of the message."""


def rate_of(given: Mapping[Path, str]) -> float | Wrong:
    """Return how many messages a second are wanted, 0 for one alone, or what is wrong with it."""
    text = given.get(RATE.path, "").strip()
    if text.lower() in ("", RATE.default):
        return 0.0
    match = _HZ.fullmatch(text)
    rate = 0.0 if match is None else float(match[1])
    if 0 < rate <= MOST:
        return rate
    return Wrong(f"it is `once`, or a rate of up to {MOST:g} hz, such as 10 hz", RATE.path)
