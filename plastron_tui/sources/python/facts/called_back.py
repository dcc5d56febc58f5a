"""The functions of a file that ROS calls, and what it calls them with.

Source: `rclpy` of Jazzy (`Subscription.callback`, `Executor._take_*`, `rclpy.action`), `rospy` and
`actionlib` of Noetic.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.kinds import EndpointKind
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.callbacks import callback_target
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.names import NODE
from plastron_tui.sources.python.references import function_of
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.syntax import parts_of

from .objects import Objects


class CalledBack(NamedTuple):
    """A function that ROS calls.

    Attributes:
        kind: the kind of the endpoint that it is for.
        value: what hands the function over.
        scope: where it is handed over.
        function: the function of the file, None where that is not known.
        counts: with how many arguments it may be called.
        site: the call site of the endpoint, None for what has none of its own.
        is_task: whether the executor calls it apart from all groups of callbacks.
        is_inherited: whether the call site is of another file; the value is then where the file
            itself defines the function.
    """

    kind: EndpointKind
    value: Node
    scope: Scope
    function: Scope | None
    counts: tuple[int, ...]
    site: Site | None = None
    is_task: bool = False
    is_inherited: bool = False


class _Given(NamedTuple):
    """A function that a method is given, besides the one of a call site's shape."""

    argument: Argument
    counts: tuple[int, ...]
    kind: EndpointKind
    is_task: bool = False


COUNTS: dict[str, dict[EndpointKind, tuple[int, ...]]] = {
    "rclpy": {
        EndpointKind.SUBSCRIPTION: (1, 2),
        EndpointKind.SERVICE: (2,),
        EndpointKind.TIMER: (0,),
        EndpointKind.ACTION_SERVER: (1,),
    },
    "rospy": {
        EndpointKind.SUBSCRIPTION: (1,),
        EndpointKind.SERVICE: (1,),
        EndpointKind.TIMER: (1,),
        EndpointKind.ACTION_SERVER: (1,),
    },
}
"""With how many arguments callbacks are called, by the client library."""

_SERVER, _CLIENT = EndpointKind.ACTION_SERVER, EndpointKind.ACTION_CLIENT
_OF_SITES: dict[str, tuple[_Given, ...]] = {
    "rclpy.action.ActionServer": (
        _Given(Argument(-1, "goal_callback"), (1,), _SERVER),
        _Given(Argument(-1, "handle_accepted_callback"), (1,), _SERVER),
        _Given(Argument(-1, "cancel_callback"), (1,), _SERVER),
    ),
    "actionlib.ActionServer": (_Given(Argument(3, "cancel_cb"), (1,), _SERVER),),
}
_PARAMETERS = _Given(Argument(0, "callback"), (1,), EndpointKind.PARAMETER, is_task=True)
_OF_ANY: dict[str, tuple[_Given, ...]] = {
    "add_done_callback": (
        _Given(Argument(0, "callback"), (1,), EndpointKind.CLIENT, is_task=True),
    ),
    "add_on_set_parameters_callback": (_PARAMETERS,),
    "add_post_set_parameters_callback": (_PARAMETERS,),
    "add_pre_set_parameters_callback": (_PARAMETERS,),
}
"""What is given to methods that only objects of rclpy have, unless a file has one of its own."""

_OF_OBJECTS: dict[tuple[str, str], tuple[_Given, ...]] = {
    ("rclpy.action.ActionClient", "send_goal_async"): (
        _Given(Argument(1, "feedback_callback"), (1,), _CLIENT),
    ),
    ("rclpy.action.ActionClient", "send_goal"): (
        _Given(Argument(-1, "feedback_callback"), (1,), _CLIENT),
    ),
    ("actionlib.SimpleActionServer", "register_goal_callback"): (
        _Given(Argument(0, "cb"), (0,), _SERVER),
    ),
    ("actionlib.SimpleActionServer", "register_preempt_callback"): (
        _Given(Argument(0, "cb"), (0,), _SERVER),
    ),
    ("actionlib.SimpleActionClient", "send_goal"): (
        _Given(Argument(1, "done_cb"), (2,), _CLIENT),
        _Given(Argument(2, "active_cb"), (0,), _CLIENT),
        _Given(Argument(3, "feedback_cb"), (1,), _CLIENT),
    ),
}
"""What is given to methods of what a call site makes, by the name of the class."""

