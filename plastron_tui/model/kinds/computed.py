"""What is computed when it is sent, held against the node that sends it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes
from plastron_tui.language.inputs import Calculation, ParameterValue, Received
from plastron_tui.language.statements import CreateMessage
from plastron_tui.ros.interfaces import Field, FieldType
from plastron_tui.ros.parameters import INTEGERS, ParameterType
from plastron_tui.ros.primitives import LARGEST_FLOAT, check_scalar

from ..computed_values import written_as
from ..mistake import Mistake
from ..value_diagnostics import span
from ..values import (
    Computed,
    OfParameter,
    OfReceived,
    Origin,
    Value,
    calculated,
    computed_fields,
    computed_in,
)
from .parameter import Parameter, find_parameter
from .received import What, type_received, what_of

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node


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
        origins: where each part is written that it is computed of, in their order.
        sent: where it is sent, which is where it is written unless another statement made it.
    """

    field: str
    value: Computed
    whole: Span
    origins: tuple[Span, ...]
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
        use = _Use(field, each, where, (where,) * len(each.origins), where)
        if _mistakes(run, node, use, heard) is None:
            continue
        # Where it is written is looked for among all values, and needed for a mistake only.
        owner, values = (
            (statement, getattr(statement, slot)) if made is None else (made, made.input)
        )
        written = written_as(values, each) if isinstance(values, tuple) else None
        if written is not None:
            whole, *parts = (
                span(part.syntax).moved(owner.shift) for part in (written, *_origins(written))
            )
            use = _Use(field, each, whole, tuple(parts), whole if made is None else where)
        mistakes = _mistakes(run, node, use, heard) or ()
        raise Mistake(*(_placed(found, use, is_sure=written is not None) for found in mistakes))


def _origins(
    written: ParameterValue | Received | Calculation,
) -> list[ParameterValue | Received]:
    """Return what a value is computed of, as it is written."""
    if not isinstance(written, Calculation):
        return [written]
    operands = (step.operand for step in written.steps)
    return [written.first, *(each for each in operands if not isinstance(each, int | float))]


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
    given = [
        _given(run, node, use, (origin, where), heard)
        for origin, where in zip(value.origins, use.origins, strict=True)
    ]
    found = [
        _what_of_parameter(each) if isinstance(each, Parameter) else what_of(each, version)
        for each in given
    ]
    if any(map(is_too_large, (operand for _, operand in value.steps))):
        raise Mistake(Diagnostic(codes.VALUE_OUT_OF_RANGE, "the number is too large", use.whole))
    if value.steps:
        _check_numbers(use, found, version)
    first = given[0]
    problem = _misfit(use, found, version)
    if problem is None:
        problem = _too_long(use, None if isinstance(first, Parameter) else first)
    if problem is not None:
        remedy = _element(value, value.source, found[0], version)
        if value.steps and any(operator == "/" for operator, _ in value.steps):
            remedy = "what is divided may have a fraction"
        raise Mistake(Diagnostic(codes.COMPUTED_TYPE_MISMATCH, problem, use.whole, help=remedy))
    if isinstance(first, Parameter):
        problem = _unfit_default(value, first, version)
        if problem is not None:
            raise Mistake(Diagnostic(codes.VALUE_OUT_OF_RANGE, problem, use.whole))


def _given(
    run: Run,
    node: Node,
    use: _Use,
    part: tuple[Origin, Span],
    heard: Sequence[Field] | None,
) -> Parameter | FieldType:
    """Return the parameter that a value is computed of, or the type of what is received.

    Raises:
        Mistake: there is none.
    """
    origin, where = part
    if isinstance(origin, OfParameter):
        if heard is None and len(use.value.origins) > 1:
            raise Mistake(
                Diagnostic(
                    codes.NOTHING_RECEIVED,
                    "two parameters go together only with something that is received",
                    use.sent,
                    help="calculate with one parameter and numbers",
                )
            )
        return find_parameter(run, where, node, origin.name)
    if heard is None:
        raise Mistake(
            Diagnostic(
                codes.NOTHING_RECEIVED,
                f"nothing is received that `{origin}` could be of",
                use.sent,
                help="send it `for_each` message of a topic, or in an answer",
            )
        )
    catalog = run.types.catalog(run.checks.version_of(node))
    return type_received(origin, heard, catalog, where)


def _check_numbers(use: _Use, found: Sequence[What], version: int) -> None:
    """Check that all that a value is calculated of are numbers.

    Raises:
        Mistake: one is none, and is told where it stands.
    """
    for origin, what, where in zip(use.value.origins, found, use.origins, strict=True):
        if what.is_list or what.kind not in (int, float):
            raise Mistake(
                Diagnostic(
                    codes.COMPUTED_TYPE_MISMATCH,
                    f"`{origin}` is {what}, and cannot be calculated with",
                    where,
                    help=_element(use.value, origin, what, version),
                )
            )


def _element(value: Computed, origin: Origin, found: What, version: int) -> str | None:
    """Return what to write for a list whose elements fit, None where that is no remedy."""
    wanted = what_of(value.type, version)
    fits = found.kind == wanted.kind or (found.kind is int and wanted.kind is float)
    if not isinstance(origin, OfReceived) or not found.is_list or wanted.is_list or not fits:
        return None
    return f"write `{origin}[0]` for its first element"


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
        return not (_misfit(use, [found], ros_version) or _too_long(use, source))
    if source.holds is None:
        return False
    value = Computed(OfParameter(source.name), (), type_)
    use = _unwritten(value)
    if _misfit(use, [_what_of_parameter(source)], ros_version) or _too_long(use, None):
        return False
    return source.default is None or not _unfit_default(value, source, ros_version)


def _unwritten(value: Computed) -> _Use:
    nowhere = Span(0, 0)
    return _Use("", value, nowhere, (nowhere,) * len(value.origins), nowhere)


def _what_of_parameter(parameter: Parameter) -> What:
    assert parameter.holds is not None  # `find_parameter` has seen to it
    return What(_PARAMETERS[parameter.holds.element], parameter.holds.is_list)


def _misfit(use: _Use, parts: Sequence[What], version: int) -> str | None:
    """Return why a value does not fit its field, None where it does.

    Args:
        use: the value.
        parts: what it is computed of; numbers where it is calculated.
        version: the generation of ROS.
    """
    value = use.value
    wanted = what_of(value.type, version)
    found, shown = parts[0], f"`{value.source}`"
    if value.steps:
        is_whole = all(each.kind is int for each in parts) and not value.is_float
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
    default, steps = parameter.default, value.numbers
    if steps is None:
        return None
    for each in default if isinstance(default, tuple) else (default,):
        result = each
        if steps:
            assert isinstance(each, (int, float))  # others cannot be calculated with
            result = calculated(each, steps)
        problem = check_scalar(value.type.name, result, version, value.type.string_bound)
        if problem is not None:
            return f"by the default of `{value.source}`, {problem}"
    return None
