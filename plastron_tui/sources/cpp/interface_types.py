"""Interface types in C++: their classes, and the headers that define them.

Sources: `gencpp` (ROS 1), `rosidl_generator_cpp` and `rosidl_pycommon` (ROS 2).
"""

from __future__ import annotations

import re

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName

from .keywords import is_keyword, is_taken


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


def unusable(interface: Interface, catalog: Catalog) -> str | None:
    """Return what of C++ is the name of an interface, a part of it or a field, None for none.

    The generators write it all the same, into a header that no compiler takes.
    """
    seen, left = {interface.name}, [interface]
    while left:
        each = left.pop()
        if (reason := _taken_name(each)) is not None:
            return reason
        for field in (field for section in each.sections for field in section.fields):
            if field.type.message is not None and field.type.message not in seen:
                seen.add(field.type.message)
                part = catalog.find(field.type.message, InterfaceKind.MESSAGE)
                left += [part] if part is not None else []
    return None


def _taken_name(interface: Interface) -> str | None:
    for word in (interface.name.package, interface.name.name):
        if is_taken(word):
            return f"`{interface.name}` has a name that is {_what(word)} of C++"
    for field in (field for section in interface.sections for field in section.fields):
        if is_taken(field.name):
            name = f"`{interface.name}` has a field `{field.name}`"
            return f"{name}, which is {_what(field.name)} of C++"
    return None


def _what(word: str) -> str:
    return "a keyword" if is_keyword(word) else "a macro"
