"""The target `rclcpp`: C++ nodes for ROS 2."""

from __future__ import annotations

from typing import ClassVar

from .dialect import Dialect
from .target import CppTarget

DIALECT = Dialect(library="rclcpp", ros_version=2)


class RclcppTarget(CppTarget):
    """Writes, reads and edits rclcpp nodes."""

    name: ClassVar[str] = "rclcpp"
    ros_version: ClassVar[int] = 2
    dialect: ClassVar[Dialect] = DIALECT
