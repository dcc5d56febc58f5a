"""Endpoints that are created again each time that something is called, and never end."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import Repeated
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.conventions import target_name
from plastron_tui.sources.python.own_loop import is_endless
from plastron_tui.sources.python.scopes import BindingKind, Scope
from plastron_tui.sources.python.syntax import FUNCTIONS

from .call_graph import CallGraph
from .called_back import CalledBack, is_certain, named, running_scope
from .unconditional import asks_only_for, runs_each_time

_ENDING = re.compile(
    rb"destroy|\.unregister\(|\.cancel\(|(?<!is_)shutdown\(|\bexit\(|SystemExit|\bquit\("
)
"""What a callback does that is called only once, or that ends what it has created before."""

_ENDED = {
    EndpointKind.PUBLISHER: re.compile(rb"destroy_publisher|destroy_lifecycle"),
    EndpointKind.SUBSCRIPTION: re.compile(rb"destroy_subscription"),
    EndpointKind.SERVICE: re.compile(rb"destroy_service|\.shutdown\("),
    EndpointKind.CLIENT: re.compile(rb"destroy_client"),
    EndpointKind.ACTION_SERVER: re.compile(rb"\.destroy\("),
    EndpointKind.ACTION_CLIENT: re.compile(rb"\.destroy\("),
    EndpointKind.TIMER: re.compile(rb"destroy_timer|\.cancel\(|\.shutdown\("),
}
"""How endpoints of a kind are ended; a file that does so keeps account of them."""

_LAST = frozenset(
    {"__del__", "destroy_node", "on_cleanup", "on_deactivate", "on_error", "on_shutdown"}
)
"""Methods of a node that end what there is once, when it has done its work."""

_UNREGISTERED = re.compile(rb"\.unregister\(")
_BEFORE = re.compile(rb"[\w.]*\W*\Z")
_LONGEST = 200
"""Bytes before a call in which what it is called of is looked for: words have no limit."""

_MODULES = frozenset({b"rclpy", b"rospy"})
_REPEATING = frozenset(
    {
        EndpointKind.SUBSCRIPTION,
        EndpointKind.TIMER,
        EndpointKind.SERVICE,
        EndpointKind.ACTION_SERVER,
    }
)
_OPEN = frozenset({"dictionary", "list", "set", "none", "call", "list_comprehension"})
"""Values that may become others without an assignment, or that stand for nothing yet."""

_ONESHOT = Argument(2, "oneshot")


def repeated(
    analysis: Analysis, callbacks: Sequence[CalledBack], graph: CallGraph
) -> Iterator[Repeated]:
    """Yield the endpoints that a callback, or a loop without end, creates each time."""
    sites: dict[Scope, list[Site]] = {}
    for site in analysis.first_sites():
        if _counts(site, analysis) and running_scope(analysis, site.call).parent is not None:
            sites.setdefault(running_scope(analysis, site.call), []).append(site)
    found: dict[int, Repeated] = {}
    for site, name in (*_in_callbacks(analysis, callbacks, graph, sites), *_in_loops(analysis)):
        span = Span(site.call.start_byte, site.call.end_byte)
        found.setdefault(site.call.id, Repeated(site.endpoint.kind, name, span))
    yield from sorted(found.values(), key=lambda each: each.span)


def _counts(site: Site, analysis: Analysis) -> bool:
    """Tell whether a call site makes one endpoint of a name, which goes on when it is let go."""
    kind = site.endpoint.kind
    ended = _ENDED.get(kind)
    if ended is None or site.shape.gives_message or _keeps_account(analysis, ended):
        return False
    if analysis.library.module == "rospy" and (kind is EndpointKind.CLIENT or _is_oneshot(site)):
        return False
    is_named = kind is EndpointKind.TIMER or site.endpoint.name is not None
    return is_named and is_certain(site, analysis) and not _is_unregistered(kind, analysis)


def _keeps_account(analysis: Analysis, ended: re.Pattern[bytes]) -> bool:
    """Tell whether a file ends endpoints while its node works: the last one is no account."""
    for found in ended.finditer(analysis.syntax.text):
        function = analysis.scopes.at(found.start()).enclosing("function")
        is_method = function is not None and bool(function.self_name)
        if function is None or not is_method or function.name not in _LAST:
            return True
    return False


def _is_unregistered(kind: EndpointKind, analysis: Analysis) -> bool:
    """Tell whether a file of rospy ends an endpoint that may be of a kind."""
    ended = set(_unregistered(analysis.syntax.text))
    if not ended:
        return False
    others = (site for site in analysis.first_sites() if site.endpoint.kind is not kind)
    known = {analysis.syntax.encode(target_name(analysis, site) or "") for site in others}
    return not ended <= known


def _unregistered(text: bytes) -> Iterator[bytes]:
    """Yield what is unregistered, as it is written."""
    done = 0
    for call in _UNREGISTERED.finditer(text):
        before = _BEFORE.search(text[max(done, call.start() - _LONGEST) : call.start()])
        yield before[0] if before is not None else b""
        done = call.end()


def _in_callbacks(
    analysis: Analysis,
    callbacks: Sequence[CalledBack],
    graph: CallGraph,
    sites: dict[Scope, list[Site]],
) -> Iterator[tuple[Site, str]]:
    if not sites:
        return
    for callback in callbacks:
        function = callback.function
        if function is None or not _is_repeating(callback, analysis):
            continue
        taken = _taken(function, analysis)
        all_reached = graph.reached(function)
        if any(_ENDING.search(each.node.text or b"") for each in all_reached):
            continue
        for reached, calls in all_reached.items():
            for site in sites.get(reached, ()):
                if not _may_start_again(callback, site):
                    continue
                steps = (*calls, site.call)
                known = taken | _settled(site, analysis)
                if all(_is_sure(step, function, known, analysis) for step in steps):
                    yield site, named(callback.value, callback.scope, analysis)


def _taken(function: Scope, analysis: Analysis) -> frozenset[bytes]:
    """Return the names of what a callback is given, and of what it makes of that alone."""
    known = {
        analysis.syntax.encode(name)
        for name, bindings in function.bindings.items()
        if name != function.self_name
        and bindings[0].kind is BindingKind.PARAMETER
        and bindings[0].value is None
    }
    imported = {
        analysis.syntax.encode(name)
        for name, bindings in analysis.scopes.module.bindings.items()
        if all(each.kind is BindingKind.IMPORT for each in bindings)
    }
    # In the order of the text: what is made of a name comes behind it.
    for name, bindings in function.bindings.items():
        if all(
            each.kind is BindingKind.VALUE
            and each.value is not None
            and asks_only_for(each.value, frozenset(known | imported))
            for each in bindings
        ):
            known.add(analysis.syntax.encode(name))
    return frozenset(known)


def _settled(site: Site, analysis: Analysis) -> frozenset[bytes]:
    """Return the attributes of a node that only its constructor sets, as conditions name them."""
    owner = site.owner
    if owner is None or site.receiver != "self":
        return frozenset()
    return frozenset(
        analysis.syntax.encode(f"self.{name}")
        for name, bindings in owner.attributes.items()
        if all(running_scope(analysis, each.node).name == "__init__" for each in bindings)
        and all(each.value is None or each.value.type not in _OPEN for each in bindings)
    )


def _is_sure(step: Node, callback: Scope, known: frozenset[bytes], analysis: Analysis) -> bool:
    """Tell whether a call is made each time that its function runs, for some messages at least."""
    scope = running_scope(analysis, step)
    if scope is not callback:
        known = frozenset(each for each in known if b"." in each)
    return runs_each_time(step, scope.node, known | _MODULES)


def _is_repeating(callback: CalledBack, analysis: Analysis) -> bool:
    if callback.site is None:
        # What filters call, as often as a topic has messages; a node changes its state rarely.
        return callback.kind is EndpointKind.SUBSCRIPTION
    if callback.kind not in _REPEATING:
        return False
    return analysis.library.module != "rospy" or not _is_oneshot(callback.site)


def _is_oneshot(site: Site) -> bool:
    """Tell whether a timer of rospy may tick only once."""
    is_timer = site.endpoint.kind is EndpointKind.TIMER
    return is_timer and site.arguments.get(_ONESHOT) is not None


def _may_start_again(callback: CalledBack, site: Site) -> bool:
    """Tell whether a callback is surely called more than once for what it creates.

    A timer that a request starts is often the one that the node has.
    """
    is_asked = callback.kind in (EndpointKind.SERVICE, EndpointKind.ACTION_SERVER)
    return not (is_asked and site.endpoint.kind is EndpointKind.TIMER)


def _in_loops(analysis: Analysis) -> Iterator[tuple[Site, str]]:
    loops = [each for each in analysis.captures.get("while", []) if is_endless(analysis, each)]
    if not loops:
        return
    around = {loop.id: loop for loop in loops}
    for site in analysis.first_sites():
        loop: Node | None = site.call.parent
        while loop is not None and loop.id not in around and loop.type not in FUNCTIONS:
            loop = loop.parent
        if loop is None or loop.id not in around or not _counts(site, analysis):
            continue
        body = loop.child_by_field_name("body")
        if body is None or _ENDING.search(body.text or b"") or _is_left(analysis, body, site):
            continue
        if runs_each_time(site.call, body):
            yield site, ""


def _is_left(analysis: Analysis, body: Node, site: Site) -> bool:
    """Tell whether a loop ends with its first turn, or by what is asked of its endpoint."""
    target = target_name(analysis, site)
    pending = list(body.named_children)
    while pending:
        node = pending.pop()
        if node.type in ("break_statement", "return_statement", "raise_statement"):
            return True
        if node.type == "if_statement":
            asked = node.child_by_field_name("condition")
            text = b"" if asked is None else asked.text or b""
            if target is None or analysis.syntax.encode(target) in text:
                pending += node.named_children
        elif node.type not in FUNCTIONS:
            pending += node.named_children
    return False
