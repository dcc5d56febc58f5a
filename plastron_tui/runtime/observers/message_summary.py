"""What of a message of either ROS is shown: a line that sums it up, and its fields with values.

What has too many numbers to be read is told in a few: an image by its size and encoding, a scan by
the least of its distances.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from plastron_text import field_names

MOST_FIELDS = 60
_FEW_FIELDS = 3
_MOST_ELEMENTS = 6
_LONGEST_STRING = 120
_LONGEST_LINE = 200
_DEEPEST = 8
# Of longer arrays only so many values, evenly spread, are looked at for the least and the greatest.
_MOST_COMPARED = 2000


class FieldText(NamedTuple):
    """A field: its path from the message, its value as text, and as a number where it is one."""

    path: str
    text: str
    number: float | None


def fields_of(message: Any) -> list[FieldText]:
    """Return the fields of a message, those of messages in it by their paths: `linear.x`."""
    found: list[FieldText] = []
    for field in _fields(message, "", 0):
        if len(found) == MOST_FIELDS:
            return [*found, FieldText("…", "more fields", None)]
        found.append(field)
    return found


def summary_of(message: Any, type_name: str) -> FieldText:
    """Return a line about a message, and the number that stands for it, where there is one.

    That is the first number that is no part of a header. Of many fields those with 0 are left out.
    """
    make = _SPECIAL.get(type_name)
    if make is not None:
        return FieldText("", make(message)[:_LONGEST_LINE], None)
    fields = [each for each in fields_of(message) if not _is_header(each.path)]
    number = next((each.number for each in fields if each.number is not None), None)
    if len(fields) == 1:
        return FieldText("", fields[0].text[:_LONGEST_LINE], number)
    if len(fields) > _FEW_FIELDS:
        fields = [each for each in fields if each.number != 0] or [FieldText("all", "0", None)]
    line = ", ".join(f"{each.path}: {each.text}" for each in fields) or "empty"
    return FieldText("", line[:_LONGEST_LINE], number)


def amount(count: float) -> str:
    """Return a number of bytes for a person: `900 KB`."""
    for unit in ("bytes", "KB", "MB"):
        if count < 1000:
            return (
                f"{count:.0f} {unit}" if count >= 10 or unit == "bytes" else f"{count:.1f} {unit}"
            )
        count /= 1000
    return f"{count:.1f} GB"


def _counted(count: int, thing: str) -> str:
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def _is_header(path: str) -> bool:
    return path.partition(".")[0] in ("header", "stamp")


def _fields(message: Any, around: str, depth: int) -> Iterator[FieldText]:
    for name in field_names(message):
        value = getattr(message, name)
        path = f"{around}.{name}" if around else name
        if _is_time(value):
            yield FieldText(path, _time(value), None)
        elif field_names(value) and depth < _DEEPEST:
            yield from _fields(value, path, depth + 1)
        else:
            yield FieldText(path, _text(value), _number(value))


def _is_time(value: Any) -> bool:
    return type(value).__name__ in ("Time", "Duration") and (
        hasattr(value, "nsecs") or hasattr(value, "nanosec")
    )


def _time(value: Any) -> str:
    seconds = value.secs if hasattr(value, "secs") else value.sec
    parts = value.nsecs if hasattr(value, "nsecs") else value.nanosec
    return f"{seconds + parts / 1e9:.3f} s"


def _number(value: Any) -> float | None:
    if isinstance(value, (bool, int, float)):
        try:
            number = float(value)
        except OverflowError:
            return None
        return number if math.isfinite(number) else None
    return None


def _text(value: Any) -> str:
    if isinstance(value, str):
        more = "…" if len(value) > _LONGEST_STRING else ""
        return json.dumps(value[:_LONGEST_STRING] + more, ensure_ascii=False)
    if isinstance(value, (bool, int)):
        return str(value)
    if isinstance(value, float):
        return _short(value)
    if isinstance(value, (bytes, bytearray)):
        return amount(len(value)) if len(value) > 1 else str(value[0] if value else 0)
    if hasattr(value, "__len__") and hasattr(value, "__getitem__"):
        return _list(value)
    return str(value)[:_LONGEST_STRING]


def _short(value: float) -> str:
    return min(repr(value), f"{value:.4g}", key=len)


def _list(values: Sequence[Any]) -> str:
    count = len(values)
    if not count:
        return "[]"
    first = _plain(values[0])
    if field_names(first):
        kind = type(first).__name__.lstrip("_")
        return f"{count} × {kind}"
    if count <= _MOST_ELEMENTS:
        return f"[{', '.join(_text(_plain(each)) for each in values)}]"
    if isinstance(first, bool) or not isinstance(first, (int, float)):
        return f"{count} values"
    return f"{count} numbers{_range(values)}"


def _plain(element: Any) -> Any:
    """Return numpy's scalars as Python's."""
    return element.item() if hasattr(element, "item") else element


def _range(values: Sequence[Any]) -> str:
    """Return the least and the greatest of numbers, "" where none is finite."""
    step = max(1, len(values) // _MOST_COMPARED)
    finite = [float(each) for each in values[::step] if math.isfinite(each)]
    if not finite:
        return ""
    low, high = min(finite), max(finite)
    return f", {_short(round(low, 3))}…{_short(round(high, 3))}"


def _image(message: Any) -> str:
    size = f"{message.width}x{message.height}"
    return f"{size} {message.encoding}, {amount(len(message.data))}"


def _compressed(message: Any) -> str:
    return f"{message.format or 'compressed'}, {amount(len(message.data))}"


def _scan(message: Any) -> str:
    count = _counted(len(message.ranges), "range")
    if not len(message.ranges):
        return count
    low, high = _reach(message.range_min, message.range_max)
    inside = [float(each) for each in message.ranges if math.isfinite(each) and low <= each <= high]
    if not inside:
        return f"{count}, nothing in reach"
    return f"{count}, nearest {_short(round(min(inside), 3))} m"


def _reach(low: float, high: float) -> tuple[float, float]:
    """Return the distances between which a laser measures; limits that say nothing do not count.

    A greatest distance of 0 is that of a message in which nobody filled it in.
    """
    low = low if math.isfinite(low) and low > 0 else 0.0
    if not high > 0:
        return low, math.inf
    return (low, high) if low <= high else (0.0, math.inf)


def _cloud(message: Any) -> str:
    names = " ".join(field.name for field in message.fields)
    points = message.width * message.height
    return f"{points:,} points ({names}), {amount(len(message.data))}"


def _grid(message: Any) -> str:
    info = message.info
    return f"{info.width}x{info.height} cells of {_short(round(info.resolution, 4))} m"


def _path(message: Any) -> str:
    return _counted(len(message.poses), "pose")


def _transforms(message: Any) -> str:
    pairs = [f"{each.header.frame_id} → {each.child_frame_id}" for each in message.transforms[:3]]
    more = ", …" if len(message.transforms) > len(pairs) else ""
    count = _counted(len(message.transforms), "transform")
    return f"{count}: {', '.join(pairs)}{more}"


_SPECIAL: dict[str, Callable[[Any], str]] = {
    "sensor_msgs/Image": _image,
    "sensor_msgs/CompressedImage": _compressed,
    "sensor_msgs/LaserScan": _scan,
    "sensor_msgs/PointCloud2": _cloud,
    "nav_msgs/OccupancyGrid": _grid,
    "nav_msgs/Path": _path,
    "geometry_msgs/PoseArray": _path,
    "tf2_msgs/TFMessage": _transforms,
    "tf/tfMessage": _transforms,
}
