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


_SCALARS = {
    "bool": "bool",
    "float32": "float",
    "float64": "double",
    "string": "std::string",
    "wstring": "std::u16string",
    "char": "uint8_t",
    "time": "ros::Time",
    "duration": "ros::Duration",
}


def scalar_class(name: str, ros_version: int) -> str:
    """Return the C++ type of a primitive: `byte` is signed in ROS 1, and `bool` one of 8 bits."""
    if ros_version == 1 and name in {"bool", "byte"}:
        return "uint8_t" if name == "bool" else "int8_t"
    return _SCALARS.get(name) or ("uint8_t" if name == "byte" else f"{name}_t")
