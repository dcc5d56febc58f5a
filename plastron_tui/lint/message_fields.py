"""What a path of names of fields leads to, by the definitions that the workspace has."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import NamedTuple

from plastron_tui.model.code_facts import ITEM, MessageField, MessageType, Part
from plastron_tui.ros.catalog import DISTRIBUTIONS, Catalog
from plastron_tui.ros.interfaces import Field, FieldType, InterfaceKind, InterfaceName, Section

from .python_attributes import LIST_ATTRIBUTES, MESSAGE_ATTRIBUTES, attributes_of
from .tree import SourceTree, UnitFacts

_SERVICE = (Part.REQUEST, Part.RESPONSE)
_ACTION = (Part.GOAL, Part.RESULT, Part.FEEDBACK)
_PARTS = {each: parts for parts in (_SERVICE, _ACTION) for each in parts}
_ACTION_ENDS = {"Goal": Part.GOAL, "Result": Part.RESULT, "Feedback": Part.FEEDBACK}
PYTHON = frozenset({"rospy", "rclpy"})
"""The client libraries of Python."""


class Missing(NamedTuple):
    """A name that leads nowhere.

    Attributes:
        position: its position in the path.
        owner: what has no such field, in words.
        names: what would lead somewhere.
        field: the field that is no message, "" where a message lacks the field.
        other: the part of the service or the action that has it instead, None for none.
        is_constant: whether it is a constant there.
        deeper: the one field of a field that may be meant, by its path, () for none or several.
    """

    position: int
    owner: str
    names: Sequence[str]
    field: str = ""
    other: MessageType | None = None
    is_constant: bool = False
    deeper: tuple[str, ...] = ()


Place = FieldType | MessageType
"""What a path leads to."""


class Messages:
    """Looks up messages for the code of one client library."""

    def __init__(self, catalog: Catalog, library: str) -> None:
        """Look up in a catalog; in its distribution's relatives only what it does not know."""
        self.is_python = library in PYTHON
        self.version = catalog.ros_version
        self._catalog = catalog
        self._sections: dict[MessageType, Section | None] = {}

    def section(self, type_: MessageType) -> Section | None:
        """Return the fields and constants of a message, None where they are not known for sure."""
        if type_ not in self._sections:
            self._sections[type_] = _section(self._catalog, type_)
        return self._sections[type_]

    def fields(self, type_: MessageType) -> Sequence[Field]:
        """Return the fields of a message, none where they are not known."""
        section = self.section(type_)
        return () if section is None else section.fields

    def place(self, field: MessageField) -> Place | None:
        """Return what a path leads to, None where it leads nowhere or that is not known."""
        if len(field.path) == 1 and field.path[0].startswith("#"):
            fields, index = self.fields(field.type), int(field.path[0][1:])
            return fields[index].type if index < len(fields) else None
        found = self._walk(field)
        return None if isinstance(found, Missing) else found

    def missing(self, field: MessageField) -> Missing | None:
        """Return the name of a path that leads nowhere, None where all do or that is not sure."""
        found = self._walk(field)
        return found if isinstance(found, Missing) else None

    def _walk(self, field: MessageField) -> Place | Missing | None:
        place: Place = field.type
        for index, name in enumerate(field.path):
            found = self._step(place, name, index, field.path[:index])
            if found is None or isinstance(found, Missing):
                return found
            place = found
        return place

    def _step(
        self, place: Place, name: str, index: int, before: Sequence[str]
    ) -> Place | Missing | None:
        if isinstance(place, FieldType):
            if place.is_array or place.message is None:
                return self._into_value(place, name, index, before)
            place = MessageType(place.message)
        section = self.section(place)
        if section is None or name == ITEM or name.startswith("_"):
            return None
        known: Mapping[str, FieldType] = {each.name: each.type for each in section.fields}
        if name in known:
            return known[name]
        constants = {each.name: FieldType(each.type) for each in section.constants}
        if name in constants:
            return constants[name]
        if name in MESSAGE_ATTRIBUTES[self.version] or self._is_known_elsewhere(place, name):
            return None
        names, deeper = (*known, *constants), self._deeper(known, name)
        missing = Missing(index, described(place), names, deeper=deeper)
        for part in _PARTS.get(place.part, ()):
            other = place._replace(part=part)
            section = self.section(other)
            if section is None:
                continue
            is_constant = any(each.name == name for each in section.constants)
            if is_constant or any(each.name == name for each in section.fields):
                return missing._replace(other=other, is_constant=is_constant)
        return missing

    def _deeper(self, known: Mapping[str, FieldType], name: str) -> tuple[str, ...]:
        """Return where a field has one of the name: `pose.position`, `linear.x` for `linear_x`."""
        found = []
        for holder, type_ in known.items():
            if type_.is_array or type_.message is None:
                continue
            inner = {each.name for each in self.fields(MessageType(type_.message))}
            names = {name, name.removeprefix(f"{holder}_")}
            found += [(holder, each) for each in names if each in inner]
        return found[0] if len(found) == 1 else ()

    def _into_value(
        self, type_: FieldType, name: str, index: int, before: Sequence[str]
    ) -> Place | Missing | None:
        """Return what is in a list, a number or a text."""
        field = next((each for each in reversed(before) if each != ITEM), "")
        if type_.is_array:
            if name == ITEM:
                return type_.element
            if not self.is_python:
                # There an index is left out of the path.
                return self._step(type_.element, name, index, before) if type_.message else None
            if name.startswith("_") or name in LIST_ATTRIBUTES:
                return None
            return Missing(index, f"a list, of `{type_.element}`", (), field)
        if not self.is_python or name == ITEM or name.startswith("_"):
            return None
        attributes = attributes_of(type_.name, self.version)
        if attributes is None or name in attributes:
            return None
        names = attributes if type_.name in ("time", "duration") else ()
        return Missing(index, f"of type `{type_.name}`", tuple(names), field)

    def _is_known_elsewhere(self, type_: MessageType, name: str) -> bool:
        """Whether another distribution has a field: the code may be for that one."""
        for catalog in _relatives(self._catalog.distribution):
            section = _section(catalog, type_)
            if section is not None:
                names = {each.name for each in section.fields}
                if name in names.union(each.name for each in section.constants):
                    return True
        return False


