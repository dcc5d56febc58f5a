"""What to write where a publisher and a subscription of a program never match."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Fix, Span, write
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.qos import DEFAULT, Qos, mismatches
from plastron_tui.ros.qos_agreement import words_to_ask, words_to_hear, words_to_offer

from .kinds import Publisher, Subscription
from .workspace import Node


class Remedy(NamedTuple):
    """The remedy, in words and as an edit where a statement can be mended."""

    help: str
    fix: Fix | None = None


def qos_remedy(
    publisher: tuple[Node, Publisher],
    subscription: tuple[Node, Subscription],
    statements: Mapping[Span, Statement],
) -> Remedy:
    """Return what lets a subscription hear a publisher.

    Whoever hears a publisher goes on to do so when a subscription asks for less, or a publisher
    offers more. Of two statements, that is mended which says nothing of the policies that do not
    match; where both do, or none, the subscription.

    Args:
        publisher: a node, and how it publishes the topic.
        subscription: a node, and how it listens to it.
        statements: the statements of the program, by their spans.
    """
    offered, requested = meant_qos(*publisher), meant_qos(*subscription)
    heard, sent = _statement(subscription[1], statements), _statement(publisher[1], statements)
    less = more = ""
    if isinstance(heard, st.Subscribe):
        stated = publisher[1].qos or Qos()
        less = "" if heard.qos else words_to_hear([stated])
        less = less or words_to_ask(offered, subscription[1].qos or Qos())
    # Of several that publish to it, each may have its words.
    if isinstance(sent, st.Publish) and len(publisher[1].publications) == 1:
        more = words_to_offer(publisher[1].qos or Qos(), requested)
        policies = [each.policy for each in mismatches(offered, requested)]
        if more and not _says(publisher[1], policies) and _says(subscription[1], policies):
            less = ""
    if less:
        return _written(heard, less, f"let `{subscription[0].variable}` ask for less")
    if more:
        return _written(sent, more, f"let `{publisher[0].variable}` offer more")
    return Remedy("no message arrives: offer as much as is asked for, or ask for less")


def meant_qos(node: Node, endpoint: Publisher | Subscription) -> Qos:
    """Return what is known of the quality of service of an endpoint.

    A file may have it from elsewhere; what is created is all that the program says.
    """
    if node.source is not None:
        return endpoint.qos or Qos()
    return DEFAULT if endpoint.qos is None else endpoint.qos.over(DEFAULT)


def _says(endpoint: Publisher | Subscription, policies: Sequence[str]) -> bool:
    """Tell whether the quality of service of an endpoint says any of some policies."""
    return any(getattr(endpoint.qos or Qos(), policy) is not None for policy in policies)


def _statement(
    endpoint: Publisher | Subscription, statements: Mapping[Span, Statement]
) -> Statement | None:
    return None if endpoint.span is None else statements.get(endpoint.span)


def _written(statement: Any, words: str, who: str) -> Remedy:
    """Return the remedy that gives a statement these words, in place of those that it has."""
    if statement.qos:
        fix = write(words, statement.span_of("qos"))
    else:
        end = statement.span_of("type").end
        fix = Fix(f"write `with qos {words}`", write(f" with qos {words}", Span(end, end)).edits)
    return Remedy(f"no message arrives: {who}, `with qos {words}`", fix)
