"""Bringing together what two hands made of one robot."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, NamedTuple

from .description import Description


class Merged(NamedTuple):
    """Both changes in one description; None where both changed the same, with what that is.

    Attributes:
        robot: the description.
        clash: what both changed, such as `mass of the link arm`.
    """

    robot: Description | None
    clash: str = ""


class _ClashError(Exception):
    """Both changed the same; the arguments say what, the innermost first."""


def merged(base: Description, new: Description, present: Description) -> Merged:
    """Bring what became of a description on one side into what became of it on the other.

    Values are merged one by one: the mass of a link on one side, and its colour on the other.
    What one side took out and the other one changed is a clash.

    Args:
        base: what both come from.
        new: the one side.
        present: the other one, whose order of parts stays.
    """
    try:
        name = _value(base.name, new.name, present.name)
        kinds: dict[str, Any] = {
            kind: _parts(kind, *(getattr(each, kind) for each in (base, new, present)))
            for kind in ("links", "joints", "materials")
        }
    except _ClashError as clash:
        return Merged(None, " of ".join(map(str, clash.args)) or "name")
    return Merged(replace(present, name=name, **kinds))


def _parts(
    kind: str, base: Mapping[str, Any], new: Mapping[str, Any], present: Mapping[str, Any]
) -> dict[str, Any]:
    """Merge parts by their names; None stands for a part that is not there."""
    sides = (base, new, present)
    found = {name: _part(kind, name, *sides) for name in dict.fromkeys((*present, *new))}
    return {name: part for name, part in found.items() if part is not None}


def _part(kind: str, name: str, *sides: Mapping[str, Any]) -> Any:
    try:
        return _value(*(each.get(name) for each in sides))
    except _ClashError as clash:
        raise _ClashError(*clash.args, f"the {kind.removesuffix('s')} `{name}`") from None


def _value(base: Any, new: Any, present: Any) -> Any:
    if new in (base, present):
        return present
    if present == base:
        return new
    kinds = {type(each) for each in (base, new, present)}
    if len(kinds) > 1 or not isinstance(base, tuple):
        raise _ClashError
    if not hasattr(base, "_fields"):
        are_alike = len(base) == len(new) == len(present)
        if not are_alike or not all(isinstance(each, tuple) for each in base):
            raise _ClashError
        return tuple(map(_value, base, new, present))
    return type(base)(*(_field(field, base, new, present) for field in base._fields))


def _field(field: str, *parts: Any) -> Any:
    try:
        return _value(*(getattr(each, field) for each in parts))
    except _ClashError as clash:
        raise _ClashError(*clash.args, f"`{field}`") from None
