"""What a node sends for each message that it receives."""

from __future__ import annotations

import operator as operators
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes, guess, write
from plastron_tui.language.statements import Publish
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType, Interface, InterfaceKind, Scalar
from plastron_tui.ros.primitives import primitive

from ..computed_values import received
from ..mistake import Mistake, function_conflict
from ..value_diagnostics import Misfit, span
from ..values import OfReceived
from .computed import is_too_large
from .received import type_received, what_of
from .subscription import Subscription

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node


_COMPARE: dict[str, Callable[[float, float], bool]] = {
    "<": operators.lt,
    ">": operators.gt,
    "=": operators.eq,
}
_WORDS = {"<": "less than", ">": "greater than", "=": "equal to"}


class Condition(NamedTuple):
    """What must hold of a received message.

    Attributes:
        quantifier: `any` or `all` elements of a list; None for what is no list.
        source: what is compared.
        operator: `<`, `>` or `=`.
        value: with what.
    """

    quantifier: str | None
    source: OfReceived
    operator: str
    value: bool | int | float | str


class Reaction(NamedTuple):
    """For each message of which topic something is sent, and under which condition."""

    topic: str
    condition: Condition | None = None


def reaction_of(run: Run, statement: Publish, node: Node) -> tuple[Reaction, Interface] | None:
    """Return what a statement reacts to, and the type of it; None where it reacts to nothing."""
    if statement.trigger is None:
        return None
    version = run.checks.version_of(node)
    topic = run.name(statement, "trigger", version, check=None)
    subscription = node.of(Subscription).get(topic)
    where = statement.span_of("trigger")
    if subscription is None or subscription.type is None:
        if run.consequences.explains(node, topic):
            raise Mistake
        remedy, fix = guess(topic, node.of(Subscription), where, is_quoted=True)
        raise Mistake(
            Diagnostic(
                codes.NOT_SUBSCRIBED,
                f"`{node.variable}` does not subscribe to `{topic}`",
                where,
                help=remedy
                or f"subscribe first: `subscribe {node.variable} to '{topic}' of message_type ...`",
                fix=fix,
            )
        )
    _check_function(statement, node, subscription)
    type_ = run.types.catalog(version).find(subscription.type, InterfaceKind.MESSAGE)
    if type_ is None:
        type_ = Interface.undefined(subscription.type, InterfaceKind.MESSAGE)
    return Reaction(topic, _condition(run, statement, node, type_)), type_


def _check_function(statement: Publish, node: Node, subscription: Subscription) -> None:
    """Check that the function that is to send takes the messages of no other topic."""
    function = subscription.callback
    for other in node.of(Subscription).values():
        if function is not None and other is not subscription and other.callback == function:
            message = f"`{function}` is called for each message of `{other.name}` too"
            remedy = f"let `{node.variable}` call another function for `{other.name}`"
            raise function_conflict(message, remedy, statement.span_of("trigger"), other.span)


def _condition(run: Run, statement: Publish, node: Node, type_: Interface) -> Condition | None:
    given = statement.condition
    if given is None:
        return None
    try:
        source = received(given.received)
    except Misfit as misfit:
        raise Mistake(misfit.diagnostic.moved(statement.shift)) from None
    catalog = run.types.catalog(run.checks.version_of(node))
    where = span(given.received.syntax).moved(statement.shift)
    compared = type_received(source, type_.fields, catalog, where)
    found = what_of(compared, catalog.ros_version)
    problem, right, remedy = None, None, None
    if found.is_list != (given.quantifier is not None):
        problem = f"`{source}` is {found}: write `any` or `all` before it"
        if given.quantifier is not None:
            problem = f"`{source}` is {found}, of which there is no `{given.quantifier}`"
            remedy = f"leave `{given.quantifier}` out"
    elif not _is_comparable(found.kind, given.operator, given.value.value):
        problem = f"`{source}` is {found}, and is not compared like this"
        right = _literal(found.kind, given.operator, given.value.value)
        remedy = None if right is None else f"write `= {right}`"
        if found.kind in (bool, str) and given.operator != "=":
            remedy = f"{found} is compared with `=`"
    if problem is not None:
        at = span(given.value.syntax).moved(statement.shift)
        raise Mistake(
            Diagnostic(
                codes.COMPUTED_TYPE_MISMATCH,
                problem,
                statement.span_of("condition"),
                help=remedy,
                fix=None if right is None else write(right, at),
            )
        )
    problem = _foregone(compared, given.operator, given.value.value, catalog.ros_version)
    if is_too_large(given.value.value):
        problem = "the number is too large"
    if problem is not None:
        where = statement.span_of("condition")
        raise Mistake(Diagnostic(codes.VALUE_OUT_OF_RANGE, problem, where))
    return Condition(given.quantifier, source, given.operator, given.value.value)


def can_compare(condition: Condition, fields: Sequence[Field], catalog: Catalog) -> bool:
    """Tell whether a condition can hold, and fail, of a message with these fields."""
    try:
        compared = type_received(condition.source, fields, catalog, Span(0, 0))
    except Mistake:
        return False
    found, version = what_of(compared, catalog.ros_version), catalog.ros_version
    operator, value = condition.operator, condition.value
    if found.is_list != (condition.quantifier is not None):
        return False
    is_comparable = _is_comparable(found.kind, operator, value)
    return is_comparable and _foregone(compared, operator, value, version) is None


def _is_comparable(kind: object, operator: str, value: Scalar) -> bool:
    if kind in (bool, str):
        return operator == "=" and isinstance(value, kind)
    return kind in (int, float) and isinstance(value, (int, float)) and not isinstance(value, bool)


def _literal(kind: object, operator: str, value: Scalar) -> str | None:
    """Return the value that is meant by one of another type, None where nobody can tell."""
    if operator != "=" or isinstance(value, str) or value not in (0, 1):
        return None
    if kind is bool:
        return str(bool(value))
    return str(int(value)) if kind in (int, float) else None


def _foregone(type_: FieldType, operator: str, value: Scalar, ros_version: int) -> str | None:
    """Return why a condition holds always or never, whatever is received; None where it does not.

    A float may be infinite, so that it is less, and more, than any number.
    """
    known = primitive(type_.name, ros_version)
    if known is None or not isinstance(value, (int, float)):
        return None
    if known.low is None or known.high is None:
        return None
    holds = _COMPARE[operator]
    ends = {holds(known.low, value), holds(known.high, value)}
    if operator == "=" and known.low <= value <= known.high and value % 1 == 0:
        return None
    if len(ends) == 2:
        return None
    which, how = ("every", "always") if True in ends else ("no", "never")
    what = f"{which} `{type_.name}` is {_WORDS[operator]} {value}"
    return f"{what}: the condition {how} holds"
