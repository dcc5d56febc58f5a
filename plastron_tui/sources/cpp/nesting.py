"""Texts that are nested so deep that a parser takes all of the memory for them, or dies."""

from __future__ import annotations

import re
from itertools import accumulate

MOST_NESTED = 2_000
"""Brackets within each other; what people write, or generate, has some twenty."""

_MOST_QUALIFIERS = 2_000
"""How many names one name has before it: `a::b::c` has two."""

_OPENING = b"([{"
_ROUND = re.compile(rb"[(\[{]|[)\]}]")
# Neither `a << b`, `a <= b` nor `a->b` are templates; no template goes on over the others.
_ANGLE = re.compile(rb"(?<!<)<(?![<=])|(?<!-)>|[;{}]")
_END = re.compile(rb"[;{},|+]|<<")
_STEPS = {b"<": 1, b">": -1}


def is_nested_too_deep(code: bytes) -> bool:
    """Tell whether brackets are within more others than people write."""
    if sum(map(code.count, (b"(", b"[", b"{"))) > MOST_NESTED:
        signs = (1 if each[0] in _OPENING else -1 for each in _ROUND.findall(code))
        if max(accumulate(signs), default=0) > MOST_NESTED:
            return True
    if code.count(b"<") > MOST_NESTED:
        depth = 0
        for each in _ANGLE.findall(code):
            depth = max(depth + _STEPS[each], 0) if each in _STEPS else 0
            if depth > MOST_NESTED:
                return True
    return code.count(b"::") > _MOST_QUALIFIERS and any(
        each.count(b"::") > _MOST_QUALIFIERS for each in _END.split(code)
    )
