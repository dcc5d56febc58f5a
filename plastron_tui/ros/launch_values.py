"""Which type the value of a parameter gets from a launch file in XML.

Sources: `roslaunch.loader.convert_value`; for ROS 2 `launch/utilities/type_utils.py`, which takes
YAML as PyYAML does, and `launch_ros/actions/node.py` for the names of types.
"""

from __future__ import annotations

from typing import Any

from .parameter_values import yaml_text
from .parameters import Scalar, Setting

_NAMES = {
    1: {bool: "bool", int: "int", float: "double", str: "str", tuple: "yaml"},
    2: {bool: "bool", int: "int", float: "float", str: "str"},
}
_LISTS = {bool: "list_of_bool", int: "list_of_int", float: "list_of_float", str: "list_of_str"}
_LONGEST = 100_000


def typed(text: str, ros_version: int) -> Setting | None:
    """Return the value of a text whose type is not said, None where it is none that ROS takes."""
    if ros_version == 2:
        return from_yaml(text) if text else ""
    try:
        return float(text) if "." in text else int(text)
    except ValueError:
        pass
    return {"true": True, "false": False}.get(text.lower(), text)


def typed_as(text: str, type_: str | None, ros_version: int) -> Setting | None:
    """Return the value of a text of a type, None where it is not one of that type."""
    if ros_version == 1:
        # `roslaunch.xmlloader` does so before it looks at the type.
        text = text.strip()
    if type_ is None or (ros_version == 1 and type_ == "auto"):
        return typed(text, ros_version)
    if type_ in ("str", "string"):
        return text
    try:
        if type_ == "int":
            return int(text)
        if type_ in ("double", "float"):
            return float(text)
    except ValueError:
        return None
    if type_ == "bool":
        return {"true": True, "1": True, "false": False, "0": False}.get(text.lower())
    if type_ == "yaml" or type_ in _LISTS.values():
        return from_yaml(text)
    return None


def from_yaml(text: str) -> Setting | None:
    """Return a value in YAML as PyYAML reads it, None for what no parameter can hold."""
    import yaml

    if len(text) > _LONGEST:
        return None
    try:
        return as_value(yaml.safe_load(text))
    except (ValueError, OverflowError, RecursionError, yaml.YAMLError):
        return None


def as_value(value: Any) -> Setting | None:
    """Return a value of Python as a parameter holds it, None where it cannot."""
    if isinstance(value, (bool, int, float, str)):
        return value
    if not isinstance(value, (list, tuple)):
        return None
    items = [each for each in value if isinstance(each, (bool, int, float, str))]
    is_one_type = len({type(each) for each in items}) < 2
    return tuple(items) if len(items) == len(value) and is_one_type else None


def written(value: Setting, ros_version: int) -> tuple[str, str | None]:
    """Return a value as a text, and the type that has to be said beside it, None for none."""
    if isinstance(value, tuple):
        is_texts = any(isinstance(each, str) for each in value)
        if ros_version == 1:
            return yaml_text(value), "yaml"
        return yaml_text(value), "list_of_str" if is_texts else None
    if ros_version == 1 and isinstance(value, str) and value != value.strip():
        return yaml_text(value), "yaml"
    text = _scalar_text(value, ros_version)
    found = typed(text, ros_version)
    if type(found) is type(value) and (found == value or found != found):
        return text, None
    return text, _NAMES[ros_version][type(value)]


def _scalar_text(value: Scalar, ros_version: int) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, float) and ros_version == 1:
        return repr(value)
    return yaml_text(value)
