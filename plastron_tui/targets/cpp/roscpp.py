"""The target `roscpp`: C++ nodes for ROS 1."""

from __future__ import annotations

from typing import ClassVar

from .dialect import Dialect
from .target import CppTarget

# What the templates give to methods, attributes and functions of a file.
_ATTRIBUTES = """
    all_in_range as_vector divisor follow_rates in_range is_list nh parameters_mutex private_nh
    rates_timer
"""
_TASK_NAMES = """
    SERVICE_TIMEOUT WARNING_PERIOD ask end_goals exit_status is_ending is_running is_served run
    send_goal wait_for_action wait_until_served work
"""

DIALECT = Dialect(
    library="roscpp",
    ros_version=1,
    attribute_names=frozenset(_ATTRIBUTES.split()),
    task_names=frozenset(_TASK_NAMES.split()),
)


class RoscppTarget(CppTarget):
    """Writes, reads and edits roscpp nodes."""

    name: ClassVar[str] = "roscpp"
    ros_version: ClassVar[int] = 1
    dialect: ClassVar[Dialect] = DIALECT
