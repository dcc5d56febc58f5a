"""The values of messages as JSON, and back.

A message is an object of one key, its type. What is computed when it is sent is an object of the
key `=`; all other values are JSON's own.
"""

from __future__ import annotations

from typing import Any

from plastron_tui.model.values import (
    Computed,
    MessageValue,
    OfParameter,
    OfReceived,
    Operand,
    Origin,
    Value,
)
from plastron_tui.ros.interfaces import FieldType, InterfaceName

_COMPUTED = "="


def value_to_json(value: Value) -> Any:
    """Return a value as JSON has it."""
    match value:
        case MessageValue(type=type_, fields=fields):
            return {str(type_): {name: value_to_json(each) for name, each in fields.items()}}
        case Computed(source=source, steps=steps, type=type_, is_float=is_float):
            pairs = [[operator, _operand_to_json(operand)] for operator, operand in steps]
            return {_COMPUTED: [source_to_json(source), pairs, type_, is_float]}
        case tuple():
            return [value_to_json(each) for each in value]
        case _:
            return value


def value_from_json(value: Any) -> Value:
    """Return the value that JSON has.

    Raises:
        ValueError, TypeError, KeyError: it has none.
    """
    if isinstance(value, dict):
        ((key, held),) = value.items()
        if key == _COMPUTED:
            source, steps, type_, is_float = held
            pairs = tuple((_operator(sign), _operand_from_json(each)) for sign, each in steps)
            return Computed(source_from_json(source), pairs, _field_type(type_), bool(is_float))
        name = type_from_json(key)
        if name is None:
            raise ValueError
        return MessageValue(name, {field: value_from_json(each) for field, each in held.items()})
    if isinstance(value, list):
        return tuple(value_from_json(each) for each in value)
    return scalar_from_json(value)


def message_from_json(value: Any) -> MessageValue:
    """Return the message that JSON has.

    Raises:
        ValueError, TypeError, KeyError: it has none.
    """
    found = value_from_json(value)
    if not isinstance(found, MessageValue):
        raise TypeError
    return found


def _operand_to_json(operand: Operand) -> Any:
    return operand if isinstance(operand, int | float) else source_to_json(operand)


def _operand_from_json(operand: Any) -> Operand:
    return source_from_json(operand) if isinstance(operand, str | list) else _number(operand)


def source_to_json(source: Origin) -> Any:
    """Return where a value comes from: a parameter's name, or a path and a position."""
    if isinstance(source, OfParameter):
        return source.name
    return [source.path, source.position]


def source_from_json(source: Any) -> Origin:
    """Return where a value comes from.

    Raises:
        ValueError, TypeError: JSON does not say it.
    """
    if isinstance(source, str):
        return OfParameter(source)
    path, position = source
    return OfReceived(tuple(map(_text, path)), None if position is None else int(_number(position)))


def scalar_from_json(value: Any) -> bool | int | float | str:
    """Return a scalar that JSON has.

    Raises:
        TypeError: it has none.
    """
    if not isinstance(value, (bool, int, float, str)):
        raise TypeError
    return value


def type_from_json(text: Any) -> InterfaceName | None:
    """Return a type that JSON has, None for null.

    Raises:
        ValueError, TypeError: it has none.
    """
    if text is None:
        return None
    package, name = _text(text).split("/")
    return InterfaceName(package, name)


def _field_type(value: Any) -> FieldType:
    name, package, is_array, *limits = value
    for limit in limits:
        if limit is not None:
            _number(limit)
    package = None if package is None else _text(package)
    return FieldType(_text(name), package, bool(is_array), *limits)


def _operator(value: Any) -> str:
    if value not in ("+", "-", "*", "/"):
        raise ValueError
    return _text(value)


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError
    return value


def _number(value: Any) -> int | float:
    if not isinstance(value, (int, float)) or isinstance(value, bool):
        raise TypeError
    return value
