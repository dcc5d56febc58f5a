"""How often something is done, as a program says it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes, write
from plastron_tui.language.inputs import ParameterValue

from ..mistake import Mistake

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node

HIGHEST_RATE = 1e6
"""More than any node does, in hertz; a typing error."""

LOWEST_RATE = 1e-9
"""The lowest rate, in hertz: ROS 1 counts the seconds between two times in 31 bits (genpy)."""


class Rate(NamedTuple):
    """How often something is done.

    Attributes:
        hertz: how often; for a parameter, its default.
        parameter: the parameter of the node that says it, None for a rate that stays.
    """

    hertz: float
    parameter: str | None = None

    def __str__(self) -> str:
        return self.parameter or f"{self.hertz:g} Hz"


def rate_of(run: Run, statement: Any, node: Node) -> Rate | None:
    """Return the rate that a statement gives, None where it gives none."""
    given = statement.rate
    if given is None:
        return None
    if isinstance(given, ParameterValue):
        from .parameter import find_parameter  # which imports this file

        found = find_parameter(run, statement.span_of("rate"), node, given.name)
        if not isinstance(found.default, (int, float)) or isinstance(found.default, bool):
            raise Mistake(
                Diagnostic(
                    codes.PARAMETER_TYPE_MISMATCH,
                    f"a rate is a number, and `{given.name}` is none",
                    statement.span_of("rate"),
                )
            )
        hertz = check_rate(statement, found.default, f"the default of `{given.name}` is no rate")
        for limit in (found.minimum, found.maximum):
            if limit is not None:
                check_rate(statement, limit, f"`{given.name}` may be {limit:g}, which is no rate")
        return Rate(hertz, found.name)
    return Rate(check_rate(statement, given))


def check_rate(statement: Any, rate: int | float, what: str = "") -> float:
    """Check that a number is a rate, and return it."""
    if LOWEST_RATE <= rate <= HIGHEST_RATE:
        return float(rate)
    where = statement.span_of("rate")
    is_negative = not what and LOWEST_RATE <= -rate <= HIGHEST_RATE
    limits = f"a rate is at least {LOWEST_RATE:g} and at most {HIGHEST_RATE:g} hz"
    if rate <= 0:
        limits = "a rate is greater than 0 hz"
    help_ = f"write `at {-rate:g} hz`" if is_negative else None
    raise Mistake(
        Diagnostic(
            codes.INVALID_RATE,
            f"{what}: {limits}" if what else limits,
            where,
            help="write how often, such as `at 1 hz`" if not what and rate == 0 else help_,
            fix=write(f"{-rate:g}", where) if is_negative else None,
        )
    )
