"""Names, types and values of a node, written as the Python of its client library."""

from __future__ import annotations

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Parameter
from plastron_tui.model.kinds.ranges import Interval
from plastron_tui.model.values import Computed, MessageValue, Value
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType, Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.ros.qos import Qos
from plastron_tui.sources.python import literals, naming
from plastron_tui.sources.python.computed import Computing
from plastron_tui.sources.python.dialect import Dialect
from plastron_tui.sources.python.import_block import Imports
from plastron_tui.sources.python.qos_code import new_keywords, profile
from plastron_tui.targets.planning.writing import Writing

AS_FLOAT32 = "as_float32"
"""The function of a file that makes a number one of 32 bits."""

_IN_RANGE = "in_range"
_ALL_IN_RANGE = "all_in_range"
_DIVISOR = "divisor"

_RANGES = {ParameterType.INT: "IntegerRange", ParameterType.FLOAT: "FloatingPointRange"}
_RANGE_FIELDS = {ParameterType.INT: "integer_range", ParameterType.FLOAT: "floating_point_range"}

_CHECKS = {
    ParameterType.BOOL: "type({0}) is bool",
    ParameterType.INT: "type({0}) is int",
    ParameterType.FLOAT: "type({0}) in (int, float)",
    ParameterType.STRING: "type({0}) is str",
}
"""How a value of ROS 1 is seen to be of a type."""


class Functions(set[str]):
    """The functions of a file that keep from a field what it cannot hold."""

    def number(self, text: str, limits: Interval) -> str:
        """Let a number through that is in a range."""
        self.add(_IN_RANGE)
        return f"{_IN_RANGE}({text}, {limits.least}, {limits.most})"

    def numbers(self, text: str, limits: Interval) -> str:
        """Do so with each number of a list."""
        self.update((_IN_RANGE, _ALL_IN_RANGE))
        return f"{_ALL_IN_RANGE}({text}, {limits.least}, {limits.most})"

    def short(self) -> str:
        """Make a number one of 32 bits."""
        self.add(AS_FLOAT32)
        return AS_FLOAT32

    def element(self, holder: str, position: int) -> None:
        """Let Python raise the error."""

    def divisor(self, text: str) -> str:
        """Let a number through that is not 0."""
        self.add(_DIVISOR)
        return f"{_DIVISOR}({text})"


