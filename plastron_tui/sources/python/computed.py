"""Values that are known when they are sent, as the Python that computes them.

What a field cannot hold never comes to a publisher: rclpy wraps it around or ends the node, and
rospy's publisher sends nothing any more after one message that cannot be serialized.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from plastron_tui.model.kinds import Condition
from plastron_tui.model.kinds.ranges import Interval, field_range
from plastron_tui.model.kinds.received import type_received
from plastron_tui.model.values import Computed, Number, OfReceived
from plastron_tui.ros.interfaces import Field, FieldType
from plastron_tui.sources.computing import BaseComputing, Formula, Source, may_be_zero

from . import literals
from .dialect import Dialect


class Guard(Protocol):
    """How a file keeps what a field cannot hold from it."""

    def number(self, text: str, limits: Interval) -> str:
        """Return a number as the field gets it, which may be out of the field's limits."""

    def numbers(self, text: str, limits: Interval) -> str:
        """Return a list of numbers as the field gets it, some of which may be out of its limits."""

    def short(self) -> str:
        """Return what makes a number one of 32 bits that may be too great for them, "" for none."""

    def element(self, holder: str, position: int) -> None:
        """Note that a list may have too few elements."""

    def divisor(self, text: str) -> str:
        """Return a number to divide by, which may be 0."""


_OCTET = "octet"
"""A byte of ROS 2, which is one of a `bytes` in rclpy."""


@dataclass(frozen=True, slots=True)
class Computing(BaseComputing):
    """What writes the values of a Python file that are known when they are sent.

    Attributes:
        dialect: the client library.
        guard: what keeps from a field what it cannot hold.
    """

    dialect: Dialect
    guard: Guard

    def write(self, value: Computed, holder: str, heard: Sequence[Field]) -> str:
        """Write a value as its field takes it.

        Args:
            value: the value.
            holder: what holds the message or the request that is received.
            heard: its fields.
        """
        formula = self.formula_of(value, holder, heard)
        source = formula.source
        if source.type == value.type and not value.steps:
            return source.text
        if value.type.is_array:
            return self._list(value, formula)
        text = self._term(source)
        for operator, operand in formula.steps:
            text += f" {operator} {self._operand(operator, operand)}"
        return self._fitting(value, formula, text)

    def _term(self, source: Source) -> str:
        """Write what comes from somewhere as something to calculate with."""
        return source.text if source.type is None else self._as_number(source.text, source.type)

    def _operand(self, operator: str, operand: Number | Source) -> str:
        if not isinstance(operand, Source):
            return literals.number(operand)
        text = self._term(operand)
        return self.guard.divisor(text) if operator == "/" and may_be_zero(operand) else text

    def condition(
        self, condition: Condition, holder: str, heard: Sequence[Field], value: str
    ) -> str:
        """Write what must hold of a message.

        Args:
            condition: what.
            holder: what holds the message.
            heard: its fields.
            value: what a field is compared with, as the file writes it.
        """
        type_ = type_received(condition.source, heard, self.catalog, self.span)
        whole = self.holder_of(condition.source, holder, heard)
        compared = self._as_number(whole if condition.quantifier is None else "each", type_)
        operator = "==" if condition.operator == "=" else condition.operator
        if operator == "==" and type_.name == "float32":
            value = self._as_short(value)
        text = f"{compared} {operator} {value}"
        if isinstance(condition.value, bool):
            text = compared if condition.value else f"not {compared}"
        if condition.quantifier is not None:
            text = f"{condition.quantifier}({text} for each in {whole})"
        return text

    def holder_of(self, source: OfReceived, holder: str, heard: Sequence[Field]) -> str:
        """Write a field of what is received; an element of an array is a number of Python's own."""
        text = ".".join((holder, *map(self.dialect.field, source.path)))
        if source.position is None:
            return text
        if self.lacks(source, heard):
            self.guard.element(text, source.position)
        text += f"[{source.position}]"
        whole = self.whole(source, heard)
        range_ = field_range(whole, self.ros_version)
        # rclpy has arrays of a fixed length as those of NumPy, whose numbers its messages do not
        # take.
        if whole.length is None or range_ is None or whole.name == "byte" or not self._is_rclpy:
            return text
        return f"{'int' if isinstance(range_.least, int) else 'float'}({text})"

    def _as_number(self, text: str, type_: FieldType) -> str:
        """Write a value, or an element of a list, as something to calculate and compare with."""
        return f"{text}[0]" if self._is_rclpy and type_.name == "byte" else text

    def _as_short(self, number: str) -> str:
        """Write a number as 32 bits hold it."""
        held = array("f", [float(number)])[0]
        if held == float(number) or math.isinf(held):
            return number
        made = self.guard.short()
        return f"{made}({number})" if made else literals.number(held)

    @property
    def _is_rclpy(self) -> bool:
        return self.ros_version == 2

    def _list(self, value: Computed, formula: Formula) -> str:
        """Write a list as a field of lists takes it."""
        source = formula.source
        text = source.text
        is_bytes = source.type is not None and source.type.name == "byte" and self._is_rclpy
        if is_bytes:
            text = f"[each[0] for each in {text}]"
        elif self._is_rclpy and source.type is not None and source.range is not None:
            # An array of another type is no list: its memory would be taken as it is.
            text = f"{text}.tolist()"
        limits = self.limits(value, formula)
        if limits is not None:
            text = self.guard.numbers(text, limits)
        made = self._made_of(value, formula)
        if made == _OCTET:
            return f"[bytes([each]) for each in {text}]"
        if made:
            return f"list(map({made}, {text}))"
        is_list = not self._is_rclpy or text != source.text
        return text if is_list else f"list({text})"

    def _fitting(self, value: Computed, formula: Formula, text: str) -> str:
        """Write a value of which the text is known as the field takes it."""
        limits = self.limits(value, formula)
        if limits is not None:
            text = self.guard.number(text, limits)
        made = self._made_of(value, formula)
        if made == _OCTET:
            return f"bytes([{text}])"
        return f"{made}({text})" if made else text

    def _made_of(self, value: Computed, formula: Formula) -> str:
        """Return what makes a number one that the field takes, "" where it is one."""
        target, range_ = field_range(value.type, self.ros_version), formula.range
        if range_ is None or target is None:
            return ""
        if isinstance(target.least, int):
            return _OCTET if self._is_rclpy and value.type.name == "byte" else ""
        is_short = value.type.name == "float32"
        is_long = not target.contains(range_)
        made = self.guard.short() if is_short and is_long else ""
        is_whole = formula.is_whole and not value.is_float
        return made or ("float" if self._is_rclpy and is_whole else "")
