"""What a callback is, whatever it is wrapped in."""

from __future__ import annotations

from tree_sitter import Node

from .analysis import Analysis
from .arguments import Arguments
from .calls import Argument
from .scopes import Scope

_PARTIALS = frozenset({"functools.partial"})


def callback_target(node: Node | None, scope: Scope, analysis: Analysis) -> Node | None:
    """Unwrap `functools.partial(callback, …)`."""
    while node is not None and node.type == "call":
        callee = node.child_by_field_name("function")
        if not any(name in _PARTIALS for name in analysis.resolver.qualified(callee, scope)):
            return None
        node = Arguments.of(node, analysis.syntax).get(Argument(0, ""))
    return node
