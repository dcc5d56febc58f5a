"""The target `roscpp`: C++ nodes for ROS 1."""

from __future__ import annotations

from typing import ClassVar

from .dialect import Dialect
from .target import CppTarget

DIALECT = Dialect(library="roscpp", ros_version=1)


class RoscppTarget(CppTarget):
    """Writes, reads and edits roscpp nodes."""

    name: ClassVar[str] = "roscpp"
    ros_version: ClassVar[int] = 1
    dialect: ClassVar[Dialect] = DIALECT
