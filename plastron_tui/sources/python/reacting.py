"""Sending something for each message of a topic, from the function of the file that gets it."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import NoReturn

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import Publication, Publisher
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind

from . import naming
from .addition import Addition
from .analysis import Analysis, Site
from .functions import callback_scope
from .hearing import Heard, NotHeardError, find_heard
from .messages import CannotAddError
from .place import climb, place_before
from .references import statement_of
from .sending import sending
from .splices import Splice, line_start


def place_before_hearing(added: Addition, node: Analysis) -> None:
    """Let a publisher be there before what it reacts to: rospy calls back at once."""
    endpoint = added.endpoint
    if added.is_rclpy or not isinstance(endpoint, Publisher):
        return
    for each in endpoint.publications:
        for site in _sites(node, each):
            statement = climb(statement_of(site.call))
            is_before = statement is not None and statement.start_byte < added.place.offset
            if statement is not None and is_before and added.is_beside(site):
                added.place = place_before(added.analysis, added.place, statement)


def shared(added: Addition, node: Analysis) -> list[str]:
    """Return the line that lets functions of the module see the publisher that `main` creates."""
    endpoint, module = added.endpoint, added.analysis.scopes.module
    if not isinstance(endpoint, Publisher) or "." in added.variable or added.place.scope is module:
        return []
    sites = [site for each in endpoint.publications for site in _sites(node, each)]
    hearing = [callback_scope(added.analysis, each) for each in sites]
    is_needed = any(each is not None and each.parent is module for each in hearing)
    return [f"global {added.variable}"] if is_needed else []


def react(added: Addition, node: Analysis, publisher: Publisher) -> None:
    """Send what a publisher sends for messages in the functions that hear these.

    Raises:
        CannotAddError: a message is to be sent by hand.
    """
    for each in publisher.publications:
        if each.reaction is None:
            continue
        try:
            _react(added, each, _sites(node, each))
        except NotHeardError as error:
            _refuse(added, each.reaction.topic, str(error))


def _react(added: Addition, publication: Publication, sites: list[Site]) -> None:
    assert publication.reaction is not None
    topic, type_ = publication.reaction.topic, sites[0].endpoint.type if sites else None
    heard = find_heard(added.analysis, sites)
    interface = added.messages.interface(type_, InterfaceKind.MESSAGE, topic)
    inside = _inside(added, heard)
    inside.heard = heard.message, interface
    inside.stand(is_nested=True)
    variable = added.free_name(f"{naming.words(added.name)}_message")
    lines = sending(inside, publication, variable, False)
    root = inside.place.receiver.partition(".")[0]
    is_used = bool(root) and any(re.search(rf"\b{root}\.", each) for each in lines)
    if is_used and heard.function.lookup(root) is None:
        raise NotHeardError(f"`{heard.function.name}` does not see `{root}`")
    added.writer.lines(heard.offset, heard.indent, lines)
    if heard.is_empty:
        text = added.analysis.syntax.text
        empty = Splice(line_start(text, heard.offset - 1), heard.offset)
        added.writer.splices += [empty] if empty not in added.writer.splices else []


def _sites(node: Analysis, publication: Publication) -> list[Site]:
    """Return the subscriptions of the topic that something is sent for."""
    if publication.reaction is None:
        return []
    topic = publication.reaction.topic
    return [
        each
        for each in node.sites
        if each.endpoint.kind is EndpointKind.SUBSCRIPTION
        and not each.shape.gives_message
        and topic in (each.endpoint.name, each.endpoint.default)
    ]


def _inside(added: Addition, heard: Heard) -> Addition:
    """Return what writes in a function as the addition does where it is itself.

    Raises:
        NotHeardError: the function does not see the publisher.
    """
    function, place = heard.function, added.place
    holder, dot, name = added.variable.partition(".")
    is_own = bool(dot) and place.owner is not None and holder == place.self_name
    variable, receiver = added.variable, added.receiver_in_callback()
    if is_own:
        is_seen = function.parent is place.owner and bool(function.self_name)
        variable = f"{function.self_name}.{name}"
        first, dot, rest = receiver.partition(".")
        receiver = f"{function.self_name}{dot}{rest}" if first == holder else receiver
    else:
        found = function.lookup(holder)
        module = added.analysis.scopes.module
        is_new = place.scope.lookup(holder) is None
        is_seen = found is not None and found == place.scope.lookup(holder)
        # What is new is shared with the functions of the module.
        is_seen = is_seen or (
            is_new and (function.is_within(place.scope) or function.parent is module)
        )
        receiver = place.receiver
    if not is_seen:
        raise NotHeardError(f"`{function.name}` does not see `{added.variable}`")
    owner = function.parent if function.self_name else None
    there = replace(
        place,
        offset=heard.offset,
        indent=heard.indent,
        scope=function,
        owner=owner,
        self_name=function.self_name,
        receiver=receiver,
        statement=heard.statement,
    )
    return replace(added, place=there, variable=variable)


def _refuse(added: Addition, topic: str, reason: str) -> NoReturn:
    message = f"`{added.name}` is not sent for each message of `{topic}`: {reason}"
    remedy = f"publish to `{added.name}` by hand in the function that hears `{topic}`"
    raise CannotAddError(codes.EDIT_REFUSED, message, added.endpoint.span, remedy)
