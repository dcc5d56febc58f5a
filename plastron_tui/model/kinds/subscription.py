"""Subscriptions: topics that a node listens to."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span, codes
from plastron_tui.language.statements import Subscribe
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.names import spelled
from plastron_tui.ros.qos import Qos

from .quality import qos_of

if TYPE_CHECKING:
    from ..run import Run
    from ..workspace import Node


class Subscription(NamedTuple):
    """A topic that a node listens to; without a `callback` the target names one.

    `qos` is None where a program does not say it, and where nothing of it is known of a file.
    """

    name: str
    type: InterfaceName | None
    callback: str | None = None
    span: Span | None = None
    qos: Qos | None = None


def subscribe(run: Run, statement: Subscribe) -> None:
    """Let a node listen to a topic."""
    node = run.checks.node(statement)
    topic, type_ = run.interface(statement, node, "topic", InterfaceKind.MESSAGE)
    check_unheard(run, statement, node)
    check_callback(run, statement, node)
    qos = qos_of(run, statement, run.checks.version_of(node))
    subscription = Subscription(topic, type_.name, statement.function, statement.span, qos)
    run.add(statement, node, subscription)


def check_unheard(run: Run, statement: Subscribe, node: Node) -> None:
    """Check that a node does not listen to a topic yet."""
    if spelled(statement.topic) in node.of(Subscription):
        what = f"`{node.variable}` subscribes to"
        raise run.checks.exists_already(statement, "topic", node, codes.ALREADY_SUBSCRIBED, what)


def check_callback(run: Run, statement: Subscribe, node: Node) -> None:
    """Check that a function may take messages."""
    from . import EndpointKind  # which imports this file

    run.checks.function(statement, node, EndpointKind.SUBSCRIPTION)
