"""The target `rospy`: Python nodes for ROS 1."""

from __future__ import annotations

import keyword
from collections.abc import Callable
from typing import ClassVar

from plastron_tui.model.kinds import Parameter
from plastron_tui.model.values import Value
from plastron_tui.ros.interfaces import FieldType, InterfaceKind, InterfaceName
from plastron_tui.sources.python.dialect import Dialect, plain_scalar
from plastron_tui.sources.python.import_block import Imports

from .target import PythonTarget

_TASK_NAMES = """
    ask call end_goals exit_status fail is_served send_goal wait_for_action wait_until_served work
"""


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

    def parameter(self, parameter: Parameter, getter: Callable[[str], str]) -> str:
        """Write what reads a parameter: the parameter server takes whatever it is told."""
        return f"self.{getter(parameter.name)}()"

    def class_of(self, type_: InterfaceName, kind: InterfaceKind, imports: Imports) -> str:
        """Return the class of a type; that of an action is the message that genaction makes."""
        if kind is InterfaceKind.ACTION:
            return self.part_of(type_, kind, "Action", imports)
        return super().class_of(type_, kind, imports)

    def part_of(
        self, type_: InterfaceName, kind: InterfaceKind, part: str, imports: Imports
    ) -> str:
        """Return the class that genpy makes beside that of a service, or of an action's message."""
        folder = kind if kind is InterfaceKind.SERVICE else InterfaceKind.MESSAGE
        return imports.use(f"{type_.package}.{folder.value}", f"{type_.name}{part}")


DIALECT = _Rospy(
    library="rospy",
    ros_version=1,
    standard=("signal",),
    calling=("sys", "threading"),
    timing=("threading",),
    modules=("rospy",),
    symbols=(),
    server_symbols=(("actionlib", "SimpleActionServer"),),
    client_symbols=(("actionlib", "SimpleActionClient"),),
    goal_symbols=(("actionlib", "GoalStatus"),),
    task_symbols=(),
    module_names=frozenset(
        {"SERVICE_TIMEOUT", "WARNING_PERIOD", "all_in_range", "as_float32", "ctypes", "in_range"}
        | {"divisor", "interrupt", "main", "node", "worker"}
    ),
    method_names=frozenset(),
    attribute_names=frozenset({"follow_rates"}),
    task_names=frozenset(_TASK_NAMES.split()),
    serving="server",
)


class RospyTarget(PythonTarget):
    """Writes, reads and edits rospy nodes."""

    name: ClassVar[str] = "rospy"
    ros_version: ClassVar[int] = 1
    package_folder: ClassVar[str] = "scripts"
    dialect: ClassVar[Dialect] = DIALECT
