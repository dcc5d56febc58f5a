"""The calls of a file that wait: for an answer, for time to pass, for whatever spins."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.code_facts import Wait
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.constants import Known
from plastron_tui.sources.python.scopes import BindingKind, Scope
from plastron_tui.sources.retries import is_short_retry
from plastron_tui.sources.unreachable import is_unreachable

from .called_back import function_in, running_scope
from .callers import future_of
from .objects import Making, Objects

_SLEEPS = frozenset({"time.sleep", "rospy.sleep", "rospy.timer.sleep"})
_DURATIONS = frozenset(
    f"{module}.Duration" for module in ("genpy", "genpy.rostime", "rospy", "rospy.rostime")
)
_NAMES = frozenset(
    {"call", "done", "get_result", "send_goal", "sleep", "sleep_for", "sleep_until", "spin"}
    | {"spin_once", "spin_until_future_complete", "wait"}
)
_ANSWERS = {
    "call_async": EndpointKind.CLIENT,
    "send_goal_async": EndpointKind.ACTION_CLIENT,
}
_ENDLESS = re.compile(rb"True|1|(?:\w+\.)*ok\([^()]*\)")
_OF_A_GOAL = frozenset({"get_result_async", "cancel_goal_async"})
_LEAVING = re.compile(rb"\b(?:break|return|raise|await)\b")
_LOGICAL = frozenset({"not_operator", "boolean_operator", "parenthesized_expression"})
_WORDS = re.compile(
    rb"\.call\(|\.done\(\s*\)|sleep|\.get_result\(|\.send_goal\(|\.wait\(|\bspin(?:_once|_until_future_complete)?\("
)


class Waiting(NamedTuple):
    """A call that waits.

    Attributes:
        wait: what it waits for.
        call: the call.
        sites: the endpoints that bring what it waits for.
        node: the node that it lets spin meanwhile, None for none.
        seconds: how long it sleeps, None where that is not known.
        is_rate: whether it waits for a timer of rclpy.
    """

    wait: Wait
    call: Node
    sites: tuple[Site, ...] = ()
    node: Node | None = None
    seconds: float | None = None
    is_rate: bool = False


def may_wait(analysis: Analysis) -> bool:
    """Tell whether a file has the words of what waits."""
    return _WORDS.search(analysis.syntax.text) is not None


class WaitingCalls:
    """The calls of a file that wait."""

    def __init__(self, analysis: Analysis, objects: Objects) -> None:
        self._analysis = analysis
        self._objects = objects
        self._action_clients = tuple(
            site
            for site in analysis.first_sites()
            if site.endpoint.kind is EndpointKind.ACTION_CLIENT
        )

    def all(self) -> Iterator[Waiting]:
        """Yield them."""
        syntax = self._analysis.syntax
        for call in self._analysis.captures.get("call", []):
            name = syntax.called_name(call)
            if name in _NAMES and not is_unreachable(call):
                found = self._waiting(call, name, running_scope(self._analysis, call))
                if found is not None:
                    yield found

    def _waiting(self, call: Node, name: str, scope: Scope) -> Waiting | None:
        callee = call.child_by_field_name("function")
        holder = callee.child_by_field_name("object") if callee is not None else None
        match name:
            case "call":
                sites = self._of_kind(holder, scope, EndpointKind.CLIENT)
                return Waiting(Wait.SERVICE, call, sites) if sites else None
            case "send_goal":
                sites = self._of_kind(holder, scope, EndpointKind.ACTION_CLIENT)
                return Waiting(Wait.ACTION, call, sites) if sites else None
            case "get_result":
                sites = self._of_handle(holder, scope)
                return Waiting(Wait.ACTION, call, sites) if sites else None
            case "done":
                return self._polled(call, holder, scope)
            case "wait":
                return self._woken(call, holder, scope)
            case "sleep":
                return self._slept(call, holder, scope)
            case "sleep_for" | "sleep_until":
                return self._slept_by_clock(call, holder, scope)
            case _:
                return self._spun(call, name, scope)

    def _of_kind(self, holder: Node | None, scope: Scope, kind: EndpointKind) -> tuple[Site, ...]:
        sites = self._objects.sites(holder, scope)
        return sites if all(site.endpoint.kind is kind for site in sites) else ()

    def _of_handle(self, handle: Node | None, scope: Scope) -> tuple[Site, ...]:
        """Return the clients that the handle of a goal in rclpy is of; none where that is not sure.

        A handle is what the future of a goal has, and a done callback gets that future.
        """
        analysis = self._analysis
        made = self._objects.makings(handle, scope) if analysis.library.node_classes else ()
        found: list[Site] = []
        for each in made:
            callee = each.call.child_by_field_name("function")
            future = callee.child_by_field_name("object") if callee is not None else None
            if future is None or analysis.syntax.called_name(each.call) != "result":
                return ()
            function = each.scope.enclosing("function")
            bound = [] if function is None else function.bindings.get(analysis.syntax.slice(future))
            at = each.scope
            if function is not None and bound and bound[0].kind is BindingKind.PARAMETER:
                future = future_of(analysis, function) if len(bound) == 1 else None
                at = at if future is None else analysis.scopes.at(future.start_byte)
            asked = {
                analysis.syntax.called_name(each.call) for each in self._objects.makings(future, at)
            }
            sites = self._answers(future, at) if asked == {"send_goal_async"} else ()
            if not sites:
                return ()
            found += sites
        return tuple(found)

    def _answers(self, future: Node | None, scope: Scope) -> tuple[Site, ...]:
        """Return the endpoints that bring the result of a future; none where that is not known."""
        found: list[Site] = []
        made = self._objects.makings(future, scope)
        for each in made:
            sites = self._bringing(each)
            if not sites:
                return ()
            found += sites
        return tuple(found)

    def _bringing(self, made: Making) -> tuple[Site, ...]:
        name = self._analysis.syntax.called_name(made.call)
        if name in _OF_A_GOAL:
            return self._action_clients
        kind = _ANSWERS.get(name)
        callee = made.call.child_by_field_name("function")
        holder = callee.child_by_field_name("object") if callee is not None else None
        return () if kind is None else self._of_kind(holder, made.scope, kind)

    def _polled(self, call: Node, holder: Node | None, scope: Scope) -> Waiting | None:
        """Return the wait of a loop that only goes on until a future is done."""
        loop = _loop_until(call)
        if loop is None:
            return None
        sites = self._answers(holder, scope)
        body = loop.child_by_field_name("body")
        spun = call if body is not None and b"spin" in (body.text or b"") else None
        return Waiting(Wait.SERVICE, call, sites, spun) if sites else None

    def _woken(self, call: Node, holder: Node | None, scope: Scope) -> Waiting | None:
        """Return the wait for an event that only the done callback of a future sets."""
        analysis = self._analysis
        if holder is None or b"add_done_callback" not in analysis.syntax.text:
            return None
        made = self._objects.makings(holder, scope)
        if {analysis.syntax.called_name(each.call) for each in made} != {"Event"}:
            return None
        setting = (holder.text or b"") + b".set"
        found: list[Site] = []
        count = 0
        for other in analysis.captures.get("call", []):
            if analysis.syntax.called_name(other) != "add_done_callback":
                continue
            callee = other.child_by_field_name("function")
            given = Arguments.of(other, analysis.syntax).get(Argument(0, "callback"))
            at = running_scope(analysis, other)
            function = None if given is None else function_in(given, at, analysis)
            body = given if function is None else function.node
            if body is not None and setting in (body.text or b""):
                count += (body.text or b"").count(setting)
                found += self._answers(
                    callee.child_by_field_name("object") if callee is not None else None, at
                )
        is_all = count == analysis.syntax.text.count(setting)
        return Waiting(Wait.SERVICE, call, tuple(found)) if found and is_all else None

    def _slept(self, call: Node, holder: Node | None, scope: Scope) -> Waiting | None:
        analysis = self._analysis
        names = analysis.resolver.qualified(call.child_by_field_name("function"), scope)
        if _SLEEPS.intersection(names):
            given = Arguments.of(call, analysis.syntax).get(Argument(0, "secs"))
            length = self._seconds(given, scope)
            is_retry = is_short_retry(call, length)
            return None if is_retry else Waiting(Wait.SLEEP, call, seconds=length)
        made = self._objects.makings(holder, scope) if holder is not None else ()
        makers = {analysis.syntax.called_name(each.call) for each in made}
        if makers == {"create_rate"}:
            return Waiting(Wait.SLEEP, call, is_rate=True)
        if makers == {"Rate"} and analysis.library.module == "rospy" and len(made) == 1:
            given = Arguments.of(made[0].call, analysis.syntax).get(Argument(0, "hz"))
            hertz = self._number(given, made[0].scope)
            return Waiting(Wait.SLEEP, call, seconds=1 / hertz if hertz else None)
        return None

    def _slept_by_clock(self, call: Node, holder: Node | None, scope: Scope) -> Waiting | None:
        """Return the wait of `node.get_clock().sleep_for(…)`."""
        made = self._objects.makings(holder, scope) if holder is not None else ()
        makers = {self._analysis.syntax.called_name(each.call) for each in made}
        return Waiting(Wait.SLEEP, call) if makers and makers <= {"get_clock", "Clock"} else None

    def _seconds(self, node: Node | None, scope: Scope) -> float | None:
        """Return how long a number, or a duration of rospy, is."""
        made = self._objects.makings(node, scope)
        if len(made) != 1:
            return self._number(node, scope)
        call, at = made[0]
        callee = call.child_by_field_name("function")
        arguments = Arguments.of(call, self._analysis.syntax)
        if _DURATIONS.isdisjoint(self._analysis.resolver.qualified(callee, at)):
            return self._number(node, scope)
        if arguments.is_open:
            return None
        seconds = self._number(arguments.get(Argument(0, "secs")), at)
        nanoseconds = arguments.get(Argument(1, "nsecs"))
        more = 0 if nanoseconds is None else self._number(nanoseconds, at)
        return None if seconds is None or more is None else seconds + more * 1e-9

    def _number(self, node: Node | None, scope: Scope) -> float | None:
        folded = self._analysis.resolver.fold(node, scope)
        value = folded.value if isinstance(folded, Known) else None
        return float(value) if isinstance(value, int | float) else None

    def _spun(self, call: Node, name: str, scope: Scope) -> Waiting | None:
        """Return the wait of what spins until a future is done, or until all ends."""
        analysis = self._analysis
        names = analysis.resolver.qualified(call.child_by_field_name("function"), scope)
        if name == "spin":
            return Waiting(Wait.SPIN, call, node=call) if "rclpy.spin" in names else None
        if name != "spin_until_future_complete":
            return None
        is_function = f"rclpy.{name}" in names
        arguments = Arguments.of(call, analysis.syntax)
        future = arguments.get(Argument(1 if is_function else 0, "future"))
        sites = self._answers(future, scope)
        return Waiting(Wait.SPIN, call, sites, call) if sites else None


def _loop_until(call: Node) -> Node | None:
    """Return the loop that a call of `done` ends, if it is all that does.

    `while not future.done()`, or `while rclpy.ok()` with `if future.done(): break`.
    """
    inner, above = call, call.parent
    while above is not None and above.type in _LOGICAL:
        inner, above = above, above.parent
    if above is None:
        return None
    text = inner.text or b""
    if above.type == "while_statement":
        body = above.child_by_field_name("body")
        is_left = body is None or _LEAVING.search(body.text or b"")
        is_negated = re.search(rb"\bnot\s+[\w.]+\.done\(", text) and b" or " not in text
        return above if is_negated and not is_left else None
    block = above.parent
    loop = block.parent if block is not None and block.type == "block" else None
    if above.type != "if_statement" or inner is not call or block is None or loop is None:
        return None
    if loop.type != "while_statement" or _LEAVING.search(above.text or b"") is None:
        return None
    others = (each for each in block.named_children if each.id != above.id)
    condition = loop.child_by_field_name("condition")
    is_endless = condition is not None and _ENDLESS.fullmatch(condition.text or b"") is not None
    return loop if is_endless and not any(_LEAVING.search(o.text or b"") for o in others) else None