_METHODS = frozenset({method for _, method in _OF_OBJECTS} | {"registerCallback"})
_SYNCHRONIZERS = frozenset(
    {
        "message_filters.TimeSynchronizer",
        "message_filters.ApproximateTimeSynchronizer",
    }
)
_OF_FUNCTIONS: dict[str, _Given] = {
    "dynamic_reconfigure.server.Server": _Given(
        Argument(1, "callback"), (2,), EndpointKind.PARAMETER
    ),
    "rospy.on_shutdown": _Given(Argument(0, "h"), (0,), EndpointKind.TIMER),
}
"""What is given to functions and classes of rospy that create no endpoint."""

_TRANSITIONS = (
    "on_activate", "on_cleanup", "on_configure", "on_deactivate", "on_error", "on_shutdown"
)  # fmt: skip
CALLBACK_ARGS = Argument(3, "callback_args")


def called_back(analysis: Analysis, objects: Objects) -> list[CalledBack]:
    """Return the functions that ROS calls, as far as the file says it."""
    found = list(_of_sites(analysis))
    found += _of_methods(analysis, objects)
    found += _of_functions(analysis)
    found += _of_transitions(analysis)
    return found


def _of_sites(analysis: Analysis) -> Iterator[CalledBack]:
    counts = COUNTS[analysis.library.module]
    for site in analysis.first_sites():
        kind, callback = site.endpoint.kind, site.shape.callback
        if not is_certain(site, analysis):
            continue
        if callback is not None and kind in counts:
            value = site.arguments.get(callback)
            if value is not None and value.type != "none":
                given = with_arguments(site, counts[kind])
                # A goal is done in a task of its own (`ActionServer._execute_goal_request`).
                is_task = kind is EndpointKind.ACTION_SERVER
                function = function_in(value, site.scope, analysis)
                yield CalledBack(kind, value, site.scope, function, given, site, is_task)
        for each in _OF_SITES.get(site.shape.callees[0], ()):
            value = site.arguments.get(each.argument)
            if value is not None and value.type != "none":
                function = function_in(value, site.scope, analysis)
                yield CalledBack(kind, value, site.scope, function, each.counts, site)


def with_arguments(site: Site, counts: tuple[int, ...]) -> tuple[int, ...]:
    """Return how many arguments a callback gets, which rospy may hand one besides."""
    if site.shape.callees[0] != "rospy.Subscriber":
        return counts
    more = site.arguments.get(CALLBACK_ARGS)
    if more is None:
        return counts
    is_there = more.type in ("tuple", "list", "dictionary", "string", "integer", "float")
    return (2,) if is_there else (1, 2)


def _of_methods(analysis: Analysis, objects: Objects) -> Iterator[CalledBack]:
    syntax = analysis.syntax
    is_rclpy = bool(analysis.library.node_classes)
    of_any = _OF_ANY.keys() - {scope.name for scope in analysis.scopes.all} if is_rclpy else ()
    for call in analysis.captures.get("call", []):
        name = syntax.called_name(call)
        if name not in _METHODS and name not in of_any:
            continue
        scope = analysis.scopes.at(call.start_byte)
        if name == "registerCallback":
            yield from _of_filter(analysis, objects, call, scope)
            continue
        site: Site | None = None
        given = _OF_ANY.get(name, ())
        if not given:
            callee = call.child_by_field_name("function")
            holder = callee.child_by_field_name("object") if callee is not None else None
            sites = objects.sites(holder, scope)
            classes = {each.shape.callees[0] for each in sites}
            if len(classes) != 1:
                continue
            site = sites[0]
            given = _OF_OBJECTS.get((_class_name(site, analysis), name), ())
        arguments = Arguments.of(call, syntax)
        for each in given:
            value = arguments.get(each.argument)
            if value is not None and value.type != "none":
                function = function_in(value, scope, analysis)
                yield CalledBack(each.kind, value, scope, function, each.counts, site, each.is_task)


