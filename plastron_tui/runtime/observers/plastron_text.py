"""A message of either ROS as one short line."""

from __future__ import annotations

import json
from typing import Any

_MOST_ELEMENTS = 4
_LONGEST_STRING = 200


def line_of(message: Any) -> str:
    """Return the fields of a message: `x: 1.0, y: 2.0, name: "arm"`."""
    names = field_names(message)
    return ", ".join(f"{name}: {_text(getattr(message, name))}" for name in names)


def field_names(value: Any) -> list[str]:
    """Return the names of a message's fields, nothing for a value that is no message."""
    if hasattr(value, "get_fields_and_field_types"):
        return list(value.get_fields_and_field_types())
    return list(value.__slots__) if hasattr(value, "_slot_types") or _is_time(value) else []


def _is_time(value: Any) -> bool:
    return type(value).__name__ in ("Time", "Duration") and hasattr(value, "nsecs")


def _text(value: Any) -> str:
    if isinstance(value, str):
        return json.dumps(value[:_LONGEST_STRING], ensure_ascii=False)
    if isinstance(value, (bool, int)):
        return str(value)
    if isinstance(value, float):
        return min(repr(value), f"{value:.6g}", key=len)
    if hasattr(value, "__len__") and hasattr(value, "__getitem__"):
        first = ", ".join(_text(_plain(element)) for element in value[:_MOST_ELEMENTS])
        more = f", … {len(value)} in all" if len(value) > _MOST_ELEMENTS else ""
        return f"[{first}{more}]"
    if field_names(value):
        return f"({line_of(value)})"
    return "" if hasattr(value, "__slots__") else str(value)


def _plain(element: Any) -> Any:
    """Return numpy's scalars as Python's."""
    return element.item() if hasattr(element, "item") else element
