"""Values that are known when they are sent, as the C++ that computes them.

What a field cannot hold never comes to a publisher: `in_range` and `at` throw a
`std::out_of_range`, which the sender catches.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Sequence
from dataclasses import dataclass

from plastron_tui.model.kinds import Condition
from plastron_tui.model.kinds.ranges import Interval, field_range
from plastron_tui.model.kinds.received import type_received
from plastron_tui.model.values import Computed, Number, OfReceived
from plastron_tui.ros.interfaces import Field, FieldType
from plastron_tui.ros.parameters import INTEGERS
from plastron_tui.sources.computing import BaseComputing, Formula, Source, may_be_zero

from . import literals
from .interface_types import scalar_class

_INT64 = Interval(INTEGERS[0], INTEGERS[-1])
_IN_RANGE = "in_range"
_ALL_IN_RANGE = "all_in_range"
_DIVISOR = "divisor"
_AS_VECTOR = "as_vector"
_ALGORITHMS = {"any": "std::any_of", "all": "std::all_of"}


class Functions(set[str]):
    """The functions of a file that its expressions call."""

    def use(self, name: str) -> str:
        """Take a function, and return what it is called."""
        self.add(name)
        return name


@dataclass(frozen=True, slots=True)
class Computing(BaseComputing):
    """What writes the values of a C++ file that are known when they are sent.

    Attributes:
        functions: those of the file that the values call.
    """

    functions: Functions

    def set(self, target: str, value: Computed, holder: str, heard: Sequence[Field]) -> list[str]:
        """Write the statements that give a field its value.

        Args:
            target: the field.
            value: the value.
            holder: what holds the message or the request that is received.
            heard: its fields.
        """
        formula = self.formula_of(value, holder, heard)
        if value.type.is_array and formula.source.type != value.type:
            return self._list(target, value, formula)
        return [f"{target} = {self._scalar(value, formula)};"]

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
        type_ = type_received(condition.source, heard, self.catalog, self.span).element
        whole = self.holder_of(condition.source, holder, heard)
        compared = whole if condition.quantifier is None else "each"
        operator = "==" if condition.operator == "=" else condition.operator
        if isinstance(condition.value, bool):
            text = compared if condition.value else f"!{compared}"
        elif isinstance(condition.value, str):
            text = f"{compared} {operator} {value}"
        else:
            text = self._comparison(compared, operator, condition.value, type_)
        if condition.quantifier is not None:
            ends = f"{whole}.begin(), {whole}.end()"
            algorithm = _ALGORITHMS[condition.quantifier]
            return f"{algorithm}({ends}, [](const auto & each) {{return {text};}})"
        return text

    def _comparison(self, compared: str, operator: str, number: float, type_: FieldType) -> str:
        """Write how a field compares with a number, of whatever type both are.

        C++ takes a negative number that is compared with an unsigned one for a great one.
        """
        range_ = field_range(type_, self.ros_version)
        assert range_ is not None  # only numbers are compared with numbers
        if not isinstance(range_.least, int):
            return f"{compared} {operator} {self._float_literal(operator, number, type_)}"
        if isinstance(number, float) and not number.is_integer():
            return f"{compared} {operator} {literals.real(number)}"
        number = int(number)
        if range_.least < number < range_.most:
            return f"{compared} {operator} {literals.integer(number)}"
        # What never holds, or always does, would be a warning.
        return f"static_cast<long double>({compared}) {operator} {number}.0L"

    def _float_literal(self, operator: str, number: float, type_: FieldType) -> str:
        """Write a number as a field of floats is compared with it: an equal one has its bits."""
        text = literals.real(float(number))
        if operator != "==" or type_.name != "float32":
            return text
        is_long = math.isinf(array("f", [float(number)])[0])
        return text if is_long else f"{text}F"

    def holder_of(self, source: OfReceived, holder: str, heard: Sequence[Field]) -> str:
        """Write a field of what is received, or an element of one, which may not be there."""
        # A service of ROS 2 has a pointer to its request.
        arrow = "->" if holder == "request" and self.ros_version == 2 else "."
        text = f"{holder}{arrow}{'.'.join(source.path)}"
        if source.position is None:
            return text
        is_sure = not self.lacks(source, heard)
        return f"{text}[{source.position}]" if is_sure else f"{text}.at({source.position})"

    def _scalar(self, value: Computed, formula: Formula) -> str:
        """Write a value as its field takes it, whatever it is calculated of."""
        text = self._calculated(formula) if value.steps else formula.source.text
        if self.limits(value, formula) is None:
            return text
        return f"{self.functions.use(_IN_RANGE)}<{self._class(value.type)}>({text})"

    def _calculated(self, formula: Formula, wide: str = "") -> str:
        """Write what is calculated: of whole numbers in 64 bits, or in more where they may pass.

        Args:
            formula: what is calculated.
            wide: the type to calculate in, "" for one that holds it.
        """
        if not wide and formula.is_whole:
            wide = "int64_t" if all(map(_INT64.contains, formula.ranges)) else "long double"
        wide = wide or "double"
        text = self._as(wide, formula.source)
        for operator, operand in formula.steps:
            written = self._as(wide, operand)
            if operator == "/" and isinstance(operand, Source) and may_be_zero(operand):
                written = self._divisor(written)
            text += f" {operator} {written}"
        return text

    def _divisor(self, text: str) -> str:
        """Write a number to divide by, which may be 0."""
        return f"{self.functions.use(_DIVISOR)}({text})"

    def _as(self, wide: str, operand: Number | Source) -> str:
        """Write what is calculated with as a number of a type."""
        if isinstance(operand, Source):
            text = operand.text
            return text if self._is(operand, wide) else f"static_cast<{wide}>({text})"
        if wide == "int64_t":
            return literals.integer(int(operand))
        suffix = "L" if wide == "long double" else ""
        return f"{literals.real(float(operand))}{suffix}"

    def _is(self, source: Source, wide: str) -> bool:
        """Tell whether a source is of a type already."""
        if source.type is not None:
            return self._class(source.type) == wide
        # What a parameter of integers is in ROS 1 is an `int`.
        own = "double" if not source.is_whole else "int64_t" if self.ros_version == 2 else "int"
        return wide == own

    def _list(self, target: str, value: Computed, formula: Formula) -> list[str]:
        """Write what gives a list of another type its elements."""
        source = formula.source
        is_checked = self.limits(value, formula) is not None
        class_ = self._class(value.type)
        if source.type is None:
            make = self.functions.use(_ALL_IN_RANGE if is_checked else _AS_VECTOR)
            if is_checked:
                self.functions.use(_IN_RANGE)
            return [f"{target} = {make}<{class_}>({source.text});"]
        ends = f"{source.text}.begin(), {source.text}.end()"
        if not is_checked and value.type.length is None:
            return [f"{target}.assign({ends});"]
        lines = [] if value.type.length else [f"{target}.resize({source.text}.size());"]
        if not is_checked:
            return [*lines, f"std::copy({ends}, {target}.begin());"]
        check = f"{self.functions.use(_IN_RANGE)}<{class_}, {self._class(source.type)}>"
        return [*lines, f"std::transform({ends}, {target}.begin(), {check});"]

    def _class(self, type_: FieldType) -> str:
        """Return the C++ type of a primitive field, or of its elements."""
        return scalar_class(type_.name, self.ros_version)
