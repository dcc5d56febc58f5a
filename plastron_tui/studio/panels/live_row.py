"""A row of the live panel, as data."""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.runtime.live_parts import LiveParameter

WIDEST = 500
"""So many characters of a value are looked at: more than windows show in a line."""


class Kind(Enum):
    """What a row is about."""

    HEADING = "heading"
    TOPIC = "topic"
    FIELD = "field"
    SENDING = "sending"
    SERVICE = "service"
    ANSWER = "answer"
    ACTION = "action"
    GOAL = "goal"
    NODE = "node"
    PARAMETER = "parameter"
    NOTE = "note"


class Answer(NamedTuple):
    """What a service answered."""

    text: str
    is_failure: bool = False


class LiveRow(NamedTuple):
    """A line of the panel.

    Attributes:
        key: what it is, the same as long as that is there.
        kind: what it is about.
        name: what is in its first column.
        owner: the full name of the topic, service, action or node that it belongs to.
        ros_version: the generation of ROS.
        type: the type of a topic, a service, an action or a parameter.
        rate: messages a second, in words.
        value: the last message, a field's or a parameter's value, an answer.
        tone: the tone of the value.
        samples: the numbers of its curve.
        depth: how far it is indented.
        is_branch: whether it can be unfolded.
        is_open: whether it is.
        parameter: what is known of a parameter.
        goal: the number of a goal that is worked on, of an action the newest such; 0 for none.
        is_sent_to: whether a message is sent to a topic at a rate, from here.
        is_foreign: whether the program that is watched does not have it.
        is_old: whether it is what was seen last, and nobody watches any more.
    """

    key: str
    kind: Kind
    name: str
    owner: str = ""
    ros_version: int = 2
    type: str = ""
    rate: str = ""
    value: str = ""
    tone: str = ""
    samples: tuple[float, ...] = ()
    depth: int = 0
    is_branch: bool = False
    is_open: bool = False
    parameter: LiveParameter | None = None
    goal: int = 0
    is_sent_to: bool = False
    is_foreign: bool = False
    is_old: bool = False


def one_line(text: str) -> str:
    """Return a text in one line that a terminal shows as it is; a long one is cut first."""
    return visible(text if len(text) <= WIDEST else text[:WIDEST] + "…")
