"""Messages of either ROS, filled with values that came as JSON."""

from __future__ import annotations

import importlib
import re
from collections.abc import Mapping
from typing import Any

_ROS2_ELEMENT = re.compile(r"sequence<(.+?)(?:, \d+)?>|(.+)\[\d+\]")


def fill(message: Any, values: Mapping[str, Any]) -> Any:
    """Give fields of a message their values, and return it; the others keep their defaults.

    Raises:
        AttributeError: there is no such field.
        AssertionError, TypeError, ValueError: a value does not fit its field.
    """
    types = _field_types(message)
    for name, value in values.items():
        setattr(message, name, _value(getattr(message, name), types.get(name, ""), value))
    return message


def _field_types(message: Any) -> dict[str, str]:
    if hasattr(message, "get_fields_and_field_types"):
        return dict(message.get_fields_and_field_types())
    return {name: message._slot_types[at] for at, name in enumerate(message.__slots__)}


def _value(current: Any, type_name: str, value: Any) -> Any:
    if isinstance(value, dict):
        return fill(current, value)
    element = _element(type_name)
    if element is not None and isinstance(value, list):
        return _list(element, value)
    if hasattr(current, "nsecs") and isinstance(value, list):
        return type(current)(*value)
    return bytes([value]) if type_name == "octet" and isinstance(value, int) else value


def _element(type_name: str) -> str | None:
    """Return the type of a list's elements, None for what is no list."""
    if type_name.endswith("[]"):
        return type_name[:-2]
    match = _ROS2_ELEMENT.fullmatch(type_name)
    return None if match is None else match[1] or match[2]


def _list(element: str, values: list[Any]) -> list[Any]:
    if element == "octet":
        return [bytes([each]) for each in values]
    if not any(isinstance(each, dict) for each in values):
        return values
    package, name = element.split("/")
    made = getattr(importlib.import_module(f"{package}.msg"), name)
    return [fill(made(), each) for each in values]


def has_stamp(message: Any, values: Mapping[str, Any]) -> bool:
    """Tell whether the time in a message's header is to be that at which it is sent."""
    header = getattr(message, "header", None)
    given = values.get("header")
    is_given = isinstance(given, dict) and "stamp" in given
    return header is not None and hasattr(header, "stamp") and not is_given
