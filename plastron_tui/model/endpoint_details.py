"""What a file says of an endpoint beside its name, its interface and its callback, by kind."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple, TypeVar

T = TypeVar("T")

Value = bool | int | float | str | tuple["Value", ...]
"""What a parameter holds; a list is a tuple."""


class Range(NamedTuple):
    """The values that a parameter may have, both ends among them; any step where it is 0."""

    low: float
    high: float
    step: float = 0


class ParameterDetails(NamedTuple):
    """What one call says of a parameter.

    Attributes:
        type: `bool`, `int`, `float`, `string`, or a list of one, `float_list`; None where the
            call does not say it.
        default: the value that it has where nobody sets it, None where that is not known.
        default_expression: the source text of the default, "" where the call gives none.
        range: the least and the greatest value.
        description: what it is for.
        is_read_only: whether the descriptor says that nobody may change it.
        is_guess: whether the default is no more than likely: it is that of another parameter, or
            of an argument that another file may give.
    """

    type: str | None = None
    default: Value | None = None
    default_expression: str = ""
    range: Range | None = None
    description: str | None = None
    is_read_only: bool = False
    is_guess: bool = False


class TimerDetails(NamedTuple):
    """When a timer ticks.

    Attributes:
        period: in seconds, None where the file does not say it.
        is_oneshot: whether it ticks once.
        is_guess: whether the period is no more than likely, as `ParameterDetails.is_guess`.
        serves: whether it is a part of another endpoint: its function publishes a message, waits
            or calls a service as those do that Plastron writes.
    """

    period: float | None = None
    is_oneshot: bool = False
    is_guess: bool = False
    serves: bool = False


class ActionDetails(NamedTuple):
    """The functions that an action server or client has called, by name, besides its callback.

    Attributes:
        goal: of a server: decides about a goal, or hears of one.
        accepted: of a server: handles a goal that was accepted; of a client: hears that it was.
        cancel: of a server: decides about the end of a goal, or hears of it.
        feedback: of a client: takes what the server tells meanwhile.
        result: of a client: takes what came of the goal.
    """

    goal: str | None = None
    accepted: str | None = None
    cancel: str | None = None
    feedback: str | None = None
    result: str | None = None


EndpointDetails = ParameterDetails | TimerDetails | ActionDetails


def merged(said: Sequence[ParameterDetails]) -> ParameterDetails:
    """Return what several calls say of one parameter, and nothing of what they disagree about.

    A default that is not known, such as the last good value, is not another one.
    """
    defaults = [each for each in said if each.default_expression]
    known = [each.default for each in defaults if each.default is not None]
    is_one = len({(each, type(each)) for each in known}) == 1
    return ParameterDetails(
        type=_agreed(each.type for each in said),
        default=known[0] if is_one else None,
        default_expression=defaults[0].default_expression if defaults else "",
        range=_agreed(each.range for each in said),
        description=_agreed(each.description for each in said),
        is_read_only=any(each.is_read_only for each in said),
        is_guess=any(each.is_guess for each in defaults),
    )


def _agreed(said: Iterable[T | None]) -> T | None:
    """Return what is said, None where that is nothing, or not the same."""
    found = {each for each in said if each is not None}
    return found.pop() if len(found) == 1 else None
