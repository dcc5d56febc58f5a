"""Why values do not fit, as diagnostics."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from tree_sitter import Node as SyntaxNode

from plastron_tui.diagnostics import Diagnostic, Span, codes, counted, listed, write
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.language.inputs import COMMENTS, InputValue, Literal
from plastron_tui.ros.interfaces import Field, FieldType, InterfaceName
from plastron_tui.ros.primitives import Primitive

_BOOLEANS = {
    **dict.fromkeys(("true", "on", "yes", "1"), "True"),
    **dict.fromkeys(("false", "off", "no", "0"), "False"),
}
_NUMBER = re.compile(r"[+-]?\d+(\.\d+)?")


class Misfit(Exception):  # noqa: N818 - it carries diagnostics to `fit`, and goes no further
    """Values that do not fit, with the reason."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


def wrong_count(
    name: InterfaceName,
    fields: Sequence[Field],
    leaves: tuple[tuple[str, ...], ...] | None,
    count: int,
    where: Span,
) -> Diagnostic:
    """Say that a message takes another number of values, and name its fields in order."""
    if not fields:
        return Diagnostic(
            codes.WRONG_NUMBER_OF_VALUES, f"`{name}` takes no values", where, help="write `none`"
        )
    takes = counted(len(fields), "value")
    text = f"in order: {listed(field.name for field in fields)}"
    if leaves is not None and len(leaves) != len(fields):
        takes += f", or {len(leaves)}"
        text += f"; or: {listed('.'.join(path) for path in leaves)}"
    return Diagnostic(
        codes.WRONG_NUMBER_OF_VALUES, f"`{name}` takes {takes}, not {count}", where, help=text
    )


def span(syntax: SyntaxNode) -> Span:
    """Return where a node of the tree stands."""
    return Span(syntax.start_byte, syntax.end_byte)


def path_span(syntax: SyntaxNode, length: int) -> Span:
    """Return where a name stands in a named value's path, counted from the end of the path.

    A value without a name stands for itself.
    """
    path = syntax.child_by_field_name("field")
    if path is None:
        return span(syntax)
    names = [child for child in path.named_children if child.kind_id not in COMMENTS]
    return span(names[-length])


def wrong_kind(
    problem: str,
    value: InputValue,
    type_: FieldType,
    field: str,
    remedy: tuple[str, str | None] | None = None,
) -> Diagnostic:
    """Say that a value is of another kind than its field, and perhaps what to write."""
    text, where, fix = f"`{field}` is of type `{type_}`", span(value.syntax), None
    if remedy is not None:
        text += f"; write {remedy[0]}"
        fix = None if remedy[1] is None else write(remedy[1], where)
    return Diagnostic(codes.WRONG_KIND_OF_VALUE, problem, where, help=text, fix=fix)


def _remedy(given: bool | int | float | str, kind: type | None) -> tuple[str, str | None] | None:
    """Return how a value is written that is of another kind than its field: said, and exactly."""
    if kind is bool:
        right = _BOOLEANS.get(given.lower()) if isinstance(given, str) else None
        if not isinstance(given, str) and given in (0, 1):
            right = str(bool(given))
        return ("`True` or `False`", None) if right is None else (f"`{right}`", right)
    if kind is str:
        return None if isinstance(given, str) else (f'"{given}"', f'"{given}"')
    if isinstance(given, str) and _NUMBER.fullmatch(given.strip()):
        return f"{given.strip()} without quotes", given.strip()
    return None


def wrong_length(problem: str, count: int, value: InputValue) -> Diagnostic:
    """Say that a list has more or fewer elements than its array."""
    return Diagnostic(codes.WRONG_ARRAY_LENGTH, f"{problem}, not {count}", span(value.syntax))


def no_time(type_: str, value: InputValue, field: str) -> Diagnostic:
    """Say that a value is no time, and how a time is written."""
    return Diagnostic(
        codes.WRONG_KIND_OF_VALUE,
        f"`{field}` is a `{type_}`",
        span(value.syntax),
        help=f"write seconds ({field}=1.5), or seconds and nanoseconds ({field}=(1, 500000000))",
    )


def does_not_fit(
    problem: str, value: Literal, type_: FieldType, field: str, wanted: Primitive | None
) -> Diagnostic:
    """Say why a value does not fit: it is of another kind, or too large, or no text."""
    given = value.value
    kind = None if wanted is None else wanted.kind
    if kind is str and isinstance(given, str):
        return Diagnostic(codes.INVALID_TEXT, problem, span(value.syntax))
    is_number = isinstance(given, (int, float)) and not isinstance(given, bool)
    if not is_number or (kind is not float and (kind is not int or isinstance(given, float))):
        return wrong_kind(problem, value, type_, field, _remedy(given, kind))
    text = f"`{field}` is of type `{type_}`"
    return Diagnostic(codes.VALUE_OUT_OF_RANGE, problem, span(value.syntax), help=text)


def unknown_field(
    name: InterfaceName,
    field: str,
    fields: tuple[str, ...],
    where: Span,
    deeper: Callable[[], Sequence[tuple[str, ...]] | None] = lambda: None,
) -> Diagnostic:
    """Say that a type has no such field, and which one may be meant.

    `deeper` gives the paths of the fields within its fields, to recognise `linear_x`.
    """
    paths = deeper() if "_" in field else None
    joined = {"_".join(path): ".".join(path) for path in paths or () if len(path) > 1}
    guess = joined.get(field) or nearest(field, fields)
    message = f"`{name}` has no field `{field}`"
    if guess is not None:
        text, fix = f"did you mean `{guess}`?", write(guess, where)
        return Diagnostic(codes.UNKNOWN_FIELD, message, where, help=text, fix=fix)
    text = f"its fields are: {listed(fields)}" if fields else "it has no fields"
    return Diagnostic(codes.UNKNOWN_FIELD, message, where, help=text)
