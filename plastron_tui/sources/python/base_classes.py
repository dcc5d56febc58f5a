"""What a node creates through a class of another file of its package that its own derives from."""

from __future__ import annotations

import re
from collections.abc import Iterator

from plastron_tui.model.source import SourceEndpoint

from .analysis import Analysis, Site
from .details import Details
from .scopes import Scope


def inherited(analysis: Analysis, owner: Scope | None) -> list[SourceEndpoint]:
    """Return what the base classes of other files create for a node.

    Args:
        analysis: the file.
        owner: the class of the node, None for all classes that nothing in the file derives from.
    """
    if analysis.package is None:
        return []
    classes = analysis.scopes.classes() if owner is None else [owner]
    derived = analysis.resolver.classes.derived
    leaves = [each for each in classes if owner is not None or not derived(each)]
    found: dict[tuple[str, int], SourceEndpoint] = {}
    details: dict[int, Details] = {}
    for leaf in leaves:
        for module, site in inherited_sites(analysis, leaf):
            if module.package is not None:
                file = analysis.package.relative(module.package)
                # What a parameter may decide, the class of this file may decide otherwise.
                name = None if site.endpoint.is_guess else site.endpoint.name
                endpoint = (
                    details.setdefault(id(module), Details(module))
                    .of(site)
                    ._replace(file=file, name=name)
                )
                found.setdefault((file, site.call.start_byte), endpoint)
    return list(found.values())


def inherited_sites(
    analysis: Analysis, owner: Scope, seen: set[Scope] | None = None
) -> Iterator[tuple[Analysis, Site]]:
    """Yield the call sites that a class inherits from classes not yet seen, each with its file."""
    package = analysis.package
    if package is None:
        return
    seen = set() if seen is None else seen
    own = [owner, *analysis.resolver.classes.bases(owner)]
    for name in analysis.resolver.foreign_bases(owner):
        held = package.class_(name)
        if held is None or held[1] in seen:
            continue
        module, base = package.complete(held[0]), held[1]
        seen.add(base)
        family = [base, *module.resolver.classes.bases(base)]
        of_module = ((module, each) for each in module.sites)
        for file, site in (*of_module, *inherited_sites(module, base, seen)):
            classes = family if file is module else file.scopes.classes()
            method = _method(site, classes)
            if method is not None and not _is_replaced(method, own, analysis):
                yield file, site


def _method(site: Site, classes: list[Scope]) -> str | None:
    """Return the method of one of some classes that has a call site."""
    scope: Scope | None = site.scope
    while scope is not None and scope.parent is not None:
        if scope.kind == "function" and scope.parent in classes:
            return scope.name
        scope = scope.parent
    return None


def _is_replaced(method: str, classes: list[Scope], analysis: Analysis) -> bool:
    """Whether one of some classes has a method of its own, which does not call that of its base."""
    calls = re.compile(rf"\)\s*\.\s*{re.escape(method)}\s*\(|\w\.{re.escape(method)}\s*\(\s*self\b")
    for owner in classes:
        for binding in owner.bindings.get(method, ()):
            if not calls.search(analysis.syntax.slice(binding.node)):
                return True
    return False
