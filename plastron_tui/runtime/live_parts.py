"""What the reports of a monitor say of a topic's ends, of a goal, of a parameter."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple


class LiveEnd(NamedTuple):
    """A node at a topic: whether it publishes there, and with which quality of service."""

    node: str
    sends: bool
    qos: str = ""


class LiveGoal(NamedTuple):
    """A goal that was sent from here.

    Attributes:
        number: its number.
        action: the name of the action.
        sent: its values, in a line.
        state: how far it is, in words.
        text: the last feedback, or the result.
        is_over: whether nothing comes of it any more.
        is_failure: whether it ended, and was not reached.
    """

    number: int
    action: str
    sent: str
    state: str
    text: str = ""
    is_over: bool = False
    is_failure: bool = False


class LiveParameter(NamedTuple):
    """A parameter of a node.

    Attributes:
        name: its name.
        value: its value, None where it has none.
        type: its type as programs name it, "" for one that cannot be set here.
        range: the least and the greatest value, None where nothing limits them.
        about: what the node says about it.
        is_read_only: whether nobody can set it.
    """

    name: str
    value: bool | int | float | str | tuple[Any, ...] | None
    type: str = ""
    range: tuple[float, float] | None = None
    about: str = ""
    is_read_only: bool = False


def ends_of(more: Sequence[Iterable[Any]]) -> tuple[LiveEnd, ...]:
    """Return who does what at a topic: the second list of a report, if it has one."""
    found = more[1] if len(more) > 1 else ()
    return tuple(LiveEnd(str(node), bool(sends), str(qos)) for sends, node, qos in found)


def goal_of(report: Mapping[str, Any]) -> LiveGoal:
    """Return the goal that a report is about."""
    return LiveGoal(
        int(report["id"]),
        str(report["name"]),
        str(report["sent"]),
        str(report["state"]),
        str(report["text"]),
        bool(report["is_over"]),
        bool(report["is_failure"]),
    )


def parameter_of(row: Mapping[str, Any]) -> LiveParameter:
    """Return the parameter that a row of a report is about."""
    value, limits = row["value"], row.get("range")
    return LiveParameter(
        str(row["name"]),
        tuple(value) if isinstance(value, list) else value,
        str(row["type"]),
        None if limits is None else (float(limits[0]), float(limits[1])),
        str(row["about"]),
        bool(row["is_read_only"]),
    )
