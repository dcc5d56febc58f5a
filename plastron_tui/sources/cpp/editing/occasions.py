"""When a file sends a message: once, or for each that it hears."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.kinds import Publication
from plastron_tui.model.kinds.reaction import Condition, Reaction
from plastron_tui.model.source import EndpointKind
from plastron_tui.model.values import computed_in
from plastron_tui.ros.interfaces import Field, InterfaceKind

from .. import literals
from ..scopes import Function, Variable
from .computing import computing_for
from .creation import creation_of
from .refilling import addition_at
from .refusals import RefusedError
from .replacing import NotInPlaceError, Replacement
from .sent import Sent, timer_of

_LOOPS = frozenset({"while_statement", "for_statement", "do_statement", "for_range_loop"})


class Heard(NamedTuple):
    """What a message is sent for.

    Attributes:
        holder: what stands before a field of it, "" where it has no name.
        fields: its fields.
    """

    holder: str = ""
    fields: Sequence[Field] = ()


def check_once(update: Replacement, sent: Sent) -> None:
    """Check that a message is sent once, and kept for those who listen later.

    Raises:
        NotInPlaceError: that is not known.
    """
    analysis, qos = update.analysis, update.site.endpoint.qos
    function = analysis.unit.function_of(sent.scope)
    if function is None or qos is None or qos.durability != "transient_local":
        raise NotInPlaceError
    body = function.file.syntax.code[function.node.start_byte : function.node.end_byte]
    if timer_of(analysis, function) is not None and b"->cancel()" in body:
        return
    creation = creation_of(analysis, update.site)
    maker = None if creation is None else analysis.unit.function_of(update.site.call.scope)
    if function is not maker:
        calls = analysis.callers.of(function)
        if len(calls) != 1 or analysis.unit.function_of(calls[0].scope) is not maker:
            raise NotInPlaceError
        _check_straight(calls[0].node)
    _check_straight(sent.call)


def _check_straight(node: Node) -> None:
    """Check that something is done once where its function runs."""
    inner: Node | None = node
    while inner is not None and inner.type != "function_definition":
        if inner.type in _LOOPS or inner.type == "lambda_expression":
            raise NotInPlaceError
        inner = inner.parent


def heard_for(
    update: Replacement, sent: Sent, publication: Publication, reaction: Reaction
) -> Heard:
    """Return what a message is sent for, under the condition that is asked for from then on.

    Raises:
        NotInPlaceError: it is sent for something else.
    """
    analysis = update.analysis
    sites = [
        site
        for site in analysis.sites
        if site.endpoint.kind is EndpointKind.SUBSCRIPTION and site.endpoint.name == reaction.topic
    ]
    hearing = {each for site in sites for each in site.callback.functions if each.scope is not None}
    function = analysis.unit.function_of(sent.scope)
    type_ = sites[0].endpoint.type if len(sites) == 1 else None
    interface = None if type_ is None else update.catalog.find(type_, InterfaceKind.MESSAGE)
    if function is None or interface is None or not function.parameters:
        raise NotInPlaceError
    callers = {analysis.unit.function_of(each.scope) for each in analysis.callers.of(function)}
    if function not in hearing and not (callers and callers <= hearing):
        raise NotInPlaceError
    parameter = function.parameters[0]
    if not parameter.name and any(computed_in(publication.message.value)):
        raise NotInPlaceError
    heard = Heard(field_of(parameter), interface.fields)
    _set_condition(update, sent, function, heard, reaction.condition)
    return heard


def field_of(parameter: Variable) -> str:
    """Return what stands before a field of a parameter."""
    text = parameter.file.syntax.word(parameter.node)
    is_pointer = parameter.is_pointer or "Ptr" in text or "_ptr" in text
    return f"{parameter.name}{'->' if is_pointer else '.'}" if parameter.name else ""


def _set_condition(
    update: Replacement, sent: Sent, function: Function, heard: Heard, condition: Condition | None
) -> None:
    """Let the one `if` around what sends ask for a condition.

    Raises:
        NotInPlaceError: there is none, or it rules something else as well.
    """
    found = list(_conditions(sent.statement, function))
    if condition is None and not found:
        return
    if condition is None or len(found) != 1 or not heard.holder:
        raise NotInPlaceError
    added = addition_at(update)
    try:
        computing, conditions = computing_for(added, added.span)
        written = literals.scalar(condition.value)
        text = computing.condition(condition, heard.holder, heard.fields, written)
    except RefusedError:
        raise NotInPlaceError from None
    asked = found[0].child_by_field_name("condition")
    if asked is None or conditions or found[0].child_by_field_name("alternative") is not None:
        raise NotInPlaceError
    syntax = sent.file.syntax
    start, end = asked.start_byte + 1, asked.end_byte - 1
    if "".join(syntax.between(start, end).split()) == "".join(text.split()):
        return
    body = found[0].child_by_field_name("consequence")
    if body is None or body.named_children[-1:] != [sent.statement]:
        raise NotInPlaceError
    update.put_between(sent.file, start, end, text)


def _conditions(statement: Node, function: Function) -> Iterator[Node]:
    inner: Node | None = statement
    while inner is not None and inner.id != function.node.id:
        if inner.type == "if_statement":
            yield inner
        elif inner.type in (*_LOOPS, "else_clause", "switch_statement"):
            raise NotInPlaceError
        inner = inner.parent
