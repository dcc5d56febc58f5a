"""What completion offers for types, packages, launch files and robots."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from plastron_tui.language import SlotKind
from plastron_tui.language.expectations import Expectation

from .candidate import Candidate, Offer
from .robot_completion import OFFERS as ROBOT_OFFERS
from .vocabulary import Vocabulary

_FIELDS = (
    ("float64", "a number with a fraction"),
    ("int32", "a whole number"),
    ("bool", "true or false"),
    ("string", "a text"),
    ("uint8", "a whole number from 0 to 255"),
    ("float32", "a number with a fraction, half as large"),
    ("int64", "a large whole number"),
)
"""The types of most fields."""

_LICENSES = ("Apache-2.0", "BSD-3-Clause", "MIT", "GPL-3.0-only", "LGPL-3.0-only", "MPL-2.0")
_SECTIONS = ("request", "response", "goal", "result", "feedback")


def _known(found: Mapping[str, str]) -> Iterator[Candidate]:
    yield from (Candidate(name, about) for name, about in found.items())


def _items(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    yield from _known({**vocabulary.nodes, **vocabulary.launches, **vocabulary.robots})


def _fields(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer types where a field begins, at a comma; a name is for the user to find."""
    written = expected.written
    if not written or written[-1] == ",":
        yield from (Candidate(name, about, " ") for name, about in _FIELDS)
        yield from (Candidate(name, about, " ") for name, about in vocabulary.types.items())


def _started(expected: Expectation, vocabulary: Vocabulary) -> Iterator[Candidate]:
    """Offer what a launch file starts, to one that is to be started no longer."""
    declaration = expected.declaration
    if declaration is not None and declaration.undoes is not None:
        names = vocabulary.started(expected.filled.get("launch", ""))
        yield from (Candidate(f"'{name}'") for name in names)


OFFERS: Mapping[SlotKind, Offer] = {
    SlotKind.OWN_TYPE: lambda _, vocabulary: _known(vocabulary.types),
    SlotKind.PACKAGE: lambda _, vocabulary: _known(vocabulary.packages),
    SlotKind.LAUNCH: lambda _, vocabulary: _known(vocabulary.launches),
    SlotKind.ITEM: _items,
    SlotKind.STARTED: lambda _, vocabulary: _known(vocabulary.nodes),
    SlotKind.HELD: lambda expected, vocabulary: _known(
        vocabulary.contents(expected.filled.get("package", ""))
    ),
    SlotKind.RUN_NAME: _started,
    SlotKind.FIELDS: _fields,
    SlotKind.LICENSE: lambda *_: (Candidate(f'"{name}"') for name in _LICENSES),
    SlotKind.SECTION: lambda *_: (Candidate(name) for name in _SECTIONS),
    **ROBOT_OFFERS,
}
"""What may fill each kind of slot."""
