"""What both generations of ROS have in common in their launch files in XML."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from plastron_tui.ros.launch import Condition, ParameterValue, Place, Remapping
from plastron_tui.ros.launch_text import Text
from plastron_tui.ros.launch_values import typed_as
from plastron_tui.sources.xml.document import Element

from .substitutions import parse_text

COMMON = ("if", "unless")


class Words:
    """The attributes of an element, with their substitutions."""

    def __init__(self, element: Element, ros_version: int) -> None:
        self.element = element
        self._version = ros_version

    def get(self, name: str) -> Text | None:
        """Return the text of an attribute, None where it is not there."""
        found = self.element.attribute(name)
        if found is None:
            return None
        parsed, span = parse_text(found.value, self._version), found.value_span
        # What has references is written otherwise.
        is_plain = parsed.literal is not None and span.end - span.start == len(found.value.encode())
        return replace(parsed, span=span) if is_plain else parsed

    @property
    def condition(self) -> Condition | None:
        """When what the element says holds."""
        for name in COMMON:
            found = self.get(name)
            if found is not None:
                return Condition(found, name == "unless")
        return None

    @property
    def place(self) -> Place:
        """Where the element stands."""
        return Place(self.element.span.start, self.element.span.end, self.element.line)

    def others(self, *known: str) -> tuple[tuple[str, Text], ...]:
        """Return the attributes that are not among these."""
        return tuple(
            (each.name, parse_text(each.value, self._version))
            for each in self.element.attributes
            if each.name not in (*known, *COMMON)
        )


def remaps_of(element: Element, ros_version: int) -> Iterator[Remapping]:
    """Yield the remaps in an element."""
    for child in element.named("remap"):
        words = Words(child, ros_version)
        old, new = words.get("from"), words.get("to")
        if old is not None and new is not None and words.condition is None:
            yield Remapping(old, new, words.place)


def value_of(name: Text, source: str, type_: str | None, ros_version: int) -> ParameterValue:
    """Return a parameter whose value is a text, with the type that it gets.

    In ROS 2 a text without a type is read as YAML, and so are the texts in it.
    """
    is_text = type_ in ("str", "string")
    found = parse_text(source, ros_version)
    if ros_version == 2 and not is_text:
        value = typed_as(source, type_, 2)
        if isinstance(value, tuple):
            parts = [parse_text(x, 2).literal if isinstance(x, str) else x for x in value]
            known = tuple(x for x in parts if x is not None)
            if len(known) == len(parts):
                return ParameterValue(name, known)
        elif isinstance(value, str) and "$(" not in source:
            found = parse_text(value, 2)
    literal = found.literal
    if literal is None:
        return ParameterValue(name, found, is_text, type_ in ("float", "double"))
    value = typed_as(literal, type_, ros_version)
    return ParameterValue(name, found if value is None else value, is_text and value is None)
