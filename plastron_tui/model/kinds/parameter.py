"""Parameters: values of a node that are set from outside."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes, guess, write
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.language.inputs import ListValue, Literal
from plastron_tui.language.statements import HasParameter
from plastron_tui.ros.names import check_parameter_name, parameter_name
from plastron_tui.ros.parameter_values import unfit
from plastron_tui.ros.parameters import OF_EVERY_NODE, ParameterType, Setting, as_setting

from ..mistake import Mistake

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node


class Parameter(NamedTuple):
    """A parameter of a node.

    Attributes:
        name: its name, in ROS 1 with the `~` of what is private.
        type: None, a parameter has no interface type.
        holds: what it holds, None where a file does not say it.
        default: its value where none is set.
        minimum: the least value of a number.
        maximum: the greatest value.
        description: what it is for.
        span: the statement that made it.
    """

    name: str
    type: None = None
    holds: ParameterType | None = None
    default: Setting | None = None
    minimum: int | float | None = None
    maximum: int | float | None = None
    description: str = ""
    span: Span | None = None


def has_parameter(run: Run, statement: HasParameter) -> None:
    """Give a node a parameter."""
    node = run.checks.node(statement)
    version = run.checks.version_of(node)
    run.name(statement, "parameter", version, check_parameter_name)
    name = parameter_name(statement.parameter, version)
    if version == 2 and name.partition(".")[0] in OF_EVERY_NODE:
        what = f"every node of ROS 2 has the parameter `{name}` without a word of yours"
        raise Mistake(Diagnostic(codes.ALREADY_HAVING, what, statement.span_of("parameter")))
    run.checks.absent(statement, node)
    type_ = type_of(statement)
    default = default_of(statement, type_)
    if default == () and version == 2:
        raise _no_default(statement, type_, "an empty list does not say in ROS 2 what it is of")
    wrong = unfit(default, version)
    if wrong is not None:
        raise Mistake(
            Diagnostic(codes.PARAMETER_TYPE_MISMATCH, wrong, statement.span_of("default"))
        )
    minimum, maximum = range_of(statement, type_, default)
    parameter = Parameter(
        name, None, type_, default, minimum, maximum, statement.description or "", statement.span
    )
    run.add(statement, node, parameter)


def type_of(statement: HasParameter) -> ParameterType:
    """Return the type that a statement names."""
    try:
        return ParameterType(statement.type)
    except ValueError:
        where = statement.span_of("type")
        names = [each.value for each in ParameterType]
        remedy, fix = guess(_OTHER_NAMES.get(statement.type, statement.type), names, where)
        raise Mistake(
            Diagnostic(
                codes.UNKNOWN_PARAMETER_TYPE,
                f"no parameter type `{statement.type}`",
                where,
                help=remedy or f"there are {', '.join(names)}",
                fix=fix,
            )
        ) from None


_OTHER_NAMES = {
    **dict.fromkeys(("boolean", "Bool", "bools"), "bool"),
    **dict.fromkeys(("integer", "int32", "int64", "number", "Int"), "int"),
    **dict.fromkeys(("double", "float32", "float64", "real", "Float"), "float"),
    **dict.fromkeys(("str", "text", "String"), "string"),
}
"""What people call the types elsewhere."""


def default_of(statement: HasParameter, type_: ParameterType) -> Setting:
    """Return the default that a statement gives, which is to be of its type."""
    given = statement.default
    value: object = None
    match given:
        case Literal(value=value):
            pass
        case ListValue(items=items):
            value = [each.value if isinstance(each, Literal) else None for each in items]
    default = as_setting(type_, value)
    if default is None:
        raise _no_default(statement, type_, f"the default is no `{type_.value}`")
    return default


def _no_default(statement: HasParameter, type_: ParameterType, what: str) -> Mistake:
    where = statement.span_of("default")
    remedy = f"write {_EXAMPLES[type_]}"
    return Mistake(Diagnostic(codes.PARAMETER_TYPE_MISMATCH, what, where, help=remedy))


_EXAMPLES = {
    ParameterType.BOOL: "`True` or `False`",
    ParameterType.INT: "a whole number, such as `1`",
    ParameterType.FLOAT: "a number, such as `0.5`",
    ParameterType.STRING: 'a text, such as `"front"`',
    ParameterType.BOOL_LIST: "a list, such as `[True, False]`",
    ParameterType.INT_LIST: "a list, such as `[1, 2]`",
    ParameterType.FLOAT_LIST: "a list, such as `[0.5, 1.0]`",
    ParameterType.STRING_LIST: 'a list, such as `["left", "right"]`',
}


def range_of(
    statement: HasParameter, type_: ParameterType, default: Setting
) -> tuple[int | float | None, int | float | None]:
    """Return the least and the greatest value that a statement allows, None where it says none."""
    minimum, maximum = statement.minimum, statement.maximum
    if minimum is None or maximum is None:
        return None, None
    low, high = as_setting(type_, minimum), as_setting(type_, maximum)
    if not type_.is_number or low is None or high is None:
        what = "only a number has a range"
        if type_.is_number:
            what = f"the range is not of the type `{type_.value}`"
        raise _wrong_range(statement, what)
    assert isinstance(low, (int, float)) and isinstance(high, (int, float))
    assert isinstance(default, (int, float))
    if low > high:
        turned = f"{maximum} and {minimum}"
        raise _wrong_range(statement, f"{minimum:g} is greater than {maximum:g}", turned)
    if not low <= default <= high:
        what = f"the default is not between {minimum:g} and {maximum:g}"
        raise Mistake(Diagnostic(codes.INVALID_RANGE, what, statement.span_of("default")))
    return low, high


def _wrong_range(statement: HasParameter, what: str, right: str | None = None) -> Mistake:
    where = Span(statement.span_of("minimum").start, statement.span_of("maximum").end)
    fix = None if right is None else write(right, where)
    remedy = None if right is None else f"write `between {right}`"
    return Mistake(Diagnostic(codes.INVALID_RANGE, what, where, help=remedy, fix=fix))


def find_parameter(run: Run, where: Span, node: Node, written: str) -> Parameter:
    """Return the parameter of a node that a statement uses, where it writes `parameter 'NAME'`."""
    parameters = node.of(Parameter)
    name = parameter_name(written, run.checks.version_of(node))
    found = parameters.get(name)
    if found is not None and found.holds is not None and found.default is not None:
        return found
    if found is None and run.consequences.explains(node, name):
        raise Mistake
    what = "has no parameter" if found is None else "does not say the default of"
    names = [each.removeprefix("~/") for each in parameters]
    guessed = nearest(written, names)
    remedy = None if guessed is None else f"did you mean `{guessed}`?"
    made = f"{node.variable} has_parameter '{written}' of parameter_type float with default 1"
    raise Mistake(
        Diagnostic(
            codes.UNKNOWN_PARAMETER,
            f"`{node.variable}` {what} `{written}`",
            where,
            help=remedy or f"give it one first, such as `{made}`",
            fix=write(f"parameter '{guessed}'", where) if guessed else None,
        )
    )
