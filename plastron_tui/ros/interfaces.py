"""Interface types: messages, services and actions, and their fields."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple


class InterfaceKind(str, Enum):
    """The three kinds, by the name of the folder that holds their definitions."""

    MESSAGE = "msg"
    SERVICE = "srv"
    ACTION = "action"


class InterfaceName(NamedTuple):
    """The full name of an interface type, such as `geometry_msgs/Twist`."""

    package: str
    name: str

    def __str__(self) -> str:
        return f"{self.package}/{self.name}"


class FieldType(NamedTuple):
    """The type of a field.

    Attributes:
        name: a primitive (`float64`, `string`, `time`, …), or a message's name.
        package: the message's package, None for a primitive.
        is_array: whether it is an array of the named type.
        length: the length of a fixed array, None otherwise.
        bound: the most elements of a bounded sequence, None otherwise.
        string_bound: the most characters of a bounded string, None otherwise.
    """

    name: str
    package: str | None = None
    is_array: bool = False
    length: int | None = None
    bound: int | None = None
    string_bound: int | None = None

    @property
    def message(self) -> InterfaceName | None:
        """The name of the nested message, None for a primitive."""
        return None if self.package is None else InterfaceName(self.package, self.name)

    @property
    def element(self) -> FieldType:
        """The type of an array's elements; what is no array is its own."""
        return self._replace(is_array=False, length=None, bound=None)

    def __str__(self) -> str:
        base = self.name if self.package is None else f"{self.package}/{self.name}"
        if self.string_bound is not None:
            base += f"<={self.string_bound}"
        if not self.is_array:
            return base
        if self.length is not None:
            return f"{base}[{self.length}]"
        return f"{base}[<={self.bound}]" if self.bound is not None else f"{base}[]"


Scalar = bool | int | float | str


class Field(NamedTuple):
    """A field of a message.

    `default` is what ROS 2 definitions may give it; `comment` is the first sentence of what
    the definition says about it.
    """

    name: str
    type: FieldType
    default: Scalar | tuple[Scalar, ...] | None = None
    comment: str = ""


class Constant(NamedTuple):
    """A constant of a message."""

    name: str
    type: str
    value: Scalar


_SECTIONS = {InterfaceKind.MESSAGE: 1, InterfaceKind.SERVICE: 2, InterfaceKind.ACTION: 3}


@dataclass(frozen=True, slots=True)
class Section:
    """The fields and constants between two `---` lines of a definition."""

    fields: tuple[Field, ...] = ()
    constants: tuple[Constant, ...] = ()


@dataclass(frozen=True, slots=True)
class Interface:
    """An interface type.

    A message has one section; a service has a request and a response; an action has a goal, a
    result and a feedback. `comment` is the first line of the definition's own description.
    """

    name: InterfaceName
    kind: InterfaceKind
    sections: tuple[Section, ...]
    comment: str = ""

    @staticmethod
    def undefined(name: InterfaceName, kind: InterfaceKind) -> Interface:
        """Return a type of which nothing but the name is known: it has no fields to give values."""
        return Interface(name, kind, (Section(),) * _SECTIONS[kind])

    @property
    def fields(self) -> tuple[Field, ...]:
        """The fields of a message, a service's request, or an action's goal."""
        return self.sections[0].fields

    @property
    def response(self) -> Section:
        """The response of a service, or the result of an action."""
        return self.sections[1]
