"""Where the links of a robot are, with all joints at 0."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, isfinite, nan, sin
from operator import mul
from typing import NamedTuple, TypeAlias

from .description import ORIGIN, Description, Pose, Vector
from .tree import branches

Matrix: TypeAlias = tuple[Vector, Vector, Vector]

_IDENTITY: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Transform(NamedTuple):
    """What takes points of a body to where they are, seen from the root."""

    rotation: Matrix = _IDENTITY
    translation: Vector = ORIGIN

    def point(self, at: Vector) -> Vector:
        """Return where a point is."""
        turned = self.direction(at)
        x, y, z = self.translation
        return turned[0] + x, turned[1] + y, turned[2] + z

    def direction(self, along: Vector) -> Vector:
        """Return where a direction points."""
        (a, b, c), (d, e, f), (g, h, i) = self.rotation
        x, y, z = along
        return a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z

    def then(self, pose: Pose) -> Transform:
        """Return that of what is at a pose seen from here."""
        inner = rotation_matrix(pose.rotation)
        columns = [self.direction((inner[0][i], inner[1][i], inner[2][i])) for i in range(3)]
        first, second, third = columns
        rotation: Matrix = (
            (first[0], second[0], third[0]),
            (first[1], second[1], third[1]),
            (first[2], second[2], third[2]),
        )
        return Transform(rotation, self.point(pose.position))


def seen_from(frame: Matrix, other: Matrix) -> Matrix:
    """Return what turns points seen from `other` into points seen from `frame`."""
    columns = list(zip(*other, strict=True))
    first, second, third = (
        tuple(sum(map(mul, across, column)) for column in columns)
        for across in zip(*frame, strict=True)
    )
    return _vector(first), _vector(second), _vector(third)


def _vector(values: Sequence[float]) -> Vector:
    x, y, z = values
    return x, y, z


def rotation_matrix(rotation: Vector) -> Matrix:
    """Return what roll, pitch and yaw turn by (urdfdom: `Rotation::setFromRPY`).

    What an angle without end turns by is not a number.
    """
    roll, pitch, yaw = (angle if isfinite(angle) else nan for angle in rotation)
    cr, sr, cp, sp, cy, sy = cos(roll), sin(roll), cos(pitch), sin(pitch), cos(yaw), sin(yaw)
    return (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )


def placed(robot: Description) -> dict[str, Transform]:
    """Return where each link is that hangs on a root."""
    found: dict[str, Transform] = {}
    for branch in branches(robot):
        if branch.joint is None:
            found[branch.link] = Transform()
        else:
            found[branch.link] = found[branch.joint.parent].then(branch.joint.pose)
    return found
