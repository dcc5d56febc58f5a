"""How a unit logs, and what logs in its manner."""

from __future__ import annotations

import re
from collections import Counter

from ..nodes import group
from .adding import Addition
from .handles import is_nodelet_place

_ROS2_CALL = re.compile(
    r"\bRCLCPP_(?:DEBUG|INFO|WARN|ERROR)(_STREAM)?\(\s*((?:[^(),]|\([^()]*\))+),"
)


def log_line(added: Addition, label: str, value: str, *, level: str = "INFO") -> str:
    """Write a statement that logs a value in a callback; "" as the value for the label alone.

    Args:
        added: the endpoint.
        label: what stands before the value, in plain characters.
        value: an expression that a stream takes: in ROS 2 a text, in ROS 1 a message.
        level: the level.
    """
    if not added.is_ros2:
        macro = f"{_ros1_macro(added)}_{level}"
        if not value:
            return f'{macro}("{label}");'
        return f'{macro}_STREAM("{label}: " << {value});'
    logger, is_stream = _logger(added)
    if not value:
        return f'RCLCPP_{level}({logger}, "{label}");'
    if is_stream:
        return f'RCLCPP_{level}_STREAM({logger}, "{label}: " << {value});'
    return f'RCLCPP_{level}({logger}, "{label}: %s", {value}.c_str());'


def _ros1_macro(added: Addition) -> str:
    text = added.place.file.syntax.code
    if is_nodelet_place(added.analysis, added.place):
        return "NODELET" if b"NODELET_" in text or b"ROS_" not in text else "ROS"
    return "ROS"


def _logger(added: Addition) -> tuple[str, bool]:
    """Return what a callback logs with, and whether the file logs streams."""
    code = added.place.file.syntax.code.decode(added.place.file.syntax.encoding, "replace")
    found = list(_ROS2_CALL.finditer(code))
    streams = sum(each[1] is not None for each in found)
    is_stream = streams * 2 > len(found)
    loggers = Counter(each[2].strip() for each in found)
    if added.owner is not None:
        members = {
            name for base in added.analysis.unit.bases(added.owner) for name in base.variables
        }
        for text, _ in loggers.most_common():
            name = text.removeprefix("this->")
            is_own = name == "get_logger()" and not added.place.node.strip("this->")
            if is_own or re.split(r"->|\.|\(", name)[0] in members:
                return text, is_stream
        receiver = added.place.node
        first = re.split(r"->|\.", receiver.removeprefix("this->"))[0]
        if receiver in ("", "this->") or first in members:
            return f"{receiver}get_logger()", is_stream
    for text, _ in loggers.most_common():
        if text.startswith("rclcpp::get_logger("):
            return text, is_stream
    names = [node.label for node in group(added.analysis) if added.label in ("", node.label)]
    name = names[0] if len(names) == 1 and names[0] else "node"
    return f'rclcpp::get_logger("{name}")', is_stream
