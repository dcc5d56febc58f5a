"""What a node sends for each message that it receives."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, codes, guess
from plastron_tui.language.statements import Publish
from plastron_tui.ros.interfaces import Interface, InterfaceKind

from ..computed_values import received
from ..mistake import Mistake
from ..value_diagnostics import Misfit
from ..values import OfReceived
from .computed import is_too_large, type_received, what_of
from .subscription import Subscription

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node


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
            labels = () if other.span is None else (Label(other.span, "called here"),)
            raise Mistake(
                Diagnostic(
                    codes.FUNCTION_CONFLICT,
                    f"`{function}` is called for each message of `{other.name}` too",
                    statement.span_of("trigger"),
                    help=f"let `{node.variable}` call another function for `{other.name}`",
                    labels=labels,
                )
            )


def _condition(run: Run, statement: Publish, node: Node, type_: Interface) -> Condition | None:
    given = statement.condition
    if given is None:
        return None
    where = statement.span_of("condition")
    try:
        source = received(given.received)
    except Misfit as misfit:
        raise Mistake(misfit.diagnostic.moved(statement.shift)) from None
    catalog = run.types.catalog(run.checks.version_of(node))
    found = what_of(type_received(source, type_.fields, catalog, where), catalog.ros_version)
    problem = None
    if found.is_list != (given.quantifier is not None):
        problem = f"`{source}` is {found}: write `any` or `all` before it"
        if given.quantifier is not None:
            problem = f"`{source}` is {found}, of which there is no `{given.quantifier}`"
    elif not _is_comparable(found.kind, given.operator, given.value.value):
        problem = f"`{source}` is {found}, and is not compared like this"
    if problem is not None:
        raise Mistake(Diagnostic(codes.COMPUTED_TYPE_MISMATCH, problem, where))
    value = given.value.value
    if is_too_large(value):
        raise Mistake(Diagnostic(codes.VALUE_OUT_OF_RANGE, "the number is too large", where))
    return Condition(given.quantifier, source, given.operator, value)


def _is_comparable(kind: object, operator: str, value: bool | int | float | str) -> bool:
    if kind in (bool, str):
        return operator == "=" and isinstance(value, kind)
    return kind in (int, float) and isinstance(value, (int, float)) and not isinstance(value, bool)
