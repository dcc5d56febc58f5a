"""Joints of URDF files (urdfdom: `joint.cpp`)."""

from __future__ import annotations

from plastron_tui.diagnostics import guess
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.ros.robots.description import (
    Dynamics,
    Joint,
    JointType,
    Limit,
    Mimic,
    Vector,
)
from plastron_tui.sources.xml.document import Element

from .links import pose_of
from .values import Values, first, has_any, is_computed


def joint_of(element: Element, name: str, values: Values) -> Joint | None:
    """Return a joint, None for one that nobody knows where it is or how it moves."""
    type_ = _type_of(element, values)
    parent, child = _end(element, "parent", values), _end(element, "child", values)
    limit = _limit(element, type_, values)
    if type_ is None or parent is None or child is None:
        return None
    return Joint(
        name,
        type_,
        parent,
        child,
        pose_of(element, values),
        _axis(element, type_, values),
        limit,
        _dynamics(element, values),
        _mimic(element, values),
    )


def _type_of(element: Element, values: Values) -> JointType | None:
    found = values.needed(element, "type")
    if found is None:
        return None
    names = [each.value for each in JointType]
    if found.value in names:
        return JointType(found.value)
    if not (values.is_xacro and is_computed(found.value)):
        near, _ = guess(found.value, names, found.value_span)
        others = f"it is one of {', '.join(f'`{each}`' for each in names)}"
        values.tell(f"`{found.value}` is no joint type", found.value_span, near or others)
    return None


def _end(element: Element, which: str, values: Values) -> str | None:
    end = values.needed_child(element, which)
    found = None if end is None else values.needed(end, "link")
    return None if found is None else found.value


def _axis(element: Element, type_: JointType, values: Values) -> Vector | None:
    axis = first(element, "axis")
    if axis is None:
        return None
    if not type_.has_axis:
        # urdfdom does not look at it: exporters write "0 0 0" there.
        quiet = Values(values.document, values.is_xacro)
        return quiet.vector(axis, "xyz")
    if axis.attribute("xyz") is None:
        message = "`<axis>` has no `xyz`, and counts as 0 0 0"
        values.tell(message, axis.name_span, severity=Severity.WARNING)
        return None
    found = values.vector(axis, "xyz", is_needed=True)
    if found is not None and not any(found):
        message = "an axis of 0 0 0 points nowhere"
        span = (axis.attribute("xyz") or axis).span
        values.tell(message, span, severity=Severity.WARNING)
    return found


def _limit(element: Element, type_: JointType | None, values: Values) -> Limit | None:
    limit = first(element, "limit")
    if limit is None:
        if type_ is not None and type_.is_limited and not values.has_macros_in(element):
            message = f"a joint that is {type_.value} needs a `<limit>`, and this one has none"
            turns = "a joint that turns without end is `continuous`"
            help_text = turns if type_ is JointType.REVOLUTE else None
            values.tell(message, element.name_span, help_text)
        return None
    lower, upper = values.number(limit, "lower"), values.number(limit, "upper")
    effort = values.number(limit, "effort", is_needed=True)
    velocity = values.number(limit, "velocity", is_needed=True)
    return Limit(lower or 0.0, upper or 0.0, effort or 0.0, velocity or 0.0)


def _dynamics(element: Element, values: Values) -> Dynamics | None:
    dynamics = first(element, "dynamics")
    if dynamics is None:
        return None
    if not has_any(dynamics, Dynamics._fields):
        values.tell("`<dynamics>` has neither damping nor friction", dynamics.name_span)
    damping, friction = values.number(dynamics, "damping"), values.number(dynamics, "friction")
    return Dynamics(damping or 0.0, friction or 0.0)


def _mimic(element: Element, values: Values) -> Mimic | None:
    mimic = first(element, "mimic")
    followed = None if mimic is None else values.needed(mimic, "joint")
    if mimic is None or followed is None:
        return None
    multiplier, offset = values.number(mimic, "multiplier"), values.number(mimic, "offset")
    return Mimic(followed.value, 1.0 if multiplier is None else multiplier, offset or 0.0)
