"""The types of parameters."""

from __future__ import annotations

import sys
from enum import Enum

Scalar = bool | int | float | str
Setting = Scalar | tuple[Scalar, ...]
"""What a parameter can hold; a list is a tuple."""

INTEGERS = range(-(2**63), 2**63)
"""What an integer parameter of ROS 2 can hold (rcl_interfaces/ParameterValue: an int64)."""


OF_EVERY_NODE = ("use_sim_time", "start_type_description_service", "qos_overrides")
"""The parameters that each node of ROS 2 declares itself; the last one has others below it.

Sources: `rclpy/time_source.py`, `rclpy/type_description_service.py`,
`rclpy/qos_overriding_options.py`.
"""


class ParameterType(str, Enum):
    """What a parameter holds, as programs name it.

    ROS 2 has these, and lists of bytes besides (rcl_interfaces/ParameterType). ROS 1 takes what
    YAML can say (wiki.ros.org/Parameter Server).
    """

    BOOL = "bool"
    INT = "int"
    FLOAT = "float"
    STRING = "string"
    BOOL_LIST = "bool_list"
    INT_LIST = "int_list"
    FLOAT_LIST = "float_list"
    STRING_LIST = "string_list"

    @property
    def is_list(self) -> bool:
        """Whether it is a list."""
        return self.value.endswith("_list")

    @property
    def element(self) -> ParameterType:
        """The type of a list's elements; what is no list is its own."""
        return ParameterType(self.value.removesuffix("_list"))

    @property
    def is_number(self) -> bool:
        """Whether it is a single number."""
        return self in (ParameterType.INT, ParameterType.FLOAT)


def as_setting(type_: ParameterType, value: object) -> Setting | None:
    """Return a value as a parameter of a type holds it, None where it cannot."""
    if type_.is_list:
        if not isinstance(value, (tuple, list)):
            return None
        found = [_scalar(type_.element, each) for each in value]
        return None if None in found else tuple(each for each in found if each is not None)
    return _scalar(type_, value)


def _scalar(type_: ParameterType, value: object) -> Scalar | None:
    if isinstance(value, bool):
        return value if type_ is ParameterType.BOOL else None
    if isinstance(value, str):
        return value if type_ is ParameterType.STRING else None
    if isinstance(value, int) and type_ is ParameterType.INT:
        return value if value in INTEGERS else None
    if isinstance(value, (int, float)) and type_ is ParameterType.FLOAT:
        return float(value) if abs(value) <= sys.float_info.max else None
    return None
