"""What differs between two versions of an interface, and circles of types."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import NamedTuple

from .interfaces import Interface, InterfaceName, Section


class ChangeKind(str, Enum):
    """What became of a member; a constant of another value is retyped, too."""

    ADDED = "added"
    REMOVED = "removed"
    RETYPED = "retyped"


class MemberChange(NamedTuple):
    """A member that is not as it was, and the section (from 0) that it is in."""

    kind: ChangeKind
    section: int
    name: str


def member_changes(old: Interface, new: Interface) -> tuple[MemberChange, ...]:
    """Return how the members of two versions of a type differ, section by section.

    A default value and a comment are no difference: they break no user of the type.
    """
    changes: list[MemberChange] = []
    for number, (before, after) in enumerate(zip(old.sections, new.sections, strict=True)):
        was, is_ = _members(before), _members(after)
        for name in {**was, **is_}:
            if name not in is_:
                changes.append(MemberChange(ChangeKind.REMOVED, number, name))
            elif name not in was:
                changes.append(MemberChange(ChangeKind.ADDED, number, name))
            elif was[name] != is_[name]:
                changes.append(MemberChange(ChangeKind.RETYPED, number, name))
    return tuple(changes)


def _members(section: Section) -> dict[str, object]:
    fields = {field.name: field.type for field in section.fields}
    return fields | {each.name: (each.type, repr(each.value)) for each in section.constants}


def find_circle(messages: Mapping[InterfaceName, Interface]) -> tuple[InterfaceName, ...]:
    """Return the messages of a circle in their order, () when no message contains itself."""
    done: set[InterfaceName] = set()
    for start in messages:
        path: list[InterfaceName] = []
        stack = [iter((start,))]
        while stack:
            name = next(stack[-1], None)
            if name is None:
                stack.pop()
                if path:
                    done.add(path.pop())
            elif name in path:
                return tuple(path[path.index(name) :])
            elif name in messages and name not in done:
                path.append(name)
                stack.append(iter(_nested(messages[name])))
    return ()


def _nested(interface: Interface) -> tuple[InterfaceName, ...]:
    fields = (field for section in interface.sections for field in section.fields)
    return tuple(field.type.message for field in fields if field.type.message is not None)
