"""Names, types and values of a node, written in the language of its client library."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import NoReturn, Protocol

from plastron_tui.diagnostics import Code, Diagnostic, Span, codes
from plastron_tui.model.kinds import Condition, Endpoint, Parameter
from plastron_tui.model.kinds.ranges import EVERY_FLOAT, EVERY_INTEGER, Interval, limits_of
from plastron_tui.model.values import Computed, MessageValue, Origin, computed_in
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog, moved
from plastron_tui.ros.interfaces import Field, Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.names import name_as_written, parameter_name
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.ros.qos import Qos
from plastron_tui.sources import naming
from plastron_tui.sources.naming import Scope

from .plan import MethodPlan, SendPlan

_HEADER = InterfaceName("std_msgs", "Header")
_EVERY = {ParameterType.INT: EVERY_INTEGER, ParameterType.FLOAT: EVERY_FLOAT}


class CannotPlanError(Exception):
    """A part of the node that its client library cannot have; the diagnostic says which."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


class Computing(Protocol):
    """What writes the values that are known when they are sent."""

    def may_fail(self, value: Computed, heard: Sequence[Field]) -> bool:
        """Tell whether there may be no value, or one that its field does not take."""

    def lacks(self, source: Origin, heard: Sequence[Field]) -> bool:
        """Tell whether a list may have too few elements."""

    def condition(
        self, condition: Condition, holder: str, heard: Sequence[Field], value: str
    ) -> str:
        """Write what must hold of a message that `holder` holds."""


