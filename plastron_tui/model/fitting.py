"""Values held against the fields of a type: the one place where syntax and types meet."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import isinf

from tree_sitter import Node as SyntaxNode

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.language.inputs import (
    Argument,
    InputValue,
    ListValue,
    Literal,
    NamedArgument,
    NestedValue,
)
from plastron_tui.language.statements import ClientRequests, CreateMessage
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType, Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.primitives import check_scalar, primitive

from .values import MessageValue, Value

_NANOSECONDS = 1_000_000_000

Where = Callable[[], Span]
"""Tells a place when a mistake asks for it: most statements have none, and no place to tell."""


class Misfit(Exception):  # noqa: N818 - it carries diagnostics to `fit`, and goes no further
    """Values that do not fit, with the reason."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


class Fitter:
    """Fits the values of a program to the types of one distribution."""

    def __init__(self, catalog: Catalog) -> None:
        self._catalog = catalog
        self._leaves: dict[InterfaceName, tuple[tuple[str, ...], ...] | None] = {}

    def fit(
        self, type_: Interface, statement: CreateMessage | ClientRequests
    ) -> MessageValue | Diagnostic:
        """Return the checked value of a statement's input, or the first thing that does not fit."""
        values = statement.input
        if not values:
            return MessageValue(type_.name, {})
        try:
            return self._message(
                type_.name, type_.fields, values, lambda: statement.span_of("input")
            )
        except Misfit as misfit:
            return misfit.diagnostic

    def _message(
        self, name: InterfaceName, fields: Sequence[Field], values: Sequence[Argument], where: Where
    ) -> MessageValue:
        positional = [value for value in values if not isinstance(value, NamedArgument)]
        if len(positional) < len(values):
            return self._named(name, fields, values, positional)
        if len(positional) == len(fields) and not self._should_flatten(fields, positional):
            return MessageValue(
                name,
                {
                    field.name: self._value(field.type, value, field.name)
                    for field, value in zip(fields, positional, strict=True)
                },
            )
        leaves = self._leaves_of(name, fields)
        if (
            leaves is not None
            and len(leaves) == len(positional)
            and all(isinstance(value, Literal) for value in positional)
        ):
            pairs = [
                (path, value, value.syntax) for path, value in zip(leaves, positional, strict=True)
            ]
            return self._by_path(name, fields, pairs)
        raise Misfit(_wrong_count(name, fields, leaves, len(positional), where()))

    def _should_flatten(self, fields: Sequence[Field], values: Sequence[InputValue]) -> bool:
        """Tell whether scalars stand where a nested message of one leaf is meant."""
        return any(
            field.type.package is not None
            and not field.type.is_array
            and isinstance(value, Literal)
            for field, value in zip(fields, values, strict=True)
        )

    def _named(
        self,
        name: InterfaceName,
        fields: Sequence[Field],
        values: Sequence[Argument],
        positional: Sequence[InputValue],
    ) -> MessageValue:
        pairs: list[tuple[tuple[str, ...], InputValue, SyntaxNode]] = []
        for index, value in enumerate(values):
            if isinstance(value, NamedArgument):
                pairs.append((value.path, value.value, value.syntax))
            elif index >= len(fields):
                raise Misfit(_wrong_count(name, fields, None, len(positional), _span(value.syntax)))
            elif index > 0 and isinstance(values[index - 1], NamedArgument):
                raise Misfit(
                    Diagnostic(
                        "value-after-named",
                        "a value without a name cannot follow one with a name",
                        _span(value.syntax),
                        help="name it too, or put it first",
                    )
                )
            else:
                pairs.append(((fields[index].name,), value, value.syntax))
        return self._by_path(name, fields, pairs)

    def _by_path(
        self,
        name: InterfaceName,
        fields: Sequence[Field],
        pairs: Sequence[tuple[tuple[str, ...], InputValue, SyntaxNode]],
    ) -> MessageValue:
        """Fit values that each say which field they are for, by a path of names."""
        by_name = {field.name: field for field in fields}
        direct: dict[str, Value] = {}
        deeper: dict[str, list[tuple[tuple[str, ...], InputValue, SyntaxNode]]] = {}
        for path, value, syntax in pairs:
            head, *rest = path
            field = by_name.get(head)
            if field is None:
                raise Misfit(_unknown_field(name, head, tuple(by_name), _path_span(syntax)))
            if head in direct or (not rest and head in deeper):
                raise Misfit(
                    Diagnostic(
                        "duplicate-field",
                        f"`{head}` has a value already",
                        _path_span(syntax),
                    )
                )
            if not rest:
                direct[head] = self._value(field.type, value, head)
            elif field.type.message is None or field.type.is_array:
                raise Misfit(
                    Diagnostic(
                        "unknown-field",
                        f"`{head}` is of type `{field.type}` and has no fields",
                        _path_span(syntax),
                    )
                )
            else:
                deeper.setdefault(head, []).append((tuple(rest), value, syntax))
        for head, inner in deeper.items():
            nested = self._nested_type(by_name[head].type, inner[0][2])
            direct[head] = self._by_path(nested.name, nested.fields, inner)
        return MessageValue(
            name, {field.name: direct[field.name] for field in fields if field.name in direct}
        )

    def _value(self, type_: FieldType, value: InputValue, field: str) -> Value:
        if type_.is_array:
            return self._array(type_, value, field)
        if type_.package is not None:
            return self._nested(type_, value, field)
        wanted = primitive(type_.name, self._catalog.ros_version)
        if wanted is not None and wanted.parts and isinstance(value, NestedValue):
            return self._time_parts(type_, value, field)
        if not isinstance(value, Literal):
            raise Misfit(_does_not_fit(f"`{field}` takes one value", value, str(type_)))
        given = value.value
        if isinstance(given, float) and isinf(given):
            raise Misfit(_does_not_fit("the number is too large", value, str(type_)))
        problem = check_scalar(
            type_.name, given, self._catalog.ros_version, string_bound=type_.string_bound
        )
        if problem is not None:
            raise Misfit(_does_not_fit(problem, value, str(type_), field))
        if wanted is not None and wanted.kind is float:
            return _time(float(given)) if wanted.parts else float(given)
        return given

    def _array(self, type_: FieldType, value: InputValue, field: str) -> Value:
        if not isinstance(value, ListValue):
            raise Misfit(
                Diagnostic(
                    "value-does-not-fit",
                    f"`{field}` is an array (`{type_}`)",
                    _span(value.syntax),
                    help=f"write its elements in brackets: {field}=[…]",
                )
            )
        count = len(value.items)
        if type_.length is not None and count != type_.length:
            raise Misfit(
                _does_not_fit(f"`{field}` has {type_.length} elements, not {count}", value, None)
            )
        if type_.bound is not None and count > type_.bound:
            raise Misfit(
                _does_not_fit(
                    f"`{field}` has at most {type_.bound} elements, not {count}", value, None
                )
            )
        element = type_._replace(is_array=False, length=None, bound=None)
        return tuple([self._value(element, item, field) for item in value.items])

    def _nested(self, type_: FieldType, value: InputValue, field: str) -> MessageValue:
        nested = self._nested_type(type_, value.syntax)
        if not isinstance(value, NestedValue):
            names = ", ".join(inner.name for inner in nested.fields)
            raise Misfit(
                Diagnostic(
                    "value-does-not-fit",
                    f"`{field}` is a message (`{type_}`)",
                    _span(value.syntax),
                    help=f"write its values in parentheses: {field}=({names})",
                )
            )
        if not value.arguments:
            return MessageValue(nested.name, {})
        return self._message(
            nested.name, nested.fields, value.arguments, lambda: _span(value.syntax)
        )

    def _nested_type(self, type_: FieldType, syntax: SyntaxNode) -> Interface:
        message = type_.message
        assert message is not None
        found = self._catalog.find(message, InterfaceKind.MESSAGE)
        if found is None:
            raise Misfit(
                Diagnostic(
                    "unknown-type",
                    f"the definition of `{message}` is not at hand, so its fields are not known",
                    _span(syntax),
                )
            )
        return found

    def _time_parts(self, type_: FieldType, value: NestedValue, field: str) -> Value:
        given = [
            argument.value if isinstance(argument, NamedArgument) else argument
            for argument in value.arguments
        ]
        whole = [
            part.value
            for part in given
            if isinstance(part, Literal)
            and isinstance(part.value, int)
            and not isinstance(part.value, bool)
        ]
        if len(whole) != 2 or len(given) != 2 or not 0 <= whole[1] < _NANOSECONDS:
            raise Misfit(
                Diagnostic(
                    "value-does-not-fit",
                    f"`{field}` is a `{type_}`",
                    _span(value.syntax),
                    help=f"write seconds ({field}=1.5), or seconds and nanoseconds "
                    f"({field}=(1, 500000000))",
                )
            )
        problem = check_scalar(type_.name, whole[0], self._catalog.ros_version)
        if problem is not None:
            raise Misfit(_does_not_fit(problem, value, str(type_), field))
        return whole[0], whole[1]

    def _leaves_of(
        self, name: InterfaceName, fields: Sequence[Field]
    ) -> tuple[tuple[str, ...], ...] | None:
        """Return the paths of all scalars in a message, None when an array is among its fields."""
        if name not in self._leaves:
            paths = list(self._walk_leaves(fields))
            self._leaves[name] = None if None in paths else tuple(path for path in paths if path)
        return self._leaves[name]

    def _walk_leaves(self, fields: Sequence[Field]) -> Iterator[tuple[str, ...] | None]:
        for field in fields:
            message = field.type.message
            if field.type.is_array:
                yield None
            elif message is None:
                yield (field.name,)
            else:
                found = self._catalog.find(message, InterfaceKind.MESSAGE)
                if found is None:
                    yield None
                    return
                for path in self._walk_leaves(found.fields):
                    yield None if path is None else (field.name, *path)


