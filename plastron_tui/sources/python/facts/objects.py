"""Which calls the objects of a file come from, where that is sure."""

from __future__ import annotations

from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.constants import MOST_BINDINGS, without_none
from plastron_tui.sources.python.scopes import Binding, BindingKind, Scope

_MOST_DEEP = 6


class Making(NamedTuple):
    """A call that gives an object, and the scope that it is in."""

    call: Node
    scope: Scope


class Objects:
    """The objects of one file."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._sites = {site.call.id: site for site in analysis.first_sites()}

    def sites(self, node: Node | None, scope: Scope) -> tuple[Site, ...]:
        """Return the call sites that an object may come from; none where it may be another."""
        made = self.makings(node, scope)
        found = [self._sites[each.call.id] for each in made if each.call.id in self._sites]
        return tuple(found) if len(found) == len(made) else ()

    def makings(self, node: Node | None, scope: Scope, depth: int = 0) -> tuple[Making, ...]:
        """Return all calls that an object may come from; none where it may come from elsewhere."""
        if node is None or depth > _MOST_DEEP:
            return ()
        if node.type == "parenthesized_expression" and node.named_child_count == 1:
            return self.makings(node.named_children[0], scope, depth + 1)
        if node.type == "call":
            given = self._analysis.resolver.result(node, scope)
            if given is None:
                return (Making(node, scope),)
            return self.makings(given.node, given.scope, depth + 1)
        found: list[Making] = []
        bindings = without_none(self._bindings(node, scope))
        for binding in bindings[:MOST_BINDINGS]:
            made = self._bound(binding, node, depth)
            if not made:
                return ()
            found += made
        return tuple(dict.fromkeys(found)) if len(bindings) <= MOST_BINDINGS else ()

    def _bindings(self, node: Node, scope: Scope) -> list[Binding]:
        if node.type == "attribute":
            return self._analysis.resolver.attribute_bindings(node, scope)
        if node.type != "identifier":
            return []
        found = scope.lookup(self._analysis.syntax.slice(node))
        return found[1] if found is not None else []

    def _bound(self, binding: Binding, node: Node, depth: int) -> tuple[Making, ...]:
        if binding.kind is BindingKind.VALUE:
            return self.makings(binding.value, binding.scope, depth + 1)
        if binding.kind is not BindingKind.PARAMETER:
            return ()
        found: list[Making] = []
        given = self._analysis.resolver.given(binding, self._analysis.syntax.slice(node))
        for value, scope in given:
            made = self.makings(value, scope, depth + 2)
            if not made:
                return ()
            found += made
        return tuple(found)
