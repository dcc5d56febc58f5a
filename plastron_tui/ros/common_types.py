"""The interface types that people use most, and those that serve a purpose.

Both are data, so that no definition is read while somebody types.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

from .catalog.data import load, purposes
from .interfaces import InterfaceKind, InterfaceName

_FILE = Path(__file__).parent / "data" / "common_types.yaml"
_WORD = re.compile(r"[a-z]+")
_FILLERS = frozenset(("and", "are", "for", "how", "its", "not", "that", "the", "what", "with"))
_IN_LINE = 40
"""How much a word counts that is in the line about a type; those beside it count less and less."""
_COMMON = 36
"""So many of the types count more for being common, the first the most."""

LEAST_PURPOSE = 3
"""Letters from which on a word may be one of purpose."""


@cache
def _listed(kind: InterfaceKind) -> Sequence[InterfaceName]:
    """Return the most common types of a kind, the most common first."""
    return [InterfaceName(*name.split("/")) for name in load(_FILE)[kind.value].split()]


@cache
def _places(kind: InterfaceKind) -> Mapping[InterfaceName, int]:
    """Return how common the types of a kind are: 0 for the most common."""
    names = dict.fromkeys([*_listed(kind), *_described(kind)])
    return {name: place for place, name in enumerate(names)}


def most_common_first(names: Iterable[InterfaceName], kind: InterfaceKind) -> list[InterfaceName]:
    """Return types in the order in which people want them; unknown ones keep their order."""
    places = _places(kind)
    return sorted(names, key=lambda name: places.get(name, len(places)))


@cache
def _described(kind: InterfaceKind) -> Mapping[InterfaceName, tuple[str, Mapping[str, int]]]:
    """Return of each type that is described its line, and its words with how much they count."""
    found = {}
    for full_name, text in purposes()[kind.value].items():
        line, _, words = text.partition(" | ")
        weights = dict.fromkeys(_WORD.findall(line.lower()), _IN_LINE)
        for place, word in enumerate(words.split()):
            weights.setdefault(word, max(1, _IN_LINE - 1 - place))
        found[InterfaceName(*full_name.split("/"))] = (line, weights)
    return found


def line_about(name: InterfaceName, kind: InterfaceKind) -> str:
    """Return the line that says what a type is for, "" for one that nobody has described."""
    line, _ = _described(kind).get(name, ("", {}))
    return line


class ForPurpose(NamedTuple):
    """A type that a word of purpose leads to.

    `line` says what it is for; `is_whole` whether the word is all there, or half written.
    """

    name: InterfaceName
    line: str
    is_whole: bool


def types_for(word: str, names: Iterable[InterfaceName], kind: InterfaceKind) -> list[ForPurpose]:
    """Return the types, out of some, that a word such as `speed` leads to, the best first."""
    wanted = word.lower()
    if len(wanted) < LEAST_PURPOSE or wanted in _FILLERS:
        return []
    places, described = _places(kind), _described(kind)
    found = []
    for name in names:
        line, weights = described.get(name, ("", {}))
        begun = [weight for known, weight in weights.items() if known.startswith(wanted)]
        if begun:
            common = max(0, _COMMON - places[name])
            score = max(begun) + common
            found.append((wanted not in weights, -score, ForPurpose(name, line, wanted in weights)))
    return [each for *_, each in sorted(found)]
