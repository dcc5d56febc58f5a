"""Which values the fields of messages take.

Sources for Python: the setters that rosidl_generator_py makes (checked up to Iron, and with
`ROS_PYTHON_CHECK_FIELDS` since; without the check the conversion to C takes what the value is not);
the `serialize` that genpy makes, which packs numbers by `struct`. In C++ numbers become one
another, and what a text gets of a number is one character.
"""

from __future__ import annotations

from plastron_tui.model.code_facts import FieldValue, MessageField, MessageType, Part, ValueKind
from plastron_tui.ros.interfaces import FieldType, InterfaceName
from plastron_tui.ros.primitives import PRIMITIVES

from .cpp_values import is_refused_in_cpp
from .dependencies import TYPE_ENDINGS
from .message_fields import Messages, Place, described

_WORDS = {
    ValueKind.BOOL: "a bool",
    ValueKind.INT: "an int",
    ValueKind.FLOAT: "a float",
    ValueKind.TEXT: "a str",
    ValueKind.BYTES: "bytes",
    ValueKind.LIST: "a list",
    ValueKind.DICT: "a dict",
    ValueKind.SET: "a set",
    ValueKind.NONE: "None",
    ValueKind.TIME: "a time of the client library",
    ValueKind.MESSAGE: "a message",
    ValueKind.CLASS: "the class of a message",
}
_LONGEST = 40
"""The most digits of an integer that are looked at; no type holds half of them."""

_BOTH = frozenset({ValueKind.BOOL, ValueKind.INT})

_RCLPY = {
    "bool": frozenset({ValueKind.BOOL}),
    "int": _BOTH,
    # An integer there is for another rule.
    "float": frozenset({ValueKind.FLOAT, ValueKind.INT}),
    "string": frozenset({ValueKind.TEXT}),
    "byte": frozenset({ValueKind.BYTES}),
}
_ROSPY = {
    "bool": _BOTH,
    "int": _BOTH,
    "float": frozenset({ValueKind.BOOL, ValueKind.INT, ValueKind.FLOAT}),
    # In Python 2 these are texts.
    "string": frozenset({ValueKind.TEXT, ValueKind.BYTES}),
    "byte": _BOTH,
    "time": frozenset({ValueKind.TIME}),
}
_NUMBERS = frozenset({ValueKind.BOOL, ValueKind.INT, ValueKind.FLOAT})
_CPP = {
    **dict.fromkeys(("bool", "int", "float", "byte"), _NUMBERS),
    "string": frozenset({ValueKind.TEXT, ValueKind.BYTES}),
    "time": frozenset(ValueKind),
}
_BYTES = frozenset({"uint8", "int8", "char", "byte"})


def kind_of(place: Place, ros_version: int) -> ValueKind | None:
    """Return what a field has, as Python tells values apart; None where that is not known."""
    if isinstance(place, MessageType) or (place.message is not None and not place.is_array):
        return ValueKind.MESSAGE
    if place.is_array:
        return ValueKind.LIST
    family = family_of(place.name, ros_version)
    return {
        "bool": ValueKind.BOOL,
        "int": ValueKind.INT,
        "float": ValueKind.FLOAT,
        "string": ValueKind.TEXT,
        "time": ValueKind.TIME,
        "byte": ValueKind.BYTES if ros_version == 2 else ValueKind.INT,
    }.get(family)


def family_of(primitive: str, ros_version: int) -> str:
    """Return what a primitive type is like: `int` for `uint8`."""
    if primitive in ("time", "duration"):
        return "time"
    if primitive == "byte":
        return "byte" if ros_version == 2 else "int"
    if primitive in ("char", "octet"):
        return "int"
    if primitive in ("string", "wstring"):
        return "string"
    return primitive.rstrip("0123456789").removeprefix("u")


def words(messages: Messages, value: FieldValue) -> str:
    """Return what a value is, in words."""
    place = messages.place(value.source) if value.source is not None else None
    if isinstance(place, MessageType):
        return f"a {described(place)}" if place.part is Part.MESSAGE else described(place)
    if isinstance(place, FieldType):
        return f"a `{place}`"
    return _WORDS[value.kind]


def is_refused(messages: Messages, place: Place, value: FieldValue) -> bool:
    """Tell whether a field does not take a value, for sure; an int in a float field is not told."""
    if not messages.is_python:
        return is_refused_in_cpp(messages, place, value.kind, value.source)
    kind: ValueKind | None = value.kind
    given: Place | None = None
    if kind is ValueKind.MESSAGE:
        source = value.source
        if source is None and value.message is not None:
            source = MessageField(MessageType(value.message))
        given = messages.place(source) if source is not None else None
        kind = None if given is None else kind_of(given, messages.version)
    if kind is None or (kind is ValueKind.NONE and not _is_checked(messages, value)):
        return False
    if isinstance(place, MessageType) or (place.message is not None and not place.is_array):
        wanted = place if isinstance(place, MessageType) else MessageType(_message(place))
        fields = messages.fields(wanted)
        is_bare = kind is not ValueKind.MESSAGE and not value.path
        if is_bare and messages.version == 1 and len(fields) == 1:
            # rospy makes a message of it: what is sent is the value of its only field.
            return is_refused(messages, fields[0].type, value)
        return kind is not ValueKind.MESSAGE or _is_other(messages, wanted, given, value)
    if place.is_array:
        return _is_list_refused(messages, place, kind, given, value)
    return kind not in _taken(place, messages) or _is_out_of_range(messages, place, value)