class Writing(ABC):
    """Writes the expressions of one file, and keeps its names apart.

    What is planned is the same in all languages; how it is written, each says itself.

    Attributes:
        node: the node.
        catalog: the interface types.
        ros_version: the generation of ROS that the file is for, 1 or 2.
        attributes: the names of what the node's class has.
        methods: the functions that endpoints call, by their keys.
        serving: how the attribute of an action ends that a node provides.
    """

    def __init__(
        self, node: Node, catalog: Catalog, ros_version: int, attributes: Scope, serving: str
    ) -> None:
        self.node = node
        self.catalog = catalog
        self.ros_version = ros_version
        self.attributes = attributes
        self.serving = serving
        self.methods: dict[str, MethodPlan] = {}
        self._heard: Sequence[Field] = ()
        self._getters: dict[str, str] = {}

    @property
    def is_ros2(self) -> bool:
        """Whether the file is one of ROS 2."""
        return self.ros_version == 2

    @property
    @abstractmethod
    def computing(self) -> Computing:
        """What writes the values that are known when they are sent."""

    @abstractmethod
    def string(self, text: str) -> str:
        """Write a string."""

    @abstractmethod
    def setting(self, value: object) -> str:
        """Write the value of a parameter."""

    @abstractmethod
    def period(self, rate: str | float) -> str:
        """Write the seconds between two turns of what is done at a rate.

        Args:
            rate: the rate in hertz, or what reads it.
        """

    @abstractmethod
    def quality(self, qos: Qos | None, *, is_publisher: bool) -> str:
        """Write what a publisher or a subscription is given behind the rest, "" for nothing."""

    @abstractmethod
    def message(self, value: MessageValue, span: Span | None, received: str = "received") -> str:
        """Write a message; `received` is what holds the message that it is an answer to."""

    @abstractmethod
    def request(self, type_: InterfaceName, value: MessageValue, span: Span | None) -> str:
        """Write a request of a service's type."""

    @abstractmethod
    def goal(self, type_: InterfaceName, value: MessageValue, span: Span | None) -> str:
        """Write a goal of an action's type."""

    @abstractmethod
    def empty_response(self, type_: InterfaceName) -> str:
        """Write a response of a service's type in which nothing is said."""

    @abstractmethod
    def response(self, type_: InterfaceName, value: MessageValue, span: Span | None) -> str:
        """Write a response of a service's type, to a request that is called `request`."""

    @abstractmethod
    def class_of(self, type_: InterfaceName, kind: InterfaceKind) -> str:
        """Write the class of a type."""

    @abstractmethod
    def part_of(self, type_: InterfaceName, kind: InterfaceKind, part: str) -> str:
        """Write the class of a part of a service or an action."""

    @abstractmethod
    def empty(self, type_: InterfaceName, kind: InterfaceKind, part: str) -> str:
        """Write a part of a service or an action in which nothing is said."""

    @abstractmethod
    def parameter(self, name: str) -> str:
        """Write the value that a parameter of the node has."""

    @abstractmethod
    def parameter_type(self, type_: ParameterType) -> str:
        """Write the type of a parameter's value, "" in a language that needs none."""

    @abstractmethod
    def descriptor(self, parameter: Parameter, limits: Interval | None) -> str:
        """Write what describes a parameter of ROS 2, "" where there is nothing to say."""

    @abstractmethod
    def check(self, type_: ParameterType, limits: Interval | None) -> str:
        """Write what holds of a `value` of ROS 1 that is of a type, and within limits."""

    @abstractmethod
    def unusable(self, interface: Interface) -> str | None:
        """Return why there is no class of an interface, None where there is one."""

    @abstractmethod
    def follow_rate(self) -> None:
        """Note that the file has a rate that is the value of a parameter."""

    def held(self, attribute: str) -> str:
        """Name what holds a part of a managed node, which destroys it later; "" in other nodes."""
        return self.attributes.new(attribute) if self.node.is_managed else ""

    def sending(self, attribute: str, *, is_repeated: bool) -> str:
        """Name what holds the last sending of requests or goals, "" where nothing does."""
        return self.attributes.new(attribute) if self.is_ros2 and is_repeated else ""

    def getter(self, name: str) -> str:
        """Name the method that reads a parameter in ROS 1, the same one whenever it is asked for.

        Names that differ may be alike in words: those of `a_b` and of `a/b` are numbered.
        """
        own = name.removeprefix("~/")
        if own not in self._getters:
            self._getters[own] = self.attributes.new(f"get_{naming.words(own)}")
        return self._getters[own]

    def method_key(self, name: str, type_: str) -> str:
        """Return what tells a function from others; in some languages its type does as well."""
        del type_
        return name

    def name(self, endpoint: Endpoint) -> str:
        """Write the name of an endpoint as the client library takes it."""
        return self.string(name_as_written(endpoint.name, self.ros_version))

    def parameter_name(self, name: str, *, is_own: bool) -> str:
        """Write the name of a parameter; `is_own` of one of the node in ROS 1."""
        return self.string(f"~{name}" if is_own else name)

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
        return SendPlan(self.message(value, span), has_header and not has_time, self.unsure(value))

    def unsure(self, value: MessageValue) -> tuple[str, ...]:
        """Name what a message is computed of that may not be there, or fit no field."""
        found = (each for each in computed_in(value) if self.computing.may_fail(each, self._heard))
        return tuple(dict.fromkeys(str(origin) for each in found for origin in each.origins))

    def parameter_of(self, name: str) -> Parameter:
        """Return the parameter of the node that a value names."""
        parameters = self.node.of(Parameter)
        # A node of ROS 1 may be written for ROS 2, which has no sign for its own ones.
        names = (parameter_name(name.removeprefix("~/"), version) for version in (1, 2))
        return next(parameters[each] for each in names if each in parameters)

    def parameter_value(self, name: str) -> tuple[str, Interval | None]:
        """Write what reads a parameter, and tell which numbers it may be; None for no number."""
        parameter = self.parameter_of(name)
        assert parameter.holds is not None  # statements say it
        limits = limits_of(self.node, parameter, self.ros_version)
        return self.parameter(name), limits or _EVERY.get(parameter.holds.element)

    def message_class(self, type_: InterfaceName | None, name: str, span: Span | None) -> str:
        """Write the class of an endpoint's messages."""
        found = self.known(type_, InterfaceKind.MESSAGE, name, span)
        return self.class_of(found, InterfaceKind.MESSAGE)

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
            self.refuse(codes.UNKNOWN_TYPE, message, span, self.note(type_))
        reason = self.unusable(found)
        if reason is not None:
            self.refuse(codes.UNUSABLE_TYPE, reason, span)
        return found

    def note(self, type_: InterfaceName) -> str | None:
        """Return what is known to have become of a type."""
        note = moved(type_, self.catalog.ros_version)
        return f"use `{note}`" if isinstance(note, InterfaceName) else note

    def refuse(
        self, code: Code, message: str, span: Span | None, help_text: str | None = None
    ) -> NoReturn:
        """Stop: the client library cannot have a part of the node."""
        raise CannotPlanError(Diagnostic(code, message, span or self.node.span, help=help_text))

    def checked_field(
        self, interface: Interface, fields: Sequence[Field], name: str, span: Span | None
    ) -> Field:
        """Return a field of an interface by its name."""
        found = next((field for field in fields if field.name == name), None)
        if found is None:
            message = f"`{interface.name}` has no field `{name}` in {self.catalog.distribution}"
            self.refuse(codes.UNKNOWN_FIELD, message, span, self.note(interface.name))
        return found
