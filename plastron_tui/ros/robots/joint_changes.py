"""Joints changed by what is said of them."""

from __future__ import annotations

from typing import NamedTuple

from .description import Joint, JointType, Limit, Mimic, Pose, Vector

NO_MIMIC = Mimic("")
"""Said of a joint that is to follow no other."""


class JointValues(NamedTuple):
    """What is said of a joint; None where nothing is.

    Attributes:
        type: how it moves.
        ends: the names of the link that holds, and of the one that is held.
        position: where the child is, in metres.
        rotation: how the child is turned, in radians.
        axis: what it moves about or along.
        mimic: which joint it follows; `NO_MIMIC` for none.
    """

    type: JointType | None = None
    ends: tuple[str, str] | None = None
    position: Vector | None = None
    rotation: Vector | None = None
    axis: Vector | None = None
    mimic: Mimic | None = None


def changed_joint(joint: Joint, values: JointValues) -> Joint:
    """Return a joint with what is said of it changed, and nothing else.

    What a joint of the new type has no use for goes; what stays means the same as before.
    """
    type_, ends, position, rotation, axis, mimic = values
    parent, child = ends or (joint.parent, joint.child)
    if type_ is not None and type_ is not joint.type:
        joint = retyped(joint, type_)
    if mimic == NO_MIMIC:
        joint, mimic = joint._replace(mimic=None), None
    return joint._replace(
        parent=parent,
        child=child,
        pose=Pose(
            joint.pose.position if position is None else position,
            joint.pose.rotation if rotation is None else rotation,
        ),
        axis=joint.axis if axis is None else axis,
        mimic=joint.mimic if mimic is None else mimic,
    )


def retyped(joint: Joint, type_: JointType) -> Joint:
    """Return a joint that moves otherwise, without what the new type has no use for.

    Limits and dynamics of what turns are in radians, of what slides in metres: they say nothing
    of the other. What turns without end has no range, but may have an effort and a velocity. What a
    joint has left from before it was fixed counts again once it turns.
    """
    old = joint.type
    joint = joint._replace(type=type_)
    if not type_.has_axis:
        return joint._replace(axis=None, limit=None, dynamics=None, mimic=None)
    if not old.has_axis:
        # A tool writes zeros into what does not move; the rest was meant for when it does.
        joint = joint._replace(
            axis=joint.axis if joint.axis is not None and any(joint.axis) else None,
            limit=joint.limit if joint.limit is not None and any(joint.limit) else None,
            dynamics=joint.dynamics if joint.dynamics is not None and any(joint.dynamics) else None,
        )
    if not type_.turns or (old.has_axis and not old.turns):
        return joint._replace(limit=None, dynamics=None, mimic=None)
    if joint.limit is None or type_ is JointType.REVOLUTE:
        return joint
    return joint._replace(limit=Limit(effort=joint.limit.effort, velocity=joint.limit.velocity))
