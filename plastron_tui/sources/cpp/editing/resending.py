"""Publishing other values through a publisher of a file, in the lines that set them."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.kinds import Publication, Publisher, is_sending
from plastron_tui.model.source import EndpointKind
from plastron_tui.model.values import MessageValue

from .. import literals
from ..analysis import Site
from ..scopes import Function, Scope, Variable
from ..timers import recreated
from .creation import creation_of
from .leftovers import functions_of
from .pacing import set_period
from .replacing import NotInPlaceError, Replacement
from .statements import calls_method, local_of, statement_of
from .uses import uses_of

_PUBLISH = frozenset({"publish"})


def resend(update: Replacement) -> None:
    """Write other constants for those that a publisher publishes.

    Raises:
        NotInPlaceError: the lines that publish are to be written anew.
    """
    endpoint = update.change.endpoint
    if not isinstance(endpoint, Publisher) or not is_sending(endpoint):
        return
    creation = creation_of(update.analysis, update.site)
    variable = None if creation is None else creation.variable
    if variable is None or len(endpoint.publications) != 1:
        raise NotInPlaceError
    publication = endpoint.publications[0]
    if publication.is_once or publication.reaction or publication.parameter:
        raise NotInPlaceError
    published = list(_published(update, variable))
    if len(published) != 1:
        raise NotInPlaceError
    statement, scope = published[0]
    message = local_of(update.analysis, statement, scope)
    if message is None:
        raise NotInPlaceError
    _set_fields(update, message, publication.message.value)
    if not publication.is_rate_open:
        _set_rate(update, statement, scope, publication)


def _published(update: Replacement, variable: Variable) -> Iterator[tuple[Node, Scope]]:
    for file, node, scope in uses_of(update.analysis, variable):
        statement = statement_of(node)
        if statement is not None and calls_method(statement, node, file.syntax, _PUBLISH):
            yield statement, scope


def _set_fields(update: Replacement, message: Variable, value: MessageValue) -> None:
    """Write the values of the fields that the lines of a message set, and no others."""
    wanted = dict(_flat(value))
    said: dict[str, tuple[Node, Scope]] = {}
    for node, path, given, scope in update.analysis.fields.of(message.name):
        if update.analysis.unit.lookup(message.name, scope, node.start_byte) is message:
            if path in said:
                raise NotInPlaceError
            said[path] = given, scope
    if set(said) != set(wanted):
        raise NotInPlaceError
    for path, (given, scope) in said.items():
        new = wanted[path]
        known = update.analysis.evaluator.fold(given, scope)
        if known is not None and known.value == new and type(known.value) is type(new):
            continue
        if isinstance(new, tuple | MessageValue) or known is None or not _is_literal(given):
            raise NotInPlaceError
        assert isinstance(new, bool | int | float | str), "what is computed is no constant"
        update.put(scope.file, given, literals.scalar(new))


def _flat(value: MessageValue, prefix: str = "") -> Iterator[tuple[str, object]]:
    for name, each in value.fields.items():
        if isinstance(each, MessageValue):
            yield from _flat(each, f"{prefix}{name}.")
        else:
            if not isinstance(each, bool | int | float | str):
                raise NotInPlaceError
            yield prefix + name, each


def _is_literal(node: Node) -> bool:
    inner = node.child_by_field_name("argument") if node.type == "unary_expression" else node
    kinds = ("number_literal", "string_literal", "true", "false")
    return inner is not None and inner.type in kinds


def _set_rate(update: Replacement, statement: Node, scope: Scope, publication: Publication) -> None:
    """Write another rate for the timer, or the loop, that publishes alone."""
    function = update.analysis.unit.function_of(scope)
    timer = _timer_of(update, function)
    if timer is None or timer.shape.name >= len(timer.arguments):
        raise NotInPlaceError
    period = getattr(timer.endpoint.details, "period", None)
    if period and math.isclose(1 / period, publication.rate):
        return
    others = [
        each
        for each in _statements(function)
        if each.id != statement.id and b"publish" in (each.text or b"")
    ]
    if others:
        raise NotInPlaceError
    set_period(update, timer.arguments[timer.shape.name], timer.place, publication.rate)


def _statements(function: Function | None) -> list[Node]:
    body = None if function is None else function.node.child_by_field_name("body")
    return [] if body is None else body.named_children


def _timer_of(update: Replacement, function: Function | None) -> Site | None:
    """Return the timer that calls a function."""
    if function is None:
        return None
    found = []
    again = recreated(update.analysis, update.analysis.sites)
    for site in update.analysis.sites:
        if site.endpoint.kind is not EndpointKind.TIMER or site in again:
            continue
        at = site.shape.callback
        given = site.arguments[at] if at is not None and at < len(site.arguments) else None
        is_lambda = (
            given is not None
            and given.start_byte <= function.node.start_byte < given.end_byte
            and site.file is function.file
        )
        named = [each for listed in functions_of(update.analysis, site) for each in listed]
        if is_lambda or function in named:
            found.append(site)
    return found[0] if len(found) == 1 else None
