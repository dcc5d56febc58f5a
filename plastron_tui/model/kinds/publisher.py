"""Publishers: topics that a node sends messages to, again and again."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Label, Span, codes, write, write_before
from plastron_tui.language import DECLARATIONS
from plastron_tui.language.sentence import sentence
from plastron_tui.language.statements import Publish, StopPublishing
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.names import spelled
from plastron_tui.ros.qos import Qos

from ..mistake import Mistake
from .computed import check_computed
from .quality import agreed, qos_of
from .rate import rate_of
from .reaction import Reaction, reaction_of

if TYPE_CHECKING:
    from ..run import Run
    from ..values import MessageValue
    from ..workspace import Node

DEFAULT_RATE = 10.0
"""How often a message is published where the program does not say, in hertz."""


class Message(NamedTuple):
    """A message that a program created, under its variable's name."""

    variable: str
    value: MessageValue
    span: Span


class Publication(NamedTuple):
    """One message on its way to a topic, and when it is sent.

    Attributes:
        message: the message.
        rate: how often it is sent, in hertz; 0 where it is not sent at a rate.
        span: the statement that sends it.
        is_rate_open: whether the program leaves the rate to Plastron, or to the loop of a file
            that has one; `rate` is then the default.
        parameter: the parameter of the node that says the rate, None where none does.
        is_once: whether it is sent once, and to those who listen later.
        reaction: for which messages it is sent, None where it is for none.
    """

    message: Message
    rate: float
    span: Span | None = None
    is_rate_open: bool = False
    parameter: str | None = None
    is_once: bool = False
    reaction: Reaction | None = None

    @property
    def is_beside(self) -> bool:
        """Whether it is meant to be sent beside others: an alarm, or a stop."""
        return self.is_once or (self.reaction is not None and self.reaction.condition is not None)

    def fits(self, rate: float | None) -> bool:
        """Tell whether a loop of a rate can send it: its own is not written, or the same."""
        is_same = rate is not None and math.isclose(self.rate, rate)
        return self.is_rate_open or (is_same and self.parameter is None)


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
    rate = rate_of(run, statement, node)
    reaction, type_heard = reaction_of(run, statement, node) or (None, None)
    heard = None if type_heard is None else type_heard.fields
    made = run.messages.made_by(message)
    check_computed(run, statement, "message", node, message.value, heard=heard, made=made)
    publisher = node.of(Publisher).get(topic)
    earlier = () if publisher is None else publisher.publications
    check_unsent(run, statement, node, message, reaction)
    span = statement.span if publisher is None else publisher.span
    is_open = rate is None and reaction is None and not statement.once
    sent = Publication(
        message,
        DEFAULT_RATE if is_open else 0 if rate is None else rate.hertz,
        statement.span,
        is_open,
        None if rate is None else rate.parameter,
        statement.once,
        reaction,
    )
    qos = qos_of(run, statement, checks.version_of(node))
    if publisher is not None:
        qos = agreed(statement, qos, publisher.qos, publisher.span)
    also_sent = None if publisher is None else _also_sent(statement, node, publisher, sent)
    run.add(statement, node, Publisher(topic, type_.name, (*earlier, sent), span, qos))
    if also_sent is not None:
        run.report(statement, also_sent)


def _also_sent(
    statement: Publish, node: Node, publisher: Publisher, sent: Publication
) -> Diagnostic | None:
    """Return the warning that a file sends to a topic itself, None where that is meant.

    It is said once of a topic. The statement that mends it stands before all that send to it.
    """
    place = node.place_of(publisher)
    earlier = publisher.publications
    if not place or sent.is_beside or not all(each.is_beside for each in earlier):
        return None
    first = (earlier[0].span if earlier else None) or statement.span
    declaration = DECLARATIONS[StopPublishing]
    stop = sentence(declaration, {"node": node.variable, "topic": publisher.name})
    return Diagnostic(
        codes.ALSO_SENT,
        f"{place} sends to `{publisher.name}` too: these messages come between",
        statement.span_of("topic"),
        help=f"to send these alone, write `{stop}` before",
        fix=write_before(stop, first),
    )


def check_unsent(
    run: Run, statement: Publish, node: Node, message: Message, reaction: Reaction | None
) -> None:
    """Check that a node does not send a message to a topic for the same reason yet.

    Another rate is no other reason: it is more often, or a slip.
    """
    publisher = node.of(Publisher).get(spelled(statement.topic))
    for each in () if publisher is None else publisher.publications:
        is_same = each.is_once == statement.once and each.reaction == reaction
        if each.message is message and is_same:
            what = f"`{node.variable}` publishes `{message.variable}` to"
            code = codes.ALREADY_PUBLISHING
            raise run.checks.exists_already(statement, "topic", node, code, what, each.span)


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
