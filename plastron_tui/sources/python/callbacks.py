"""What a callback is, whatever it is wrapped in."""

from __future__ import annotations

from tree_sitter import Node

from .analysis import Analysis
from .arguments import Arguments
from .calls import Argument
from .scopes import BindingKind, Scope

_PARTIALS = frozenset({"functools.partial"})


def callback_target(node: Node | None, scope: Scope, analysis: Analysis) -> Node | None:
    """Unwrap `functools.partial(callback, …)`, also where a name of its own is given to it."""
    if node is not None and node.type == "identifier":
        node = _named_partial(node, scope, analysis) or node
    while node is not None and node.type == "call":
        if not is_partial(node, scope, analysis):
            return None
        node = Arguments.of(node, analysis.syntax).get(Argument(0, ""))
    return node


def _named_partial(node: Node, scope: Scope, analysis: Analysis) -> Node | None:
    """Return the call that a name is bound to, if that wraps a callback and nothing else does."""
    found = scope.lookup(analysis.syntax.slice(node))
    if found is None or len(found[1]) != 1 or found[1][0].kind is not BindingKind.VALUE:
        return None
    value = found[1][0].value
    is_call = value is not None and value.type == "call"
    return value if value is not None and is_call and is_partial(value, scope, analysis) else None


def is_partial(call: Node, scope: Scope, analysis: Analysis) -> bool:
    """Whether a call is `functools.partial(…)`."""
    callee = call.child_by_field_name("function")
    return any(name in _PARTIALS for name in analysis.resolver.qualified(callee, scope))


def callback_name(analysis: Analysis, node: Node | None, scope: Scope) -> str | None:
    """Return the name of a callback, None for one that has no name."""
    node = callback_target(node, scope, analysis)
    if node is None or node.type not in ("identifier", "attribute"):
        return None
    return analysis.syntax.slice(node).rpartition(".")[2].strip()
