"""Publishers: topics that a node sends messages to, again and again."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes, write
from plastron_tui.language.statements import Publish
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.names import spelled
from plastron_tui.ros.qos import Qos

from ..mistake import Mistake

if TYPE_CHECKING:
    from ..run import Run
    from ..values import MessageValue
    from ..workspace import Node

DEFAULT_RATE = 10.0
"""How often a message is published where the program does not say, in hertz."""

HIGHEST_RATE = 1e6
"""More than any node sends, in hertz; a typing error."""

LOWEST_RATE = 1e-9
"""The lowest rate, in hertz: ROS 1 counts the seconds between two messages in 31 bits (genpy)."""


class Message(NamedTuple):
    """A message that a program created, under its variable's name."""

    variable: str
    value: MessageValue
    span: Span


class Publication(NamedTuple):
    """One message on its way to a topic, and how often it is sent, in hertz.

    `is_rate_open` tells that the program leaves the rate to Plastron, or to the loop of a file
    that has one; `rate` is then the default.
    """

    message: Message
    rate: float
    span: Span | None = None
    is_rate_open: bool = False


class Publisher(NamedTuple):
    """A topic that a node publishes; `publications` is empty for one that was read from a file.

    `qos` is None where a program does not say it, and where nothing of it is known of a file.
    """

    name: str
    type: InterfaceName | None
    publications: tuple[Publication, ...] = ()
    span: Span | None = None
    qos: Qos | None = None


def publish(run: Run, statement: Publish) -> None:
    """Let a node send one more message to a topic."""
    checks = run.checks
    node = checks.node(statement)
    message = run.messages.find(statement)
    topic, type_ = run.interface(statement, node, "topic", InterfaceKind.MESSAGE)
    message = run.messages.for_version(message, checks.version_of(node))
    check_sent(statement, message, type_.name)
    rate = rate_of(statement)
    publisher = node.of(Publisher).get(topic)
    earlier = () if publisher is None else publisher.publications
    check_unsent(run, statement, node, message)
    span = statement.span if publisher is None else publisher.span
    sent = Publication(message, rate, statement.span, statement.rate is None)
    qos = None if publisher is None else publisher.qos
    run.add(statement, node, Publisher(topic, type_.name, (*earlier, sent), span, qos))


def check_unsent(run: Run, statement: Publish, node: Node, message: Message) -> None:
    """Check that a node does not send a message to a topic yet."""
    publisher = node.of(Publisher).get(spelled(statement.topic))
    if publisher is not None and any(each.message is message for each in publisher.publications):
        what = f"`{node.variable}` publishes `{message.variable}` to"
        raise run.checks.exists_already(statement, "topic", node, codes.ALREADY_PUBLISHING, what)


def check_sent(statement: Publish, message: Message, type_: InterfaceName) -> None:
    """Check that a message is of the type that its topic takes."""
    if message.value.type != type_:
        where = statement.span_of("type")
        raise Mistake(
            Diagnostic(
                codes.MESSAGE_TYPE_MISMATCH,
                f"`{message.variable}` is of type `{message.value.type}`, not `{type_}`",
                where,
                help=f"write of message_type {message.value.type}",
                fix=write(str(message.value.type), where),
                labels=(Label(message.span, "created here"),),
            )
        )


def rate_of(statement: Publish) -> float:
    """Return how often a message is to be sent, in hertz."""
    rate = DEFAULT_RATE if statement.rate is None else statement.rate
    if LOWEST_RATE <= rate <= HIGHEST_RATE:
        return float(rate)
    where = statement.span_of("rate")
    is_negative = LOWEST_RATE <= -rate <= HIGHEST_RATE
    raise Mistake(
        Diagnostic(
            codes.INVALID_RATE,
            f"a rate is at least {LOWEST_RATE:g} and at most {HIGHEST_RATE:g} hz",
            where,
            help=f"write `at {-rate:g} hz`" if is_negative else None,
            fix=write(f"{-rate:g}", where) if is_negative else None,
        )
    )
