"""When two descriptions say the same: numbers have as many digits as are written."""

from __future__ import annotations

from collections.abc import Mapping

from plastron_tui.ros.robots.description import Description

from .new_elements import rounded


def same(one: object, other: object) -> bool:
    """Tell whether two parts, or two values of parts, say the same."""
    if one is other:
        return True
    if isinstance(one, (int, float)) and isinstance(other, (int, float)):
        return one == other or rounded(one) == rounded(other)
    if type(one) is not type(other):
        return False
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(same(one[each], other[each]) for each in one)
    return one == other


def same_robot(one: Description, other: Description) -> bool:
    """Tell whether two robots are the same, in whatever order their parts are."""
    return (
        one.name == other.name
        and same(one.links, other.links)
        and same(one.joints, other.joints)
        and same(one.materials, other.materials)
    )
