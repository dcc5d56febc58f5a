"""What a file does with messages."""

from __future__ import annotations

import re
from collections.abc import Container
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import Built, FieldUse, FieldValue, Sent
from plastron_tui.sources.python.analysis import Analysis

from .fields import field_uses
from .message_values import MessageValues
from .sent import sent_messages
from .value_kinds import ValueKinds
from .values import answered_values, built_messages, field_values

_LIBRARIES = [
    re.compile(rb"^[ \t]*(?:import|from)[ \t]+" + name + rb"\b", re.MULTILINE)
    for name in (b"rospy", b"rclpy")
]


class MessageFacts(NamedTuple):
    """The facts that the rules about messages look at; their names are those of `CodeFacts`."""

    fields: tuple[FieldUse, ...] = ()
    values: tuple[FieldValue, ...] = ()
    built: tuple[Built, ...] = ()
    sent: tuple[Sent, ...] = ()


def message_facts(analysis: Analysis, misfits: Container[Span] = frozenset()) -> MessageFacts:
    """Return what a file does with messages.

    Args:
        analysis: the file.
        misfits: the parameters of callbacks that cannot be called.
    """
    if all(each.search(analysis.syntax.text) for each in _LIBRARIES):
        # What a message has hangs on the generation of ROS that the file runs in.
        return MessageFacts()
    messages = MessageValues(analysis, misfits)
    kinds = ValueKinds(messages)
    return MessageFacts(
        tuple(field_uses(messages)),
        (*field_values(messages, kinds), *answered_values(messages, kinds)),
        tuple(built_messages(messages, kinds)),
        tuple(sent_messages(messages)),
    )
