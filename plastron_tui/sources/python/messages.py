"""Messages as Python expressions, in the manner of the file that they go into."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import NoReturn

from plastron_tui.diagnostics import Code, Diagnostic, Span, codes
from plastron_tui.model.kinds import Condition
from plastron_tui.model.kinds.ranges import EVERY_INTEGER, Interval
from plastron_tui.model.values import Computed, MessageValue, Value
from plastron_tui.ros.catalog import Catalog, moved
from plastron_tui.ros.interfaces import Field, FieldType, Interface, InterfaceKind, InterfaceName
from plastron_tui.sources.computing import ParameterValue

from .computed import Computing
from .conventions import Conventions
from .dialect import Dialect, plain_scalar
from .typeimports import FileImports

_HEADER = InterfaceName("std_msgs", "Header")


class CannotAddError(Exception):
    """Why an endpoint cannot be added to a file."""

    def __init__(self, code: Code, message: str, span: Span | None, remedy: str | None = None):
        super().__init__(message)
        self.diagnostic = Diagnostic(code, message, span, help=remedy)


class Conditions:
    """What must hold so that fields can hold what is computed for them."""

    def __init__(self, name: Callable[[str], str]) -> None:
        """Require nothing yet; `name` returns a free name like a wanted one."""
        self._name = name
        self._named: dict[str, str] = {}
        # Each by itself; that a list has an element by the list, of which the last one counts.
        self._required: dict[str, tuple[str, bool]] = {}
        self._longest: dict[str, int] = {}

    def number(self, text: str, limits: Interval) -> str:
        """Require a number to be in the limits of a field; what is read for it is read once."""
        if not _within(text, limits):
            return text
        text = self._once(text, "number")
        self.require(_within(text, limits))
        return text

    def numbers(self, text: str, limits: Interval) -> str:
        """Require that of each number of a list."""
        within = _within("each", limits)
        if not within:
            return text
        name = self._once(text, "numbers")
        self.require(f"all({within} for each in {name})")
        # A parameter of rclpy holds an array, which a field of another type does not take.
        return name if name == text or text.endswith(".tolist()") else f"list({name})"

    def _once(self, text: str, wanted: str) -> str:
        """Return the variable that gets what a call returns."""
        if "(" in text and text not in self._named:
            self._named[text] = self._name(wanted)
        return self._named.get(text, text)

    def short(self) -> str:
        """Leave a number alone that only 64 bits can hold: hardly anything is as great."""
        return ""

    def element(self, holder: str, position: int) -> None:
        """Require a list to have an element."""
        longest = self._longest[holder] = max(position, self._longest.get(holder, 0))
        self._required[holder] = f"len({holder}) > {longest}", True

    def divisor(self, text: str) -> str:
        """Require a number to divide by not to be 0."""
        condition = f"{text} != 0"
        self._required[condition] = condition, True
        return text

    def require(self, condition: str) -> None:
        """Require that something holds, once there is all that is calculated with."""
        self._required.setdefault(condition, (condition, False))

    def __bool__(self) -> bool:
        """Whether anything is required."""
        return bool(self._required)

    def around(self, lines: Sequence[str]) -> list[str]:
        """Write lines that are only run where all of that holds.

        A name is given to what is calculated once there is all that it is calculated of.
        """
        named = [f"{name} = {text}" for text, name in self._named.items()]
        if not named:
            return _if([condition for condition, _ in self._required.values()], lines)
        first = [condition for condition, is_first in self._required.values() if is_first]
        then = [condition for condition, is_first in self._required.values() if not is_first]
        return _if(first, [*named, *_if(then, lines)])


def _if(conditions: Sequence[str], lines: Sequence[str]) -> list[str]:
    """Write lines that are only run where conditions hold, if there are any."""
    if not conditions:
        return [*lines]
    return [f"if {' and '.join(conditions)}:", *(f"\t{line}" for line in lines)]


class _Unguarded:
    """Lets a field have whatever it is given."""

    def number(self, text: str, limits: Interval) -> str:
        del limits
        return text

    numbers = number

    def short(self) -> str:
        return ""

    def element(self, holder: str, position: int) -> None:
        pass

    def divisor(self, text: str) -> str:
        return text


def _within(text: str, limits: Interval) -> str:
    """Write that a number is in limits, "" for those of 64 bits, which hardly anything passes."""
    least = f"{limits.least} <= " if limits.least > EVERY_INTEGER.least else ""
    most = f" <= {limits.most}" if limits.most < EVERY_INTEGER.most else ""
    if least and not most:
        return f"{text} >= {limits.least}"
    return f"{least}{text}{most}" if least or most else ""


class Messages:
    """Writes types and values into a file.

    Attributes:
        conditions: what must hold so that what was written can be sent.
    """

    def __init__(
        self,
        catalog: Catalog,
        dialect: Dialect,
        imports: FileImports,
        conventions: Conventions,
        span: Span | None,
        read: ParameterValue,
        name: Callable[[str], str],
    ) -> None:
        self._catalog = catalog
        self._dialect = dialect
        self._imports = imports
        self._conventions = conventions
        self._span = span
        self.conditions = Conditions(name)
        where = span or Span(0, 0)
        version = dialect.ros_version
        self._computing = Computing(catalog, version, where, read, dialect, self.conditions)
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
        """Write a request of a service, which is sent whether or not its fields can hold it."""
        self._computing = replace(self._computing, guard=_Unguarded())
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
        self.hear(request, interface)
        class_ = self._dialect.response(interface.name, self._imports).removesuffix("()")
        return f"{class_}({self._written(interface.response.fields, interface, value)})"

    def hear(self, holder: str, interface: Interface) -> None:
        """Compute what is written next of a message that a name holds."""
        self._received = holder, interface.fields

    def when(self, condition: Condition | None) -> None:
        """Write what must hold of the message that is received."""
        if condition is None:
            return
        value = condition.value
        text = self._conventions.string(value) if isinstance(value, str) else plain_scalar(value)
        self.conditions.require(self._computing.condition(condition, *self._received, text))

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
            return self._computing.write(value, *self._received)
        if type_.is_array and isinstance(value, tuple):
            element = type_._replace(is_array=False, length=None, bound=None)
            return f"[{', '.join(self._value(element, each) for each in value)}]"
        if isinstance(value, MessageValue):
            return self.message(value)
        if isinstance(value, str):
            return self._conventions.string(value)
        return self._dialect.scalar(type_, value, self._imports)

    def _refuse(self, code: Code, message: str) -> NoReturn:
        raise CannotAddError(code, message, self._span)
