"""Names, types and values of a node, written as the C++ of its client library."""

from __future__ import annotations

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Parameter
from plastron_tui.model.kinds.ranges import Interval
from plastron_tui.model.values import MessageValue
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.ros.qos import Qos
from plastron_tui.sources.cpp import interface_types, literals, naming
from plastron_tui.sources.cpp.computed import Computing, Functions
from plastron_tui.sources.cpp.messages import Filling
from plastron_tui.sources.cpp.qos_code import latch, profile
from plastron_tui.targets.planning.writing import Writing

from .dialect import Dialect

_PARAMETER_TYPES = {
    1: {"bool": "bool", "int": "int", "float": "double", "string": "std::string"},
    2: {"bool": "bool", "int": "int64_t", "float": "double", "string": "std::string"},
}
"""What a parameter's value is in C++ (`ros::NodeHandle::param`, `rclcpp::ParameterValue`)."""


class CppWriting(Writing):
    """Writes the expressions of one C++ node.

    What makes a message is a statement for each of its fields, of which the first declares it:
    `message`, `request` or `goal`; a response is there already.

    Attributes:
        dialect: the client library.
        headers: those that the types of its interfaces are in.
        functions: those of the file that its expressions call.
    """

    def __init__(self, node: Node, catalog: Catalog, dialect: Dialect, given: set[str]) -> None:
        """Begin a node in which the names in `given` are taken."""
        # An attribute is called as a method may be, with an underscore behind it.
        taken = {*given, *(name.removesuffix("_") for name in given)}
        scope = naming.Scope(taken | dialect.names)
        serving = "goal" if dialect.ros_version == 2 else "server"
        super().__init__(node, catalog, dialect.ros_version, scope, serving)
        self.dialect = dialect
        self.headers: set[str] = set()
        self.functions = Functions()

    @property
    def computing(self) -> Computing:
        """What writes the values that are known when they are sent."""
        # Not kept: each would hold the other, and only the cycle collector would free them.
        given = self.catalog, self.ros_version, self.node.span, self.parameter_value
        return Computing(*given, self.functions)

    def held(self, attribute: str) -> str:
        """Name what holds a part of the node: what nothing holds is gone at once in C++."""
        return self.attributes.new(attribute)

    def sending(self, attribute: str, *, is_repeated: bool) -> str:
        """Name what holds a sending: it has a thread, which something has to wait for."""
        del is_repeated
        return self.attributes.new(attribute)

    def method_key(self, name: str, type_: str) -> str:
        """Return what tells a function from others: C++ has several of one name."""
        return f"{name}({type_})"

    def string(self, text: str) -> str:
        """Write a string."""
        return literals.string(text)

    def setting(self, value: object) -> str:
        """Write the value of a parameter."""
        if isinstance(value, tuple):
            return f"{{{', '.join(map(self.setting, value))}}}"
        assert isinstance(value, (bool, int, float, str))
        return literals.scalar(value)

    def period(self, rate: str | float) -> str:
        """Write the seconds between two turns of what is done at a rate; in ROS 2, a duration."""
        seconds = f"1.0 / {rate if isinstance(rate, str) else literals.real(float(rate))}"
        if not self.is_ros2:
            return seconds
        milliseconds = 0 if isinstance(rate, str) else round(1000 / rate)
        if milliseconds and 1000 / milliseconds == rate:
            return f"std::chrono::milliseconds({milliseconds})"
        return f"std::chrono::duration<double>({seconds})"

    def follow_rate(self) -> None:
        """Leave it to the template, which sees the timers that follow."""

    def quality(self, qos: Qos | None, *, is_publisher: bool) -> str:
        """Write what a publisher or a subscription is given behind the rest."""
        if self.is_ros2:
            return profile(qos or Qos())
        return latch(qos, is_publisher=is_publisher)

    def message(self, value: MessageValue, span: Span | None, received: str = "received") -> str:
        """Write what makes a message that is called `message`."""
        interface = self.find(value.type, InterfaceKind.MESSAGE, span)
        class_ = self.class_of(interface.name, InterfaceKind.MESSAGE)
        lines = self._lines(interface, interface.fields, value, span, "message.", received)
        return "\n".join((f"{class_} message;", *lines))

    def request(self, type_: InterfaceName, value: MessageValue, span: Span | None) -> str:
        """Write what makes a request that is called `request`; ROS 1 keeps the answer with it."""
        interface = self.find(type_, InterfaceKind.SERVICE, span)
        class_ = self.class_of(type_, InterfaceKind.SERVICE)
        if self.is_ros2:
            first, holder = f"auto request = std::make_shared<{class_}::Request>();", "request->"
        else:
            first, holder = f"{class_} call;", "call.request."
        return "\n".join((first, *self._lines(interface, interface.fields, value, span, holder)))

    def goal(self, type_: InterfaceName, value: MessageValue, span: Span | None) -> str:
        """Write what makes a goal that is called `goal`."""
        interface = self.find(type_, InterfaceKind.ACTION, span)
        class_ = self.part_of(type_, InterfaceKind.ACTION, "Goal")
        lines = self._lines(interface, interface.fields, value, span, "goal.")
        return "\n".join((f"{class_} goal;", *lines))

    def empty_response(self, type_: InterfaceName) -> str:
        """Write nothing: the response is there, and says nothing."""
        del type_
        return ""

    def response(self, type_: InterfaceName, value: MessageValue, span: Span | None) -> str:
        """Write what fills a response, to a request that is called `request`."""
        interface = self.find(type_, InterfaceKind.SERVICE, span)
        self._heard = interface.fields
        holder = "response->" if self.is_ros2 else "response."
        fields = interface.response.fields
        return "\n".join(self._lines(interface, fields, value, span, holder, "request"))

    def _lines(
        self,
        interface: Interface,
        fields: tuple[Field, ...],
        value: MessageValue,
        span: Span | None,
        holder: str,
        received: str = "received",
    ) -> list[str]:
        """Write what sets the fields of a message that has a value; `holder` ends with its dot."""
        filling = Filling(self, self.computing, span, received, self._heard)
        return filling.lines(interface, fields, value, holder)

    def parameter(self, name: str) -> str:
        """Write the value that a parameter of the node has."""
        parameter = self.parameter_of(name)
        assert parameter.holds is not None  # statements say it
        own = parameter.name.removeprefix("~/")
        if not self.is_ros2:
            return f"{self.getter(own)}()"
        kind = {"bool": "bool", "int": "int", "float": "double", "string": "string"}
        element = kind[parameter.holds.element.value]
        array = {"bool": "bool", "int": "integer", "double": "double", "string": "string"}[element]
        reader = f"as_{array}_array" if parameter.holds.is_list else f"as_{element}"
        return f"get_parameter({literals.string(own)}).{reader}()"

    def parameter_name(self, name: str, *, is_own: bool) -> str:
        """Write the name of a parameter; the node's own ones are asked of a handle of their own."""
        del is_own
        return literals.string(name)

    def parameter_type(self, type_: ParameterType) -> str:
        """Write the type of a parameter's value."""
        element = _PARAMETER_TYPES[self.ros_version][type_.element.value]
        return f"std::vector<{element}>" if type_.is_list else element

    def descriptor(self, parameter: Parameter, limits: Interval | None) -> str:
        """Write the statements that fill a `descriptor` of ROS 2, "" where there is none."""
        lines = []
        if parameter.description:
            lines.append(f"descriptor.description = {literals.string(parameter.description)};")
        if limits is not None:
            kind = "integer" if isinstance(limits.least, int) else "floating_point"
            low, high = map(self.setting, limits)
            lines.append(f"descriptor.{kind}_range.resize(1);")
            lines.append(f"descriptor.{kind}_range[0].from_value = {low};")
            lines.append(f"descriptor.{kind}_range[0].to_value = {high};")
        return "\n".join(lines)

    def check(self, type_: ParameterType, limits: Interval | None) -> str:
        """Write what holds of a `value` that is within limits; its type is that of the getter."""
        del type_
        if limits is None:
            return ""
        low, high = map(self.setting, limits)
        return f"{low} <= value && value <= {high}"

    def class_of(self, type_: InterfaceName, kind: InterfaceKind) -> str:
        """Write the class of a type; that of an action of ROS 1 is the message of its parts."""
        part = "Action" if kind is InterfaceKind.ACTION and not self.is_ros2 else ""
        self.headers.add(interface_types.header(type_, kind, self.ros_version, part))
        return interface_types.class_name(type_, kind, self.ros_version) + part

    def part_of(self, type_: InterfaceName, kind: InterfaceKind, part: str) -> str:
        """Write the class of a part of a service or an action."""
        class_ = self.class_of(type_, kind)
        if kind is InterfaceKind.ACTION and not self.is_ros2:
            return class_.removesuffix("Action") + part
        return f"{class_}::{part}"

    def empty(self, type_: InterfaceName, kind: InterfaceKind, part: str) -> str:
        """Write the class of a part of which nothing is said."""
        return self.part_of(type_, kind, part)

    def unusable(self, interface: Interface) -> str | None:
        """Return what of C++ is the name of an interface or of a part of it, None for none."""
        return interface_types.unusable(interface, self.catalog)
