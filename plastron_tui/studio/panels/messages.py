"""The messages, each with its values."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from .entry import Entries, Entry, Subject
from .entry_signs import SIGNS, type_text

if TYPE_CHECKING:
    from plastron_tui.model.values import MessageValue

    from ..analysis import Analysis


def make(analysis: Analysis, _: object) -> Entries:
    """Make what the panel shows."""
    return Entries(
        _messages(analysis),
        "no messages yet\ncreate_message hello of message_type String …",
    )


def _messages(analysis: Analysis) -> Iterator[Entry]:
    sent = {
        sending.message
        for topic in analysis.graph.topics
        for end in topic.tails
        for sending in end.sendings
    }
    for variable, message in analysis.workspace.messages.items():
        fields = list(_fields(message.value))
        yield Entry(
            f"message {variable}",
            variable,
            type_text(message.value.type),
            *SIGNS[Subject.MESSAGE],
            warning="" if variable in sent else "not sent",
            span=message.span,
            subject=Subject.MESSAGE,
            name=variable,
            is_branch=bool(fields),
        )
        for name, value in fields:
            key = f"field {variable} {name}"
            yield Entry(key, f"{name} = {value}", depth=1, name=variable)


def _fields(value: MessageValue, before: str = "") -> Iterator[tuple[str, str]]:
    """Yield the fields that have a value, nested ones by their dotted names."""
    from plastron_tui.model.values import MessageValue

    for name, inner in value.fields.items():
        if isinstance(inner, MessageValue):
            yield from _fields(inner, f"{before}{name}.")
        else:
            yield before + name, _shown(inner)


def _shown(value: object) -> str:
    if isinstance(value, tuple):
        return "[" + ", ".join(map(_shown, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else str(value)


def count(analysis: Analysis) -> int:
    """Return how much there is."""
    return len(analysis.workspace.messages)
