"""Messages as Python expressions, in the manner of the file that they go into."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NoReturn

from plastron_tui.diagnostics import Code, Diagnostic, Span, codes
from plastron_tui.model.kinds.computed import type_received, what_of
from plastron_tui.model.values import Computed, MessageValue, OfParameter, Value
from plastron_tui.ros.catalog import Catalog, moved
from plastron_tui.ros.interfaces import Field, FieldType, Interface, InterfaceKind, InterfaceName

from . import literals
from .conventions import Conventions
from .dialect import Dialect
from .typeimports import FileImports

ReadParameter = Callable[[str], tuple[str, bool]]
"""Writes what reads a parameter, and tells whether that may be an integer."""

_HEADER = InterfaceName("std_msgs", "Header")


class CannotAddError(Exception):
    """Why an endpoint cannot be added to a file."""

    def __init__(self, code: Code, message: str, span: Span | None, remedy: str | None = None):
        super().__init__(message)
        self.diagnostic = Diagnostic(code, message, span, help=remedy)


class Messages:
    """Writes types and values into a file."""

    def __init__(
        self,
        catalog: Catalog,
        dialect: Dialect,
        imports: FileImports,
        conventions: Conventions,
        span: Span | None,
        read: ReadParameter,
    ) -> None:
        self._catalog = catalog
        self._dialect = dialect
        self._imports = imports
        self._conventions = conventions
        self._span = span
        self._read = read
        self._received: tuple[str, Sequence[Field]] = ("received", ())

    def interface(self, type_: InterfaceName | None, kind: InterfaceKind, name: str) -> Interface:
        """Return an interface of the distribution, under its new name where it has one."""
        if type_ is None:
            self._refuse(codes.UNKNOWN_TYPE, f"the type of `{name}` is not known")
        found = self._catalog.find(type_, kind)
        instead = moved(type_, self._catalog.ros_version) if found is None else None
        if isinstance(instead, InterfaceName):
            found = self._catalog.find(instead, kind)
        if found is None:
            self._refuse(codes.UNKNOWN_TYPE, f"{self._catalog.distribution} has no type `{type_}`")
        reason = self._dialect.unusable(found, self._catalog)
        if reason is not None:
            self._refuse(codes.UNUSABLE_TYPE, reason)
        return found

    def interfaces(self, name: InterfaceName, kind: InterfaceKind) -> Interface | None:
        """Return an interface type, None where it is not known."""
        return self._catalog.find(name, kind)

    def type_class(self, interface: Interface) -> str:
        """Return the class of an interface type."""
        return self._dialect.class_of(interface.name, interface.kind, self._imports)

    def message(self, value: MessageValue) -> str:
        """Write a message."""
        interface = self.interface(value.type, InterfaceKind.MESSAGE, str(value.type))
        return f"{self.type_class(interface)}({self._arguments(interface, value)})"

    def request(self, interface: Interface, value: MessageValue) -> str:
        """Write a request of a service."""
        return f"{self.request_class(interface)}({self._arguments(interface, value)})"

    def request_class(self, interface: Interface) -> str:
        """Return the class of a service's requests."""
        return self._dialect.request(interface.name, self._imports)

    def goal(self, interface: Interface, value: MessageValue) -> str:
        """Write a goal of an action."""
        return f"{self.part(interface, 'Goal')}({self._arguments(interface, value)})"

    def part(self, interface: Interface, part: str) -> str:
        """Return the class of an action's goals, of its feedback, or of its results."""
        return self._dialect.part_of(interface.name, interface.kind, part, self._imports)

    def answer(self, interface: Interface, value: MessageValue, request: str) -> str:
        """Write a response of a service that has values, of the request that a name holds."""
        self._received = request, interface.fields
        class_ = self._dialect.response(interface.name, self._imports).removesuffix("()")
        return f"{class_}({self._written(interface.response.fields, interface, value)})"

    def response(self, interface: Interface) -> str:
        """Write the default response of a service."""
        return self._dialect.response(interface.name, self._imports)

    def needs_stamp(self, value: MessageValue) -> bool:
        """Whether a message has a header whose time the program does not give."""
        interface = self.interface(value.type, InterfaceKind.MESSAGE, str(value.type))
        header = value.fields.get("header")
        has_time = isinstance(header, MessageValue) and "stamp" in header.fields
        return not has_time and any(
            field.name == "header" and field.type.message == _HEADER for field in interface.fields
        )

    def _arguments(self, interface: Interface, value: MessageValue) -> str:
        return self._written(interface.fields, interface, value)

    def _written(self, fields: Sequence[Field], interface: Interface, value: MessageValue) -> str:
        types = {field.name: field.type for field in fields}
        written = []
        for name, each in value.fields.items():
            if name not in types:
                where = self._catalog.distribution
                self._refuse(
                    codes.UNKNOWN_FIELD, f"`{interface.name}` has no field `{name}` in {where}"
                )
            written.append(f"{self._dialect.field(name)}={self._value(types[name], each)}")
        return ", ".join(written)

    def _value(self, type_: FieldType, value: Value) -> str:
        if isinstance(value, Computed):
            return self._computed(value)
        if type_.is_array and isinstance(value, tuple):
            element = type_._replace(is_array=False, length=None, bound=None)
            return f"[{', '.join(self._value(element, each) for each in value)}]"
        if isinstance(value, MessageValue):
            return self.message(value)
        if isinstance(value, str):
            return self._conventions.string(value)
        return self._dialect.scalar(type_, value, self._imports)

    def _computed(self, value: Computed) -> str:
        """Write a value that is known when it is sent."""
        source = value.source
        if isinstance(source, OfParameter):
            written, is_whole = self._read(source.name)
        else:
            holder, fields = self._received
            path = ".".join(map(self._dialect.field, source.path))
            position = "" if source.position is None else f"[{source.position}]"
            written = f"{holder}.{path}{position}"
            where = self._span or Span(0, 0)
            type_ = type_received(source, fields, self._catalog, where)
            is_whole = what_of(type_, self._catalog.ros_version).kind is int
        for operator, number in value.steps:
            written += f" {operator} {literals.number(number)}"
        if self._dialect.ros_version == 1:
            return written
        if value.type.is_array:
            return f"list({written})" if isinstance(source, OfParameter) else written
        is_float = value.type.name in {"float32", "float64"}
        return f"float({written})" if is_float and is_whole and not value.is_float else written

    def _refuse(self, code: Code, message: str) -> NoReturn:
        raise CannotAddError(code, message, self._span)
