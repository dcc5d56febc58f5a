"""Interface types in C++: their classes, and the headers that define them.

Sources: `gencpp` (ROS 1), `rosidl_generator_cpp` and `rosidl_pycommon` (ROS 2).
"""

from __future__ import annotations

import re

from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName


def snake_case(name: str) -> str:
    """Return the name of a type as rosidl names its header: `ROIInfo2D` is `roi_info2_d`."""
    name = re.sub(r"(.)([A-Z][a-z]+)", r"\1_\2", name)
    return re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name).lower()


def header(type_: InterfaceName, kind: InterfaceKind, ros_version: int, part: str = "") -> str:
    """Return the header of a type; `part` is the message of an action in ROS 1 (`Action`, …)."""
    if ros_version == 1:
        return f"{type_.package}/{type_.name}{part}.h"
    return f"{type_.package}/{kind.value}/{snake_case(type_.name)}.hpp"


def class_name(type_: InterfaceName, kind: InterfaceKind, ros_version: int) -> str:
    """Return the class of a type."""
    folder = "" if ros_version == 1 else f"{kind.value}::"
    return f"{type_.package}::{folder}{type_.name}"
