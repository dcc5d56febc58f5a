"""The target `component`: C++ nodes for ROS 2."""

from __future__ import annotations

from typing import ClassVar

from .dialect import Dialect
from .target import CppTarget

DIALECT = Dialect(library="component", ros_version=2, like="rclcpp", is_plugin=True)


class ComponentTarget(CppTarget):
    """Writes, reads and edits component nodes."""

    name: ClassVar[str] = "component"
    ros_version: ClassVar[int] = 2
    dialect: ClassVar[Dialect] = DIALECT
