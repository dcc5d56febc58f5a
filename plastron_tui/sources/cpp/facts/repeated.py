"""Endpoints that a callback, or a loop without end, creates each time."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.code_facts import Repeated
from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.holders import holder_of
from plastron_tui.sources.cpp.scopes import Scope, body_of
from plastron_tui.sources.cpp.timers import timer_details

from .called_back import CallbackBodies, CalledBack
from .places import Conditionals, span_of
from .repeats import parameters_of, runs_each_time

_COUNTED = frozenset(
    {
        EndpointKind.PUBLISHER,
        EndpointKind.SUBSCRIPTION,
        EndpointKind.SERVICE,
        EndpointKind.CLIENT,
        EndpointKind.ACTION_SERVER,
        EndpointKind.ACTION_CLIENT,
    }
)
_ENDING = re.compile(
    rb"\b(?:cancel|shutdown|exit|quit|call_once|unsubscribe)\s*\("
    rb"|(?i:sub|pub|timer|client|srv|service|server)\w*\s*(?:(?:\.|->)\s*(?:reset|stop)\s*\("
    rb"|=\s*(?:nullptr|NULL|ros::\w+\s*(?:\(\s*\)|\{\s*\}))\s*;)"
)
_ENDLESS = re.compile(
    rb"\(?(?:true|1|(?:(?:ros|rclcpp)::|\w+(?:\.|->))ok\(\))\)?|!ros::isShuttingDown\(\)"
)
_LOOPING = re.compile(rb"\b(?:while|for|do)\b")
_STAYING = re.compile(rb"(?i:\w*(?:spin|wait|sleep)\w*)\s*\(|\bok\s*\(")
_LEAVING = re.compile(rb"\b(?:break|return|throw|exit)\b")


def repeated(analysis: Analysis, bodies: CallbackBodies) -> Iterator[Repeated]:
    """Yield the endpoints, each once."""
    conditionals = {id(file): Conditionals(file) for file in analysis.unit.files}
    sites = [
        site
        for site in analysis.sites
        if _counts(analysis, site)
        and not conditionals[id(site.file)].has(site.call.node.start_byte)
    ]
    if not sites:
        return
    by_body: dict[int, list[Site]] = {}
    for site in sites:
        body = site.call.scope.enclosing("function", "lambda")
        if body is not None:
            by_body.setdefault(id(body), []).append(site)
    found: dict[tuple[str, int], Repeated] = {}
    for site, name in (*_in_callbacks(analysis, bodies, by_body), *_in_loops(sites)):
        kind, file = site.endpoint.kind, site.file.name
        key = file, site.call.node.start_byte
        found.setdefault(key, Repeated(kind, name, span_of(site.call.node), file))
    yield from (found[key] for key in sorted(found))


def _counts(analysis: Analysis, site: Site) -> bool:
    """Tell whether a call surely creates one endpoint, which is not kept beside others."""
    endpoint = site.endpoint
    if endpoint.kind not in _COUNTED or endpoint.name is None or endpoint.is_guess:
        return False
    if analysis.ros_version == 1 and endpoint.kind is EndpointKind.CLIENT:
        # A client of ROS 1 costs nothing until it calls.
        return False
    if site.shape.on in ("empty", "lazy") or site.call.name in ("waitForMessage", "call"):
        return False
    if "wait_for_message" in site.call.name:
        return False
    holder = holder_of(analysis, site)
    return holder is None or not (holder.is_list or "map<" in holder.type)


def _in_callbacks(
    analysis: Analysis, bodies: CallbackBodies, by_body: dict[int, list[Site]]
) -> Iterator[tuple[Site, str]]:
    for callback in bodies.all:
        is_timer = callback.site.endpoint.kind is EndpointKind.TIMER
        if is_timer and timer_details(analysis, callback.site).is_oneshot:
            continue
        reached = bodies.reached(callback.body)
        if any(_ends(scope) for scope, _ in reached.values()):
            continue
        for key, (_, calls) in reached.items():
            for site in by_body.get(key, ()):
                steps = [(call.scope, call.node) for call in calls]
                steps.append((site.call.scope, site.call.node))
                if all(_is_sure(callback, each, node) for each, node in steps):
                    yield site, callback.name


def _is_sure(callback: CalledBack, scope: Scope, node: Node) -> bool:
    """Tell whether a call is made whenever its function runs, at least for some messages."""
    around = scope.enclosing("function", "lambda")
    body = None if around is None else body_of(around.node)
    if around is None or body is None:
        return False
    code = scope.file.syntax.code
    # What waits, or works in a loop, has the endpoint for as long as that takes.
    if _STAYING.search(code, node.end_byte, body.end_byte):
        return False
    taken = parameters_of(around) if around is callback.body else frozenset[bytes]()
    return runs_each_time(node, body, taken, code)


def _ends(scope: Scope) -> bool:
    """Tell whether a callback is called but once, or ends what it has created before."""
    return _ENDING.search(scope.file.syntax.code, scope.start, scope.end) is not None


def _in_loops(sites: list[Site]) -> Iterator[tuple[Site, str]]:
    for site in sites:
        code = site.file.syntax.code
        loop = _loop_around(site.call.node)
        condition = None if loop is None else loop.child_by_field_name("condition")
        body = None if loop is None else loop.child_by_field_name("body")
        if loop is None or body is None:
            continue
        said = b"true" if condition is None else code[condition.start_byte : condition.end_byte]
        if _ENDLESS.fullmatch(b"".join(said.split())) is None:
            continue
        if _LEAVING.search(code, body.start_byte, body.end_byte):
            continue
        if _LOOPING.search(code, body.start_byte, body.end_byte):
            continue
        if _ENDING.search(code, body.start_byte, body.end_byte):
            continue
        if runs_each_time(site.call.node, body, frozenset(), code):
            yield site, ""


def _loop_around(node: Node) -> Node | None:
    """Return the innermost loop around a call in its function, None for none."""
    loop = node.parent
    while loop is not None and loop.type not in ("while_statement", "for_statement"):
        if loop.type in ("function_definition", "lambda_expression", "for_range_loop"):
            return None
        loop = loop.parent
    return loop
