"""Values that are known when they are sent, as the C++ that computes them.

What a field cannot hold never comes to a publisher: `in_range` and `at` throw what the sender
catches.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Condition
from plastron_tui.model.kinds.computed import type_received
from plastron_tui.model.kinds.ranges import Interval, field_range, range_of_calculated
from plastron_tui.model.values import Computed, OfParameter, OfReceived
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType

from . import literals

ParameterValue = Callable[[str], tuple[str, Interval | None]]
"""Writes what reads a parameter, and tells which numbers it may be; None for no number."""


class Functions(set[str]):
    """The functions of a file that its expressions call."""


@dataclass(frozen=True, slots=True)
class Computing:
    """What writes the values of a file that are known when they are sent.

    Attributes:
        catalog: the interface types.
        ros_version: 1 or 2.
        span: the statement that asks for them.
        parameter: what writes those of parameters.
        functions: those of the file that the values call.
    """

    catalog: Catalog
    ros_version: int
    span: Span
    parameter: ParameterValue
    functions: Functions

    def write(self, value: Computed, holder: str, heard: Sequence[Field]) -> str:
        """Write a value as its field takes it."""
        text, _ = self._source(value.source, holder, heard)
        for operator, number in value.steps:
            text += f" {operator} {literals.scalar(number)}"
        return text

    def condition(
        self, condition: Condition, holder: str, heard: Sequence[Field], value: str
    ) -> str:
        """Write what must hold of a message."""
        text, _ = self._source(condition.source, holder, heard)
        operator = "==" if condition.operator == "=" else condition.operator
        return f"{text} {operator} {value}"

    def may_fail(self, value: Computed, heard: Sequence[Field]) -> bool:
        """Tell whether there may be no value, or one that its field does not take."""
        _, range_ = self._source(value.source, "received", heard)
        target = field_range(value.type, self.ros_version)
        is_lacking = self.lacks(value.source, heard)
        if is_lacking or range_ is None or target is None or not isinstance(target.least, int):
            return is_lacking
        return not target.contains(range_of_calculated(range_, value.steps))

    def lacks(self, source: OfParameter | OfReceived, heard: Sequence[Field]) -> bool:
        """Tell whether a list may have too few elements; a fixed length has been counted."""
        if isinstance(source, OfParameter) or source.position is None:
            return False
        whole = type_received(OfReceived(source.path), heard, self.catalog, self.span)
        return whole.length is None

    def _source(
        self, source: OfParameter | OfReceived, holder: str, heard: Sequence[Field]
    ) -> tuple[str, Interval | None]:
        if isinstance(source, OfParameter):
            return self.parameter(source.name)
        type_: FieldType = type_received(source, heard, self.catalog, self.span)
        arrow = "->" if holder == "request" and self.ros_version == 2 else "."
        text = f"{holder}{arrow}{'.'.join(source.path)}"
        if source.position is not None:
            text += f".at({source.position})"
        return text, field_range(type_, self.ros_version)
