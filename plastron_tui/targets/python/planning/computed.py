"""Values that are known when they are sent, as the Python that computes them.

What a field cannot hold never comes to a publisher: rclpy wraps it around or ends the node, and
rospy's publisher sends nothing any more after one message that cannot be serialized.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.model.kinds.computed import type_received
from plastron_tui.model.kinds.ranges import (
    EVERY_FLOAT,
    EVERY_INTEGER,
    Interval,
    field_range,
    limits_of,
    range_of_calculated,
)
from plastron_tui.model.values import Computed, OfParameter, OfReceived
from plastron_tui.ros.interfaces import Field, FieldType
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.sources.python import literals

if TYPE_CHECKING:
    from .writing import Writing

IN_RANGE = "in_range"
"""The function of a file that lets a number through that is in a range."""

ALL_IN_RANGE = "all_in_range"
"""The function of a file that does so with each number of a list."""

AS_FLOAT32 = "as_float32"
"""The function of a file that makes a number one of 32 bits."""

_OCTET = "octet"
"""A byte of ROS 2, which is one of a `bytes` in rclpy."""


class _Source(NamedTuple):
    """What a value comes from.

    Attributes:
        text: the expression.
        type: the type of the field that it is, None for a parameter.
        range: what it can be, or its elements; None for no number.
    """

    text: str
    type: FieldType | None
    range: Interval | None

    @property
    def is_whole(self) -> bool:
        """Whether it is of integers."""
        return self.range is not None and isinstance(self.range.least, int)


def written(writing: Writing, value: Computed, holder: str, heard: Sequence[Field]) -> str:
    """Write a value as its field takes it.

    Args:
        writing: the file.
        value: the value.
        holder: what holds the message or the request that is received.
        heard: its fields.
    """
    source = _source(writing, value.source, holder, heard)
    is_same = source.type == value.type and not value.steps
    if is_same:
        return source.text
    if value.type.is_array:
        return _list(writing, value, source)
    text = source.text if source.type is None else as_number(writing, source.text, source.type)
    for operator, number in value.steps:
        text += f" {operator} {literals.number(number)}"
    return _fitting(writing, value, source, text)


def may_fail(writing: Writing, value: Computed, heard: Sequence[Field]) -> bool:
    """Tell whether there may be no value, or one that its field does not take."""
    source = _source(writing, value.source, "received", heard)
    return lacks(writing, value.source, heard) or _least_and_most(writing, value, source) != ""


def lacks(writing: Writing, source: OfParameter | OfReceived, heard: Sequence[Field]) -> bool:
    """Tell whether a list may have too few elements; those of a fixed length have been counted."""
    if isinstance(source, OfParameter) or source.position is None:
        return False
    whole = OfReceived(source.path)
    return type_received(whole, heard, writing.catalog, writing.node.span).length is None


def holder_of(writing: Writing, source: OfReceived, holder: str, heard: Sequence[Field]) -> str:
    """Write a field of what is received; an element of an array is a number of Python's own."""
    path = ".".join(map(writing.dialect.field, source.path))
    text = f"{holder}.{path}"
    if source.position is None:
        return text
    text += f"[{source.position}]"
    whole = type_received(OfReceived(source.path), heard, writing.catalog, writing.node.span)
    range_ = field_range(whole, writing.dialect.ros_version)
    # rclpy has arrays of a fixed length as those of NumPy, whose numbers its messages do not take.
    if whole.length is None or range_ is None or whole.name == "byte" or not writing.is_rclpy:
        return text
    return f"{'int' if isinstance(range_.least, int) else 'float'}({text})"


def as_number(writing: Writing, text: str, type_: FieldType) -> str:
    """Write a value of a type that is no list as something to calculate and compare with."""
    return f"{text}[0]" if writing.is_rclpy and type_.name == "byte" else text


def compared_with(writing: Writing, number: float, type_: FieldType) -> str:
    """Write a number that fields of a type are equal to where they hold it, as near as they can."""
    text = literals.number(number)
    if type_.name != "float32" or array("f", [number])[0] in (number, math.inf, -math.inf):
        return text
    writing.functions.add(AS_FLOAT32)
    return f"{AS_FLOAT32}({text})"


def _source(
    writing: Writing, source: OfParameter | OfReceived, holder: str, heard: Sequence[Field]
) -> _Source:
    version = writing.dialect.ros_version
    if isinstance(source, OfReceived):
        type_ = type_received(source, heard, writing.catalog, writing.node.span)
        text = holder_of(writing, source, holder, heard)
        return _Source(text, type_, field_range(type_, version))
    parameter = writing.parameter_of(source.name)
    assert parameter.holds is not None  # statements say it
    every = {ParameterType.INT: EVERY_INTEGER, ParameterType.FLOAT: EVERY_FLOAT}
    range_ = limits_of(writing.node, parameter, version) or every.get(parameter.holds.element)
    return _Source(writing.parameter(source.name), None, range_)


def _list(writing: Writing, value: Computed, source: _Source) -> str:
    """Write a list as a field of lists takes it."""
    text = source.text
    is_bytes = source.type is not None and source.type.name == "byte" and writing.is_rclpy
    if is_bytes:
        text = f"[each[0] for each in {text}]"
    elif writing.is_rclpy and source.type is not None and source.range is not None:
        # An array of another type is no list: its memory would be taken as it is.
        text = f"{text}.tolist()"
    limits = _least_and_most(writing, value, source)
    if limits:
        writing.functions |= {IN_RANGE, ALL_IN_RANGE}
        text = f"{ALL_IN_RANGE}({text}, {limits})"
    made = _made_of(writing, value, source)
    if made == _OCTET:
        return f"[bytes([each]) for each in {text}]"
    if made:
        return f"list(map({made}, {text}))"
    is_list = limits or not writing.is_rclpy or text != source.text
    return text if is_list else f"list({text})"


def _fitting(writing: Writing, value: Computed, source: _Source, text: str) -> str:
    """Write a value of which the text is known as the field takes it."""
    limits = _least_and_most(writing, value, source)
    if limits:
        writing.functions.add(IN_RANGE)
        text = f"{IN_RANGE}({text}, {limits})"
    made = _made_of(writing, value, source)
    if made == _OCTET:
        return f"bytes([{text}])"
    return f"{made}({text})" if made else text


def _made_of(writing: Writing, value: Computed, source: _Source) -> str:
    """Return what makes a number one that the field takes, "" where it is one."""
    target = field_range(value.type, writing.dialect.ros_version)
    if source.range is None or target is None:
        return ""
    if isinstance(target.least, int):
        return _OCTET if writing.is_rclpy and value.type.name == "byte" else ""
    is_short = value.type.name == "float32"
    if is_short and not target.contains(range_of_calculated(source.range, value.steps)):
        writing.functions.add(AS_FLOAT32)
        return AS_FLOAT32
    is_whole = source.is_whole and not value.is_float
    return "float" if writing.is_rclpy and is_whole else ""


def _least_and_most(writing: Writing, value: Computed, source: _Source) -> str:
    """Write the limits of a field that a value may pass, "" where it cannot."""
    target = field_range(value.type, writing.dialect.ros_version)
    if source.range is None or target is None or not isinstance(target.least, int):
        return ""
    if target.contains(range_of_calculated(source.range, value.steps)):
        return ""
    return f"{target.least}, {target.most}"
