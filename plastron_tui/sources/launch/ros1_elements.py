"""The elements of ROS 1's launch files.

Sources: the ROS wiki pages "roslaunch/XML/…", and `roslaunch.xmlloader`.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any

from plastron_tui.ros.launch import (
    Argument,
    Group,
    Include,
    Item,
    Namespace,
    Parameter,
    ParameterFile,
    ParameterValue,
    Remap,
    SetParameter,
    StartedNode,
    Variable,
)
from plastron_tui.ros.launch_text import Kind, Substitution, Text, text
from plastron_tui.ros.launch_values import as_value
from plastron_tui.sources.xml.document import Element

from .elements import Words, remaps_of, value_of
from .substitutions import parse_text

READ_VALUES = {"textfile": Kind.CONTENT, "command": Kind.COMMAND}
"""The attributes of a `param` that say where its value is read from."""

_DEEPEST = 20
_MOST = 5_000


def item_of(element: Element) -> Item | None:
    """Return what an element says, None where that is not understood."""
    words = Words(element, 1)
    match element.name:
        case "node":
            return _node(words)
        case "arg":
            return _argument(words)
        case "include":
            return _include(words)
        case "group":
            namespace = words.get("ns")
            items = () if namespace is None else (Namespace(namespace, place=words.place),)
            return Group(items, condition=words.condition, place=words.place)
        case "remap":
            old, new = words.get("from"), words.get("to")
            if old is None or new is None:
                return None
            return Remap(old, new, condition=words.condition, place=words.place)
        case "param" | "rosparam":
            found = _parameters(element)
            if found is None or len(found) != 1:
                return None
            return SetParameter(found[0], condition=words.condition, place=words.place)
        case _:
            return None


def _node(words: Words) -> StartedNode | None:
    element = words.element
    package, executable = words.get("pkg"), words.get("type")
    if package is None or executable is None:
        return None
    parameters: list[Parameter] = []
    others = list(words.others("pkg", "type", "name", "ns"))
    for child in element.named("param", "rosparam", "env"):
        found = None if child.name == "env" else _parameters(child)
        if found is None:
            others.append((f"{child.name} {child.get('name') or child.get('param') or ''}", text()))
        else:
            parameters += found
    return StartedNode(
        package,
        executable,
        words.get("name"),
        words.get("ns"),
        tuple(remaps_of(element, 1)),
        tuple(parameters),
        tuple(others),
        condition=words.condition,
        place=words.place,
    )


def _parameters(element: Element) -> list[Parameter] | None:
    """Return the parameters that an element sets, None where that is not understood."""
    words = Words(element, 1)
    if words.condition is not None:
        return None
    name = words.get("name") if element.name == "param" else words.get("param")
    if element.name == "param":
        value = element.get("value")
        if name is None:
            return None
        if value is not None:
            return [value_of(name, value, element.get("type"), 1)]
        for attribute, kind in READ_VALUES.items():
            source = words.get(attribute)
            if source is not None:
                return [ParameterValue(name, Text((Substitution(kind, source),)), is_text=True)]
        return None
    file = words.get("file")
    if file is not None:
        is_load = element.get("command") in (None, "load")
        is_plain = name is None and words.get("ns") is None
        return [ParameterFile(file)] if is_load and is_plain else None
    if words.get("ns") is not None or element.get("command") not in (None, "load"):
        return None
    return _inline(element, "" if name is None else name.literal)


def _inline(element: Element, name: str | None) -> list[Parameter] | None:
    import yaml

    source = element.text
    if name is None or "$(" in source or len(source) > 100_000:
        return None
    try:
        # An alias of an alias may stand for more than there is room for.
        found = list(islice(_flat(yaml.safe_load(source), name, 0), _MOST + 1))
    except (ValueError, OverflowError, RecursionError, yaml.YAMLError):
        return None
    known = [each for each in found if each is not None]
    return list(known) if len(known) == len(found) <= _MOST else None


def _flat(value: Any, name: str, depth: int) -> Iterator[ParameterValue | None]:
    if isinstance(value, dict) and depth < _DEEPEST:
        for key, inner in value.items():
            yield from _flat(inner, f"{name}/{key}" if name else str(key), depth + 1)
        return
    found = as_value(value)
    yield None if found is None or not name else ParameterValue(text(name), found)


def _argument(words: Words) -> Item | None:
    name, value = words.element.get("name"), words.get("value")
    if name is None:
        return None
    if value is not None:
        return Variable(name, value, condition=words.condition, place=words.place)
    return Argument(
        name,
        words.get("default"),
        words.element.get("doc") or "",
        condition=words.condition,
        place=words.place,
    )


def _include(words: Words) -> Include | None:
    file = words.get("file")
    if file is None:
        return None
    arguments = []
    for child in words.element.named("arg"):
        name = child.get("name")
        value = child.get("value") if child.get("value") is not None else child.get("default")
        if name is None or value is None:
            return None
        arguments.append((name, parse_text(value, 1)))
    return Include(
        file,
        tuple(arguments),
        words.get("ns"),
        words.others("file", "ns"),
        condition=words.condition,
        place=words.place,
    )
