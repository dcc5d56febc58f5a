"""Values held against the fields of a type: the one place where syntax and types meet."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from math import isinf

from tree_sitter import Node as SyntaxNode

from plastron_tui.diagnostics import Diagnostic, Span, codes, listed, write
from plastron_tui.language.declaration import Statement
from plastron_tui.language.inputs import (
    Argument,
    Calculation,
    Input,
    InputValue,
    ListValue,
    Literal,
    NamedArgument,
    NestedValue,
    ParameterValue,
    Received,
)
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType, Interface, InterfaceKind, InterfaceName
from plastron_tui.ros.primitives import check_scalar, primitive

from .computed_values import computed
from .times import BUILTIN_TIMES, builtin_time, split_seconds, time_parts
from .value_diagnostics import (
    Misfit,
    does_not_fit,
    path_span,
    span,
    unknown_field,
    wrong_count,
    wrong_kind,
    wrong_length,
)
from .values import MessageValue, Value

Where = Callable[[], Span]
"""Tells a place when a mistake asks for it: most statements have none, and no place to tell."""

Leaves = tuple[tuple[str, ...], ...]
"""The paths of scalars, each the names that lead to it."""

# The largest messages of ROS have a hundred; messages in messages can have millions.
_MOST_LEAVES = 1_000

_SCALARS = (Literal, ParameterValue, Received, Calculation)
"""What may stand for a scalar among values in order."""

_AtPath = tuple[tuple[str, ...], InputValue, SyntaxNode]
"""A value with the names that lead to its field, and what its mistakes are said of."""


Fitted = tuple[Input, Interface, MessageValue]
"""The values of a statement, their type, and what they are of it."""


class Fitter:
    """Fits the values of a program to the types of one distribution.

    While a program is edited, most statements keep their values: what was fitted for the program
    before the last edit is not fitted again.
    """

    def __init__(self, catalog: Catalog, earlier: Fitter | None = None) -> None:
        """Start with a catalog, and with what another one with the same catalog has fitted."""
        self._catalog = catalog
        self._leaves: dict[InterfaceName, Leaves | None] = {}
        # By identity, which the values keep as long as they stand here too.
        self._fitted: dict[int, Fitted] = {}
        self._misfits: list[Diagnostic] = []
        self._earlier: Mapping[int, Fitted] = {}
        if earlier is not None and earlier._catalog is catalog:
            self._earlier = earlier._fitted

    @property
    def fitted(self) -> dict[int, Fitted]:
        """What was fitted so far."""
        return dict(self._fitted)

    def resume(self, fitted: Mapping[int, Fitted]) -> None:
        """Know what the first statements of the program have fitted."""
        self._fitted.update(fitted)

    def fit(
        self, type_: Interface, fields: Sequence[Field], statement: Statement, slot: str
    ) -> MessageValue | tuple[Diagnostic, ...]:
        """Return the checked value of a statement's input, or all that does not fit.

        Args:
            type_: the type whose values they are.
            fields: the fields of the part of it that is meant.
            statement: the statement.
            slot: the slot that has the values.
        """
        values: Input = getattr(statement, slot)
        if not values:
            return MessageValue(type_.name, {})
        known = self._earlier.get(id(values))
        if known is None or known[0] is not values or known[1] is not type_:
            found = self._fit(type_.name, fields, statement, slot)
            if self._misfits:
                # Values know where they stood when they were parsed.
                return tuple([each.moved(statement.shift) for each in self._misfits])
            known = values, type_, found
        self._fitted[id(values)] = known
        return known[2]

    def _fit(
        self, name: InterfaceName, fields: Sequence[Field], statement: Statement, slot: str
    ) -> MessageValue:
        """Return the value of a statement's input, without what is noted as a misfit."""

        def where() -> Span:
            return span(statement.syntax.child_by_field_name(slot) or statement.syntax)

        self._misfits = []
        try:
            return self._message(name, fields, getattr(statement, slot), where)
        except Misfit as misfit:
            found = misfit.diagnostic
            if not fields and found.code == codes.WRONG_NUMBER_OF_VALUES:
                found = found._replace(fix=write("none", where()))
            self._misfits.append(found)
            return MessageValue(name, {})

    def _message(
        self, name: InterfaceName, fields: Sequence[Field], values: Sequence[Argument], where: Where
    ) -> MessageValue:
        positional = [value for value in values if not isinstance(value, NamedArgument)]
        if len(positional) < len(values):
            return self._named(name, fields, values, positional)
        if len(positional) == len(fields) and not self._should_flatten(fields, positional):
            return self._in_order(name, fields, positional)
        leaves = self._leaves_of(name, fields)
        if (
            leaves is not None
            and len(leaves) == len(positional)
            and all(isinstance(value, _SCALARS) for value in positional)
        ):
            pairs = [
                (path, value, value.syntax) for path, value in zip(leaves, positional, strict=True)
            ]
            return self._by_path(name, fields, pairs)
        if leaves is None and len(positional) == len(fields):
            return self._in_order(name, fields, positional)
        raise Misfit(wrong_count(name, fields, leaves, len(positional), where()))

    def _in_order(
        self, name: InterfaceName, fields: Sequence[Field], values: Sequence[InputValue]
    ) -> MessageValue:
        return MessageValue(
            name,
            {
                field.name: self._value(field.type, value, field.name)
                for field, value in zip(fields, values, strict=True)
            },
        )

    def _should_flatten(self, fields: Sequence[Field], values: Sequence[InputValue]) -> bool:
        """Tell whether scalars stand where a nested message of one leaf is meant."""
        return any(
            field.type.package is not None
            and not field.type.is_array
            and field.type.message not in BUILTIN_TIMES
            and isinstance(value, _SCALARS)
            for field, value in zip(fields, values, strict=True)
        )

    def _named(
        self,
        name: InterfaceName,
        fields: Sequence[Field],
        values: Sequence[Argument],
        positional: Sequence[InputValue],
    ) -> MessageValue:
        pairs: list[_AtPath] = []
        is_after_name = False
        for index, value in enumerate(values):
            if isinstance(value, NamedArgument):
                pairs.append((value.path, value.value, value.syntax))
                is_after_name = True
            elif index >= len(fields):
                raise Misfit(wrong_count(name, fields, None, len(positional), span(value.syntax)))
            elif is_after_name:
                raise Misfit(
                    Diagnostic(
                        codes.VALUE_AFTER_NAMED,
                        "a value without a name cannot follow one with a name",
                        span(value.syntax),
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
        pairs: Sequence[_AtPath],
    ) -> MessageValue:
        """Fit values that each say which field they are for, by a path of names."""
        by_name = {field.name: field for field in fields}
        direct: dict[str, Value] = {}
        deeper: dict[str, list[_AtPath]] = {}
        for path, value, syntax in pairs:
            head, *rest = path
            length = len(path)
            field = by_name.get(head)
            if field is None:
                leaves = partial(self._leaves_of, name, fields)
                where = path_span(syntax, length)
                self._misfits.append(unknown_field(name, head, tuple(by_name), where, leaves))
            elif head in direct or (not rest and head in deeper):
                what = f"`{head}` has a value already"
                where = path_span(syntax, length)
                self._misfits.append(Diagnostic(codes.DUPLICATE_FIELD, what, where))
            elif not rest:
                direct[head] = self._value(field.type, value, head)
            elif field.type.is_array or not self._has_parts(field.type):
                what = f"`{head}` is of type `{field.type}` and has no fields"
                where = path_span(syntax, len(rest))
                self._misfits.append(Diagnostic(codes.UNKNOWN_FIELD, what, where))
            else:
                deeper.setdefault(head, []).append((tuple(rest), value, syntax))
        for head, inner in deeper.items():
            direct[head] = self._parts(by_name[head], inner)
        return MessageValue(
            name, {field.name: direct[field.name] for field in fields if field.name in direct}
        )

    def _parts(self, field: Field, pairs: Sequence[_AtPath]) -> Value:
        """Fit the values of what is in a field, by the paths that lead on from it."""
        syntax = pairs[0][2]
        if field.type.message is None:
            time = NestedValue(tuple([NamedArgument(*pair) for pair in pairs]), syntax)
            return self._value(field.type, time, field.name)
        try:
            nested = self._nested_type(field.type, syntax)
        except Misfit as misfit:
            self._misfits.append(misfit.diagnostic)
            return ()
        return self._by_path(nested.name, nested.fields, pairs)

    def _value(self, type_: FieldType, value: InputValue, field: str) -> Value:
        """Return the value of a field; what does not fit is noted, and any value stands for it."""
        try:
            if isinstance(value, (ParameterValue, Received, Calculation)):
                return computed(type_, value)
            if type_.is_array:
                return self._array(type_, value, field)
            if type_.package is not None:
                return self._nested(type_, value, field)
            return self._scalar(type_, value, field)
        except Misfit as misfit:
            self._misfits.append(misfit.diagnostic)
            return ()

    def _scalar(self, type_: FieldType, value: InputValue, field: str) -> Value:
        wanted = primitive(type_.name, self._catalog.ros_version)
        if wanted is not None and wanted.parts and isinstance(value, NestedValue):
            return time_parts(type_, value, field)
        if not isinstance(value, Literal):
            raise Misfit(wrong_kind(f"`{field}` takes one value", value, type_, field))
        given = value.value
        if isinstance(given, float) and isinf(given):
            raise Misfit(
                Diagnostic(codes.VALUE_OUT_OF_RANGE, "the number is too large", span(value.syntax))
            )
        problem = check_scalar(
            type_.name, given, self._catalog.ros_version, string_bound=type_.string_bound
        )
        if problem is not None:
            raise Misfit(does_not_fit(problem, value, type_, field, wanted))
        if wanted is not None and wanted.kind is float:
            return split_seconds(float(given)) if wanted.parts else float(given)
        return given

    def _has_parts(self, type_: FieldType) -> bool:
        """Tell whether a path leads on from a field of a type."""
        wanted = None
        if type_.package is None:
            wanted = primitive(type_.name, self._catalog.ros_version)
        return type_.package is not None or (wanted is not None and bool(wanted.parts))

    def _array(self, type_: FieldType, value: InputValue, field: str) -> Value:
        if not isinstance(value, ListValue):
            raise Misfit(
                Diagnostic(
                    codes.WRONG_KIND_OF_VALUE,
                    f"`{field}` is an array (`{type_}`)",
                    span(value.syntax),
                    help=f"write its elements in brackets: {field}=[…]",
                )
            )
        count = len(value.items)
        if type_.length is not None and count != type_.length:
            raise Misfit(wrong_length(f"`{field}` has {type_.length} elements", count, value))
        if type_.bound is not None and count > type_.bound:
            raise Misfit(
                wrong_length(f"`{field}` has at most {type_.bound} elements", count, value)
            )
        element = type_._replace(is_array=False, length=None, bound=None)
        return tuple([self._value(element, item, field) for item in value.items])

    def _nested(self, type_: FieldType, value: InputValue, field: str) -> MessageValue:
        nested = self._nested_type(type_, value.syntax)
        if nested.name in BUILTIN_TIMES and isinstance(value, Literal):
            return builtin_time(nested, value, field)
        if not isinstance(value, NestedValue):
            names = listed(inner.name for inner in nested.fields)
            raise Misfit(
                Diagnostic(
                    codes.WRONG_KIND_OF_VALUE,
                    f"`{field}` is a message (`{type_}`)",
                    span(value.syntax),
                    help=f"write its values in parentheses: {field}=({names})",
                )
            )
        if not value.arguments:
            return MessageValue(nested.name, {})
        return self._message(
            nested.name, nested.fields, value.arguments, lambda: span(value.syntax)
        )

    def _nested_type(self, type_: FieldType, syntax: SyntaxNode) -> Interface:
        message = type_.message
        assert message is not None
        found = self._catalog.find(message, InterfaceKind.MESSAGE)
        if found is None:
            raise Misfit(
                Diagnostic(
                    codes.UNKNOWN_TYPE,
                    f"the definition of `{message}` is not at hand, so its fields are not known",
                    span(syntax),
                )
            )
        return found

    def _leaves_of(self, name: InterfaceName, fields: Sequence[Field]) -> Leaves | None:
        """Return the paths of all scalars in a message.

        None when an array is among its fields, and for more scalars than anybody gives in order.
        """
        if name not in self._leaves:
            self._leaves[name] = self._find_leaves(fields)
        return self._leaves[name]

    def _find_leaves(self, fields: Sequence[Field]) -> Leaves | None:
        paths: list[tuple[str, ...]] = []
        for field in fields:
            inner = self._leaves_within(field.type)
            if inner is None or len(paths) + len(inner) > _MOST_LEAVES:
                return None
            paths += [(field.name, *path) for path in inner]
        return tuple(paths)

    def _leaves_within(self, type_: FieldType) -> Leaves | None:
        """Return the paths that lead on from a field of a type."""
        if type_.is_array:
            return None
        if type_.message is None:
            return ((),)
        found = self._catalog.find(type_.message, InterfaceKind.MESSAGE)
        # A type is looked into once, however many fields have it.
        return None if found is None else self._leaves_of(found.name, found.fields)
