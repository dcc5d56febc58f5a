"""Which values the fields of messages take in C++, where numbers become each other.

Sources: `rosidl_generator_cpp` of Jazzy and `gencpp` of Noetic, whose fields are plain members: a
number for a text compiles, as one character of it, and a text for a `bool`, as `true`.
"""

from __future__ import annotations

from plastron_tui.model.code_facts import MessageField, MessageType, ValueKind
from plastron_tui.ros.interfaces import FieldType

from .message_fields import Messages, Place

_NUMBERS = frozenset({ValueKind.BOOL, ValueKind.INT, ValueKind.FLOAT})
_TEXTS = frozenset({"string", "wstring"})
_TIMES = frozenset({"time", "duration"})


def is_refused_in_cpp(
    messages: Messages, place: Place, kind: ValueKind, source: MessageField | None
) -> bool:
    """Tell whether a field does not take a value, or makes something else of it.

    Args:
        messages: the definitions.
        place: the field.
        kind: what the value is.
        source: the message, or the field of one, that the value is, None for a literal.
    """
    given = None if source is None else messages.place(source)
    if source is not None and given is None:
        return False
    wanted = _message(place)
    if given is not None:
        return _is_other(messages, place, given)
    if wanted is not None or isinstance(place, MessageType) or place.is_array:
        return True
    if place.name in _TIMES:
        return False
    return kind not in (frozenset({ValueKind.TEXT}) if place.name in _TEXTS else _NUMBERS)


def _is_other(messages: Messages, place: Place, given: Place) -> bool:
    """Tell whether what a field has is no value of another one, where both are known."""
    wanted, other = _message(place), _message(given)
    if any(each is not None and messages.section(each) is None for each in (wanted, other)):
        return False
    if wanted is not None and other is not None:
        # Packages of other releases have the same messages.
        return wanted.name.name != other.name.name
    return wanted is not other and not (_is_list(place) or _is_list(given))


def _message(place: Place) -> MessageType | None:
    """Return the message that a field has, or has a list of; None for none."""
    if isinstance(place, MessageType):
        return place
    return None if place.message is None else MessageType(place.message)


def _is_list(place: Place) -> bool:
    return isinstance(place, FieldType) and place.is_array
