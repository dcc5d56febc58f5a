"""What is computed when it is sent, held against the node that sends it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes, listed, write
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.language.inputs import Calculation
from plastron_tui.language.statements import CreateMessage
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType, InterfaceKind
from plastron_tui.ros.parameters import INTEGERS, ParameterType
from plastron_tui.ros.primitives import LARGEST_FLOAT, check_scalar, primitive

from ..computed_values import written_as
from ..mistake import Mistake
from ..value_diagnostics import span
from ..values import (
    Computed,
    OfParameter,
    OfReceived,
    Value,
    calculated,
    computed_fields,
    computed_in,
)
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


class _Use(NamedTuple):
    """A value that is computed, and where it is.

    Attributes:
        field: the field that it is for.
        value: the value.
        whole: where it is written.
        source: where what it is computed of is written.
        sent: where it is sent, which is where it is written unless another statement made it.
    """

    field: str
    value: Computed
    whole: Span
    source: Span
    sent: Span


def check_computed(
    run: Run,
    statement: Any,
    slot: str,
    node: Node,
    value: Value,
    *,
    heard: Sequence[Field] | None = None,
    made: CreateMessage | None = None,
) -> None:
    """Check that a node has what is needed to compute a value when it is sent.

    Args:
        run: what the statement works on.
        statement: the statement that sends it.
        slot: the slot of the statement that has it.
        node: the node.
        value: the value.
        heard: the fields of what is received then, None where nothing is.
        made: the statement that made the value, where that is another one.
    """
    for field, each in computed_fields(value):
        where = statement.span_of(slot)
        use = _Use(field, each, where, where, where)
        if _mistakes(run, node, use, heard) is None:
            continue
        # Where it is written is looked for among all values, and needed for a mistake only.
        owner, values = (
            (statement, getattr(statement, slot)) if made is None else (made, made.input)
        )
        written = written_as(values, each) if isinstance(values, tuple) else None
        if written is not None:
            first = written.first if isinstance(written, Calculation) else written
            whole, source = (span(part.syntax).moved(owner.shift) for part in (written, first))
            use = _Use(field, each, whole, source, whole if made is None else where)
        mistakes = _mistakes(run, node, use, heard) or ()
        raise Mistake(*(_placed(found, use, is_sure=written is not None) for found in mistakes))


def can_compute(run: Run, node: Node, value: Value, heard: Sequence[Field] | None = None) -> bool:
    """Tell whether a node has all that a value is computed of, and fits the fields that it is for.

    Args:
        run: what is checked.
        node: the node.
        value: the value.
        heard: the fields of what is received then, None where nothing is.
    """
    return all(_mistakes(run, node, _unwritten(each), heard) is None for each in computed_in(value))


def _placed(found: Diagnostic, use: _Use, *, is_sure: bool) -> Diagnostic:
    """Return what is wrong with a value, with its other place; of an unsure one is no remedy."""
    if not is_sure:
        return found._replace(fix=None)
    if use.sent == use.whole:
        return found
    is_sent = found.span == use.sent
    other = Label(use.whole, "made here") if is_sent else Label(use.sent, "sent here")
    return found._replace(labels=(other,))


def _mistakes(
    run: Run, node: Node, use: _Use, heard: Sequence[Field] | None
) -> tuple[Diagnostic, ...] | None:
    """Return what is wrong with a value, None where nothing is."""
    try:
        _check(run, node, use, heard)
    except Mistake as mistake:
        return mistake.diagnostics
    return None


def _check(run: Run, node: Node, use: _Use, heard: Sequence[Field] | None) -> None:
    """Check that a value has a source, and that all that it may be fits its field."""
    value = use.value
    catalog = run.types.catalog(run.checks.version_of(node))
    version = catalog.ros_version
    parameter, given = None, None
    match value.source:
        case OfParameter(name=name):
            parameter = find_parameter(run, use.source, node, name)
            found = _what_of_parameter(parameter)
        case OfReceived() as source:
            if heard is None:
                raise Mistake(
                    Diagnostic(
                        codes.NOTHING_RECEIVED,
                        f"nothing is received that `{source}` could be of",
                        use.sent,
                        help="send it `for_each` message of a topic, or in an answer",
                    )
                )
            given = type_received(source, heard, catalog, use.source)
            found = what_of(given, version)
    if any(map(is_too_large, (number for _, number in value.steps))):
        raise Mistake(Diagnostic(codes.VALUE_OUT_OF_RANGE, "the number is too large", use.whole))
    problem = _misfit(use, found, version) or _too_long(use, given)
    if problem is not None:
        raise Mistake(
            Diagnostic(
                codes.COMPUTED_TYPE_MISMATCH,
                problem,
                use.whole,
                help=_element(value, found, version),
            )
        )
    if parameter is not None:
        problem = _unfit_default(value, parameter, version)
        if problem is not None:
            raise Mistake(Diagnostic(codes.VALUE_OUT_OF_RANGE, problem, use.whole))


def _element(value: Computed, found: What, version: int) -> str | None:
    """Return what to write for a list whose elements fit, None where that is no remedy."""
    source, wanted = value.source, what_of(value.type, version)
    fits = found.kind == wanted.kind or (found.kind is int and wanted.kind is float)
    if not isinstance(source, OfReceived) or not found.is_list or wanted.is_list or not fits:
        return None
    return f"write `{source}[0]` for its first element"


def is_too_large(number: object) -> bool:
    """Whether something is a number that ROS has no type for."""
    if isinstance(number, int):
        return number not in INTEGERS
    return isinstance(number, float) and abs(number) > LARGEST_FLOAT


def fits(type_: FieldType, source: Parameter | FieldType, ros_version: int) -> bool:
    """Tell whether a field can be what a parameter holds, or what a received field does.

    Args:
        type_: the type of the field.
        source: the parameter, or the type of what is received.
        ros_version: the generation of ROS.
    """
    if isinstance(source, FieldType):
        use = _unwritten(Computed(OfReceived(()), (), type_))
        found = what_of(source, ros_version)
        return not (_misfit(use, found, ros_version) or _too_long(use, source))
    if source.holds is None:
        return False
    value = Computed(OfParameter(source.name), (), type_)
    use = _unwritten(value)
    if _misfit(use, _what_of_parameter(source), ros_version) or _too_long(use, None):
        return False
    return source.default is None or not _unfit_default(value, source, ros_version)


def _unwritten(value: Computed) -> _Use:
    nowhere = Span(0, 0)
    return _Use("", value, nowhere, nowhere, nowhere)


def _what_of_parameter(parameter: Parameter) -> What:
    assert parameter.holds is not None  # `find_parameter` has seen to it
    return What(_PARAMETERS[parameter.holds.element], parameter.holds.is_list)


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


def _misfit(use: _Use, found: What, version: int) -> str | None:
    """Return why a value does not fit its field, None where it does."""
    value = use.value
    wanted = what_of(value.type, version)
    shown = f"`{value.source}`"
    if value.steps:
        if found.is_list or found.kind not in (int, float):
            return f"{shown} is {found}, and cannot be calculated with"
        is_whole = found.kind is int and not value.is_float
        found = What(int if is_whole else float, is_list=False)
        shown = "what is calculated"
    if found == wanted or (found.kind is int and wanted == What(float, found.is_list)):
        return None
    return f"{shown} is {found}, and `{use.field}` takes {wanted}"


def _too_long(use: _Use, given: FieldType | None) -> str | None:
    """Return why a value may have more or fewer parts than its field takes, None where it cannot.

    Args:
        use: the value.
        given: the type of what is received, None for a parameter, which has any length.
    """
    value, field = use.value, f"`{use.field}`"
    wanted = value.type
    least, most = (0, None) if given is None else _lengths(given)
    fewest, limit = _lengths(wanted)
    if least < fewest or (limit is not None and (most is None or most > limit)):
        takes = f"{limit}" if fewest else f"at most {limit}"
        return f"`{value.source}` has another length, and {field} takes {takes} elements"
    bound = wanted.string_bound
    own = None if given is None else given.string_bound
    if bound is not None and (own is None or own > bound):
        return f"`{value.source}` may be longer than the {bound} characters that {field} takes"
    return None


def _lengths(type_: FieldType) -> tuple[int, int | None]:
    """Return how many elements a list has at least, and at most."""
    if not type_.is_array:
        return 0, None
    return (type_.length or 0), (type_.bound if type_.length is None else type_.length)


def _unfit_default(value: Computed, parameter: Parameter, version: int) -> str | None:
    """Return why what is calculated of a parameter's default does not fit, None where it does."""
    default = parameter.default
    for each in default if isinstance(default, tuple) else (default,):
        result = each
        if value.steps:
            assert isinstance(each, (int, float))  # others cannot be calculated with
            result = calculated(each, value.steps)
        problem = check_scalar(value.type.name, result, version, value.type.string_bound)
        if problem is not None:
            return f"by the default of `{value.source}`, {problem}"
    return None
