"""The types of what a message or a request holds that is received."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes, listed, write
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType, InterfaceKind
from plastron_tui.ros.primitives import primitive

from ..mistake import Mistake
from ..values import OfReceived


class What(NamedTuple):
    """What a value is: a Python type, or a message.

    Attributes:
        kind: `bool`, `int`, `float` or `str`; for a message, its type.
        is_list: whether it is a list of them.
    """

    kind: object
    is_list: bool

    def __str__(self) -> str:
        name = _WORDS.get(self.kind, str(self.kind))
        return f"a list of {name}s" if self.is_list else f"a {name}"


_WORDS: dict[object, str] = {
    bool: "truth value",
    int: "whole number",
    float: "number",
    str: "text",
}


def type_received(
    source: OfReceived, fields: Sequence[Field], catalog: Catalog, where: Span
) -> FieldType:
    """Return the type of a field of a received message, or of an element of it.

    Raises:
        Mistake: there is no such field.
    """
    type_: FieldType | None = None
    for name in source.path:
        if type_ is not None:
            inner = None if type_.is_array or type_.message is None else type_.message
            found = None if inner is None else catalog.find(inner, InterfaceKind.MESSAGE)
            fields = () if found is None else found.fields
        field = next((each for each in fields if each.name == name), None)
        if field is None:
            raise Mistake(_no_field(source, name, fields, where))
        type_ = field.type
    assert type_ is not None
    if source.position is not None:
        beyond = type_.length is not None and source.position >= type_.length
        if not type_.is_array or beyond:
            what = f"has {type_.length} elements" if beyond else "is no list"
            message = f"`received.{'.'.join(source.path)}` {what}"
            raise Mistake(Diagnostic(codes.UNKNOWN_FIELD, message, where))
        return type_.element
    return type_


def what_of(type_: FieldType, ros_version: int) -> What:
    """Return what a field of a type holds."""
    return What(_kind_of(type_, ros_version), type_.is_array)


def _no_field(source: OfReceived, name: str, fields: Sequence[Field], where: Span) -> Diagnostic:
    names = [each.name for each in fields]
    guess = nearest(name, names)
    right = replace(
        source, path=tuple(guess or each if each == name else each for each in source.path)
    )
    text = f"did you mean `{guess}`?" if guess else f"its fields are: {listed(names)}"
    return Diagnostic(
        codes.UNKNOWN_FIELD,
        f"what is received has no field `{'.'.join(source.path)}`",
        where,
        help=text if names else "that field has no parts",
        fix=None if guess is None else write(str(right), where),
    )


def _kind_of(type_: FieldType, ros_version: int) -> object:
    if type_.message is not None:
        return type_.message
    known = primitive(type_.name, ros_version)
    return type_.name if known is None or known.parts else known.kind
