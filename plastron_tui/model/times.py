"""Times and durations: seconds, or seconds and nanoseconds.

In ROS 1 they are primitives (`time`, `duration`) of two parts; in ROS 2 they are messages of the
package `builtin_interfaces`. A program writes both in the same ways.
"""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.language.inputs import InputValue, Literal, NamedArgument, NestedValue
from plastron_tui.ros.interfaces import FieldType, Interface, InterfaceName
from plastron_tui.ros.primitives import check_scalar, primitive

from .value_diagnostics import Misfit, no_time, span
from .values import MessageValue

BUILTIN_TIMES = frozenset(
    {InterfaceName("builtin_interfaces", "Time"), InterfaceName("builtin_interfaces", "Duration")}
)
"""The messages of ROS 2 that take seconds, too."""

_NANOSECONDS = 1_000_000_000
_LEAST_SECONDS, _MOST_SECONDS = -(1 << 31), (1 << 31) - 1


def split_seconds(seconds: float) -> tuple[int, int]:
    """Split seconds into whole seconds and nanoseconds, as ROS holds them."""
    total = round(seconds * _NANOSECONDS)
    return total // _NANOSECONDS, total % _NANOSECONDS


def builtin_time(type_: Interface, value: Literal, field: str) -> MessageValue:
    """Fit seconds to a time or duration of ROS 2.

    Raises:
        Misfit: when they are no number, or too many.
    """
    seconds = value.value
    if isinstance(seconds, (bool, str)):
        raise Misfit(no_time(str(type_.name), value, field))
    if not _LEAST_SECONDS <= seconds < _MOST_SECONDS + 1:
        message = f"`{type_.name}` takes {_LEAST_SECONDS} to {_MOST_SECONDS} seconds"
        raise Misfit(Diagnostic(codes.VALUE_OUT_OF_RANGE, message, span(value.syntax)))
    names = [part.name for part in type_.fields]
    return MessageValue(type_.name, dict(zip(names, split_seconds(float(seconds)), strict=True)))


def time_parts(type_: FieldType, value: NestedValue, field: str) -> tuple[int, int]:
    """Fit `(1, 500000000)` or `(secs=1)` to a time or duration of ROS 1.

    Raises:
        Misfit: when these are not its parts, or out of range.
    """
    wanted = primitive(type_.name, 1)
    assert wanted is not None
    parts: dict[str, int] = {}
    for index, argument in enumerate(value.arguments):
        if isinstance(argument, NamedArgument):
            name, given = ".".join(argument.path), argument.value
        else:
            name, given = "".join(wanted.parts[index : index + 1]), argument
        if name not in wanted.parts or name in parts:
            raise Misfit(no_time(str(type_), value, field))
        parts[name] = _time_part(type_, given, name == wanted.parts[0], field)
    secs, nsecs = (parts.get(name, 0) for name in wanted.parts)
    return secs, nsecs


def _time_part(type_: FieldType, given: InputValue, is_secs: bool, field: str) -> int:
    if not isinstance(given, Literal) or isinstance(given.value, (bool, float, str)):
        raise Misfit(no_time(str(type_), given, field))
    if is_secs:
        problem = check_scalar(type_.name, given.value, 1)
    else:
        in_range = 0 <= given.value < _NANOSECONDS
        problem = None if in_range else f"nanoseconds are 0 to {_NANOSECONDS - 1}"
    if problem is not None:
        raise Misfit(Diagnostic(codes.VALUE_OUT_OF_RANGE, problem, span(given.syntax)))
    return given.value
