"""Which nodes are managed, and in which transition their endpoints are made.

Source: https://design.ros2.org/articles/node_lifecycle.html, `rclpy.lifecycle` of Jazzy.
"""

from __future__ import annotations

from tree_sitter import Node

from .analysis import Analysis, NodeSite, Site
from .references import identifiers, is_member
from .scopes import Scope

MANAGED = frozenset(
    f"rclpy.lifecycle.{name}"
    for name in ("Node", "LifecycleNode", "node.Node", "node.LifecycleNode")
)
"""The classes of lifecycle nodes."""

TRANSITIONS = frozenset(
    {"on_configure", "on_cleanup", "on_shutdown", "on_activate", "on_deactivate", "on_error"}
)
"""The methods that a transition calls."""

# A method of more calls is no helper of one transition.
_MOST_CALLS = 16
# Each is looked for in the whole file.
_MOST_HELPERS = 64


def is_managed(analysis: Analysis, maker: NodeSite) -> bool:
    """Tell whether a node is a lifecycle node."""
    if maker.owner is not None:
        return analysis.resolver.derives_from(maker.owner, MANAGED)
    callee = maker.call.child_by_field_name("function") if maker.call is not None else None
    return not MANAGED.isdisjoint(analysis.resolver.qualified(callee, maker.scope))


class Transitions:
    """The transitions of the managed nodes of one file, by what they call."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._resolver = analysis.resolver
        self._looked_up = 0
        self._found: dict[Scope, frozenset[str]] = {}
        text = analysis.syntax.text
        self._has_managed = b"on_" in text and b"ifecycle" in text

    def of(self, site: Site) -> str | None:
        """Return the transition in which a call is made: None for none, and for several."""
        function = site.scope.enclosing("function")
        if not self._has_managed or site.scope.kind == "lambda" or function is None:
            return None
        found = self._of_function(function)
        return next(iter(found)) or None if len(found) == 1 else None

    def _of_function(self, function: Scope) -> frozenset[str]:
        """Return the transitions that run a function, "" among them where something else may."""
        if function not in self._found:
            # What calls itself is run by what else calls it.
            self._found[function] = frozenset()
            self._found[function] = self._find(function)
        return self._found[function]

    def _find(self, function: Scope) -> frozenset[str]:
        if self._is_transition(function):
            return frozenset({function.name})
        calls = self._resolver.callers_of(function)
        if not 0 < len(calls) <= _MOST_CALLS or self._is_handed_on(function):
            return frozenset({""})
        found: set[str] = set()
        for call in calls:
            scope = self._analysis.scopes.at(call.start_byte)
            callee = call.child_by_field_name("function")
            if callee is not None and callee.type == "attribute":
                bindings = self._resolver.attribute_bindings(callee, scope)
                if bindings and all(each.owner is not function for each in bindings):
                    continue
            caller = scope.enclosing("function")
            found |= self._of_function(caller) if caller is not None else {""}
        return frozenset(found)

    def _is_handed_on(self, function: Scope) -> bool:
        """Whether the file names a function otherwise than to call it, so that others may."""
        self._looked_up += 1
        return self._looked_up > _MOST_HELPERS or not all(
            _is_called(node) or node.parent == function.node
            for node in identifiers(function.name, self._analysis)
        )

    def _is_transition(self, function: Scope) -> bool:
        owner = function.parent
        if function.name not in TRANSITIONS or owner is None or owner.kind != "class":
            return False
        family = [owner, *self._resolver.classes.derived(owner)]
        return any(self._resolver.derives_from(each, MANAGED) for each in family)


def _is_called(name: Node) -> bool:
    """Whether a name is what a call calls: `name()` or `self.name()`."""
    callee = name
    if is_member(name) and name.parent is not None and name.parent.type == "attribute":
        callee = name.parent
    call = callee.parent
    is_call = call is not None and call.type == "call"
    return is_call and call is not None and call.child_by_field_name("function") == callee