def _is_checked(messages: Messages, value: FieldValue) -> bool:
    """Whether None is refused where it is given, and not only where it is sent."""
    is_answer = not value.path and value.type.part is Part.RESPONSE
    return messages.version == 2 or is_answer


def _is_out_of_range(messages: Messages, place: FieldType, value: FieldValue) -> bool:
    """Whether an integer is too great for a field, or too small."""
    primitive = PRIMITIVES[messages.version].get(place.name)
    if primitive is None or primitive.low is None or primitive.high is None:
        return False
    text = value.text.replace(" ", "")
    is_number = value.kind is ValueKind.INT and text.removeprefix("-").isdecimal()
    return is_number and not primitive.low <= int(text[:_LONGEST]) <= primitive.high


def _message(type_: FieldType) -> InterfaceName:
    assert type_.message is not None
    return type_.message


def _is_other(
    messages: Messages, wanted: MessageType, given: Place | None, value: FieldValue
) -> bool:
    """Whether a message is of another type, where both are known."""
    if isinstance(given, FieldType):
        given = MessageType(_message(given))
    if given is None or not all(_is_known(messages, each) for each in (wanted, given)):
        return False
    if given == wanted or messages.version == 2:
        return given != wanted
    fields = messages.fields(wanted)
    if not value.path:
        # rospy makes a message of its only field, and goes by the definition, not by its name.
        return not (
            (len(fields) == 1 and fields[0].type.message == given.name)
            or [(each.type, each.name) for each in fields]
            == [(each.type, each.name) for each in messages.fields(given)]
        )
    # rospy packs whatever has fields of these names: a point for a vector.
    names = {each.name for each in messages.fields(given)}
    return not names.issuperset(each.name for each in fields)


def _is_known(messages: Messages, type_: MessageType) -> bool:
    """Whether a type is one: for rclpy the name tells it from others, known or not."""
    is_named = messages.version == 2 and type_.name.package.endswith(TYPE_ENDINGS)
    return is_named or messages.section(type_) is not None


def _is_list_refused(
    messages: Messages, place: FieldType, kind: ValueKind, given: Place | None, value: FieldValue
) -> bool:
    element = place.element
    if kind is ValueKind.SET or (kind is ValueKind.DICT and messages.version == 1):
        # Both libraries take the elements of a set; rospy takes the keys of a dict as well.
        return False
    if kind is ValueKind.BYTES:
        return element.name not in _BYTES and messages.version == 2
    if kind is ValueKind.TEXT and messages.version == 1:
        # Python 2 has bytes in it.
        return element.name not in _BYTES
    if kind is not ValueKind.LIST:
        return True
    # `[None] * 3` has places that are filled later.
    elements = [each for each in value.elements if each is not ValueKind.NONE]
    if isinstance(given, FieldType):
        return _is_list_other(given, place, messages)
    if element.message is not None:
        return any(each is not ValueKind.MESSAGE for each in elements)
    if element_out_of_range(messages, place, value) is not None:
        return True
    return any(each not in _taken(element, messages) for each in elements)


def element_out_of_range(messages: Messages, place: Place, value: FieldValue) -> int | None:
    """Return a number of a list that is too great for an element of a field, or too small."""
    if not isinstance(place, FieldType) or not place.is_array:
        return None
    primitive = PRIMITIVES[messages.version].get(place.element.name)
    if primitive is None or primitive.low is None or primitive.high is None:
        return None
    low, high = primitive.low, primitive.high
    return next((each for each in value.extremes if not low <= each <= high), None)


def _is_list_other(given: FieldType, place: FieldType, messages: Messages) -> bool:
    """Whether the elements of a list of a message are none that another list takes."""
    if (given.message is None) != (place.message is None):
        return True
    if given.message is not None:
        return given.message != place.message
    kind = kind_of(given.element, messages.version)
    return kind is not None and kind not in _taken(place.element, messages)


def _taken(type_: FieldType, messages: Messages) -> frozenset[ValueKind]:
    of_python = _ROSPY if messages.version == 1 else _RCLPY
    table = of_python if messages.is_python else _CPP
    return table.get(family_of(type_.name, messages.version), frozenset(ValueKind))
