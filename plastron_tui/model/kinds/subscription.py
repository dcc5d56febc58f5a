"""Subscriptions: topics that a node listens to."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span, codes
from plastron_tui.language.statements import Subscribe
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

if TYPE_CHECKING:
    from ..run import Run


class Subscription(NamedTuple):
    """A topic that a node listens to; without a `callback` the target names one."""

    name: str
    type: InterfaceName | None
    callback: str | None = None
    span: Span | None = None


def subscribe(run: Run, statement: Subscribe) -> None:
    """Let a node listen to a topic."""
    checks = run.checks
    node = checks.node(statement)
    topic, type_ = run.interface(statement, node, "topic", InterfaceKind.MESSAGE)
    if topic in node.of(Subscription):
        what = f"`{node.variable}` subscribes to"
        raise checks.exists_already(statement, "topic", node, codes.ALREADY_SUBSCRIBED, what)
    if statement.function is not None:
        from .service import Service  # which imports this file

        checks.function(statement, node, node.of(Service).values())
    run.add(statement, node, Subscription(topic, type_.name, statement.function, statement.span))
