"""The one loop or timer of a node in which it does what it does again and again."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from ..arguments import Call
from ..scopes import CppFile
from ..timers import recreated, timer_details
from .adding import Addition

_LOOPS = frozenset({"while_statement", "for_statement", "do_statement"})
_WAITS = re.compile(r"(?:ros::)?spinOnce\(|\w+(?:->|\.)sleep\(|rclcpp::spin_some\(|\+\+|\w+\+\+")


class Turn(NamedTuple):
    """A block that runs at a rate.

    Attributes:
        file: the file that has it.
        owner: the function definition, or the loop.
        body: the block.
        before: the statement before which something more is done, None for the end.
        rate: in hertz, None where the file does not say it.
    """

    file: CppFile
    owner: Node
    body: Node
    before: Node | None
    rate: float | None


def own_turn(added: Addition) -> Turn | None:
    """Return the block, None where the node has none, several, or one that may be left."""
    found = [*_timers(added), *_loops(added)]
    if len(found) != 1 or found[0] is None:
        return None
    return found[0]


def _timers(added: Addition) -> Iterator[Turn | None]:
    again = recreated(added.analysis, added.sites)
    for site in added.sites:
        if site.endpoint.kind is not EndpointKind.TIMER or site in again:
            continue
        details = timer_details(added.analysis, site)
        if details.is_oneshot:
            continue
        functions = [each for each in site.callback.functions if each.scope is not None]
        functions = [each for each in functions if not each.file.is_beside]
        owners = {id(added.analysis.unit.class_of_function(each)) for each in functions}
        if len(functions) != 1 or owners != {id(added.owner)} or added.owner is None:
            yield None
            continue
        function = functions[0]
        body = function.body
        if body is None or may_leave(body):
            yield None
            continue
        is_sure = details.period is not None and details.period > 0 and not details.is_guess
        rate = 1 / details.period if is_sure and details.period else None
        yield Turn(function.file, function.node, body, None, rate)


def may_leave(body: Node) -> bool:
    """Tell whether a function may end before its last statement."""
    stack = [body]
    while stack:
        node = stack.pop()
        if node.type in ("return_statement", "throw_statement", "goto_statement"):
            return True
        stack += [each for each in node.named_children if each.type != "lambda_expression"]
    return False


def _loops(added: Addition) -> Iterator[Turn | None]:
    seen = set()
    for call in added.analysis.unit.calls.get("sleep", ()):
        type_ = added.analysis.receivers.type_of(call.receiver, call.scope)
        is_rate = type_.endswith("Rate") and not call.scope.file.is_beside
        if not is_rate or call.receiver is None:
            continue
        loop: Node | None = call.node
        while loop is not None and loop.type not in _LOOPS:
            loop = (
                None if loop.type in ("function_definition", "lambda_expression") else loop.parent
            )
        if loop is None or loop.id in seen:
            continue
        seen.add(loop.id)
        yield _loop(added, call, loop)


def _loop(added: Addition, call: Call, loop: Node) -> Turn | None:
    function = added.analysis.unit.function_of(call.scope)
    body = loop.child_by_field_name("body")
    if function is None or body is None or body.type != "compound_statement":
        return None
    owner = added.analysis.unit.class_of_function(function)
    is_seen = owner is added.owner and owner is not None
    if owner is None and added.owner is None:
        is_seen = function is added.place.function and loop.start_byte >= added.place.offset
    if not is_seen:
        return None
    file = call.scope.file
    statements = body.named_children
    at = len(statements)
    while at and _WAITS.match(file.syntax.word(statements[at - 1])):
        at -= 1
    if at == len(statements):
        return None
    held = added.analysis.holding.of(call.receiver, call.scope)
    given = held.arguments[0] if held is not None and held.arguments else None
    value = added.analysis.evaluator.fold(given, held.scope) if held and given else None
    number = value.number if value is not None and not value.is_default else None
    return Turn(file, loop, body, statements[at], float(number) if number else None)
