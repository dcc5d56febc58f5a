"""Names that a slip of the finger tells apart, where no other thing is meant."""

from __future__ import annotations

import re

LONGEST = 100
"""The longest name that is looked at, in characters: each of them may be the slip."""

_OPPOSITES = frozenset(
    frozenset(pair.split()) for pair in ("ping pong", "near rear", "get set", "send sent")
)
"""Words of a letter's difference that people name two things by."""
_SERIES = tuple(map(frozenset, ("xyz", "rpy", "rgb", "lr", "abcd")))
"""Letters that people tell things of a kind apart by."""


def shortened(name: str) -> set[str]:
    """Return a name, and it without each of its characters: names one slip apart share one."""
    return {name, *(name[:at] + name[at + 1 :] for at in range(len(name)))}


def is_slip(one: str, other: str) -> bool:
    """Tell whether a slip of the finger makes one name the other, and no other thing is meant."""
    if abs(len(one) - len(other)) > 1:
        return False
    start = _common(one, other)
    end = _common(one[start:][::-1], other[start:][::-1])
    a, b = one[start : len(one) - end], other[start : len(other) - end]
    if max(len(a), len(b)) != 1 and (len(a) != 2 or a != b[::-1]):
        return False
    words = set(re.split("[_/]", one)) ^ set(re.split("[_/]", other))
    return (
        not any(char.isdigit() for char in a + b)
        and all(len(word) > 1 for word in words)
        and (not words or max(map(len, words)) > 2)
        and words not in _OPPOSITES
        and not any({a, b} <= series for series in _SERIES)
    )


def _common(one: str, other: str) -> int:
    """Return how many characters two texts begin with alike."""
    pairs = enumerate(zip(one, other, strict=False))
    return next((at for at, (a, b) in pairs if a != b), min(len(one), len(other)))