def _of_filter(
    analysis: Analysis, objects: Objects, call: Node, scope: Scope
) -> Iterator[CalledBack]:
    """Yield what a synchronizer calls, with a message of each of its filters."""
    callee = call.child_by_field_name("function")
    holder = callee.child_by_field_name("object") if callee is not None else None
    made = objects.makings(holder, scope)
    arguments = Arguments.of(call, analysis.syntax)
    if len(made) != 1 or arguments.is_open or not arguments.positional or arguments.keywords:
        return
    maker = made[0].call.child_by_field_name("function")
    if _SYNCHRONIZERS.isdisjoint(analysis.resolver.qualified(maker, made[0].scope)):
        return
    filters = Arguments.of(made[0].call, analysis.syntax).get(Argument(0, "fs"))
    if filters is None or filters.type not in ("list", "tuple"):
        return
    parts = parts_of(filters)
    if any(each.type == "list_splat" for each in parts):
        return
    value = arguments.positional[0]
    counts = (len(parts) + len(arguments.positional) - 1,)
    function = function_in(value, scope, analysis)
    yield CalledBack(EndpointKind.SUBSCRIPTION, value, scope, function, counts)


def _of_functions(analysis: Analysis) -> Iterator[CalledBack]:
    if analysis.library.module != "rospy":
        return
    names = {name.rpartition(".")[2] for name in _OF_FUNCTIONS}
    for call in analysis.captures.get("call", []):
        if analysis.syntax.called_name(call) not in names:
            continue
        scope = analysis.scopes.at(call.start_byte)
        for name in analysis.resolver.qualified(call.child_by_field_name("function"), scope):
            given = _OF_FUNCTIONS.get(name)
            value = None
            if given is not None:
                value = Arguments.of(call, analysis.syntax).get(given.argument)
            if given is not None and value is not None:
                function = function_in(value, scope, analysis)
                yield CalledBack(given.kind, value, scope, function, given.counts)


def _of_transitions(analysis: Analysis) -> Iterator[CalledBack]:
    """Yield what a managed node of rclpy does when somebody asks it to change its state."""
    for node in analysis.nodes:
        owner = node.owner
        if owner is None or not any(
            "LifecycleNode" in name or name == "rclpy.lifecycle.Node"
            for name in analysis.resolver.foreign_bases(owner)
        ):
            continue
        for name in _TRANSITIONS:
            for binding in owner.bindings.get(name, [])[:1]:
                at = binding.node.child_by_field_name("name")
                if binding.owner is not None and at is not None:
                    yield CalledBack(
                        EndpointKind.SERVICE, at, owner, binding.owner, (1,), is_task=True
                    )


def _class_name(site: Site, analysis: Analysis) -> str:
    """Return the name of the class that a call site makes an object of, as the tables have it."""
    callee = site.call.child_by_field_name("function")
    names = analysis.resolver.qualified(callee, site.scope)
    last = {name.rpartition(".")[2] for name in names}
    first = site.shape.callees[0]
    return f"{first.rpartition('.')[0]}.{last.pop()}" if len(last) == 1 else first


def function_in(value: Node, scope: Scope, analysis: Analysis) -> Scope | None:
    """Return the function of the file that a value is, or wraps as `functools.partial` does."""
    target = callback_target(value, scope, analysis)
    if target is None:
        return None
    if target.type == "lambda":
        body = target.child_by_field_name("body")
        return None if body is None else analysis.scopes.at(body.start_byte).enclosing("lambda")
    return function_of(target, analysis)


def is_certain(site: Site, analysis: Analysis) -> bool:
    """Tell whether a call site surely creates an endpoint on a node of the client library."""
    if site.shape.node is not None or "." in site.shape.callees[0]:
        return True
    callee = site.call.child_by_field_name("function")
    holder = callee.child_by_field_name("object") if callee is not None else None
    instance = analysis.resolver.instance(holder, site.scope)
    return instance is None or instance.qualified in ("", NODE)


def running_scope(analysis: Analysis, node: Node) -> Scope:
    """Return the function, lambda or module whose run reaches a part of the file."""
    scope = analysis.scopes.at(node.start_byte)
    while scope.kind == "comprehension" and scope.parent is not None:
        scope = scope.parent
    return scope


def named(value: Node, scope: Scope, analysis: Analysis) -> str:
    """Return what a callback is called for people to read."""
    target = callback_target(value, scope, analysis)
    if target is None or target.type == "lambda":
        return "lambda"
    return analysis.syntax.slice(target).rpartition(".")[2].strip()


def names_of(found: Sequence[CalledBack]) -> frozenset[Scope]:
    """Return the functions of the file among those that ROS calls."""
    return frozenset(each.function for each in found if each.function is not None)
