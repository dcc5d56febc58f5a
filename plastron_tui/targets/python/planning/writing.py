"""Names, types and values of a node, written as the Python of its client library."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NoReturn

from plastron_tui.diagnostics import Code, Diagnostic, Span, codes
from plastron_tui.model.kinds import Endpoint, Parameter
from plastron_tui.model.kinds.ranges import EVERY_FLOAT, EVERY_INTEGER, Interval, limits_of
from plastron_tui.model.values import (
    Computed,
    MessageValue,
    Value,
    computed_in,
)
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog, moved
from plastron_tui.ros.interfaces import Field, FieldType, Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.names import name_as_written, parameter_name
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.sources.python import literals, naming
from plastron_tui.sources.python.computed import Computing
from plastron_tui.sources.python.dialect import Dialect
from plastron_tui.sources.python.import_block import Imports

from ..plan import MethodPlan, SendPlan

AS_FLOAT32 = "as_float32"
"""The function of a file that makes a number one of 32 bits."""

_IN_RANGE = "in_range"
_ALL_IN_RANGE = "all_in_range"
_HEADER = InterfaceName("std_msgs", "Header")
_EVERY = {ParameterType.INT: EVERY_INTEGER, ParameterType.FLOAT: EVERY_FLOAT}


class CannotPlanError(Exception):
    """A part of the node that its client library cannot have; the diagnostic says which."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


class _Functions(set[str]):
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


