"""The target `rospy`: Python nodes for ROS 1."""

from __future__ import annotations

import keyword
from typing import ClassVar

from plastron_tui.model.kinds import Parameter
from plastron_tui.model.values import Value
from plastron_tui.ros.interfaces import FieldType, InterfaceName
from plastron_tui.sources.python import naming
from plastron_tui.sources.python.dialect import Dialect, plain_scalar
from plastron_tui.sources.python.import_block import Imports

from .target import PythonTarget


class _Rospy(Dialect):
    __slots__ = ()

    def scalar(self, type_: FieldType, value: Value, imports: Imports) -> str:
        """Write one value; a time is a pair of seconds and nanoseconds."""
        if type_.name in {"time", "duration"} and isinstance(value, tuple):
            seconds, nanoseconds = map(plain_scalar, value)
            return f"rospy.{type_.name.capitalize()}({seconds}, {nanoseconds})"
        return plain_scalar(value)

    def field(self, name: str) -> str:
        """Return a field's name; genpy puts `_` behind one that is a word of Python's own."""
        return f"{name}_" if keyword.iskeyword(name) else name

    def parameter(self, parameter: Parameter) -> str:
        """Write what reads a parameter: the parameter server takes whatever it is told."""
        return f"self.get_{naming.words(parameter.name.removeprefix('~/'))}()"

    def request(self, type_: InterfaceName, imports: Imports) -> str:
        """Return the request class that genpy makes beside a service's class."""
        return imports.use(f"{type_.package}.srv", f"{type_.name}Request")

    def response(self, type_: InterfaceName, imports: Imports) -> str:
        """Return an empty response of the class that genpy makes beside a service's class."""
        return f"{imports.use(f'{type_.package}.srv', f'{type_.name}Response')}()"


DIALECT = _Rospy(
    library="rospy",
    ros_version=1,
    standard=("signal",),
    calling=("sys", "threading"),
    modules=("rospy",),
    symbols=(),
    module_names=frozenset(
        {
            "SERVICE_TIMEOUT",
            "all_in_range",
            "as_float32",
            "ctypes",
            "in_range",
            "interrupt",
            "main",
            "node",
        }
    ),
    method_names=frozenset(),
    attribute_names=frozenset(
        {"ask", "ask_in_time", "call", "call_services", "exit_status", "follow_rates"}
    ),
)


class RospyTarget(PythonTarget):
    """Writes, reads and edits rospy nodes."""

    name: ClassVar[str] = "rospy"
    ros_version: ClassVar[int] = 1
    dialect: ClassVar[Dialect] = DIALECT
