"""What the fields of common messages mean: their units, a few words, a value to begin with.

The table is `data/field_meanings.yaml`. A field is looked up at the outermost message that the
table knows it of: `twist.linear.x` of a TwistStamped is `linear.x` of a Twist.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

from .catalog import Catalog
from .catalog.data import load
from .interfaces import Interface, InterfaceKind, Section

_FILE = Path(__file__).parent / "data" / "field_meanings.yaml"


class Meaning(NamedTuple):
    """What a field means.

    Attributes:
        unit: its unit, or the numbers that it may have; "" where it has none.
        words: what it is.
        first: a value that shows something, as a form has it; "" where none does.
    """

    unit: str
    words: str
    first: str = ""

    @property
    def said(self) -> str:
        """The unit and the words, for people."""
        return ", ".join(part for part in (self.unit, self.words) if part)


@cache
def field_meanings() -> Mapping[str, Mapping[str, Meaning]]:
    """Return what is known of fields: by message, and by path; what matters most comes first."""
    table: Mapping[str, Mapping[str, str]] = load(_FILE)
    return {
        type_: {path: _read(text) for path, text in fields.items()}
        for type_, fields in table.items()
    }


def _read(text: str) -> Meaning:
    return Meaning(*(part.strip() for part in text.split("|")))


def meaning_of(
    catalog: Catalog, interface: Interface, path: Sequence[str], section: Section | None = None
) -> Meaning | None:
    """Return what a field means, None where that is not known.

    Args:
        catalog: has the types of what is within a message.
        interface: the message, service or action.
        path: the names of the field and of those around it, the outermost first.
        section: the part of the interface that has the field; None for its first one.
    """
    return next((known[name] for known, name in _views(catalog, interface, path, section)), None)


def rank_of(catalog: Catalog, interface: Interface, path: Sequence[str]) -> tuple[int, int]:
    """Return a key that sorts fields by how much they matter; what is not known comes last."""
    for known, name in _views(catalog, interface, path, None):
        return len(path) - len(name.split(".")), list(known).index(name)
    return _LAST


_LAST = (1000, 0)
"""The key of a field of which nothing is known: none is within so many others."""


def _views(
    catalog: Catalog, interface: Interface, path: Sequence[str], section: Section | None
) -> Iterator[tuple[Mapping[str, Meaning], str]]:
    """Yield what is known of the messages around a field, the outermost first, and its path there.

    Only those messages count that the field is known of.
    """
    meanings = field_meanings()
    around = section or interface.sections[0]
    is_answer = interface.kind is InterfaceKind.SERVICE and around is interface.response
    key = f"{interface.name} answer" if is_answer else str(interface.name)
    for depth in range(len(path)):
        name = ".".join(path[depth:])
        if name in meanings.get(key, ()):
            yield meanings[key], name
        type_ = next(
            (each.type.message for each in around.fields if each.name == path[depth]), None
        )
        found = None if type_ is None else catalog.find(type_, InterfaceKind.MESSAGE)
        if found is None:
            return
        around, key = found.sections[0], str(found.name)
