"""What calls a function of a file, as far as all that may do so is known."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.functions import function_uses
from plastron_tui.sources.python.references import function_of, is_member
from plastron_tui.sources.python.scopes import Scope

_MOST_CALLS = 16


def future_of(analysis: Analysis, function: Scope) -> Node | None:
    """Return the future that a function alone is called with, by `add_done_callback`."""
    if b"add_done_callback" not in analysis.syntax.text:
        return None
    uses = function_uses(analysis, function)
    given = uses[0] if len(uses) == 1 else None
    given = given.parent if given is not None and is_member(given) else given
    call = given.parent.parent if given is not None and given.parent is not None else None
    if call is None or analysis.syntax.called_name(call) != "add_done_callback":
        return None
    callee = call.child_by_field_name("function")
    return callee.child_by_field_name("object") if callee is not None else None


def calls_of(analysis: Analysis, function: Scope) -> list[Node] | None:
    """Return the calls of a function; None where something else may call it as well."""
    if function.kind != "function" or function.name.startswith("__"):
        return None
    calls: list[Node] = []
    for use in function_uses(analysis, function):
        callee = use.parent if use.parent is not None and is_member(use) else use
        call = callee.parent
        called = call.child_by_field_name("function") if call is not None else None
        if call is None or call.type != "call" or called is None or called.id != callee.id:
            return None
        if function_of(callee, analysis) is not function or len(calls) > _MOST_CALLS:
            return None
        calls.append(call)
    return calls
