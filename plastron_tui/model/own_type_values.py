"""What a program's values and reactions are once a type of the program is another one."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from plastron_tui.diagnostics import Span
from plastron_tui.ros.interfaces import Field, InterfaceKind, InterfaceName

from .kinds import ActionClient, Client, Endpoint, Publication, Publisher, Service, Subscription
from .kinds.computed import can_compute
from .kinds.reaction import can_compare
from .run import Run
from .values import MessageValue
from .workspace import Node

_Change = Callable[[MessageValue], MessageValue]


def fit_anew(run: Run) -> list[Span]:
    """Hold the values of a program against what its types are now, and let them be of these.

    Returns:
        The statements that do not bear it; then every value stays as it was.
    """
    fitted = run.types.refitted()
    values = list(_values(run))
    # A renamed parameter makes values that no statement has: then all statements count.
    is_sure = all(id(value) in fitted for value in values)
    counted = [fitted[id(value)] for value in values] if is_sure else list(fitted.values())
    broken = {each.span: None for each in counted if each.value is None}

    def change(value: MessageValue) -> MessageValue:
        found = fitted.get(id(value))
        return value if found is None or found.value is None else found.value

    changed = [
        (node, [_with_values(each, change) for each in node.endpoints.values()])
        for node in run.workspace.nodes.values()
    ]
    for node, endpoints in changed:
        for endpoint in endpoints:
            broken |= dict.fromkeys(_unsent(run, node, endpoint))
    if broken:
        return sorted(broken, key=lambda span: span.start)
    for node, endpoints in changed:
        for endpoint in endpoints:
            node.put(endpoint)
    run.messages.change(change)
    run.types.take(fitted)
    return []


def _values(run: Run) -> Iterator[MessageValue]:
    """Yield the values that the program has, without those that a statement took back."""
    yield from run.messages.values()
    for node in run.workspace.nodes.values():
        for endpoint in node.endpoints.values():
            yield from _values_of(endpoint)


def _values_of(endpoint: Endpoint) -> list[MessageValue]:
    found: list[MessageValue] = []

    def note(value: MessageValue) -> MessageValue:
        found.append(value)
        return value

    _with_values(endpoint, note)
    return found


def _with_values(endpoint: Endpoint, change: _Change) -> Endpoint:
    """Return an endpoint with other values in what it sends."""
    match endpoint:
        case Publisher(publications=sent) if sent:
            return endpoint._replace(publications=tuple(_published(each, change) for each in sent))
        case Client(requests=requests) if requests:
            now = (each._replace(value=change(each.value)) for each in requests)
            return endpoint._replace(requests=tuple(now))
        case ActionClient(goals=goals) if goals:
            return endpoint._replace(goals=tuple(map(change, goals)))
        case Service(answer=answer) if answer is not None:
            return endpoint._replace(answer=change(answer))
    return endpoint


def _published(publication: Publication, change: _Change) -> Publication:
    message = publication.message
    return publication._replace(message=message._replace(value=change(message.value)))


def _unsent(run: Run, node: Node, endpoint: Endpoint) -> Iterator[Span]:
    """Yield the statements whose values or condition can no longer be computed."""

    def lacks(value: MessageValue, heard: tuple[Field, ...] | None = None) -> bool:
        return not can_compute(run, node, value, heard)

    match endpoint:
        case Publisher(publications=sent):
            for each in sent:
                heard = _heard(run, node, each)
                condition = None if each.reaction is None else each.reaction.condition
                is_lost = condition is not None and not can_compare(
                    condition, heard or (), run.types.catalog(run.checks.version_of(node))
                )
                if each.span is not None and (is_lost or lacks(each.message.value, heard)):
                    yield each.span
        case Client(requests=requests, span=Span() as span):
            yield from (span for each in requests if lacks(each.value))
        case ActionClient(goals=goals, span=Span() as span):
            yield from (span for each in goals if lacks(each))
        case Service(answer=MessageValue() as answer, type=InterfaceName() as type_):
            heard = _fields(run, node, type_, InterfaceKind.SERVICE)
            if endpoint.span is not None and lacks(answer, heard):
                yield endpoint.span


def _heard(run: Run, node: Node, publication: Publication) -> tuple[Field, ...] | None:
    """Return the fields of the messages that something is sent for, None where it is for none."""
    if publication.reaction is None:
        return None
    subscription = node.of(Subscription).get(publication.reaction.topic)
    if subscription is None or subscription.type is None:
        return ()
    return _fields(run, node, subscription.type, InterfaceKind.MESSAGE)


def _fields(run: Run, node: Node, name: InterfaceName, kind: InterfaceKind) -> tuple[Field, ...]:
    found = run.types.catalog(run.checks.version_of(node)).find(name, kind)
    return () if found is None else found.fields
