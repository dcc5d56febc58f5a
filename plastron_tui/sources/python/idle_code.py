"""Functions and loops that an edit leaves with nothing to do."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.source import Change, Remove, Update
from plastron_tui.sources.left_behind import idle, taking

from .analysis import Analysis, NodeSite
from .creation import line_of
from .generated import body_of
from .own_loop import is_sleep, statements_of
from .references import Use, references, variable_of
from .scopes import Scope
from .uncalled import path_of


def tell_idle(before: Analysis, after: Analysis, changes: Sequence[Change]) -> Diagnostic | None:
    """Return a warning that names what of a file still runs, and does nothing any more.

    Args:
        before: the file as it was.
        after: the file as it is.
        changes: what was asked for.
    """
    if not taking(changes):
        return None
    had = Counter(path for path, _ in _idle(before))
    found = []
    for path, what in _idle(after):
        had[path] -= 1
        if had[path] < 0:
            found.append(what)
    return idle(found, changes)


def tell_unused_results(
    before: Analysis, after: Analysis, changes: Sequence[Change]
) -> Diagnostic | None:
    """Return a warning that names the calls which are made for nothing but what else they do.

    Args:
        before: the file as it was.
        after: the file as it is.
        changes: what was asked for.
    """
    spans = [change.span for change in changes if isinstance(change, Remove | Update)]
    had = Counter(_spelled(each) for each in _bare_calls(before))
    known = {_spelled(each) for each in before.captures.get("call", [])} if spans else set()
    found = []
    for call in _bare_calls(after) if spans else ():
        text, callee = _spelled(call), call.child_by_field_name("function")
        had[text] -= 1
        if had[text] < 0 and text in known and callee is not None:
            found.append(f"`{after.syntax.slice(callee)}` (line {line_of(call)})")
    if not found:
        return None
    message = f"nothing uses what is returned by {listed(found)}"
    span = spans[0] if len(spans) == 1 else None
    help_ = "remove the call by hand if it does nothing else"
    return Diagnostic(codes.IDLE_CODE, message, span, help=help_)


def _bare_calls(analysis: Analysis) -> list[Node]:
    """Return the calls that are statements."""
    calls = analysis.captures.get("call", [])
    return [each for each in calls if each.parent and each.parent.type == "expression_statement"]


def _spelled(call: Node) -> bytes:
    return b" ".join((call.text or b"").split())


def _idle(analysis: Analysis) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield where a function does nothing or a loop only sleeps, and what it is called."""
    for scope in analysis.scopes.all:
        is_function = scope.kind == "function" and scope.node.type == "function_definition"
        if is_function and all(each.type == "pass_statement" for each in body_of(scope)):
            yield ("def", *path_of(scope)), f"`{scope.name}` (line {line_of(scope.node)})"
    for node in analysis.nodes:
        held = _holder(node)
        if held is not None and not _is_used(analysis, held):
            yield ("node", analysis.syntax.slice(held)), f"the node in line {line_of(held)}"
    loops = [each for each in analysis.captures.get("loop", []) if each.type == "for_statement"]
    for loop in (*analysis.captures.get("while", []), *loops):
        body = loop.child_by_field_name("body")
        if body is not None and all(is_sleep(analysis, each) for each in statements_of(body)):
            yield (
                ("while", *path_of(_function(analysis, loop))),
                f"the loop in line {line_of(loop)}",
            )


def _holder(node: NodeSite) -> Node | None:
    """Return the name that a call which makes a node of rclpy is assigned to."""
    assignment = node.call.parent if node.call is not None and node.owner is None else None
    target = assignment.child_by_field_name("left") if assignment is not None else None
    return target if target is not None and target.type == "identifier" else None


def _is_used(analysis: Analysis, held: Node) -> bool:
    variable = variable_of(held, analysis)
    return variable is None or any(
        each.use not in (Use.BINDING, Use.NOTHING) for each in references(variable, analysis)
    )


def _function(analysis: Analysis, loop: Node) -> Scope:
    scope = analysis.scopes.at(loop.start_byte)
    return scope.enclosing("function") or analysis.scopes.module
