"""Lists of parts that have a shape of their own: fields of a type, remaps, parameters to set."""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

from tree_sitter import Node

from .grammar import kind_id
from .inputs import COMMENTS, InputValue, lower_number, lower_value

_NONE = kind_id("none")


class FieldText(NamedTuple):
    """A field or a constant of a type, as it is written.

    Attributes:
        type: its type without space in it, such as `string<=10[]`.
        name: its name.
        operator: `=` for a constant, `default` for a field with a default value, else "".
        value: the value behind the operator, None without one.
        syntax: where it stands; it has the fields `type`, `name` and `value`.
    """

    type: str
    name: str
    operator: str
    value: InputValue | None
    syntax: Node


class RemapText(NamedTuple):
    """A name, and the one that stands for it."""

    old: str
    new: str
    syntax: Node


class SettingText(NamedTuple):
    """A parameter, and the value that it gets."""

    parameter: str
    value: InputValue
    syntax: Node


FieldTexts: TypeAlias = tuple[FieldText, ...]
RemapTexts: TypeAlias = tuple[RemapText, ...]
SettingTexts: TypeAlias = tuple[SettingText, ...]
Vector: TypeAlias = tuple[int | float, int | float, int | float]
"""Three numbers, as they are written."""


def lower_fields(node: Node, source: bytes) -> FieldTexts:
    """Lower the fields of a type; `none` has none.

    Raises:
        TooDeep: a value is nested deeper than any message is.
    """
    return () if node.kind_id == _NONE else tuple(_field(each, source) for each in _parts(node))


def lower_remaps(node: Node, source: bytes) -> RemapTexts:
    """Lower what stands after `remapping`."""
    return tuple(
        RemapText(_name(each, "old", source), _name(each, "new", source), each)
        for each in _parts(node)
    )


def lower_settings(node: Node, source: bytes) -> SettingTexts:
    """Lower what stands after `setting`.

    Raises:
        TooDeep: a value is nested deeper than any message is.
    """
    return tuple(
        SettingText(
            _name(each, "parameter", source), lower_value(_child(each, "value"), source), each
        )
        for each in _parts(node)
    )


def lower_vector(node: Node, source: bytes) -> Vector:
    """Lower three numbers."""
    x, y, z = (lower_number(source[each.start_byte : each.end_byte]) for each in _parts(node))
    return x, y, z


def _parts(node: Node) -> list[Node]:
    return [child for child in node.named_children if child.kind_id not in COMMENTS]


def _field(node: Node, source: bytes) -> FieldText:
    operator = node.child_by_field_name("operator")
    value = node.child_by_field_name("value")
    return FieldText(
        "".join(_leaves(_child(node, "type"), source)),
        _text(_child(node, "name"), source),
        "" if operator is None else _text(operator, source),
        None if value is None else lower_value(value, source),
        node,
    )


def _leaves(node: Node, source: bytes) -> list[str]:
    """Return the words of a type, without the comments between them."""
    if node.kind_id in COMMENTS:
        return []
    if not node.children:
        return [_text(node, source)]
    return [text for child in node.children for text in _leaves(child, source)]


def _name(node: Node, field: str, source: bytes) -> str:
    return _text(_child(node, field), source)[1:-1]


def _child(node: Node, name: str) -> Node:
    child = node.child_by_field_name(name)
    assert child is not None  # a node without errors has it
    return child


def _text(node: Node, source: bytes) -> str:
    return source[node.start_byte : node.end_byte].decode()
