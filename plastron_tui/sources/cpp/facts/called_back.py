"""The functions of a unit that an executor calls, and what these call in turn.

Sources: `rclcpp/create_subscription.hpp`, `rclcpp/create_timer.hpp`, `rclcpp/create_service.hpp`,
`rclcpp_action/create_server.hpp` of Jazzy for where the groups of callbacks stand;
`ros/node_handle.h` of Noetic.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.arguments import Call, call_of
from plastron_tui.sources.cpp.callbacks import callback_of
from plastron_tui.sources.cpp.scopes import Function, Scope
from plastron_tui.sources.unreachable import is_unreachable

CALLED = frozenset(
    {
        EndpointKind.SUBSCRIPTION,
        EndpointKind.SERVICE,
        EndpointKind.TIMER,
        EndpointKind.ACTION_SERVER,
    }
)
"""The kinds of endpoints whose functions an executor calls."""

LAMBDA = "lambda"
"""What a function without a name is called for people to read."""

_BINDERS = frozenset({"bind", "bind_front", "mem_fn", "function", "make_callback"})
_MOST_REACHED = 200
_GROUPED_FROM = {
    EndpointKind.SUBSCRIPTION: 3,
    EndpointKind.SERVICE: 3,
    EndpointKind.TIMER: 2,
    EndpointKind.ACTION_SERVER: 4,
    EndpointKind.CLIENT: 2,
    EndpointKind.ACTION_CLIENT: 1,
}
"""The first argument that may say a group of callbacks, by itself or within options."""


class CalledBack(NamedTuple):
    """A function that an executor calls.

    Attributes:
        site: the call site of its endpoint.
        body: the function, or the lambda.
        name: its name, `LAMBDA` for what has none.
    """

    site: Site
    body: Scope
    name: str


class CallbackBodies:
    """The functions that executors call, and the functions of the unit that they call."""

    def __init__(self, analysis: Analysis) -> None:
        self._a = analysis
        self._unit = analysis.unit

    @cached_property
    def all(self) -> tuple[CalledBack, ...]:
        """All of them, in the order of their endpoints."""
        return tuple(self._all())

    def _all(self) -> Iterator[CalledBack]:
        seen: set[tuple[int, int]] = set()
        for site in self._a.sites:
            if site.endpoint.kind not in CALLED or site.shape.on == "object":
                continue
            for node in _callback_nodes(self._a, site):
                for body, name in self._bodies(node, site.place):
                    # One call site may stand for several endpoints.
                    key = id(body), site.call.node.id
                    if key not in seen:
                        seen.add(key)
                        yield CalledBack(site, body, name)

    def _bodies(self, node: Node, scope: Scope) -> list[tuple[Scope, str]]:
        """Return the functions that an argument may be, none where they are not known."""
        found = self.lambda_of(node, scope)
        if found is not None:
            return [(found, LAMBDA)]
        callback = callback_of(self._unit, node, scope)
        bodies = [each.scope for each in callback.functions if each.scope is not None]
        # Which of several overloads is meant is not asked.
        return [(bodies[0], callback.name or LAMBDA)] if len(bodies) == 1 else []

    def lambda_of(self, node: Node, scope: Scope, depth: int = 0) -> Scope | None:
        """Return the lambda that an argument is, by itself or by a variable; None for none."""
        if node.type == "lambda_expression":
            return self._lambdas.get((id(scope.file), node.id))
        if depth > 4:
            return None
        if node.type == "call_expression":
            call = call_of(node, scope, scope.file.syntax)
            inner = call.argument(0) if call is not None and call.name in _BINDERS else None
            return None if inner is None else self.lambda_of(inner, scope, depth + 1)
        if node.type != "identifier":
            return None
        name = scope.file.syntax.word(node)
        variable = self._unit.lookup(name, scope, node.start_byte)
        if variable is None or variable.value is None:
            return None
        return self.lambda_of(variable.value, variable.scope, depth + 1)

    @cached_property
    def _lambdas(self) -> dict[tuple[int, int], Scope]:
        return {
            (id(file), scope.node.id): scope
            for file in self._unit.files
            for scope in file.scopes
            if scope.kind == "lambda"
        }

    @cached_property
    def calls_in(self) -> dict[int, list[Call]]:
        """The calls that each function or lambda makes itself, by the identity of its scope."""
        found: dict[int, list[Call]] = {}
        for file in self._unit.files:
            for call in file.calls:
                body = call.scope.enclosing("function", "lambda")
                if body is not None:
                    found.setdefault(id(body), []).append(call)
        return found

    def reached(self, body: Scope) -> dict[int, tuple[Scope, tuple[Call, ...]]]:
        """Return the functions that a function calls, itself among them, each with the calls.

        What another thread does, or what is called later, is not among it.
        """
        found: dict[int, tuple[Scope, tuple[Call, ...]]] = {id(body): (body, ())}
        pending = [body]
        while pending and len(found) < _MOST_REACHED:
            each = pending.pop()
            for call in self.calls_in.get(id(each), ()):
                inner = self.called(call)
                if inner is None or id(inner) in found or is_unreachable(call.node):
                    continue
                found[id(inner)] = inner, (*found[id(each)][1], call)
                pending.append(inner)
        return found

    def called(self, call: Call) -> Scope | None:
        """Return the function of the unit that a call surely calls, None for another one."""
        is_own = call.receiver is None or call.receiver.type == "this"
        if not is_own or call.template is not None:
            return None
        named = self._unit.functions.get(call.name, ())
        bodies = [each for each in named if each.scope is not None and not each.file.is_beside]
        if len(bodies) != 1 or not self._is_seen(bodies[0], call):
            return None
        return bodies[0].scope

    def _is_seen(self, function: Function, call: Call) -> bool:
        """Tell whether a call may name a function: a method is one of its own class."""
        owner = self._unit.class_of_function(function)
        own = self._unit.class_of(call.scope)
        if owner is None:
            return not function.qualifier
        return own is not None and self._unit.derives_from(own, owner)


def _callback_nodes(analysis: Analysis, site: Site) -> list[Node]:
    """Return what the endpoint of a call site calls."""
    given = site.arguments
    if site.endpoint.kind is EndpointKind.ACTION_SERVER and analysis.ros_version == 2:
        return given[1:4]
    at = site.shape.callback
    return [given[at]] if at is not None and at < len(given) else []


def is_in_default_group(site: Site) -> bool:
    """Tell whether an endpoint of ROS 2 is in the group of callbacks that a node has by itself.

    Of these an executor calls one at a time, however many threads it has.
    """
    first = _GROUPED_FROM.get(site.endpoint.kind)
    return first is not None and len(site.arguments) <= first and site.options is None


def is_of_same_node(site: Site, other: Site) -> bool:
    """Tell whether two call sites surely create endpoints of one node object."""
    if site.owner is None and site.node is None and other.owner is None and other.node is None:
        held = _inherited_node(site)
        return held is not None and held == _inherited_node(other)
    return (
        site.owner is other.owner
        and site.node is other.node
        and (site.owner is not None or site.node is not None)
    )


def _inherited_node(site: Site) -> tuple[int, str] | None:
    """Return which member of a class that is not read holds the node, with the class below it."""
    call = site.call
    owner = call.scope.enclosing("class")
    if owner is None or not owner.bases or call.receiver is None:
        return None
    is_name = call.receiver.type == "identifier"
    return (id(owner), call.scope.file.syntax.word(call.receiver)) if is_name else None
