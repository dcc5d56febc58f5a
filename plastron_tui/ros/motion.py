"""What moves a robot, and what tells it how far away things are: types and usual topics."""

from __future__ import annotations

COMMAND_TOPIC = "cmd_vel"
"""The topic by which most robots are driven."""

LASER_TOPIC = "scan"
"""The topic to which most lasers send."""

VELOCITIES = frozenset(
    {
        *("geometry_msgs/Twist", "geometry_msgs/TwistStamped"),
        *("ackermann_msgs/AckermannDrive", "ackermann_msgs/AckermannDriveStamped"),
    }
)
"""The types that say how fast a robot is to go: it stands still at zero."""

COMMANDS = VELOCITIES | {
    *("geometry_msgs/Accel", "geometry_msgs/AccelStamped"),
    *("geometry_msgs/Wrench", "geometry_msgs/WrenchStamped"),
}
"""The types that say how a robot moves."""

DISTANCES = frozenset({"sensor_msgs/LaserScan", "sensor_msgs/Range"})
"""The types that say how far away things are."""


def is_velocity(type_: str) -> bool:
    """Tell whether a type, written with or without its package, says how fast to go."""
    return _is_one_of(VELOCITIES, type_)


def is_command(type_: str) -> bool:
    """Tell whether a type, written with or without its package, says how a robot moves."""
    return _is_one_of(COMMANDS, type_)


def is_distance(type_: str) -> bool:
    """Tell whether a type, written with or without its package, says how far away things are."""
    return _is_one_of(DISTANCES, type_)


def _is_one_of(known: frozenset[str], type_: str) -> bool:
    package, _, rest = type_.partition("/")
    name = type_.rpartition("/")[2]
    if rest:
        return f"{package}/{name}" in known
    return any(each.rpartition("/")[2] == name for each in known)
