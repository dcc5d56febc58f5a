"""The statements that fill messages, requests, goals and answers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from plastron_tui.diagnostics import Span
from plastron_tui.model.values import Computed, MessageValue, Value
from plastron_tui.ros.interfaces import Field, FieldType, Interface, InterfaceKind, InterfaceName

from . import literals
from .computed import Computing


class Types(Protocol):
    """What knows the interface types, and refuses what they have not."""

    def find(self, type_: InterfaceName, kind: InterfaceKind, span: Span | None) -> Interface:
        """Return an interface."""

    def checked_field(
        self, interface: Interface, fields: Sequence[Field], name: str, span: Span | None
    ) -> Field:
        """Return a field of an interface by its name."""


@dataclass(frozen=True, slots=True)
class Filling:
    """Writes the statements that give the fields of one message their values.

    Attributes:
        types: the interface types.
        computing: what writes values that are known when they are sent.
        span: the statement of the program that has the values.
        received: what holds the message that values are computed of.
        heard: its fields.
    """

    types: Types
    computing: Computing
    span: Span | None
    received: str = "received"
    heard: Sequence[Field] = ()

    def lines(
        self, interface: Interface, fields: Sequence[Field], value: MessageValue, holder: str
    ) -> list[str]:
        """Write a statement, or more, for each field; `holder` ends with its dot or arrow."""
        found: list[str] = []
        for name, each in value.fields.items():
            field = self.types.checked_field(interface, fields, name, self.span)
            found += self._set(f"{holder}{name}", field.type, each)
        return found

    def _set(self, target: str, type_: FieldType, value: Value) -> list[str]:
        if isinstance(value, Computed):
            return self.computing.set(target, value, self.received, self.heard)
        if isinstance(value, MessageValue):
            interface = self.types.find(value.type, InterfaceKind.MESSAGE, self.span)
            return self.lines(interface, interface.fields, value, f"{target}.")
        if not isinstance(value, tuple) or not type_.is_array:
            return [f"{target} = {_scalar(type_, value)};"]
        if not any(isinstance(each, MessageValue | Computed) for each in value):
            listed = ", ".join(_scalar(type_.element, each) for each in value)
            return [f"{target} = {f'{{{{{listed}}}}}' if type_.length else f'{{{listed}}}'};"]
        lines = [] if type_.length else [f"{target}.resize({len(value)});"]
        for index, each in enumerate(value):
            lines += self._set(f"{target}[{index}]", type_.element, each)
        return lines


def _scalar(type_: FieldType, value: Value) -> str:
    if isinstance(value, tuple):
        seconds, nanoseconds = value
        assert isinstance(seconds, int)
        assert isinstance(nanoseconds, int)
        class_ = f"ros::{type_.name.capitalize()}"
        return f"{class_}({literals.integer(seconds)}, {literals.integer(nanoseconds)})"
    assert isinstance(value, bool | int | float | str)
    if isinstance(value, str) and type_.name == "wstring":
        return literals.wide(value)
    if isinstance(value, int) and type_.name in {"float32", "float64"}:
        return literals.real(float(value))
    return literals.scalar(value)
