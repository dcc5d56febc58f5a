"""What is said about an interface type: what it is for, its fields, and who uses it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from plastron_tui.model.types import TypeResolver
from plastron_tui.ros.common_types import line_about
from plastron_tui.ros.field_meanings import meaning_of
from plastron_tui.ros.interfaces import Field, Interface, InterfaceKind, Section

from ..editor.card import CardRow
from .known import Known

if TYPE_CHECKING:
    from plastron_tui.ros.catalog import Catalog

_MOST_ROWS = 60
_DEEPEST = 3
_MOST_CONSTANTS = 12

NOUNS = {
    InterfaceKind.MESSAGE: "message type",
    InterfaceKind.SERVICE: "service type",
    InterfaceKind.ACTION: "action type",
}
_SECTIONS = {
    InterfaceKind.MESSAGE: ("",),
    InterfaceKind.SERVICE: ("request", "response"),
    InterfaceKind.ACTION: ("goal", "result", "feedback"),
}


def find_type(written: str, kind: InterfaceKind, catalog: Catalog) -> Interface | None:
    """Return a type as a program writes it, None for one that is unknown."""
    found = TypeResolver(catalog).resolve(written, kind)
    return found if isinstance(found, Interface) else None


def type_rows(found: Interface, catalog: Catalog, known: Known) -> Iterator[CardRow]:
    """Yield what is known of a type, the line about it first."""
    line = line_about(found.name, found.kind) or found.comment
    if line:
        yield CardRow(line)
    for name, section in zip(_SECTIONS[found.kind], found.sections, strict=False):
        if name:
            yield CardRow(f"{name}:")
        yield from _section_rows(found, section, catalog)
    yield from _users(found, known)


def _section_rows(found: Interface, section: Section, catalog: Catalog) -> Iterator[CardRow]:
    rows = [
        CardRow(".".join(path), str(field.type), _note(found, section, path, field, catalog))
        for path, field in _fields(section.fields, catalog)
    ]
    if not rows:
        yield CardRow("no fields")
    yield from rows[:_MOST_ROWS]
    if len(rows) > _MOST_ROWS:
        yield CardRow("…", f"{len(rows) - _MOST_ROWS} more")
    for constant in section.constants[:_MOST_CONSTANTS]:
        yield CardRow(constant.name, f"= {constant.value}")
    if len(section.constants) > _MOST_CONSTANTS:
        yield CardRow("…", f"{len(section.constants) - _MOST_CONSTANTS} more constants")


def _fields(
    fields: Sequence[Field], catalog: Catalog, before: tuple[str, ...] = ()
) -> Iterator[tuple[tuple[str, ...], Field]]:
    """Yield the fields by their paths, in the place of a message within it those of that one."""
    for field in fields:
        path = (*before, field.name)
        inner = None
        message = field.type.message
        if message is not None and not field.type.is_array and len(path) < _DEEPEST:
            inner = catalog.find(message, InterfaceKind.MESSAGE)
        if inner is not None and inner.fields:
            yield from _fields(inner.fields, catalog, path)
        else:
            yield path, field


def _note(
    found: Interface, section: Section, path: tuple[str, ...], field: Field, catalog: Catalog
) -> str:
    """Return the unit of a field and what it means, else what its definition says of it."""
    meaning = meaning_of(catalog, found, path, section)
    return field.comment if meaning is None else meaning.said


def _users(found: Interface, known: Known) -> Iterator[CardRow]:
    label = "used by"
    for node in known.workspace.nodes.values():
        for kind, endpoints in node.by_kind.items():
            if kind.facts.interface is not found.kind:
                continue
            for name, endpoint in endpoints.items():
                if endpoint.type == found.name:
                    yield CardRow(label, f"{node.name} {kind.facts.verb} {name}")
                    label = ""
