"""Values that are known when they are sent, as a program writes them."""

from __future__ import annotations

from collections.abc import Iterable

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.language.inputs import (
    Argument,
    Calculation,
    ListValue,
    NamedArgument,
    NestedValue,
    ParameterValue,
    Received,
    Step,
)
from plastron_tui.ros.interfaces import FieldType

from .value_diagnostics import Misfit, span
from .values import Computed, OfParameter, OfReceived, Operand, Origin


def computed(type_: FieldType, value: ParameterValue | Received | Calculation) -> Computed:
    """Return the value of a field; whether it fits is seen where it is sent.

    Raises:
        Misfit: it can be no value of anything.
    """
    first = value.first if isinstance(value, Calculation) else value
    steps = value.steps if isinstance(value, Calculation) else ()
    for step in steps:
        if step == Step("/", 0):
            message = "nothing can be divided by zero"
            raise Misfit(Diagnostic(codes.VALUE_OUT_OF_RANGE, message, span(value.syntax)))
    pairs = tuple((step.operator, _operand(step.operand)) for step in steps)
    is_float = any(sign == "/" or isinstance(operand, float) for sign, operand in pairs)
    return Computed(_origin(first), pairs, type_, is_float)


def _origin(given: ParameterValue | Received) -> Origin:
    return OfParameter(given.name) if isinstance(given, ParameterValue) else received(given)


def _operand(given: int | float | ParameterValue | Received) -> Operand:
    return given if isinstance(given, int | float) else _origin(given)


def written_as(
    values: Iterable[Argument], value: Computed
) -> ParameterValue | Received | Calculation | None:
    """Return where values of a program say a computed value, None where they do not."""
    for each in values:
        found = None
        match each:
            case NamedArgument(value=inner):
                found = written_as((inner,), value)
            case ListValue(items=inner) | NestedValue(arguments=inner):
                found = written_as(inner, value)
            case ParameterValue() | Received() | Calculation():
                found = each if computed(value.type, each) == value else None
        if found is not None:
            return found
    return None


def received(given: Received) -> OfReceived:
    """Return what a program means by a field of what is received.

    Raises:
        Misfit: it asks for an element that no list has.
    """
    position = given.position
    if position is None or (isinstance(position, int) and position >= 0):
        return OfReceived(given.path, position)
    message = "elements are counted in whole numbers, from 0"
    raise Misfit(Diagnostic(codes.VALUE_OUT_OF_RANGE, message, span(given.syntax)))
