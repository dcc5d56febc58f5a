"""Computed values in files that exist: what a field cannot hold is not sent.

A file that Plastron writes has functions that check and throw; in somebody's file an `if` around
the sending does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from plastron_tui.model.kinds.ranges import EVERY_INTEGER, Interval
from plastron_tui.model.values import Computed, OfReceived
from plastron_tui.ros.interfaces import Field
from plastron_tui.sources.computing import Formula, Source

from . import literals
from .computed import Computing


@dataclass(slots=True)
class Conditions:
    """What must hold so that fields can hold what is computed for them."""

    _required: dict[str, str] = field(default_factory=dict)
    """Each by itself; that a list has an element by the list, of which the last one counts."""
    _longest: dict[str, int] = field(default_factory=dict)

    @property
    def required(self) -> tuple[str, ...]:
        """All that must hold, in the order in which it was required first."""
        return tuple(self._required.values())

    def require(self, condition: str) -> None:
        """Require that something holds."""
        self._required.setdefault(condition, condition)

    def element(self, holder: str, position: int) -> None:
        """Require a list to have an element."""
        longest = self._longest[holder] = max(position, self._longest.get(holder, 0))
        self._required[holder] = f"{holder}.size() > {longest}"

    def within(self, text: str, limits: Interval, *, is_whole: bool) -> None:
        """Require a number to be in the limits of a field."""
        written = literals.integer if is_whole else lambda value: literals.real(float(value))
        if limits.least > EVERY_INTEGER.least:
            self.require(f"{text} >= {written(int(limits.least))}")
        if limits.most < EVERY_INTEGER.most:
            self.require(f"{text} <= {written(int(limits.most))}")

    def __bool__(self) -> bool:
        """Whether anything is required."""
        return bool(self.required)

    @property
    def text(self) -> str:
        """All of it, as the condition of an `if`."""
        return " && ".join(self.required)


@dataclass(frozen=True, slots=True)
class GuardedComputing(Computing):
    """Writes computed values, and notes what must hold for them.

    Attributes:
        conditions: what must hold so that what was written can be sent.
    """

    conditions: Conditions

    def holder_of(self, source: OfReceived, holder: str, heard: Sequence[Field]) -> str:
        """Write a field of what is received; `holder` ends with its dot or arrow."""
        text = f"{holder}{'.'.join(source.path)}"
        if source.position is None:
            return text
        if self.lacks(source, heard):
            self.conditions.element(text, source.position)
        return f"{text}[{source.position}]"

    def _divisor(self, text: str) -> str:
        self.conditions.require(f"{text} != 0")
        return text

    def _scalar(self, value: Computed, formula: Formula) -> str:
        limits = self.limits(value, formula)
        # Hardly anything passes 64 bits: what is not checked is written as somebody would.
        wide = "int64_t" if limits == EVERY_INTEGER and self._fit_64_bits(formula) else ""
        text = self._calculated(formula, wide) if value.steps else formula.source.text
        if limits is None or wide:
            return text
        self.conditions.within(text, limits, is_whole=formula.is_whole)
        return f"static_cast<{self._class(value.type)}>({text})"

    def _fit_64_bits(self, formula: Formula) -> bool:
        """Tell whether each number that is calculated with fits, whatever comes of them."""
        operands = (operand for _, operand in formula.steps if isinstance(operand, Source))
        sources = (formula.source, *operands)
        return all(
            each.range is not None and EVERY_INTEGER.contains(each.range) for each in sources
        )

    def _list(self, target: str, value: Computed, formula: Formula) -> list[str]:
        class_ = self._class(value.type)
        source, limits = formula.source, self.limits(value, formula)
        name = source.text
        if limits is not None:
            checks = Conditions()
            checks.within("each", limits, is_whole=source.is_whole)
            if checks:
                ends = f"{name}.begin(), {name}.end()"
                test = f"[](const auto & each) {{return {checks.text};}}"
                self.conditions.require(f"std::all_of({ends}, {test})")
        if value.type.length is not None:
            return [f"std::copy({name}.begin(), {name}.end(), {target}.begin());"]
        del class_
        return [f"{target}.assign({name}.begin(), {name}.end());"]
