"""The values that a program gives to a message or a request, as they are written."""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple, TypeAlias

from tree_sitter import Node

from plastron_tui.diagnostics import escapes

from .grammar import kind_id

NUMBER = kind_id("number")
STRING = kind_id("string")
BOOLEAN = kind_id("boolean")
LIST = kind_id("list")
ARGUMENTS = kind_id("arguments")
NAMED_ARGUMENT = kind_id("named_argument")
PARAMETER = kind_id("parameter")
ELEMENT = kind_id("element")
CALCULATION = kind_id("calculation")
STRING_CONTENT = kind_id("string_content")
_COMPUTED = frozenset({PARAMETER, ELEMENT, CALCULATION, kind_id("reference")})
COMMENTS = frozenset({kind_id("line_comment"), kind_id("block_comment")})


class Nothing(Enum):
    """What the word `none` stands for in the place of a name."""

    NONE = "none"


class Literal(NamedTuple):
    """A number, a string or a boolean."""

    value: bool | int | float | str
    syntax: Node


class ListValue(NamedTuple):
    """Values in brackets."""

    items: tuple[InputValue, ...]
    syntax: Node


class NestedValue(NamedTuple):
    """The values of a nested message, in parentheses."""

    arguments: tuple[Argument, ...]
    syntax: Node


class NamedArgument(NamedTuple):
    """A value with the path of its field."""

    path: tuple[str, ...]
    value: InputValue
    syntax: Node


class ParameterValue(NamedTuple):
    """The value that a parameter of the node has."""

    name: str
    syntax: Node


class Received(NamedTuple):
    """A field of what was received, or an element of a list in it, from 0."""

    path: tuple[str, ...]
    position: int | float | None
    syntax: Node


class Step(NamedTuple):
    """What is done to a value: `*` and a number, say, or another value that is known then."""

    operator: str
    operand: int | float | ParameterValue | Received


class Calculation(NamedTuple):
    """A value, and what is done to it, with the precedence of arithmetic."""

    first: ParameterValue | Received
    steps: tuple[Step, ...]
    syntax: Node


class Condition(NamedTuple):
    """What must hold of what was received.

    Attributes:
        quantifier: `any` or `all` of a list, None for what is no list.
        received: what is compared.
        operator: `<`, `>` or `=`.
        value: with what.
        syntax: where it stands.
    """

    quantifier: str | None
    received: Received
    operator: str
    value: Literal
    syntax: Node


class QosWord(NamedTuple):
    """A word of quality of service, and its number where it has one."""

    word: str
    number: int | float | None
    syntax: Node


QosWords: TypeAlias = tuple[QosWord, ...]
Rate: TypeAlias = int | float | ParameterValue
InputValue: TypeAlias = (
    "Literal | ListValue | NestedValue | ParameterValue | Received | Calculation"
)
Argument: TypeAlias = "InputValue | NamedArgument"
Input: TypeAlias = tuple[Argument, ...]
"""The arguments of an input; `none` has none."""

DEEPEST_NESTING = 50
"""More than any message nests: values that go deeper are a mistake, and not followed."""


class TooDeep(Exception):  # noqa: N818 - control flow, from a value to the statement it is in
    """Values are nested deeper than any message is; `syntax` is where it gets too deep."""

    def __init__(self, syntax: Node) -> None:
        self.syntax = syntax


def lower_input(node: Node, source: bytes) -> Input:
    """Lower what stands after the word `input`.

    Raises:
        TooDeep: the values are nested deeper than `DEEPEST_NESTING`.
    """
    return _arguments(node, source, 0) if node.kind_id == ARGUMENTS else ()


def _arguments(node: Node, source: bytes, depth: int) -> tuple[Argument, ...]:
    return tuple(
        [
            _named(child, source, depth)
            if child.kind_id == NAMED_ARGUMENT
            else _value(child, source, depth)
            for child in node.named_children
            if child.kind_id not in COMMENTS
        ]
    )


def _named(node: Node, source: bytes, depth: int) -> NamedArgument:
    path = node.child_by_field_name("field")
    value = node.child_by_field_name("value")
    assert path is not None and value is not None  # a node without errors has both
    names = tuple(
        source[part.start_byte : part.end_byte].decode()
        for part in path.named_children
        if part.kind_id not in COMMENTS
    )
    return NamedArgument(names, _value(value, source, depth), node)


