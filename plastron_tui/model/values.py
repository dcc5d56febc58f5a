"""The values of a message, checked against its type, with nothing of their syntax left."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from plastron_tui.ros.interfaces import InterfaceName


@dataclass(frozen=True, slots=True)
class MessageValue:
    """The fields of a message that were given a value, by name, in the order of the type.

    What is not there keeps its default. A scalar is a Python `bool`, `int`, `float` or `str`
    that fits its field (a float field always has a `float`); an array is a tuple; a `time` or
    `duration` of ROS 1 is a tuple of its seconds and nanoseconds.
    """

    type: InterfaceName
    fields: dict[str, Value]


Value: TypeAlias = "bool | int | float | str | MessageValue | tuple[Value, ...]"
