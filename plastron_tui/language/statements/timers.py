"""The statements about timers."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from ..inputs import Rate
from .shared import CALLBACK_HELP


@statement(
    "repeats_statement",
    "{node} repeats {function} at {rate} hz",
    summary="Let a node call a function of its own, again and again.",
    example="blinker repeats blink at 2 hz",
    purpose="do something again and again, or at another rate",
    ros_term="timer",
    about="A function of the node is called so many times a second: a new one, or one that a "
    "loaded file calls at another rate.",
)
class Repeats(Statement):
    """Let a node call a function of its own, again and again."""

    node: str = slot(SlotKind.NODE, "the node whose function it is")
    function: str = slot(SlotKind.TIMER, CALLBACK_HELP)
    rate: Rate = slot(SlotKind.RATE, "how often, in hertz")


@statement(
    "stop_repeating_statement",
    "{node} stop_repeating {function}",
    summary="Let a node no longer call a function of its own.",
    example="blinker stop_repeating blink",
    purpose="no longer do something again and again",
    ros_term="timer",
    about="Takes a timer away again.",
    undoes=Repeats,
)
class StopRepeating(Statement):
    """Let a node no longer call a function of its own."""

    node: str = slot(SlotKind.NODE, "the node whose function it is")
    function: str = slot(SlotKind.TIMER, "the function that is called")
