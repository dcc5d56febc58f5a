"""Subscriptions: topics that a node listens to."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.language.statements import Subscribe
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.qos import Qos

from .quality import qos_of

if TYPE_CHECKING:
    from ..run import Run


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
    run.checks.absent(statement, node)
    run.checks.function(statement, node)
    qos = qos_of(run, statement, run.checks.version_of(node))
    subscription = Subscription(topic, type_.name, statement.function, statement.span, qos)
    run.add(statement, node, subscription)
