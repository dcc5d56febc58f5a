"""How often the loops and the timers of a file run, where the file says so literally."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .constants import Known
from .scopes import Scope
from .syntax import parts_of

_MAKERS = ("Rate", "create_rate")
_DURATIONS = ("Duration", "from_sec")


def loop_rate(analysis: Analysis, loop: Node) -> float | None:
    """Return the rate of a loop in Hz, None where it is not literal or it sleeps twice."""
    scope = analysis.scopes.at(loop.start_byte)
    rates = []
    for call in analysis.captures.get("call", []):
        is_inside = loop.start_byte <= call.start_byte and call.end_byte <= loop.end_byte
        callee = call.child_by_field_name("function") if is_inside else None
        holder = callee.child_by_field_name("object") if callee is not None else None
        if holder is not None and _last(analysis, callee) == "sleep":
            given = _first(call)
            if given is not None:
                rates.append(_inverse(_number(analysis, given, scope)))
            else:
                rates.append(_made_rate(analysis, holder, scope))
    return rates[0] if len(rates) == 1 else None


def timer_rate(analysis: Analysis, site: Site) -> float | None:
    """Return the rate of a timer in Hz, None where it is not literal."""
    assert site.endpoint.kind is EndpointKind.TIMER
    given = site.arguments.get(site.shape.name)
    return _inverse(_number(analysis, given, site.scope)) if given is not None else None


def _made_rate(analysis: Analysis, holder: Node, scope: Scope) -> float | None:
    """Return the rate that an object sleeps at, from the one call that makes it."""
    if holder.type == "identifier":
        found = scope.lookup(analysis.syntax.slice(holder))
        values = [each.value for each in found[1]] if found is not None else []
    elif holder.type == "attribute":
        bindings = analysis.resolver.attribute_bindings(holder, scope)
        values = [each.value for each in bindings]
    else:
        values = [holder]
    made = values[0] if len(values) == 1 else None
    callee = made.child_by_field_name("function") if made is not None else None
    given = _first(made) if made is not None and _last(analysis, callee) in _MAKERS else None
    if made is None or given is None:
        return None
    return _number(analysis, given, analysis.scopes.at(made.start_byte))


def _number(analysis: Analysis, node: Node, scope: Scope) -> float | None:
    """Return a literal number, also one in `rospy.Duration(…)`."""
    callee = node.child_by_field_name("function") if node.type == "call" else None
    inner = _first(node) if _last(analysis, callee) in _DURATIONS else None
    folded = analysis.resolver.fold(inner or node, scope)
    value = folded.value if isinstance(folded, Known) else None
    if value is None and node.type == "binary_operator":
        return _quotient(analysis, node, scope)
    return float(value) if isinstance(value, int | float) else None


def _quotient(analysis: Analysis, node: Node, scope: Scope) -> float | None:
    """Return what `1.0 / 30` is."""
    parts = [node.child_by_field_name(name) for name in ("left", "operator", "right")]
    left, operator, right = parts
    if left is None or right is None or operator is None or operator.type != "/":
        return None
    above, below = _number(analysis, left, scope), _number(analysis, right, scope)
    return above / below if above is not None and below else None


def _inverse(seconds: float | None) -> float | None:
    return 1 / seconds if seconds else None


def _first(call: Node) -> Node | None:
    """Return the first argument of a call."""
    first = next(iter(parts_of(call.child_by_field_name("arguments"))), None)
    is_named = first is not None and first.type == "keyword_argument"
    return first.child_by_field_name("value") if first is not None and is_named else first


def _last(analysis: Analysis, callee: Node | None) -> str:
    """Return the last part of a dotted name."""
    return analysis.syntax.slice(callee).rpartition(".")[2] if callee is not None else ""
