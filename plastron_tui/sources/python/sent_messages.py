"""Sending something else through an endpoint, from the lines that send through it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.kinds import Client, Publication, Publisher, Request, is_sending
from plastron_tui.model.values import computed_in
from plastron_tui.ros.interfaces import Interface

from .addition import Addition
from .analysis import Analysis, Site
from .creation import Removal, parameters_in, remove_creation
from .functions import timers_of
from .generated import is_docstring, is_named_as_own, is_own_call, repeats_call
from .leftovers import remove_idle
from .own_loop import is_loop, is_sleep
from .rates import Pace, is_once, is_shared, loop_pace, timer_pace
from .references import Reference, Variable, references
from .removal import remove_uses
from .removal_plan import remove_what_served
from .replacing import NotInPlaceError, Replacement
from .same_message import is_message
from .sent_before import Sent, lost_sending, only_argument, publishing_on, sent_by
from .splices import delete_statements
from .syntax import parts_of
from .writing import key_of

_CALLS = frozenset({"call", "call_async"})


def resend(update: Replacement, interface: Interface) -> None:
    """Replace what is sent through an endpoint, where the update names that.

    Where the lines that send cannot be changed in place they are deleted (`is_silent`).

    Raises:
        NotInPlaceError: something is done with the endpoint that nobody can take back.
    """
    endpoint = update.added.endpoint
    if not is_sending(endpoint):
        return
    variable, uses = _uses(update)
    if isinstance(endpoint, Publisher):
        is_done = _publish(update, variable, endpoint.publications)
    else:
        assert isinstance(endpoint, Client), "only publishers and clients are changed in place"
        is_done = _request(update, variable, interface, endpoint.requests)
    if isinstance(endpoint, Publisher):
        old, interfaces = update.site.endpoint, update.added.messages.interfaces
        name = old.name or old.default or ""
        update.notes += lost_sending(
            update.analysis, variable, endpoint, name, interfaces, is_in_place=is_done
        )
    if not is_done:
        before = len(uses.splices)
        remove_what_served(update.analysis, uses)
        while remove_idle(update.analysis, uses):
            remove_what_served(update.analysis, uses)
        gone = delete_statements(update.analysis.syntax.text, uses.statements)
        gone += uses.splices[before:]
        update.splices += gone
        update.lost += uses.sites[1:] + parameters_in(update.analysis, gone)
        update.is_silent = True


def _uses(update: Replacement) -> tuple[Variable, Removal]:
    """Return the variable that holds an endpoint, and the statements that send through it."""
    analysis, site = update.analysis, update.site
    creation = Removal(sites=[site])
    variables = remove_creation(analysis, site, creation)
    if creation.lines or len(variables) != 1:
        raise NotInPlaceError
    uses = Removal(list(creation.statements), list(creation.splices), [site])
    remove_uses(analysis, variables[0], [site], uses)
    if uses.lines:
        raise NotInPlaceError
    created = {statement.id for statement in creation.statements}
    uses.statements = [each for each in uses.statements if each.id not in created]
    return variables[0], uses


def _publish(update: Replacement, variable: Variable, publications: Sequence[Publication]) -> bool:
    """Publish other messages in the lines that publish, at other rates where those may change."""
    added, analysis = update.added, update.analysis
    if any(each.is_once or each.reaction or each.parameter for each in publications):
        return False
    # What is sent at one rate stands together.
    rates = list(dict.fromkeys(each.rate for each in publications))
    publications = sorted(publications, key=lambda each: rates.index(each.rate))
    publishing = publishing_on(analysis, variable)
    sent = sent_by(analysis, publishing)
    if not len(publishing) == len(sent) == len(publications):
        return False
    for each, publication in zip(sent, publications, strict=True):
        messages, value = added.messages, publication.message.value
        if each.is_stamped != messages.needs_stamp(value):
            return False
        if any(computed_in(value)) and messages.message(value) and messages.conditions:
            return False
    if not _repace(update, sent, publications):
        return False
    before = len(update.splices)
    for each, publication in zip(sent, publications, strict=True):
        value = publication.message.value
        if is_message(analysis, added.messages.interfaces, each.expression, value):
            continue
        _stand(added, each.expression)
        update.put(each.expression, added.messages.message(value))
    replaced = update.splices[before:]
    served = Removal(splices=list(replaced))
    remove_what_served(analysis, served)
    update.splices += delete_statements(analysis.syntax.text, served.statements)
    update.splices += dict.fromkeys(served.splices[len(replaced) :])
    update.lost += parameters_in(analysis, update.splices[before:])
    added.stand(is_nested=True)
    return True


class _Runner(NamedTuple):
    """What runs statements again and again: a loop, or a timer.

    Attributes:
        block: the statements.
        pace: what says how often, None where nothing does literally.
        loop: the loop.
        timer: the timer.
        is_own: whether Plastron made it, for one rate.
    """

    block: Node
    pace: Pace | None
    loop: Node | None = None
    timer: Site | None = None
    is_own: bool = False


def _runner(added: Addition, statement: Node) -> _Runner | None:
    """Return what runs a statement as often as it runs itself."""
    analysis, block = added.analysis, statement.parent
    while block is not None and block.parent is not None and block.parent.type == "try_statement":
        block = block.parent.parent
    owner = block.parent if block is not None else None
    if block is None or owner is None:
        return None
    if owner.type == "while_statement" and is_loop(added, owner):
        return _Runner(block, loop_pace(analysis, owner), loop=owner)
    function = analysis.scopes.at(statement.start_byte).enclosing("function")
    if function is None or function.node.id != owner.id:
        return None
    timers = timers_of(analysis, function)
    if len(timers) != 1 or is_once(timers[0]):
        return None
    pace = timer_pace(analysis, timers[0])
    return _Runner(block, pace, timer=timers[0], is_own=is_named_as_own(function))


def _repace(update: Replacement, sent: Sequence[Sent], publications: Sequence[Publication]) -> bool:
    """Send at the rates that are asked for; False where something else would change with them."""
    rates: dict[int, tuple[_Runner, set[float]]] = {}
    for each, publication in zip(sent, publications, strict=True):
        runner = _runner(update.added, each.reference.statement)
        if runner is None:
            return False
        wanted = rates.setdefault(runner.block.id, (runner, set()))[1]
        if runner.is_own or not publication.is_rate_open:
            wanted.add(publication.rate)
    own = {statement.id for each in sent for statement in each.statements}
    for runner, wanted in rates.values():
        hertz = None if runner.pace is None else runner.pace.hertz(update.analysis)
        if all(hertz is not None and math.isclose(hertz, rate) for rate in wanted):
            continue
        if len(wanted) > 1 or not _does_only(update.added, runner.block, own):
            return False
        if not _set_rate(update, runner, wanted.pop()):
            return False
    return True


def _does_only(added: Addition, block: Node, own: set[int]) -> bool:
    """Whether a block only sends, and sleeps."""
    for statement in parts_of(block):
        body = statement.child_by_field_name("body")
        if statement.type == "try_statement" and body is not None:
            if not _does_only(added, body, own):
                return False
        elif not (
            statement.id in own or is_docstring(statement) or is_sleep(added.analysis, statement)
        ):
            return False
    return True


def _set_rate(update: Replacement, runner: _Runner, rate: float) -> bool:
    analysis, pace = update.analysis, runner.pace
    splice = None if pace is None else pace.set_to(analysis, rate)
    if pace is None or splice is None:
        return False
    if runner.loop is not None and is_shared(analysis, pace, runner.loop):
        return False
    update.splices.append(splice)
    if runner.timer is not None:
        given = runner.timer.endpoint
        start, end = pace.node.start_byte, pace.node.end_byte
        between = analysis.syntax.between
        changed = splice.text.decode(analysis.syntax.encoding)
        name = f"{between(start, splice.start)}{changed}{between(splice.end, end)}"
        update.lost.append(runner.timer)
        update.added.writer.endpoints.append(key_of(given._replace(expression=name)))
    return True


def _request(
    update: Replacement, variable: Variable, interface: Interface, requests: Sequence[Request]
) -> bool:
    """Send other requests in the calls that there are, where there are as many, as often."""
    uses = references(variable, update.analysis)
    given = [node for each in uses if (node := _request_in(update.analysis, each)) is not None]
    is_repeated = any(each.rate is not None for each in requests)
    if is_repeated or len(given) != len(requests):
        return False
    if any(repeats_call(update.analysis, node) for node in given):
        return False
    for node, request in zip(given, requests, strict=True):
        _stand(update.added, node)
        update.put(node, update.added.messages.request(interface, request.value))
    update.added.stand(is_nested=True)
    return True


def _request_in(analysis: Analysis, reference: Reference) -> Node | None:
    """Return the request that a use of a client sends, None where it sends none."""
    node, parent = reference.node, reference.node.parent
    if parent is None:
        return None
    if is_own_call(analysis, reference):
        return parts_of(parent)[1]
    callee = parent.child_by_field_name("function")
    if parent.type == "call" and callee is not None and callee.id == node.id:
        return only_argument(parent)
    name = parent.child_by_field_name("attribute")
    is_call = name is not None and analysis.syntax.slice(name) in _CALLS
    return only_argument(parent.parent) if is_call else None


def _stand(added: Addition, node: Node) -> None:
    scope = added.analysis.scopes.at(node.start_byte)
    added.stand(is_nested=scope.is_within(added.place.scope))
