"""Changes of a joint."""

from __future__ import annotations

from plastron_tui.ros.robots.description import Dynamics, Joint, Mimic

from .equality import same
from .link_edits import change_pose, put, set_or_drop
from .new_elements import axis_element, dynamics_element, limit_element, mimic_element
from .part_edits import PartEdits, Path
from .values import number_of
from .vocabulary import CALIBRATION, SAFETY


def change_joint(part: PartEdits, before: Joint, after: Joint) -> None:
    """Let a joint say what it is to say, by the least changes of its text."""
    if before.type is not after.type:
        part.set_text((), "type", after.type.value)
    if before.parent != after.parent:
        part.set_text((("parent", 0),), "link", after.parent)
    if before.child != after.child:
        part.set_text((("child", 0),), "link", after.child)
    change_pose(part, (), before.pose, after.pose)
    axis: Path = (("axis", 0),)
    if before.axis is None or after.axis is None:
        if not same(before.axis, after.axis):
            new = None if after.axis is None else axis_element(after.axis)
            put(part, axis, new, was_there=before.axis is not None)
    else:
        part.set_numbers(axis, "xyz", before.axis, after.axis)
    _change_limit(part, before, after)
    _change_dynamics(part, before.dynamics, after.dynamics)
    _change_mimic(part, before.mimic, after.mimic)
    _tell_safety(part, before, after)


def _tell_safety(part: PartEdits, old: Joint, new: Joint) -> None:
    """Tell what stays of a joint that no sentence speaks of, and no longer fits it."""
    if old.type is not new.type:
        for name in (SAFETY, CALIBRATION):
            if part.find(((name, 0),)) is not None:
                part.tell(f"`<{name}>` stays as it is in a joint that is {new.type.value} now")
        return
    safety = part.find(((SAFETY, 0),))
    if safety is None or new.limit is None or same(old.limit, new.limit):
        return
    for name in ("soft_lower_limit", "soft_upper_limit"):
        soft = number_of(safety.get(name) or "")
        if soft is not None and not new.limit.lower <= soft <= new.limit.upper:
            part.tell(f"`{name}` of `<{SAFETY}>` stays {soft:g}, which is beyond the new limits")


def _change_limit(part: PartEdits, old: Joint, new: Joint) -> None:
    path: Path = (("limit", 0),)
    before, after = old.limit, new.limit
    if before is None or after is None:
        if not same(before, after):
            element = None
            if after is not None:
                element = limit_element(after, has_range=new.type.is_limited)
            put(part, path, element, was_there=before is not None)
        return
    starts, ends = (
        each.type.is_limited and not other.type.is_limited
        for each, other in ((new, old), (old, new))
    )
    for name, was, value in (
        ("lower", before.lower, after.lower),
        ("upper", before.upper, after.upper),
    ):
        limit = part.find(path)
        is_there = limit is not None and limit.attribute(name) is not None
        if starts and not is_there:
            part.set_text(path, name, part.habits.number(name, value))
        elif not new.type.is_limited and value == 0 and (ends or was != 0):
            # What has no range does not say one.
            part.drop(path, name)
        else:
            part.set_numbers(path, name, (was,), (value,), (0.0,))
    part.set_numbers(path, "effort", (before.effort,), (after.effort,))
    part.set_numbers(path, "velocity", (before.velocity,), (after.velocity,))


def _change_dynamics(part: PartEdits, before: Dynamics | None, after: Dynamics | None) -> None:
    path: Path = (("dynamics", 0),)
    if same(before, after):
        return
    if before is None or after is None:
        new = None if after is None else dynamics_element(after)
        put(part, path, new, was_there=before is not None)
        return
    for name, was, value in zip(Dynamics._fields, before, after, strict=True):
        part.set_numbers(path, name, (was,), (value,), (0.0,))


def _change_mimic(part: PartEdits, before: Mimic | None, after: Mimic | None) -> None:
    path: Path = (("mimic", 0),)
    if same(before, after):
        return
    if before is None or after is None:
        new = None if after is None else mimic_element(after)
        put(part, path, new, was_there=before is not None)
        return
    part.set_text(path, "joint", after.joint)
    set_or_drop(part, path, "multiplier", (before.multiplier,), (after.multiplier,), (1.0,))
    set_or_drop(part, path, "offset", (before.offset,), (after.offset,), (0.0,))
