"""Sending other values through a publisher or a client of a file, in the lines that send."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.kinds import ActionClient, Client, Publication, Publisher, Service
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.sources.written_anew import no_longer_sends

from ..scopes import Function, Variable
from .creation import creation_of
from .deletions import Deletions
from .interfaces import Interfaces
from .leftovers import functions_of
from .lost import worked_out
from .occasions import Heard, check_once, field_of, heard_for
from .place import beside
from .refilling import (
    Filled,
    Refilling,
    Values,
    addition_at,
    expressions,
    prepare,
    refill,
    stamp,
    take_over,
)
from .replacing import NotInPlaceError, Replacement
from .sent import (
    PUBLISHING,
    Runner,
    Sent,
    is_rate,
    runner_of,
    sent_through,
    timer_behind,
)
from .statements import is_inside, only_sets, statement_of
from .uses import uses_of

_ASKING = {
    Client: frozenset({"async_send_request", "call", "prune_pending_requests"}),
    ActionClient: frozenset({"async_send_goal", "sendGoal", "sendGoalAndWait"}),
}


class Sending(NamedTuple):
    """How a call sends something else.

    Attributes:
        sent: the call.
        values: what it shall send.
        refilling: how its message is filled anew, None where it sends another one.
        unused: the statements that have made its message for nothing else, then.
    """

    sent: Sent
    values: Values
    refilling: Refilling | None = None
    unused: tuple[Node, ...] = ()


def sent_now(update: Replacement, *, is_retyped: bool) -> list[Sending]:
    """Return the calls that send through an endpoint, with what each shall send.

    At other rates they do so from then on.

    Raises:
        NotInPlaceError: it is not sent through one variable.
    """
    endpoint = update.change.endpoint
    creation = creation_of(update.analysis, update.site)
    variable = None if creation is None else creation.variable
    if variable is None:
        raise NotInPlaceError
    methods = _ASKING.get(type(endpoint), PUBLISHING)
    sent = list(sent_through(update.analysis, variable, methods))
    match endpoint:
        case Publisher(publications=publications):
            values = _publish(update, sent, publications)
        case Client(requests=requests):
            for each, request in zip(sent, requests, strict=False):
                if request.rate is not None:
                    _check_rate(update, each, request.rate.hertz, request.rate.parameter)
            values = [(each.value, Heard()) for each in requests]
        case ActionClient(goals=goals):
            values = [(each, Heard()) for each in goals]
        case _:
            values = []
    if len(values) != len(sent):
        raise NotInPlaceError
    return [
        _sending(update, each, _values(update, value, heard), is_retyped)
        for each, (value, heard) in zip(sent, values, strict=True)
    ]


def _sending(update: Replacement, sent: Sent, values: Values, is_retyped: bool) -> Sending:
    """Tell how a call sends something else: its own message filled anew, or another one."""
    try:
        if sent.variable is None:
            raise NotInPlaceError
        refilling = prepare(update, _filled(update, sent, is_retyped), values)
    except NotInPlaceError:
        block = sent.statement.parent
        has_block = block is not None and block.type == "compound_statement"
        if not isinstance(update.change.endpoint, Publisher) or sent.given is None or not has_block:
            raise
        return Sending(sent, values, unused=_unused(update, sent))
    return Sending(sent, values, refilling)


def resend(update: Replacement, sendings: Sequence[Sending]) -> None:
    """Send other values in the calls that there are, see `sent_now`.

    Raises:
        NotInPlaceError: what sends is to be written anew.
    """
    lost: list[str] = []
    for each in sendings:
        if each.refilling is not None:
            lost += refill(update, each.refilling)
        else:
            lost += _send_new(update, each)
    update.plan.notes += no_longer_sends(lost, update.change.endpoint, update.old)


def _send_new(update: Replacement, sending: Sending) -> list[str]:
    """Make another message above a call that publishes, and send that instead.

    Returns what it sent, and was worked out.
    """
    sent, values = sending.sent, sending.values
    assert sent.given is not None, "it was looked for"
    added = addition_at(update)
    name = added.free(f"{added.topic}_message")
    class_ = added.interfaces.class_of(values.interface.name, InterfaceKind.MESSAGE)
    found = expressions(added, f"{name}.", values, sent.statement)
    lines = [f"{class_} {name};", *(f"{name}.{path} = {text};" for path, text in found.items())]
    if values.is_stamped and "header.stamp" not in found:
        lines.append(stamp(added, f"{name}."))
    update.put(sent.file, sent.given, name)
    added.put_above(sent.file, sent.statement, lines)
    take_over(update, added)
    gone = Deletions()
    for each in sending.unused:
        gone.statement(sent.file, each)
    gone.take_empty()
    update.plan.splices[sent.file.name] += gone.splices(sent.file)
    return list(worked_out(update.analysis, sent))


def _unused(update: Replacement, sent: Sent) -> tuple[Node, ...]:
    """Return the statements that make a message, where nothing else uses it."""
    message = sent.variable
    if message is None:
        return ()
    found = [message.node]
    for _, node, _ in uses_of(update.analysis, message):
        if is_inside(node, sent.call):
            continue
        statement = statement_of(node)
        if statement is None or not only_sets(statement, node):
            return ()
        found.append(statement)
    return tuple(found)


def _values(update: Replacement, value: MessageValue, heard: Heard) -> Values:
    """Return what is to be sent, of the part of its type that is sent."""
    endpoint = update.change.endpoint
    kind = update.change.kind.facts.interface
    interfaces = Interfaces(update.catalog, update.analysis.ros_version)
    type_ = endpoint.type or update.site.endpoint.type
    assert kind is not None, "what is sent is of a type"
    if kind is InterfaceKind.MESSAGE:
        type_ = value.type
    found = None if type_ is None else update.catalog.find(type_, kind)
    if found is None:
        raise NotInPlaceError
    is_stamped = kind is InterfaceKind.MESSAGE and interfaces.needs_stamp(value)
    return Values(found, found.fields, value, heard.holder, heard.fields, is_stamped)


def _filled(update: Replacement, sent: Sent, is_retyped: bool) -> Filled:
    variable = sent.variable
    assert variable is not None, "it was looked for"
    block = variable.node.parent
    assert block is not None, "a local variable is declared in a block"
    return Filled(
        variable,
        sent.file,
        block,
        variable.node,
        _holder(update, variable),
        (sent.call,),
        is_retyped,
    )


def _holder(update: Replacement, variable: Variable) -> str:
    """Return what stands before a field of a message that is sent."""
    written = variable.type + variable.file.syntax.word(variable.node)
    is_pointer = variable.is_pointer or "Ptr" in written or "make_" in written
    is_pointer = is_pointer or "_ptr<" in written
    dot = "->" if is_pointer else "."
    is_call = isinstance(update.change.endpoint, Client) and update.analysis.ros_version == 1
    return f"{variable.name}{dot}{'request.' if is_call else ''}"


def _publish(
    update: Replacement, sent: Sequence[Sent], publications: Sequence[Publication]
) -> list[tuple[MessageValue, Heard]]:
    """Return what the calls shall publish in turn, which they then do at the rates asked for."""
    # What is sent at one rate stands together.
    rates = list(dict.fromkeys(each.rate for each in publications))
    ordered = sorted(publications, key=lambda each: rates.index(each.rate))
    if len(ordered) != len(sent):
        raise NotInPlaceError
    wanted: dict[int, set[float]] = defaultdict(set)
    runners: dict[int, Runner] = {}
    own: set[int] = set()
    heard: list[Heard] = []
    for each, publication in zip(sent, ordered, strict=True):
        heard.append(Heard())
        if publication.reaction is not None:
            heard[-1] = heard_for(update, each, publication, publication.reaction)
            continue
        if publication.is_once:
            check_once(update, each)
            continue
        runner = runner_of(update.analysis, each)
        if runner is None or publication.parameter:
            raise NotInPlaceError
        runners[runner.block.id] = runner
        own |= _own_statements(update, each)
        if runner.is_own or not publication.is_rate_open:
            wanted[runner.block.id].add(publication.rate)
    for key, asked in wanted.items():
        _pace(update, runners[key], asked, own, sent)
    return list(zip([each.message.value for each in ordered], heard, strict=True))


def _pace(
    update: Replacement, runner: Runner, asked: set[float], own: set[int], sent: Sequence[Sent]
) -> None:
    hertz = runner.hertz(update.analysis)
    if all(is_rate(hertz, rate) for rate in asked):
        return
    file = next(each.file for each in sent if each.statement.parent == runner.block)
    if len(asked) > 1 or not runner.does_only(file, own):
        raise NotInPlaceError
    runner.set_to(update, asked.pop())


def _own_statements(update: Replacement, sent: Sent) -> set[int]:
    """Return the statements that make a message and send it."""
    found = {sent.statement.id}
    if sent.variable is not None:
        found.add(sent.variable.node.id)
        for node, _, _, _ in update.analysis.fields.of(sent.variable.name):
            found |= {node.parent.id} if node.parent is not None else set()
    return found


def _check_rate(update: Replacement, sent: Sent, hertz: float, parameter: str | None) -> None:
    """Let a timer ask at another rate, where it does nothing else."""
    runner = runner_of(update.analysis, sent)
    timer = timer_behind(update.analysis, sent)
    if parameter is None and runner is None and timer is not None:
        own = Runner(sent.statement, timer)
        if not is_rate(own.hertz(update.analysis), hertz):
            own.set_to(update, hertz)
        return
    if runner is None or parameter is not None:
        raise NotInPlaceError
    _pace(update, runner, {hertz}, _own_statements(update, sent), [sent])


def answer(update: Replacement, service: Service) -> None:
    """Answer something else in the function that answers.

    Raises:
        NotInPlaceError: it does not fill its response alone.
    """
    assert service.answer is not None, "somebody asks for it"
    handler = _handler(update)
    place = beside(update.analysis, update.site)
    body = None if handler is None else handler.node.child_by_field_name("body")
    type_ = service.type or update.site.endpoint.type
    found = None if type_ is None else update.catalog.find(type_, InterfaceKind.SERVICE)
    if handler is None or place is None or body is None or found is None:
        raise NotInPlaceError
    request, response = handler.parameters[-2:]
    if not response.name:
        raise NotInPlaceError
    filled = Filled(response, handler.file, body, None, field_of(response))
    values = Values(found, found.response.fields, service.answer, field_of(request), found.fields)
    if "received" in str(service.answer) and not request.name:
        raise NotInPlaceError
    lost = refill(update, prepare(update, filled, values))
    _take_void(update, handler, body, response)
    update.plan.notes += no_longer_sends(lost, service, update.old)


def _handler(update: Replacement) -> Function | None:
    """Return the function that answers, None where it may answer others too."""
    analysis, site = update.analysis, update.site
    named = [each for listed in functions_of(analysis, site) for each in listed]
    defined = [each for each in named if each.scope is not None]
    others = [
        each
        for each in analysis.sites
        if each is not site and set(each.callback.functions) & set(named)
    ]
    if others or len(defined) != 1 or len(defined[0].parameters) not in (2, 3):
        return None
    return defined[0]


def _take_void(update: Replacement, handler: Function, body: Node, response: Variable) -> None:
    """Take out what says that the response is of no use, where it is filled now."""
    del handler
    file = response.file
    if not any(update.plan.splices[file.name]):
        return
    gone = Deletions()
    for each in body.named_children:
        text = "".join(file.syntax.word(each).split())
        if text in (f"(void){response.name};", f"static_cast<void>({response.name});"):
            gone.statement(file, each)
    update.plan.splices[file.name] += gone.splices(file)
