"""Turns as quaternions, which newer files have instead of roll, pitch and yaw."""

from __future__ import annotations

from math import atan2, cos, hypot, sin
from typing import TypeAlias

from .description import Vector

Quaternion: TypeAlias = tuple[float, float, float, float]
"""x, y, z, w."""

_LOCKED = 1e-9
"""Below this cosine of the pitch, roll and yaw turn about one axis, and only their sum counts."""

_ANGLE_DECIMALS, _DECIMALS = 10, 12
"""What a file of twelve decimals tells of an angle."""


def quaternion_of(angles: Vector) -> Quaternion:
    """Return the quaternion of roll, pitch and yaw, about the fixed axes one after the other."""
    (sr, cr), (sp, cp), (sy, cy) = ((sin(each / 2), cos(each / 2)) for each in angles)
    x = sr * cp * cy - cr * sp * sy
    y = cr * sp * cy + sr * cp * sy
    z = cr * cp * sy - sr * sp * cy
    w = cr * cp * cy + sr * sp * sy
    return _rounded(x), _rounded(y), _rounded(z), _rounded(w)


def angles_of(quaternion: Quaternion) -> Vector | None:
    """Return roll, pitch and yaw in radians; None for zeros, which turn nothing."""
    length = hypot(*quaternion)
    if not length:
        return None
    x, y, z, w = (each / length for each in quaternion)
    level = hypot(1 - 2 * (y * y + z * z), 2 * (x * y + z * w))
    pitch = atan2(2 * (y * w - x * z), level)
    if level < _LOCKED:
        roll = atan2(2 * (x * w - y * z), 1 - 2 * (x * x + z * z))
        return _angle(roll), _angle(pitch), 0.0
    roll = atan2(2 * (y * z + x * w), 1 - 2 * (x * x + y * y))
    yaw = atan2(2 * (x * y + z * w), 1 - 2 * (y * y + z * z))
    return _angle(roll), _angle(pitch), _angle(yaw)


def _angle(value: float) -> float:
    return round(value, _ANGLE_DECIMALS) + 0.0


def _rounded(value: float) -> float:
    return round(value, _DECIMALS) + 0.0
