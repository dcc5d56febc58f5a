"""What the expressions of a setup.py come to, as far as that is sure."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from string import Formatter
from typing import TypeAlias

from tree_sitter import Node

from .syntax import Setup

_DEEPEST = 40
_LONGEST = 10_000
_FIELD = re.compile(r"\w*")


@dataclass(frozen=True, slots=True)
class Glob:
    """The files that match a pattern."""

    pattern: str


@dataclass(frozen=True, slots=True)
class Unknown:
    """What is computed at a place, in bytes, in a way that is not followed."""

    start: int
    end: int


Value: TypeAlias = "str | Glob | Unknown | tuple[Value, ...]"
Names: TypeAlias = Mapping[str, str]


def evaluate(setup: Setup, node: Node, names: Names | None = None, depth: int = 0) -> Value:
    """Return the value of an expression.

    Args:
        setup: the file.
        node: the expression.
        names: what the variables of a comprehension are.
        depth: how many expressions the node is in.
    """
    unknown = Unknown(node.start_byte, node.end_byte)
    if depth > _DEEPEST:
        return unknown
    names = names or {}
    match node.type:
        case "string":
            return _string(setup, node, names, depth)
        case "concatenated_string":
            parts = [evaluate(setup, each, names, depth + 1) for each in node.named_children]
            return _joined(parts, unknown)
        case "identifier":
            name = setup.source(node)
            if name in names:
                return names[name]
            value = setup.names.constants.get(name)
            found = unknown if value is None else evaluate(setup, value, None, depth + 1)
            return unknown if isinstance(found, tuple) and setup.changed(node) else found
        case "parenthesized_expression" if node.named_child_count == 1:
            return evaluate(setup, node.named_children[0], names, depth + 1)
        case "list" | "tuple":
            return tuple(evaluate(setup, each, names, depth + 1) for each in items_of(node))
        case "list_comprehension":
            return _comprehension(setup, node, names, depth)
        case "binary_operator":
            return _operation(setup, node, names, depth)
        case "call":
            return _call(setup, node, names, depth)
    return unknown


def items_of(node: Node) -> list[Node]:
    """Return what stands between the commas of a list, a tuple, a dictionary or a call."""
    return [each for each in node.named_children if each.type != "comment"]


def _joined(parts: list[Value], unknown: Unknown) -> Value:
    texts = [each for each in parts if isinstance(each, str)]
    return "".join(texts) if len(texts) == len(parts) else unknown


def _string(setup: Setup, node: Node, names: Names, depth: int) -> Value:
    unknown = Unknown(node.start_byte, node.end_byte)
    if not any(each.type == "interpolation" for each in node.named_children):
        try:
            value = ast.literal_eval(setup.source(node))
        except (SyntaxError, ValueError):
            return unknown
        return value if isinstance(value, str) else unknown
    parts: list[Value] = []
    for each in node.named_children:
        if each.type == "string_content":
            source = setup.source(each)
            parts.append(unknown if set(source) & set("\\{}") else source)
        elif each.type == "interpolation":
            inner = each.child_by_field_name("expression")
            is_plain = inner is not None and each.named_child_count == 1
            parts.append(
                evaluate(setup, inner, names, depth + 1) if inner and is_plain else unknown
            )
    return _joined(parts, unknown)


def _operation(setup: Setup, node: Node, names: Names, depth: int) -> Value:
    """Return what `+`, `%` or pathlib's `/` of known parts is."""
    unknown = Unknown(node.start_byte, node.end_byte)
    left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
    operator = node.child_by_field_name("operator")
    if left is None or right is None or operator is None:
        return unknown
    first = evaluate(setup, left, names, depth + 1)
    second = evaluate(setup, right, names, depth + 1)
    match operator.type, first, second:
        case "+", str(), str():
            return first + second
        case "+", _, _ if isinstance(first, tuple | Glob) or isinstance(second, tuple | Glob):
            return (*_parts(first), *_parts(second))
        case "%", str(), str() | tuple() if first.count("%") == first.count("%s"):
            values = _parts(second)
            known = [each for each in values if isinstance(each, str)]
            if len(known) == len(values) == first.count("%s"):
                return first % tuple(known)
    return unknown