class PythonWriting(Writing):
    """Writes the expressions of one Python file.

    Attributes:
        dialect: the client library.
        imports: what the file imports.
        functions: those of the file that its expressions call.
    """

    def __init__(
        self, node: Node, catalog: Catalog, dialect: Dialect, imports: Imports, given: set[str]
    ) -> None:
        """Begin a file in which the names in `given` are taken."""
        managed = dialect.managed_names if node.is_managed else ()
        taken = {*dialect.attribute_names, *dialect.task_names, *managed, *given}
        super().__init__(node, catalog, dialect.ros_version, naming.Scope(taken), dialect.serving)
        self.dialect = dialect
        self.imports = imports
        self.functions = Functions()

    @property
    def computing(self) -> Computing:
        """What writes the values that are known when they are sent."""
        # Not kept: each would hold the other, and only the cycle collector would free them.
        given = self.catalog, self.ros_version, self.node.span, self.parameter_value
        return Computing(*given, self.dialect, self.functions)

    def string(self, text: str) -> str:
        """Write a string."""
        return literals.string(text)

    def setting(self, value: object) -> str:
        """Write the value of a parameter."""
        if isinstance(value, tuple):
            return f"[{', '.join(map(self.setting, value))}]"
        if isinstance(value, str):
            return literals.string(value)
        if isinstance(value, bool):
            return repr(value)
        assert isinstance(value, (int, float))
        return literals.number(value)

    def period(self, rate: str | float) -> str:
        """Write the seconds between two turns of what is done at a rate."""
        if isinstance(rate, str):
            return f"1 / {rate}"
        return f"1 / {literals.number(int(rate) if rate.is_integer() else rate)}"

    def follow_rate(self) -> None:
        """Import what rclpy wants of a function that is asked about parameters."""
        if self.is_ros2:
            self.imports.use("rcl_interfaces.msg", "SetParametersResult")

    def quality(self, qos: Qos | None, *, is_publisher: bool) -> str:
        """Write what a publisher or a subscription is given behind the rest, "" for nothing."""
        if self.is_ros2:
            return profile(qos or Qos(), self.imports.use)
        found = new_keywords(qos, is_publisher=is_publisher)
        return ", ".join(f"{name}={value}" for name, value in found.items())

    def request(self, type_: InterfaceName, value: MessageValue, span: Span | None) -> str:
        """Write a request of a service's type."""
        interface = self.find(type_, InterfaceKind.SERVICE, span)
        class_ = self.dialect.request(type_, self.imports)
        return f"{class_}({self._arguments(interface, interface.fields, value, span)})"

    def goal(self, type_: InterfaceName, value: MessageValue, span: Span | None) -> str:
        """Write a goal of an action's type."""
        interface = self.find(type_, InterfaceKind.ACTION, span)
        class_ = self.part_of(type_, InterfaceKind.ACTION, "Goal")
        return f"{class_}({self._arguments(interface, interface.fields, value, span)})"

    def empty_response(self, type_: InterfaceName) -> str:
        """Write a response of a service's type in which nothing is said."""
        return self.dialect.response(type_, self.imports)

    def response(self, type_: InterfaceName, value: MessageValue, span: Span | None) -> str:
        """Write a response of a service's type, to a request that is called `request`."""
        interface = self.find(type_, InterfaceKind.SERVICE, span)
        self._heard = interface.fields
        class_ = self.dialect.response(type_, self.imports).removesuffix("()")
        fields = interface.response.fields
        return f"{class_}({self._arguments(interface, fields, value, span, 'request')})"

    def message(self, value: MessageValue, span: Span | None, received: str = "received") -> str:
        """Write a message; `received` is what holds the message that it is an answer to."""
        interface = self.find(value.type, InterfaceKind.MESSAGE, span)
        class_ = self.class_of(interface.name, InterfaceKind.MESSAGE)
        return f"{class_}({self._arguments(interface, interface.fields, value, span, received)})"

    def _arguments(
        self,
        interface: Interface,
        fields: tuple[Field, ...],
        value: MessageValue,
        span: Span | None,
        received: str = "received",
    ) -> str:
        written = []
        for name, each in value.fields.items():
            field = self.checked_field(interface, fields, name, span)
            argument = self.dialect.field(name)
            written.append(f"{argument}={self._value(field.type, each, span, received)}")
        return ", ".join(written)

    def _value(self, type_: FieldType, value: Value, span: Span | None, received: str) -> str:
        if isinstance(value, Computed):
            return self.computing.write(value, received, self._heard)
        if type_.is_array and isinstance(value, tuple):
            items = (self._value(type_.element, each, span, received) for each in value)
            return f"[{', '.join(items)}]"
        if isinstance(value, MessageValue):
            return self.message(value, span, received)
        return self.dialect.scalar(type_, value, self.imports)

    def parameter(self, name: str) -> str:
        """Write the value that a parameter of the node has."""
        parameter = self.parameter_of(name)
        return self.dialect.parameter(parameter, self.getter)

    def parameter_type(self, type_: ParameterType) -> str:
        """Write no type: Python needs none."""
        del type_
        return ""

    def descriptor(self, parameter: Parameter, limits: Interval | None) -> str:
        """Write what describes a parameter, "" where there is nothing to say.

        A range is one of `rcl_interfaces/ParameterDescriptor`, by which rclpy refuses what is not
        in it.
        """
        given = []
        if parameter.description:
            given.append(f"description={literals.string(parameter.description)}")
        if limits is not None:
            assert parameter.holds is not None
            class_ = self.imports.use("rcl_interfaces.msg", _RANGES[parameter.holds])
            low, high = map(self.setting, limits)
            field = _RANGE_FIELDS[parameter.holds]
            given.append(f"{field}=[{class_}(from_value={low}, to_value={high})]")
        if not given:
            return ""
        class_ = self.imports.use("rcl_interfaces.msg", "ParameterDescriptor")
        return f"{class_}({', '.join(given)})"

    def check(self, type_: ParameterType, limits: Interval | None) -> str:
        """Write what holds of a `value` that is of a type, and within limits."""
        check = _CHECKS[type_.element]
        if type_.is_list:
            return f"type(value) is list and all({check.format('each')} for each in value)"
        written = check.format("value")
        if limits is None:
            return written
        low, high = map(self.setting, limits)
        return f"{written} and {low} <= value <= {high}"

    def class_of(self, type_: InterfaceName, kind: InterfaceKind) -> str:
        """Write the class of a type."""
        return self.dialect.class_of(type_, kind, self.imports)

    def part_of(self, type_: InterfaceName, kind: InterfaceKind, part: str) -> str:
        """Write the class of a part of a service or an action."""
        return self.dialect.part_of(type_, kind, part, self.imports)

    def empty(self, type_: InterfaceName, kind: InterfaceKind, part: str) -> str:
        """Write a part of a service or an action in which nothing is said."""
        return f"{self.part_of(type_, kind, part)}()"

    def unusable(self, interface: Interface) -> str | None:
        """Return why there is no class of an interface, None where there is one."""
        return self.dialect.unusable(interface, self.catalog)