def units_of(tree: SourceTree, *libraries: str) -> Iterator[tuple[UnitFacts, Messages]]:
    """Yield the files of some client libraries, or of all, each with what messages are for it."""
    known: dict[tuple[int, str], Messages] = {}
    for unit in tree.built:
        key = unit.ros_version, unit.library
        if key[0] not in tree.catalogs or (libraries and unit.library not in libraries):
            continue
        if key not in known:
            known[key] = Messages(tree.catalogs[key[0]], unit.library)
        yield unit, known[key]


@cache
def _relatives(distribution: str) -> tuple[Catalog, ...]:
    """Return the catalogs of the other distributions of a generation of ROS."""
    version = DISTRIBUTIONS[distribution]
    others = (each for each, of in DISTRIBUTIONS.items() if of == version)
    return tuple(Catalog(each) for each in others if each != distribution)


def _section(catalog: Catalog, type_: MessageType) -> Section | None:
    for name, kind, part in _meanings(type_, catalog.ros_version):
        if not catalog.is_sole(name, kind):
            return None
        interface = catalog.find(name, kind)
        if interface is not None:
            return interface.sections[part.section]
    return None


def _meanings(
    type_: MessageType, version: int
) -> Iterator[tuple[InterfaceName, InterfaceKind, Part]]:
    """Yield what may define a message: in ROS 1 a goal of an action is a message by itself."""
    yield type_.name, type_.kind, type_.part
    if type_.part is not Part.MESSAGE or version != 1:
        return
    for end, part in _ACTION_ENDS.items():
        if type_.name.name.endswith(end):
            name = InterfaceName(type_.name.package, type_.name.name.removesuffix(end))
            yield name, InterfaceKind.ACTION, part


def described(type_: MessageType) -> str:
    """Return a message in words."""
    name = f"`{type_.name}`"
    return name if type_.part is Part.MESSAGE else f"the {type_.part.value} of {name}"
