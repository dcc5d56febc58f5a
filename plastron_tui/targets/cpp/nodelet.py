"""The target `nodelet`: C++ nodes for ROS 1."""

from __future__ import annotations

from typing import ClassVar

from .dialect import Dialect
from .target import CppTarget

DIALECT = Dialect(library="nodelet", ros_version=1, like="roscpp", is_plugin=True)


class NodeletTarget(CppTarget):
    """Writes, reads and edits nodelet nodes."""

    name: ClassVar[str] = "nodelet"
    ros_version: ClassVar[int] = 1
    dialect: ClassVar[Dialect] = DIALECT