class Writing:
    """Writes the expressions of one file, and keeps its names apart.

    Attributes:
        node: the node.
        catalog: the interface types.
        dialect: the client library.
        imports: what the file imports.
        attributes: the names of what the node's class has.
        methods: the functions that endpoints call, by their names.
        functions: those of the file that its expressions call.
    """

    def __init__(
        self, node: Node, catalog: Catalog, dialect: Dialect, imports: Imports, given: set[str]
    ) -> None:
        """Begin a file in which the names in `given` are taken."""
        self.node = node
        self.catalog = catalog
        self.dialect = dialect
        self.imports = imports
        managed = dialect.managed_names if node.is_managed else ()
        self.attributes = naming.Scope(
            {*dialect.attribute_names, *dialect.task_names, *managed, *given}
        )
        self.methods: dict[str, MethodPlan] = {}
        self.functions = _Functions()
        self._heard: Sequence[Field] = ()

    @property
    def is_rclpy(self) -> bool:
        """Whether the file is one of ROS 2."""
        return self.dialect.ros_version == 2

    @property
    def computing(self) -> Computing:
        """What writes the values that are known when they are sent."""
        # Not kept: each would hold the other, and only the cycle collector would free them.
        given = self.catalog, self.dialect, self.node.span
        return Computing(*given, self._parameter_value, self.functions)

    def held(self, attribute: str) -> str:
        """Name what holds a part of a managed node, which destroys it later; "" in other nodes."""
        return self.attributes.new(attribute) if self.node.is_managed else ""

    def name(self, endpoint: Endpoint) -> str:
        """Write the name of an endpoint as the client library takes it."""
        return literals.string(name_as_written(endpoint.name, self.dialect.ros_version))

    def send(self, value: MessageValue, span: Span | None, heard: Sequence[Field] = ()) -> SendPlan:
        """Write a message that is sent; `heard` are the fields of what is received then."""
        self._heard = heard
        type_ = self.find(value.type, InterfaceKind.MESSAGE, span)
        has_header = any(
            field.name == "header" and field.type.message == _HEADER for field in type_.fields
        )
        header = value.fields.get("header")
        has_time = isinstance(header, Computed) or (
            isinstance(header, MessageValue) and "stamp" in header.fields
        )
        return SendPlan(
            self.message(value, span),
            has_header and not has_time,
            self.unsure(value),
        )

    def unsure(self, value: MessageValue) -> tuple[str, ...]:
        """Name what a message is computed of that may not be there, or fit no field."""
        found = (each for each in computed_in(value) if self.computing.may_fail(each, self._heard))
        return tuple(dict.fromkeys(str(each.source) for each in found))

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
        class_ = self.imports.use(f"{interface.name.package}.msg", interface.name.name)
        return f"{class_}({self._arguments(interface, interface.fields, value, span, received)})"

    def _arguments(
        self,
        interface: Interface,
        fields: tuple[Field, ...],
        value: MessageValue,
        span: Span | None,
        received: str = "received",
    ) -> str:
        types = {field.name: field.type for field in fields}
        written = []
        for name, each in value.fields.items():
            if name not in types:
                message = f"`{interface.name}` has no field `{name}` in {self.catalog.distribution}"
                self.refuse(codes.UNKNOWN_FIELD, message, span, self._note(interface.name))
            argument = self.dialect.field(name)
            written.append(f"{argument}={self._value(types[name], each, span, received)}")
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
        return self.dialect.parameter(self.parameter_of(name))

    def _parameter_value(self, name: str) -> tuple[str, Interval | None]:
        parameter = self.parameter_of(name)
        assert parameter.holds is not None  # statements say it
        limits = limits_of(self.node, parameter, self.dialect.ros_version)
        return self.parameter(name), limits or _EVERY.get(parameter.holds.element)

    def parameter_of(self, name: str) -> Parameter:
        """Return the parameter of the node that a value names."""
        parameters = self.node.of(Parameter)
        # A node of ROS 1 may be written for ROS 2, which has no sign for its own ones.
        names = (parameter_name(name.removeprefix("~/"), version) for version in (1, 2))
        return next(parameters[each] for each in names if each in parameters)

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

    def message_class(self, type_: InterfaceName | None, name: str, span: Span | None) -> str:
        """Write the class of an endpoint's messages."""
        found = self.known(type_, InterfaceKind.MESSAGE, name, span)
        return self.imports.use(f"{found.package}.msg", found.name)

    def class_of(self, type_: InterfaceName, kind: InterfaceKind) -> str:
        """Write the class of a type."""
        return self.dialect.class_of(type_, kind, self.imports)

    def part_of(self, type_: InterfaceName, kind: InterfaceKind, part: str) -> str:
        """Write the class of a part of a service or an action."""
        return self.dialect.part_of(type_, kind, part, self.imports)

    def known(
        self, type_: InterfaceName | None, kind: InterfaceKind, name: str, span: Span | None
    ) -> InterfaceName:
        """Return the type of an endpoint as the distribution names it."""
        if type_ is None:
            message = f"the type of `{name}` is not known"
            self.refuse(codes.UNKNOWN_TYPE, message, span, "name its type in the source file")
        return self.find(type_, kind, span).name

    def find(self, type_: InterfaceName, kind: InterfaceKind, span: Span | None) -> Interface:
        """Return an interface, under its new name where ROS has renamed it."""
        found = self.catalog.find(type_, kind)
        if found is None:
            instead = moved(type_, self.catalog.ros_version)
            if isinstance(instead, InterfaceName):
                found = self.catalog.find(instead, kind)
        if found is None:
            message = f"{self.catalog.distribution} has no type `{type_}`"
            self.refuse(codes.UNKNOWN_TYPE, message, span, self._note(type_))
        reason = self.dialect.unusable(found, self.catalog)
        if reason is not None:
            self.refuse(codes.UNUSABLE_TYPE, reason, span)
        return found

    def _note(self, type_: InterfaceName) -> str | None:
        """Return what is known to have become of a type."""
        note = moved(type_, self.catalog.ros_version)
        return f"use `{note}`" if isinstance(note, InterfaceName) else note

    def refuse(
        self, code: Code, message: str, span: Span | None, help_text: str | None = None
    ) -> NoReturn:
        """Stop: the client library cannot have a part of the node."""
        raise CannotPlanError(Diagnostic(code, message, span or self.node.span, help=help_text))
