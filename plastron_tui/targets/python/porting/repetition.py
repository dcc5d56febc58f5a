"""What a file makes anew at each pass of a loop, or each call of a function.

An object of rospy goes with its last name. The node of rclpy keeps what it made until it is
destroyed: timers of rates, publishers, clients.
"""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python.references import function_of
from plastron_tui.sources.python.scopes import Scope
from plastron_tui.sources.python.syntax import FUNCTIONS, REPEATING, is_in_loop

from .endpoints import destroys_endpoints
from .port_state import Work

_ENDLESS = frozenset({"while_statement"})
_ENDPOINTS = frozenset({EndpointKind.PUBLISHER, EndpointKind.CLIENT})


def is_called_often(work: Work, call: Node, loops: frozenset[str] = REPEATING) -> bool:
    """Tell whether the function of a call is called from a loop or a callback, or is one."""
    callers: dict[int, list[Node]] = {}
    for each in work.analysis.captures.get("call", []):
        callee = each.child_by_field_name("function")
        function = function_of(callee, work.analysis) if callee is not None else None
        if function is not None:
            callers.setdefault(function.node.id, []).append(each)
    pending: list[Scope | None] = [work.scope(call).enclosing("function")]
    seen: set[int] = set()
    while pending:
        scope = pending.pop()
        if scope is None or scope.node.id in seen:
            continue
        if scope.node.id in work.callbacks:
            return True
        seen.add(scope.node.id)
        for caller in callers.get(scope.node.id, []):
            if is_in_loop(caller, loops):
                return True
            pending.append(work.scope(caller).enclosing("function"))
    return False


def mark_repeated_endpoints(work: Work) -> None:
    """Mark publishers and clients that a callback, or a loop that goes on, makes each time."""
    if destroys_endpoints(work):
        return
    for site in work.analysis.first_sites():
        if site.endpoint.kind not in _ENDPOINTS or site.shape.gives_message:
            continue
        if _is_conditional(site.call):
            continue
        if is_in_loop(site.call, _ENDLESS) or is_called_often(work, site.call, _ENDLESS):
            what = site.endpoint.kind.value.removesuffix("s")
            remedy = "make it once: the node keeps each, until `destroy_...` of the node"
            work.mark(site.call, f"a {what} on each call", remedy)


def _is_conditional(call: Node) -> bool:
    """Tell whether a call is in an `if` of its function, which may see whether it is the first."""
    current: Node | None = call
    while current is not None and current.type not in FUNCTIONS:
        if current.type == "if_statement":
            return True
        current = current.parent
    return False