def _wrong_count(
    name: InterfaceName,
    fields: Sequence[Field],
    leaves: tuple[tuple[str, ...], ...] | None,
    count: int,
    where: Span,
) -> Diagnostic:
    if not fields:
        return Diagnostic(
            "wrong-number-of-values", f"`{name}` takes no values", where, help="write `none`"
        )
    takes = f"{len(fields)} value{'' if len(fields) == 1 else 's'}"
    names = ", ".join(field.name for field in fields)
    text = f"in order: {names}"
    if leaves is not None and len(leaves) != len(fields):
        takes += f", or {len(leaves)}"
        text += f"; or: {', '.join('.'.join(path) for path in leaves)}"
    return Diagnostic(
        "wrong-number-of-values", f"`{name}` takes {takes}, not {count}", where, help=text
    )


def _time(seconds: float) -> tuple[int, int]:
    """Split seconds into whole seconds and nanoseconds, as ROS 1 holds them."""
    total = round(seconds * _NANOSECONDS)
    return total // _NANOSECONDS, total % _NANOSECONDS


def _span(syntax: SyntaxNode) -> Span:
    return Span(syntax.start_byte, syntax.end_byte)


def _path_span(syntax: SyntaxNode) -> Span:
    """Return where the name of a named value stands; of a value without one, the value."""
    return _span(syntax.child_by_field_name("field") or syntax)


def _does_not_fit(
    problem: str, value: InputValue, type_: str | None, field: str | None = None
) -> Diagnostic:
    text = None if field is None or type_ is None else f"`{field}` is of type `{type_}`"
    return Diagnostic("value-does-not-fit", problem, _span(value.syntax), help=text)


def _unknown_field(
    name: InterfaceName, field: str, fields: tuple[str, ...], span: Span
) -> Diagnostic:
    guess = nearest(field, fields)
    if guess is not None:
        text = f"did you mean `{guess}`?"
    else:
        text = f"its fields are: {', '.join(fields)}" if fields else "it has no fields"
    return Diagnostic("unknown-field", f"`{name}` has no field `{field}`", span, help=text)
