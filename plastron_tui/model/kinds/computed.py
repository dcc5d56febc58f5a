"""What is computed when it is sent, held against the node that sends it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes, listed
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType, InterfaceKind
from plastron_tui.ros.parameters import ParameterType
from plastron_tui.ros.primitives import primitive

from ..mistake import Mistake
from ..values import Computed, OfParameter, OfReceived, Value, computed_in
from .parameter import Parameter, find_parameter

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node


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
_PARAMETERS = {
    ParameterType.BOOL: bool,
    ParameterType.INT: int,
    ParameterType.FLOAT: float,
    ParameterType.STRING: str,
}


def check_computed(
    run: Run,
    statement: Any,
    slot: str,
    node: Node,
    value: Value,
    *,
    heard: Sequence[Field] | None = None,
    made: Span | None = None,
) -> None:
    """Check that a node has what is needed to compute a value when it is sent.

    Args:
        run: what the statement works on.
        statement: the statement that sends it.
        slot: the slot of the statement that has it.
        node: the node.
        value: the value.
        heard: the fields of what is received then, None where nothing is.
        made: where the value was made, where that is another statement.
    """
    labels = () if made is None else (Label(made, "made here"),)
    for each in computed_in(value):
        try:
            found = _source(run, statement, slot, node, each, heard)
            problem = _misfit(run, node, each, found)
        except Mistake as mistake:
            raise Mistake(
                *(found._replace(labels=labels) for found in mistake.diagnostics)
            ) from None
        if problem is not None:
            where = statement.span_of(slot)
            raise Mistake(Diagnostic(codes.COMPUTED_TYPE_MISMATCH, problem, where, labels=labels))


def _source(
    run: Run,
    statement: Any,
    slot: str,
    node: Node,
    value: Computed,
    heard: Sequence[Field] | None,
) -> What:
    """Return what the source of a value is."""
    match value.source:
        case OfParameter(name=name):
            return _what_of_parameter(find_parameter(run, statement, slot, node, name))
        case OfReceived() as source:
            where = statement.span_of(slot)
            if heard is None:
                raise Mistake(
                    Diagnostic(
                        codes.NOTHING_RECEIVED,
                        f"nothing is received that `{source}` could be of",
                        where,
                        help="send it `for_each` message of a topic, or in an answer",
                    )
                )
            version = run.checks.version_of(node)
            return what_received(source, heard, run.types.catalog(version), where)


def _what_of_parameter(parameter: Parameter) -> What:
    assert parameter.holds is not None  # `find_parameter` has seen to it
    return What(_PARAMETERS[parameter.holds.element], parameter.holds.is_list)


def what_received(
    source: OfReceived, fields: Sequence[Field], catalog: Catalog, where: Span
) -> What:
    """Return what a field of a received message is.

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
    is_list = type_.is_array
    if source.position is not None:
        beyond = type_.length is not None and source.position >= type_.length
        if not is_list or beyond:
            what = f"has {type_.length} elements" if beyond else "is no list"
            message = f"`received.{'.'.join(source.path)}` {what}"
            raise Mistake(Diagnostic(codes.UNKNOWN_FIELD, message, where))
        is_list = False
    return What(_kind_of(type_, catalog.ros_version), is_list)


def _no_field(source: OfReceived, name: str, fields: Sequence[Field], where: Span) -> Diagnostic:
    names = [each.name for each in fields]
    guess = nearest(name, names)
    text = f"did you mean `{guess}`?" if guess else f"its fields are: {listed(names)}"
    return Diagnostic(
        codes.UNKNOWN_FIELD,
        f"what is received has no field `{'.'.join(source.path)}`",
        where,
        help=text if names else "that field has no parts",
    )


def _kind_of(type_: FieldType, ros_version: int) -> object:
    if type_.message is not None:
        return type_.message
    known = primitive(type_.name, ros_version)
    return type_.name if known is None or known.parts else known.kind


def _misfit(run: Run, node: Node, value: Computed, found: What) -> str | None:
    """Return why a value does not fit its field, None where it does."""
    version = run.checks.version_of(node)
    wanted = What(_kind_of(value.type, version), value.type.is_array)
    shown = f"`{value.source}`"
    if value.steps:
        if found.is_list or found.kind not in (int, float):
            return f"{shown} is {found}, and cannot be calculated with"
        is_whole = found.kind is int and all(
            isinstance(number, int) and operator != "/" for operator, number in value.steps
        )
        found = What(int if is_whole else float, is_list=False)
        shown = "what is calculated"
    if found == wanted or (found.kind is int and wanted == What(float, found.is_list)):
        return None
    return f"{shown} is {found}, and the field takes {wanted}"
