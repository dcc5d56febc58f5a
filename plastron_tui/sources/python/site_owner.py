"""Which node of a file a call site belongs to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from .analysis import Analysis, NodeSite, Site
from .scopes import Scope


class Owners:
    """The nodes of one file, by what tells that a call site is near to one of them.

    A rank says how near; of those that are equally near the first counts. Nothing is asked of
    each site and each node: there are as many of both as the file is large.
    """

    def __init__(self, makers: Sequence[NodeSite], analysis: Analysis) -> None:
        self._analysis = analysis
        self._classes: dict[Scope, int] = {}
        self._variables: dict[tuple[Scope, str], int] = {}
        self._within: dict[Scope, int] = {}
        self._makers: dict[Scope, int] = {}
        for index, maker in enumerate(makers):
            if maker.owner is not None:
                self._classes.setdefault(maker.owner, index)
                continue
            variable = self._assigned(maker)
            if variable:
                self._variables.setdefault((maker.scope, variable), index)
            if maker.scope not in self._makers:
                self._makers[maker.scope] = index
                for scope in _around(maker.scope):
                    self._within.setdefault(scope, index)
        self._making = self._makers_of_classes()

    def owner(self, site: Site) -> int:
        """Return the index of the node that a call site belongs to."""
        return -max(self._ranked(site), default=(0, 0))[1]

    def _ranked(self, site: Site) -> Iterator[tuple[int, int]]:
        """Yield ranks with indices, which are negative: the first is the greatest."""
        yield 0, 0
        if site.owner is not None and site.owner in self._classes:
            yield 100, -self._classes[site.owner]
        scopes = list(_around(site.scope))
        for scope in scopes:
            if (scope, site.receiver) in self._variables:
                yield 90, -self._variables[scope, site.receiver]
            if site.owner is None and scope in self._classes:
                yield 60, -self._classes[scope]
        owner = site.scope.enclosing("class")
        made = self._making.get(owner.name, {}) if owner is not None else {}
        for base, nodes in ((50, made), (0, self._within)):
            for depth, scope in zip(range(len(scopes), 0, -1), scopes, strict=True):
                if scope in nodes:
                    yield base + depth, -nodes[scope]
                    break

    def _assigned(self, maker: NodeSite) -> str:
        """Return the variable that a made node is assigned to."""
        assigned = maker.call.parent if maker.call is not None else None
        is_assigned = assigned is not None and assigned.type == "assignment"
        target = assigned.child_by_field_name("left") if assigned and is_assigned else None
        return self._analysis.syntax.slice(target) if target is not None else ""

    def _makers_of_classes(self) -> dict[str, dict[Scope, int]]:
        """Find the functions that make an instance of a class of the file as well as a node."""
        names = {scope.name for scope in self._analysis.scopes.classes()}
        found: dict[str, dict[Scope, int]] = {}
        pairs: set[tuple[int, str]] = set()
        for call in self._analysis.captures.get("call", []):
            callee = call.child_by_field_name("function")
            if callee is None or callee.type != "identifier":
                continue
            name = self._analysis.syntax.slice(callee)
            scope = self._analysis.scopes.at(call.start_byte)
            if name in names and scope in self._makers:
                pairs.add((self._makers[scope], name))
        scopes = {index: scope for scope, index in self._makers.items()}
        for index, name in sorted(pairs):
            for scope in _around(scopes[index]):
                found.setdefault(name, {}).setdefault(scope, index)
        return found


def _around(scope: Scope | None) -> Iterator[Scope]:
    """Yield a scope and those that it is in, the innermost first."""
    while scope is not None:
        yield scope
        scope = scope.parent