def _parts(value: Value) -> tuple[Value, ...]:
    return value if isinstance(value, tuple) else (value,)


def _comprehension(setup: Setup, node: Node, names: Names, depth: int) -> Value:
    """Return the values of `[… for NAME in …]` without a condition."""
    unknown = Unknown(node.start_byte, node.end_byte)
    found = comprehension_parts(setup, node)
    if found is None:
        return unknown
    body, variable, iterable = found
    values = evaluate(setup, iterable, names, depth + 1)
    if not isinstance(values, tuple) or setup.changed(iterable) is not None:
        return unknown
    return tuple(
        evaluate(setup, body, {**names, variable: each}, depth + 1)
        if isinstance(each, str)
        else unknown
        for each in values
    )


def comprehension_parts(setup: Setup, node: Node) -> tuple[Node, str, Node] | None:
    """Return what a comprehension makes, of which variable, out of what; None where not plain."""
    clauses = items_of(node)
    body = node.child_by_field_name("body")
    if body is None or len(clauses) != 2 or clauses[1].type != "for_in_clause":
        return None
    variable = clauses[1].child_by_field_name("left")
    iterable = clauses[1].child_by_field_name("right")
    if variable is None or variable.type != "identifier" or iterable is None:
        return None
    return body, setup.source(variable), iterable


def _call(setup: Setup, node: Node, names: Names, depth: int) -> Value:
    """Return what `os.path.join`, `glob` and `list` of known parts are."""
    unknown = Unknown(node.start_byte, node.end_byte)
    function = node.child_by_field_name("function")
    arguments = node.child_by_field_name("arguments")
    if function is None or arguments is None or arguments.type != "argument_list":
        return unknown
    name = setup.source(function)
    if function.type == "attribute" and name.endswith(".format"):
        return _formatted(setup, function, arguments, names, depth) or unknown
    values = [evaluate(setup, each, names, depth + 1) for each in items_of(arguments)]
    texts = [each for each in values if isinstance(each, str)]
    if name in ("os.path.join", "path.join", "join") and texts and len(texts) == len(values):
        return "/".join(
            part.rstrip("/") if at < len(texts) - 1 else part for at, part in enumerate(texts)
        )
    if name in ("glob", "glob.glob", "glob.iglob") and values and isinstance(values[0], str):
        return Glob(values[0])
    if name in ("list", "sorted", "tuple", "str") and len(values) == 1:
        return values[0]
    return unknown


def _formatted(
    setup: Setup, function: Node, arguments: Node, names: Names, depth: int
) -> str | None:
    """Return what `format` makes of a text and plain texts, None where it is not that plain."""
    pattern = function.child_by_field_name("object")
    text = None if pattern is None else evaluate(setup, pattern, names, depth + 1)
    given: list[str] = []
    named: dict[str, str] = {}
    for each in items_of(arguments):
        key, inner = each.child_by_field_name("name"), each.child_by_field_name("value")
        is_named = each.type == "keyword_argument" and key is not None and inner is not None
        value = evaluate(setup, inner if is_named and inner else each, names, depth + 1)
        if not isinstance(value, str):
            return None
        if is_named and key is not None:
            named[setup.source(key)] = value
        else:
            given.append(value)
    if not isinstance(text, str):
        return None
    try:
        fields = [each[1:] for each in Formatter().parse(text) if each[1] is not None]
        if any(spec or how or not _FIELD.fullmatch(name or "") for name, spec, how in fields):
            return None
        longest = max(map(len, (*given, *named.values())), default=0)
        # Formats of formats would grow without end.
        return text.format(*given, **named) if len(fields) * longest < _LONGEST else None
    except (IndexError, KeyError, ValueError):
        return None


def summands(setup: Setup, node: Node) -> Iterator[Node]:
    """Yield what is added up with `+` to make a value, names followed; else the value itself."""
    resolved = setup.resolve(node)
    if resolved.type != "binary_operator":
        yield resolved
        return
    for part in (resolved.child_by_field_name(each) for each in ("left", "right")):
        if part is not None:
            yield from summands(setup, part)
