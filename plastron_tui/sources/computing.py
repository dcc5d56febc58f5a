"""Values that are known when they are sent, whatever language computes them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds.ranges import Interval, field_range, ranges_of_terms
from plastron_tui.model.kinds.received import type_received
from plastron_tui.model.values import Computed, Number, OfParameter, OfReceived, Origin
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType

ParameterValue = Callable[[str], tuple[str, Interval | None]]
"""Writes what reads a parameter, and tells which numbers it may be; None for no number."""


class Source(NamedTuple):
    """What a value comes from.

    Attributes:
        text: the expression.
        type: the type of the field that it is, None for a parameter.
        range: what it can be, or its elements; None for no number.
    """

    text: str
    type: FieldType | None
    range: Interval | None

    @property
    def is_whole(self) -> bool:
        """Whether it is of integers."""
        return self.range is not None and isinstance(self.range.least, int)


class Formula(NamedTuple):
    """What a value comes from, and what is done to it.

    Attributes:
        source: what comes first.
        steps: an operator and an operand each.
    """

    source: Source
    steps: tuple[tuple[str, Number | Source], ...]

    @property
    def ranges(self) -> list[Interval]:
        """What each part of it can be in its turn, the whole last; nothing of what is no number."""
        if self.source.range is None:
            return []
        operands = [(operator, _range_of(operand)) for operator, operand in self.steps]
        return ranges_of_terms(self.source.range, operands)

    @property
    def range(self) -> Interval | None:
        """What it can be, or its elements; None for no number."""
        ranges = self.ranges
        return ranges[-1] if ranges else None

    @property
    def is_whole(self) -> bool:
        """Whether it is an integer for sure."""
        operands = (operand for _, operand in self.steps)
        return (
            self.source.is_whole
            and all(operator != "/" for operator, _ in self.steps)
            and all(isinstance(_range_of(each).least, int) for each in operands)
        )


def _range_of(operand: Number | Source) -> Interval:
    if isinstance(operand, Source):
        assert operand.range is not None  # only numbers are calculated with
        return operand.range
    return Interval(operand, operand)


def may_be_zero(source: Source) -> bool:
    """Tell whether nothing may be divided by a number."""
    return source.range is not None and source.range.holds_zero


@dataclass(frozen=True, slots=True)
class BaseComputing(ABC):
    """What writes the values of a file that are known when they are sent.

    Attributes:
        catalog: the interface types.
        ros_version: the generation of ROS, 1 or 2.
        span: the statement that asks for them.
        parameter: what writes those of parameters.
    """

    catalog: Catalog
    ros_version: int
    span: Span
    parameter: ParameterValue

    @abstractmethod
    def holder_of(self, source: OfReceived, holder: str, heard: Sequence[Field]) -> str:
        """Write a field of what is received, or an element of one.

        Args:
            source: the field.
            holder: what holds the message or the request.
            heard: its fields.
        """

    def may_fail(self, value: Computed, heard: Sequence[Field]) -> bool:
        """Tell whether there may be no value, or one that its field does not take."""
        formula = self.formula_of(value, "received", heard)
        return (
            any(self.lacks(origin, heard) for origin in value.origins)
            or any(
                operator == "/" and isinstance(operand, Source) and may_be_zero(operand)
                for operator, operand in formula.steps
            )
            or self.limits(value, formula) is not None
        )

    def lacks(self, source: Origin, heard: Sequence[Field]) -> bool:
        """Tell whether a list may have too few elements; a fixed length has been counted."""
        if isinstance(source, OfParameter) or source.position is None:
            return False
        return self.whole(source, heard).length is None

    def whole(self, source: OfReceived, heard: Sequence[Field]) -> FieldType:
        """Return the type of the list that a source is an element of."""
        return type_received(OfReceived(source.path), heard, self.catalog, self.span)

    def formula_of(self, value: Computed, holder: str, heard: Sequence[Field]) -> Formula:
        """Write what a value is calculated of, with what is known of it."""
        source = self.source_of(value.source, holder, heard)
        steps = tuple(
            (
                operator,
                operand
                if isinstance(operand, int | float)
                else self.source_of(operand, holder, heard),
            )
            for operator, operand in value.steps
        )
        return Formula(source, steps)

    def source_of(self, source: Origin, holder: str, heard: Sequence[Field]) -> Source:
        """Write what a value comes from, with what is known of it."""
        if isinstance(source, OfReceived):
            type_ = type_received(source, heard, self.catalog, self.span)
            range_ = field_range(type_, self.ros_version)
            return Source(self.holder_of(source, holder, heard), type_, range_)
        text, range_ = self.parameter(source.name)
        return Source(text, None, range_)

    def limits(self, value: Computed, formula: Formula) -> Interval | None:
        """Return the limits of a field that a value may pass, None where it cannot."""
        target, range_ = field_range(value.type, self.ros_version), formula.range
        if range_ is None or target is None or not isinstance(target.least, int):
            return None
        return None if target.contains(range_) else target
