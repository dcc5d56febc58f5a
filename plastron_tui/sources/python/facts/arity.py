"""Callbacks that cannot be called as ROS calls them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from inspect import Signature

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.code_facts import Arity
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.name_slips import is_slip
from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.callbacks import is_partial
from plastron_tui.sources.python.functions import definition
from plastron_tui.sources.python.positional import bounds, signature_of, takes
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.syntax import FUNCTIONS, Syntax, parts_of

from .call_graph import CallGraph
from .called_back import CALLBACK_ARGS, CalledBack, named
from .objects import Objects

_OBJECTS = frozenset({"self", "cls", "this"})
"""What methods call the object, or the class, that they are called on."""


def misfits(
    analysis: Analysis, callbacks: Sequence[CalledBack], objects: Objects, graph: CallGraph
) -> Iterator[Arity]:
    """Yield the callbacks that cannot be called."""
    for callback in callbacks:
        function = callback.function
        if function is None and callback.value.type == "call":
            yield from _result(callback, graph, analysis)
        if function is None or _is_unbound(callback, function, analysis):
            continue
        if b"NotImplementedError" in (function.node.text or b""):
            # Another file has the one that is called.
            continue
        signature = signature_of(function, analysis.syntax)
        wrapped = _wrapped(callback, analysis, objects)
        if signature is None or wrapped is None or _takes_timer_info(callback, function, analysis):
            continue
        handed, keywords = wrapped
        if any(takes(signature, handed + each, keywords) for each in callback.counts):
            continue
        least, most = _bounds(signature, handed, keywords)
        written = signature_of(function, analysis.syntax, is_written=True)
        is_shifted = written is not None and any(
            takes(written, handed + each, keywords) for each in callback.counts
        )
        parameters = function.node.child_by_field_name("parameters") or function.node
        yield Arity(
            named(callback.value, callback.scope, analysis),
            callback.kind,
            callback.counts[0],
            least,
            None if most == math.inf else int(most),
            Span(callback.value.start_byte, callback.value.end_byte),
            Span(parameters.start_byte, parameters.end_byte),
            besides=_besides(callback),
            with_self=_with_self(function, analysis.syntax) if is_shifted else "",
        )


def _with_self(function: Scope, syntax: Syntax) -> str:
    """Return how a method begins once it has `self`, "" for what needs none or has one."""
    owner, parameters = function.parent, function.node.child_by_field_name("parameters")
    is_method = function.kind == "function" and owner is not None and owner.kind == "class"
    if not is_method or parameters is None or definition(function) != function.node:
        return ""
    first = function.self_name or ""
    if first in _OBJECTS or is_slip(first, "self"):
        return ""
    listed = [" ".join(syntax.slice(each).split()) for each in parts_of(parameters)]
    start = "async def" if function.node.children[0].type == "async" else "def"
    return f"{start} {function.name}({', '.join(['self', *listed])})"


def _besides(callback: CalledBack) -> str:
    """Return what rospy is told to hand to a callback besides the message, "" for nothing."""
    site = callback.site
    if site is None or callback.counts != (2,) or site.shape.callees[0] != "rospy.Subscriber":
        return ""
    more = site.arguments.get(CALLBACK_ARGS)
    return "" if more is None or more.text is None else more.text.decode("utf-8", "replace")


def _result(callback: CalledBack, graph: CallGraph, analysis: Analysis) -> Iterator[Arity]:
    """Yield what is wrong with a callback that is called where it is handed over."""
    value = callback.value
    function = graph.callee(value)
    if function is None or function.name == "__init__" or definition(function) != function.node:
        return
    if _gives_something(function):
        return
    name = analysis.syntax.called_name(value)
    at = function.node.child_by_field_name("name") or function.node
    yield Arity(
        name,
        callback.kind,
        callback.counts[0],
        0,
        None,
        Span(value.start_byte, value.end_byte),
        Span(at.start_byte, at.end_byte),
        is_result=True,
    )


def _gives_something(function: Scope) -> bool:
    """Tell whether a function may give anything but None."""
    pending = list(function.node.children)
    while pending:
        node = pending.pop()
        is_return = node.type == "return_statement" and node.named_child_count > 0
        if is_return or node.type in ("yield", "async"):
            return True
        if node.type not in FUNCTIONS:
            pending += node.children
    return False


def _bounds(signature: Signature, handed: int, keywords: frozenset[str]) -> tuple[int, float]:
    """Return how few and how many arguments are left to be given."""
    least, most = bounds(signature)
    given = sum(name in signature.parameters for name in keywords) + handed
    return max(least - given, 0), max(most - given, 0)


def _wrapped(
    callback: CalledBack, analysis: Analysis, objects: Objects
) -> tuple[int, frozenset[str]] | None:
    """Return what `functools.partial` gives a callback; None where that is not known."""
    value, scope = callback.value, callback.scope
    if value.type == "identifier":
        made = objects.makings(value, scope)
        value, scope = made[0] if len(made) == 1 else (value, scope)
    handed, keywords = 0, frozenset[str]()
    while value.type == "call":
        if not is_partial(value, scope, analysis):
            return None
        arguments = Arguments.of(value, analysis.syntax)
        if arguments.is_open or not arguments.positional:
            return None
        handed += len(arguments.positional) - 1
        keywords |= arguments.keywords.keys()
        value = arguments.positional[0]
    return handed, keywords


def _is_unbound(callback: CalledBack, function: Scope, analysis: Analysis) -> bool:
    """Tell whether a method is handed over as its class has it, or through more than one name."""
    owner = function.parent
    if function.kind == "lambda" or owner is None or owner.kind != "class":
        return False
    if callback.value.parent == function.node:
        return False
    target = _innermost(callback.value, analysis.syntax)
    holder = target.child_by_field_name("object")
    if target.type != "attribute" or holder is None:
        return True
    return analysis.syntax.slice(holder) in {each.name for each in analysis.scopes.classes()}


def _innermost(value: Node, syntax: Syntax) -> Node:
    while value.type == "call":
        arguments = Arguments.of(value, syntax)
        if not arguments.positional:
            return value
        value = arguments.positional[0]
    return value


def _takes_timer_info(callback: CalledBack, function: Scope, analysis: Analysis) -> bool:
    """Tell whether a timer's callback asks for what rclpy gives it since Kilted."""
    if callback.kind is not EndpointKind.TIMER or analysis.library.module != "rclpy":
        return False
    parameters = function.node.child_by_field_name("parameters")
    return parameters is not None and b"TimerInfo" in (parameters.text or b"")
