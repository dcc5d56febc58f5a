"""The target `component`: C++ nodes for ROS 2 that are loaded into a container."""

from __future__ import annotations

from dataclasses import replace
from typing import ClassVar

from .dialect import Dialect
from .rclcpp import DIALECT as RCLCPP
from .target import CppTarget

DIALECT = replace(RCLCPP, library="component", like="rclcpp", is_plugin=True, is_split=True)


class ComponentTarget(CppTarget):
    """Writes, reads and edits component nodes."""

    name: ClassVar[str] = "component"
    ros_version: ClassVar[int] = 2
    writes_managed: ClassVar[bool] = True
    dialect: ClassVar[Dialect] = DIALECT
