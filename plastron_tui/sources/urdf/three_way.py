"""A difference of two descriptions, made in a third one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from plastron_tui.ros.robots.description import Description

from .equality import same


class ConflictError(Exception):
    """Something is to change that is not as it was; `what` says what."""

    def __init__(self, what: str) -> None:
        self.what = what


def merged(before: Description, after: Description, present: Description) -> Description:
    """Return what is present, with what is different in two descriptions.

    Raises:
        ConflictError: what is to change is not what it was, nor what it is to be.
    """
    return Description(
        _value(before.name, after.name, present.name, "the robot's name"),
        _parts(before.links, after.links, present.links, "link"),
        _parts(before.joints, after.joints, present.joints, "joint"),
        _parts(before.materials, after.materials, present.materials, "material"),
    )


def _parts(
    before: Mapping[str, Any], after: Mapping[str, Any], present: Mapping[str, Any], kind: str
) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for name in dict.fromkeys((*after, *present)):
        parts = (before.get(name), after.get(name), present.get(name))
        part = _value(*parts, f"the {kind} `{name}`")
        if part is not None:
            found[name] = part
    return found


def _value(before: Any, after: Any, present: Any, what: str) -> Any:
    if same(before, after) or same(after, present):
        return present
    if same(before, present):
        return after
    values = (before, after, present)
    is_alike = len({type(each) for each in values}) == 1 and isinstance(before, tuple)
    if not is_alike or len({len(each) for each in values}) != 1 or _is_vector(before):
        raise ConflictError(what)
    fields = [_value(*each, what) for each in zip(*values, strict=True)]
    return type(before)(*fields) if hasattr(before, "_fields") else tuple(fields)


def _is_vector(value: tuple[Any, ...]) -> bool:
    return not hasattr(value, "_fields") and all(isinstance(each, float) for each in value)
