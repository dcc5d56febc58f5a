"""What a C++ text says of itself to who does not parse it."""

from __future__ import annotations

import re

_ROS1 = re.compile(rb'#[ \t]*include[ \t]*[<"]ros/|\bros::[A-Za-z]')
_ROSSERIAL = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*[<"]ros\.h[>"]', re.MULTILINE)
_ROSCPP = re.compile(rb'#[ \t]*include[ \t]*[<"]ros/')
"""What rosserial, the ROS of microcontrollers, does not have: its classes have the same names."""

_ROS2 = re.compile(rb'#[ \t]*include[ \t]*[<"]rclcpp|\brclcpp(?:_\w+)?::')
_NODELET = re.compile(
    rb"\bnodelet::Nodelet\b|\bPLUGINLIB_(?:EXPORT|DECLARE)_CLASS[ \t]*\([^;{}]*nodelet"
)
_COMPONENT = re.compile(
    rb"^[ \t]*(?:RCLCPP_COMPONENTS_REGISTER_NODE\w*[ \t]*\("
    rb"|CLASS_LOADER_REGISTER_CLASS[ \t]*\([^;{}]*\brclcpp::Node\b)",
    re.MULTILINE,
)
_REGISTERED = re.compile(
    rb"^[ \t]*(?:(?:PLUGINLIB_EXPORT_CLASS|CLASS_LOADER_REGISTER_CLASS"
    rb"|RCLCPP_COMPONENTS_REGISTER_NODE\w*)[ \t]*\("
    # Before pluginlib had that: package and name of the class come first.
    rb"|PLUGINLIB_DECLARE_CLASS[ \t]*\([^,()]*,[^,()]*,)"
    rb"\s*((?:::)?\w+(?:::\w+)*)\s*[,)]",
    re.MULTILINE,
)


def is_nodelet(text: bytes) -> bool:
    """Tell whether a text makes a nodelet known, or derives from it."""
    return _NODELET.search(text) is not None


def is_component(text: bytes) -> bool:
    """Tell whether a text registers a component."""
    return _COMPONENT.search(text) is not None


def registered_classes(text: bytes) -> list[str]:
    """Return the classes that a text registers as plugins or components, with their namespaces."""
    return [found.decode().removeprefix("::") for found in _REGISTERED.findall(text)]


def mentioned_library(text: bytes) -> str | None:
    """Return the client library that a text mentions, None for none."""
    if _ROS2.search(text) is not None:
        return "component" if is_component(text) else "rclcpp"
    if is_nodelet(text):
        return "nodelet"
    if _ROSSERIAL.search(text) is not None and _ROSCPP.search(text) is None:
        return None
    return "roscpp" if _ROS1.search(text) is not None else None