def _value(node: Node, source: bytes, depth: int) -> InputValue:
    kind = node.kind_id
    if kind == NUMBER:
        return Literal(lower_number(source[node.start_byte : node.end_byte]), node)
    if kind == STRING:
        return Literal(_string(node, source), node)
    if kind == BOOLEAN:
        return Literal(source[node.start_byte : node.end_byte] == b"True", node)
    if depth == DEEPEST_NESTING:
        raise TooDeep(node)
    if kind in _COMPUTED:
        return _computed(node, source)
    children = [child for child in node.named_children if child.kind_id not in COMMENTS]
    if kind == LIST:
        return ListValue(tuple([_value(child, source, depth + 1) for child in children]), node)
    return NestedValue(_arguments(children[0], source, depth + 1) if children else (), node)


def lower_value(node: Node, source: bytes) -> InputValue:
    """Lower a single value.

    Raises:
        TooDeep: it is nested deeper than `DEEPEST_NESTING`.
    """
    return _value(node, source, 0)


def lower_rate(node: Node, source: bytes) -> Rate:
    """Lower what stands between `at` and `hz`."""
    return _parameter(node, source) if node.kind_id == PARAMETER else _number(node, source)


def lower_condition(node: Node, source: bytes) -> Condition:
    """Lower what stands after `when`."""
    quantifier = node.child_by_field_name("quantifier")
    value = _value(_child(node, "value"), source, 0)
    assert isinstance(value, Literal)
    return Condition(
        None if quantifier is None else _text(quantifier, source),
        _received(_child(node, "received"), source),
        _text(_child(node, "operator"), source),
        value,
        node,
    )


def lower_qos(node: Node, source: bytes) -> QosWords:
    """Lower what stands after `with qos`."""
    words = []
    for child in node.named_children:
        if child.kind_id not in COMMENTS:
            number = child.child_by_field_name("value")
            words.append(
                QosWord(
                    _text(_child(child, "policy"), source),
                    None if number is None else _number(number, source),
                    child,
                )
            )
    return tuple(words)


def lower_text(node: Node, source: bytes) -> str:
    """Lower a text in double quotes."""
    return _string(node, source)


def _computed(node: Node, source: bytes) -> ParameterValue | Received | Calculation:
    """Lower a parameter, a part of what was received, or a calculation with one of them."""
    if node.kind_id == PARAMETER:
        return _parameter(node, source)
    if node.kind_id != CALCULATION:
        return _received(node, source)
    first, *rest = (child for child in node.named_children if child.kind_id not in COMMENTS)
    start = _computed(first, source)
    assert not isinstance(start, Calculation)
    operators = (_text(child, source) for child in rest[::2])
    operands = (_operand(child, source) for child in rest[1::2])
    return Calculation(start, tuple(map(Step, operators, operands)), node)


def _operand(node: Node, source: bytes) -> int | float | ParameterValue | Received:
    if node.kind_id == NUMBER:
        return _number(node, source)
    return _parameter(node, source) if node.kind_id == PARAMETER else _received(node, source)


def _parameter(node: Node, source: bytes) -> ParameterValue:
    return ParameterValue(_text(_child(node, "name"), source)[1:-1], node)


def _received(node: Node, source: bytes) -> Received:
    whole = node
    index = None
    if node.kind_id == ELEMENT:
        index = _number(_child(node, "index"), source)
        node = _child(node, "list")
    names = [_text(part, source) for part in node.named_children if part.kind_id not in COMMENTS]
    return Received(tuple(names[1:]), index, whole)


def _child(node: Node, name: str) -> Node:
    child = node.child_by_field_name(name)
    assert child is not None  # a node without errors has it
    return child


def _text(node: Node, source: bytes) -> str:
    return source[node.start_byte : node.end_byte].decode()


def _number(node: Node, source: bytes) -> int | float:
    return lower_number(source[node.start_byte : node.end_byte])


def lower_number(text: bytes) -> int | float:
    """Return the number that a text says; one too large for a float is infinite."""
    try:
        return int(text)
    except ValueError:  # a fraction, an exponent, or more digits than Python takes
        return float(text)


def _string(node: Node, source: bytes) -> str:
    parts = []
    has_surrogates = False
    for part in node.named_children:
        written = source[part.start_byte : part.end_byte].decode()
        if part.kind_id == STRING_CONTENT:
            parts.append(written)
        elif written in escapes.MEANINGS:
            parts.append(escapes.MEANINGS[written])
        else:
            code = int(written[2:], 16)
            has_surrogates = has_surrogates or 0xD800 <= code < 0xDC00
            parts.append(chr(code))
    string = "".join(parts)
    if not has_surrogates:
        return string
    # A character beyond U+FFFF is written as two escapes, as in JSON.
    return string.encode("utf-16", "surrogatepass").decode("utf-16", "surrogatepass")
