"""Calls that wait in functions which an executor calls.

Sources: `rclcpp/executor.cpp` of Jazzy: a node is added to one executor at a time, and of a
group that excludes others one callback is called at a time; `ros/callback_queue.cpp` of Noetic.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.code_facts import Blocking, Wait
from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.arguments import Call, call_of
from plastron_tui.sources.cpp.durations import seconds
from plastron_tui.sources.cpp.holders import holder_of
from plastron_tui.sources.cpp.node_sites import nodelets
from plastron_tui.sources.cpp.scopes import Scope, Variable, last_name
from plastron_tui.sources.ending import ends_after, is_pause
from plastron_tui.sources.retries import is_short_retry
from plastron_tui.sources.unreachable import is_unreachable

from .called_back import CallbackBodies, CalledBack, is_in_default_group, is_of_same_node
from .parameter_clients import ASKING, ASYNC, SYNC, is_of, own_client
from .places import span_of

_SPINNING = frozenset({"spin", "spin_some", "spin_until_future_complete"})
_LETTING = frozenset({"callAvailable", "callOne", "spinOnce", "spin_once", "spin_some"})
_WAITING = frozenset({"get", "wait", "wait_for", "wait_until"})
_SLEEPING = frozenset({"sleep", "sleep_for", "sleep_until", "usleep"})
_ASKING = {
    "async_send_request": (EndpointKind.CLIENT, Wait.SERVICE),
    "async_send_goal": (EndpointKind.ACTION_CLIENT, Wait.ACTION),
    "async_get_result": (EndpointKind.ACTION_CLIENT, Wait.ACTION),
    "async_cancel_goal": (EndpointKind.ACTION_CLIENT, Wait.ACTION),
}
_ITSELF = re.compile(
    r"(?:this->)?(?:shared_from_this\(\)|get_node_base_interface\(\))"
    r"|(?:this->)?shared_from_this\(\)->get_node_base_interface\(\)"
)
_HELD = re.compile(r"(?:this->)?(\w+)(?:->get_node_base_interface\(\))?")
_SLEPT_BY = re.compile(r"(?:rclcpp|ros)::(?:Wall)?(?:Rate|Duration)(?:Base)?")
_THREADS = re.compile(rb"MultiThreaded|AsyncSpinner|CallbackQueue|MTNodeHandle|MTPrivate")
_GROUPS = re.compile(rb"callback_?group", re.IGNORECASE)
_NAMES = _SPINNING | _WAITING | _SLEEPING | ASKING


class _Waiting(NamedTuple):
    """A call that waits.

    Attributes:
        wait: what it waits for.
        call: the call.
        sites: the clients that bring it.
        is_endless: whether it never comes, whoever brings it.
        seconds: how long it sleeps, None where that is not known.
        owner: the class whose node has the client of parameters that brings it, None for others.
    """

    wait: Wait
    call: Call
    sites: tuple[Site, ...] = ()
    is_endless: bool = False
    seconds: float | None = None
    owner: Scope | None = None


def blocking(analysis: Analysis, bodies: CallbackBodies) -> Iterator[Blocking]:
    """Yield the calls that wait in callbacks, each for the first callback that makes it."""
    if not any(name in analysis.unit.calls for name in _NAMES):
        return
    found: dict[tuple[str, int], Blocking] = {}
    waits = _Waits(analysis, bodies)
    for callback in bodies.all:
        if is_pause(callback.body.node):
            continue
        reached = list(bodies.reached(callback.body).values())
        # What spins meanwhile lets others be called.
        is_spinning = any(waits.spins(scope) for scope, _ in reached)
        for scope, calls in reached:
            for waiting in waits.of(scope):
                is_sleep = waiting.wait is Wait.SLEEP
                if is_sleep and (is_spinning or _is_at_the_end(waiting.call, calls)):
                    continue
                key = scope.file.name, waiting.call.node.start_byte
                fact = waits.judged(waiting, callback)
                if fact is not None and key not in found:
                    found[key] = fact
    yield from (found[key] for key in sorted(found))


def _is_at_the_end(call: Call, calls: tuple[Call, ...]) -> bool:
    """Tell whether the program ends after a call, or after those that lead to it."""
    return any(ends_after(each.node) for each in (call, *calls))


def _inside(call: Call, callback: CalledBack) -> str:
    """Return the function that makes a call, "" where that is the callback itself."""
    body = call.scope.enclosing("function", "lambda")
    return "" if body is None or body is callback.body else body.name


def _is_repeated(node: Node) -> bool:
    """Tell whether a call is in the condition of a loop that goes on until something comes."""
    while node.parent is not None and node.type != "compound_statement":
        parent = node.parent
        if parent.type in ("while_statement", "do_statement"):
            condition = parent.child_by_field_name("condition")
            return condition is not None and condition.id == node.id
        node = parent
    return False


class _Waits:
    """The calls of a unit that wait."""

    def __init__(self, analysis: Analysis, bodies: CallbackBodies) -> None:
        self._a = analysis
        self._bodies = bodies
        self._found: dict[int, list[_Waiting]] = {}
        files = [file.syntax for file in analysis.unit.files]
        self._has_threads = any(each.has(_THREADS) for each in files)
        self._has_groups = any(each.has(_GROUPS) for each in files)
        spins = (*analysis.unit.calls.get("spin", ()), *analysis.unit.calls.get("spinOnce", ()))
        # The manager of nodelets gives those of one nodelet to one thread at a time.
        is_nodelet = bool(nodelets(analysis)) if analysis.ros_version == 1 else False
        self._is_one_thread = is_nodelet or any(call.qualifier == "ros" for call in spins)

    def of(self, body: Scope) -> list[_Waiting]:
        """Return the calls that a function makes itself."""
        if id(body) not in self._found:
            calls = self._bodies.calls_in.get(id(body), ())
            waiting = (call for call in calls if call.name in _NAMES)
            found = (self._waiting(c) for c in waiting if not is_unreachable(c.node))
            self._found[id(body)] = [each for each in found if each is not None]
        return self._found[id(body)]

    def spins(self, body: Scope) -> bool:
        """Tell whether a function itself lets callbacks be called."""
        return any(call.name in _LETTING for call in self._bodies.calls_in.get(id(body), ()))

    def judged(self, waiting: _Waiting, callback: CalledBack) -> Blocking | None:
        """Return what a wait does in a callback, None where it may be harmless."""
        is_default = self._is_in_default_group(callback.site)
        is_endless = waiting.is_endless
        if waiting.wait is Wait.SLEEP:
            # In ROS 1 the main thread calls one function after the other, but for actions.
            is_action = callback.site.endpoint.kind is EndpointKind.ACTION_SERVER
            is_alone = self._a.ros_version == 2 or (self._is_one_thread and not is_action)
            if self._has_threads or self._has_groups or not is_alone:
                return None
        elif waiting.owner is not None:
            is_own = is_of(self._a, callback.site, waiting.owner)
            is_endless = is_own and (waiting.wait is Wait.SPIN or is_default)
            if not is_endless:
                return None
        elif waiting.wait is Wait.SPIN:
            if not self._is_own_node(waiting.call, callback.site):
                return None
        else:
            is_endless = is_default and all(
                self._is_in_default_group(site) and is_of_same_node(site, callback.site)
                for site in waiting.sites
            )
            if not is_endless:
                return None
        call = waiting.call
        return Blocking(
            waiting.wait,
            callback.name,
            callback.site.endpoint.kind,
            span_of(call.node),
            call.scope.file.name,
            is_endless,
            waiting.seconds,
            callback.site.call.node.start_byte,
            _inside(call, callback),
        )

    def _is_in_default_group(self, site: Site) -> bool:
        if is_in_default_group(site):
            return True
        # Options without a word of groups leave the endpoint where it is.
        syntax = site.place.file.syntax
        given = (syntax.slice(each) for each in site.arguments)
        return not self._has_groups and not any("group" in each for each in given)

    def _waiting(self, call: Call) -> _Waiting | None:
        if call.name in _SLEEPING:
            return self._slept(call)
        if self._a.ros_version == 1:
            return None
        if call.name in _SPINNING:
            return self._spun(call)
        if call.name in ASKING:
            owner = own_client(self._a, call, SYNC)
            return None if owner is None else _Waiting(Wait.SPIN, call, owner=owner)
        return self._waited(call)

    def _spun(self, call: Call) -> _Waiting | None:
        """Return the wait of what spins a node."""
        is_function = call.receiver is None and call.qualifier == "rclcpp" and call.arguments
        return _Waiting(Wait.SPIN, call, is_endless=True) if is_function else None

    def _is_own_node(self, call: Call, site: Site) -> bool:
        """Tell whether a call spins the node whose callback it stands in."""
        given, scope = call.arguments[0], call.scope
        text = "".join(scope.file.syntax.word(given).split())
        if _ITSELF.fullmatch(text) is not None:
            return site.owner is not None and self._a.unit.class_of(scope) is site.owner
        held = _HELD.fullmatch(text)
        if held is None or site.node is None:
            return False
        return self._a.unit.lookup(held[1], scope, given.start_byte) is site.node

    def _waited(self, call: Call) -> _Waiting | None:
        """Return the wait for the answer to a request, or for what becomes of a goal."""
        asked = self._asked(call.receiver, call.scope)
        if asked is None or asked.receiver is None:
            return None
        if call.name == "wait_for" and not _is_repeated(call.node):
            time = seconds(self._a, call.argument(0), call.scope)
            if time is None or time.number is None or time.number <= 0:
                return None
        if asked.name in ASKING:
            owner = own_client(self._a, asked, ASYNC)
            return None if owner is None else _Waiting(Wait.SERVICE, call, owner=owner)
        kind, wait = _ASKING[asked.name]
        sites = self._clients(asked.receiver, asked.scope, kind)
        return _Waiting(wait, call, sites) if sites else None

    def _asked(self, node: Node | None, scope: Scope, depth: int = 0) -> Call | None:
        """Return the call that made a future, None where that is not known."""
        if node is None or depth > 6:
            return None
        if node.type == "call_expression":
            call = call_of(node, scope, scope.file.syntax)
            if call is None:
                return None
            if call.name in ("share", "move", "get_future"):
                inner = call.receiver if call.receiver is not None else call.argument(0)
                return self._asked(inner, scope, depth + 1)
            return call if call.name in _ASKING or call.name in ASKING else None
        if node.type == "field_expression" and last_name(node, scope) == "future":
            return self._asked(node.child_by_field_name("argument"), scope, depth + 1)
        if node.type != "identifier":
            return None
        variable = self._variable(node, scope)
        if variable is None or variable.kind != "local":
            return None
        writes = self._a.unit.writes(variable)
        if len(writes) != 1:
            return None
        return self._asked(writes[0].value, writes[0].scope, depth + 1)

    def _variable(self, node: Node, scope: Scope) -> Variable | None:
        name = last_name(node, scope)
        return self._a.unit.lookup(name, scope, node.start_byte) if name else None

    def _clients(self, node: Node, scope: Scope, kind: EndpointKind) -> tuple[Site, ...]:
        """Return the call sites that create what a variable has."""
        variable = self._variable(node, scope)
        if variable is None or variable.is_list:
            return ()
        return tuple(
            site
            for site in self._a.sites
            if site.endpoint.kind is kind and holder_of(self._a, site) is variable
        )

    def _slept(self, call: Call) -> _Waiting | None:
        """Return the wait of what sleeps."""
        if call.name in self._a.unit.functions:
            return None
        if call.receiver is not None:
            type_ = self._a.receivers.type_of(call.receiver, call.scope)
            is_clock = "clock" in call.scope.file.syntax.word(call.receiver).lower()
            if _SLEPT_BY.fullmatch(type_) is None and not is_clock:
                return None
            is_long = type_.endswith("Duration")
            said = call.receiver if is_long else call.argument(0)
            time = seconds(self._a, said, call.scope)
        elif call.name in ("sleep", "usleep") and not call.qualifier:
            time = self._a.evaluator.fold(call.argument(0), call.scope)
        elif call.qualifier.rpartition("::")[2] in ("this_thread", "rclcpp") or (
            not call.qualifier and call.name.startswith("sleep_")
        ):
            time = seconds(self._a, call.argument(0), call.scope)
        else:
            return None
        number = None if time is None or time.is_default or time.is_guess else time.number
        if number is not None and call.name == "usleep":
            number /= 1e6
        length = None if number is None else float(number)
        if is_short_retry(call.node, length):
            return None
        return _Waiting(Wait.SLEEP, call, seconds=length)
