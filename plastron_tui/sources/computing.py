"""Values that are known when they are sent, whatever language computes them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds.computed import type_received
from plastron_tui.model.kinds.ranges import Interval, field_range, range_of_calculated
from plastron_tui.model.values import Computed, OfParameter, OfReceived
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
        source = self.source_of(value.source, "received", heard)
        return self.lacks(value.source, heard) or self.limits(value, source) is not None

    def lacks(self, source: OfParameter | OfReceived, heard: Sequence[Field]) -> bool:
        """Tell whether a list may have too few elements; a fixed length has been counted."""
        if isinstance(source, OfParameter) or source.position is None:
            return False
        return self.whole(source, heard).length is None

    def whole(self, source: OfReceived, heard: Sequence[Field]) -> FieldType:
        """Return the type of the list that a source is an element of."""
        return type_received(OfReceived(source.path), heard, self.catalog, self.span)

    def source_of(
        self, source: OfParameter | OfReceived, holder: str, heard: Sequence[Field]
    ) -> Source:
        """Write what a value comes from, with what is known of it."""
        if isinstance(source, OfReceived):
            type_ = type_received(source, heard, self.catalog, self.span)
            range_ = field_range(type_, self.ros_version)
            return Source(self.holder_of(source, holder, heard), type_, range_)
        text, range_ = self.parameter(source.name)
        return Source(text, None, range_)

    def limits(self, value: Computed, source: Source) -> Interval | None:
        """Return the limits of a field that a value may pass, None where it cannot."""
        target = field_range(value.type, self.ros_version)
        if source.range is None or target is None or not isinstance(target.least, int):
            return None
        is_inside = target.contains(range_of_calculated(source.range, value.steps))
        return None if is_inside else target
