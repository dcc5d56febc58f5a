"""Callbacks of C++ that do not take what they are called with; the compiler says it at length.

Sources: `ros/node_handle.h` of Noetic; `rclcpp/any_subscription_callback.hpp`,
`rclcpp/any_service_callback.hpp`, `rclcpp/timer.hpp` of Jazzy.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import Arity
from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.arguments import call_of
from plastron_tui.sources.cpp.callbacks import callback_of
from plastron_tui.sources.cpp.scopes import Function, Scope

from .called_back import LAMBDA, CallbackBodies
from .places import span_of

_COUNTS = {
    (1, EndpointKind.SUBSCRIPTION): (1,),
    (1, EndpointKind.SERVICE): (2, 1),
    (1, EndpointKind.TIMER): (1,),
    (2, EndpointKind.SUBSCRIPTION): (1, 2),
    (2, EndpointKind.SERVICE): (2, 3),
    (2, EndpointKind.TIMER): (0, 1),
}
"""With how many arguments callbacks may be called, the usual number first."""


class _Taken(NamedTuple):
    """What a callback takes.

    Attributes:
        name: its name.
        takes: how many arguments it takes.
        given: with how many it is called, one of these.
        place: what names it.
        function: its definition, None for a lambda.
    """

    name: str
    takes: int
    given: tuple[int, ...]
    place: Node
    function: Function | None


def misfits(analysis: Analysis, bodies: CallbackBodies) -> Iterator[Arity]:
    """Yield the callbacks that cannot be called, each once."""
    seen: set[tuple[str, int]] = set()
    for site in analysis.sites:
        counts = _COUNTS.get((analysis.ros_version, site.endpoint.kind))
        at = site.shape.callback
        is_plain = site.shape.on in ("node", "handle") and not site.endpoint.is_guess
        if counts is None or at is None or at >= len(site.arguments) or not is_plain:
            continue
        taken = _taken(analysis, bodies, site, site.arguments[at], counts)
        if taken is None or taken.takes in taken.given:
            continue
        place, file = span_of(taken.place), site.place.file
        if (file.name, place.start) not in seen:
            seen.add((file.name, place.start))
            kind, count = site.endpoint.kind, taken.takes
            definition = _definition(taken, site.place)
            yield Arity(
                taken.name, kind, taken.given[0], count, count, place, definition, file.name
            )


def _taken(
    analysis: Analysis, bodies: CallbackBodies, site: Site, node: Node, counts: tuple[int, ...]
) -> _Taken | None:
    """Return what a callback takes and is given, None where either is not known."""
    scope = site.place
    if node.type == "lambda_expression":
        body = bodies.lambda_of(node, scope)
        function = None if body is None else body.function
        count = None if function is None else _count(function)
        return None if count is None else _Taken(LAMBDA, count, counts, node, None)
    if node.type == "call_expression":
        return _bound(analysis, node, scope)
    if node.type not in ("identifier", "pointer_expression", "qualified_identifier"):
        return None
    found = _function(analysis, node, scope)
    if found is None:
        return None
    function, count = found
    # A variable may have what is called, with some of its arguments.
    is_named = scope.file.syntax.word(node).rpartition(":")[2].strip("& ") == function.name
    return _Taken(function.name, count, counts, node, function) if is_named else None


def _bound(analysis: Analysis, node: Node, scope: Scope) -> _Taken | None:
    """Return what `std::bind(&C::f, this, _1)` takes and gives."""
    call = call_of(node, scope, scope.file.syntax)
    if call is None or call.name != "bind" or len(call.arguments) < 1:
        return None
    first = call.arguments[0]
    found = _function(analysis, first, scope)
    if found is None:
        return None
    function, count = found
    is_method = analysis.unit.class_of_function(function) is not None
    if is_method and first.type != "pointer_expression":
        return None
    given = len(call.arguments) - 1 - is_method
    return _Taken(function.name, count, (given,), first, function) if given >= 0 else None


def _function(analysis: Analysis, node: Node, scope: Scope) -> tuple[Function, int] | None:
    """Return the function that an argument names, and how many arguments each of its kind takes."""
    callback = callback_of(analysis.unit, node, scope)
    if not callback.functions or "<" in scope.file.syntax.word(node):
        return None
    owners = {id(analysis.unit.class_of_function(each)) for each in callback.functions}
    counts = {_count(each) for each in callback.functions}
    is_static = any(b"static" in _head(each) for each in callback.functions)
    if len(counts) != 1 or len(owners) != 1 or is_static:
        return None
    count = counts.pop()
    return None if count is None else (callback.functions[0], count)


def _head(function: Function) -> bytes:
    code = function.file.syntax.code
    return code[function.node.start_byte : function.declarator.start_byte]


def _count(function: Function) -> int | None:
    """Return how many arguments a function takes, None where that is not one number."""
    listed = function.declarator.child_by_field_name("parameters")
    if listed is None and function.scope is not None and function.scope.kind == "lambda":
        return 0
    if listed is None or listed.has_error:
        return None
    text = function.file.syntax.code[listed.start_byte : listed.end_byte]
    if b"..." in text or b"=" in text:
        return None
    return 0 if text.strip(b"( )\n\t") in (b"", b"void") else len(function.parameters)


def _definition(taken: _Taken, scope: Scope) -> Span:
    """Return the parameters of a callback, what names it where they are in another file."""
    function = taken.function
    if function is None or function.file is not scope.file:
        return span_of(taken.place)
    listed = function.declarator.child_by_field_name("parameters")
    return span_of(listed or taken.place)
