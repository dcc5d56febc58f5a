"""What a file sends through a publisher or a client, and how often."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from ..analysis import Analysis, Site
from ..scopes import CppFile, Function, Scope, Variable, last_name, scope_at
from ..timers import recreated, timer_details
from .leftovers import functions_of
from .pacing import set_period, set_rate
from .replacing import NotInPlaceError, Replacement
from .statements import is_inside, statement_of
from .uses import uses_of, word

_LOOPS = frozenset({"while_statement", "for_statement", "do_statement"})
_IDLE = re.compile(
    r"(?:ros::)?spinOnce\(|rclcpp::spin_some\(|\w+(?:->|\.)sleep\(|(?:ROS|RCLCPP)_[A-Z_]+\("
)
_HELPERS = frozenset({"ask", "call", "send_goal"})
PUBLISHING = frozenset({"publish"})
"""The methods that publish."""
_OWN = re.compile(r"_?(?:publish|call|send)(?:_|[A-Z])")


class Sent(NamedTuple):
    """A call that sends something.

    Attributes:
        file: the file that has it.
        scope: the scope that it is in.
        call: the call.
        statement: the statement that it is in.
        given: what it sends.
        variable: the local variable of the same block that it sends, None for another expression.
        is_helped: whether a function does it that Plastron writes, for any type.
    """

    file: CppFile
    scope: Scope
    call: Node
    statement: Node
    given: Node | None
    variable: Variable | None
    is_helped: bool = False


def sent_through(analysis: Analysis, variable: Variable, methods: frozenset[str]) -> Iterator[Sent]:
    """Yield the calls of some methods of what a variable holds.

    So does what hands it, with a message behind it, to a function that Plastron writes.
    """
    for file, node, scope in uses_of(analysis, variable):
        call = _called(file, node, methods)
        if call is None and methods is not PUBLISHING:
            call = _helped(analysis, file, node)
        statement = None if call is None else statement_of(call)
        if call is None or statement is None:
            continue
        listed = call.child_by_field_name("arguments")
        arguments = listed.named_children if listed is not None else []
        is_helped = any(is_inside(node, each) for each in arguments)
        given = arguments[-1 if is_helped else 0] if arguments else None
        message = None if given is None else _local(analysis, given, scope, statement)
        yield Sent(file, scope, call, statement, given, message, is_helped)


def _helped(analysis: Analysis, file: CppFile, node: Node) -> Node | None:
    """Return the call of a function that Plastron writes, which is given what a node names."""
    listed: Node | None = node.parent
    while listed is not None and listed.type == "pointer_expression":
        listed = listed.parent
    call = None if listed is None or listed.type != "argument_list" else listed.parent
    called = None if call is None else call.child_by_field_name("function")
    name = "" if called is None else file.syntax.word(called)
    return call if name in _HELPERS and name in analysis.unit.functions else None


def _called(file: CppFile, node: Node, methods: frozenset[str]) -> Node | None:
    """Return the call of one of some methods of what a node names."""
    holder: Node | None = node
    while holder is not None and holder.parent is not None:
        outer = holder.parent
        if outer.type == "field_expression":
            field = outer.child_by_field_name("field")
            if field is not None and field.id != holder.id:
                call = outer.parent
                is_call = call is not None and call.type == "call_expression"
                return call if is_call and file.syntax.word(field) in methods else None
        elif outer.type not in ("parenthesized_expression", "pointer_expression"):
            return None
        holder = outer
    return None


def _local(analysis: Analysis, given: Node, scope: Scope, statement: Node) -> Variable | None:
    node: Node | None = given
    while node is not None and node.type in ("pointer_expression", "call_expression"):
        if node.type == "pointer_expression":
            node = node.child_by_field_name("argument")
            continue
        called = node.child_by_field_name("function")
        listed = node.child_by_field_name("arguments")
        is_move = called is not None and scope.file.syntax.word(called) in ("std::move", "move")
        inner = listed.named_children if listed is not None and is_move else []
        node = inner[0] if len(inner) == 1 else None
    name = "" if node is None else last_name(node, scope)
    found = analysis.unit.lookup(name, scope, given.start_byte) if name else None
    if found is None or found.kind != "local" or found.node.parent is None:
        return None
    inside: Node | None = statement
    while inside is not None and inside.parent != found.node.parent:
        inside = inside.parent
    return found if inside is not None else None


class Runner(NamedTuple):
    """What runs statements again and again: a loop, or a timer.

    Attributes:
        block: the statements.
        timer: the timer, None for a loop.
        pace: the number of hertz of a loop as the file says it, None where it does not.
        scope: the scope of that.
        is_own: whether Plastron made it, for one rate.
    """

    block: Node
    timer: Site | None = None
    pace: Node | None = None
    scope: Scope | None = None
    is_own: bool = False

    def hertz(self, analysis: Analysis) -> float | None:
        """Return how often it runs, None where the file does not say it."""
        if self.timer is not None:
            period = timer_details(analysis, self.timer).period
            return 1 / period if period else None
        if self.pace is None or self.scope is None:
            return None
        known = analysis.evaluator.fold(self.pace, self.scope)
        number = None if known is None or known.is_default else known.number
        return float(number) if number else None

    def set_to(self, update: Replacement, hertz: float) -> None:
        """Let it run at another rate.

        Raises:
            NotInPlaceError: it does not say its rate as a literal.
        """
        if self.timer is not None:
            if self.timer.shape.name >= len(self.timer.arguments):
                raise NotInPlaceError
            given = self.timer.arguments[self.timer.shape.name]
            set_period(update, given, self.timer.place, hertz)
        elif self.pace is not None and self.scope is not None:
            set_rate(update, self.pace, self.scope, hertz)
        else:
            raise NotInPlaceError

    def does_only(self, file: CppFile, own: set[int]) -> bool:
        """Tell whether it only runs some statements, logs, and sleeps."""
        return all(
            each.id in own or each.type == "comment" or _IDLE.match(file.syntax.word(each))
            for each in self.block.named_children
        )


def runner_of(analysis: Analysis, sent: Sent) -> Runner | None:
    """Return what runs a statement as often as it runs itself."""
    block = sent.statement.parent
    owner = None if block is None else block.parent
    if block is None or owner is None or block.type != "compound_statement":
        return None
    if owner.type in _LOOPS:
        return _loop(analysis, sent, block)
    function = analysis.unit.function_of(sent.scope)
    if function is None or function.node.id != owner.id:
        return None
    timer = timer_of(analysis, function)
    if timer is None:
        return None
    return Runner(block, timer, is_own=_OWN.match(function.name) is not None)


def timer_behind(analysis: Analysis, sent: Sent) -> Site | None:
    """Return the timer whose function begins a sending in a thread, as Plastron writes it."""
    function = analysis.unit.function_of(sent.scope)
    found: set[Function] = set()
    for file in () if function is None else analysis.unit.files:
        for use in word(function.name).finditer(file.syntax.code) if function else ():
            other = scope_at(file, use.start()).around
            if other is not None and other.name.startswith("repeat_"):
                found.add(other)
    return timer_of(analysis, found.pop()) if len(found) == 1 else None


def _loop(analysis: Analysis, sent: Sent, block: Node) -> Runner | None:
    found = []
    for call in analysis.unit.calls.get("sleep", ()):
        statement = None if call.scope.file is not sent.file else statement_of(call.node)
        if statement is not None and statement.parent == block and call.receiver is not None:
            found.append(call)
    if len(found) != 1:
        return None
    call = found[0]
    held = analysis.holding.of(call.receiver, call.scope)
    if held is None or not held.arguments or len(held.variables) != 1:
        return None
    if sum(1 for _ in uses_of(analysis, held.variables[0])) != 1:
        return Runner(block)
    return Runner(block, None, held.arguments[0], held.scope)


def timer_of(analysis: Analysis, function: Function) -> Site | None:
    """Return the timer that alone calls a function."""
    found = []
    again = recreated(analysis, analysis.sites)
    for site in analysis.sites:
        if site.endpoint.kind is not EndpointKind.TIMER or site in again:
            continue
        if timer_details(analysis, site).is_oneshot:
            continue
        at = site.shape.callback
        given = site.arguments[at] if at is not None and at < len(site.arguments) else None
        is_lambda = is_inside(function.node, given) and site.file is function.file
        named = [each for listed in functions_of(analysis, site) for each in listed]
        if is_lambda or function in named:
            found.append(site)
    return found[0] if len(found) == 1 else None


def is_rate(one: float | None, other: float) -> bool:
    """Tell whether a rate is known, and is another one."""
    return one is not None and math.isclose(one, other)
