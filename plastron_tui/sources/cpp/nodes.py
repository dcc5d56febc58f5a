"""The nodes of a unit, and which of its call sites belong to which."""

from __future__ import annotations

from dataclasses import replace

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import SourceEndpoint, SourceNode

from .analysis import Analysis, NodeSite, Site
from .details import Details
from .node_sites import find_nodes
from .scopes import Scope
from .timers import recreated


def group(analysis: Analysis) -> tuple[SourceNode, ...]:
    """Sort the call sites into the nodes of the files."""
    if not analysis.nodes:
        find_nodes(analysis)
    details = Details(analysis)
    makers = analysis.nodes
    again = recreated(analysis, analysis.sites)
    if not makers:
        known = tuple(details.of(each) for each in analysis.sites if each not in again)
        owner = main_class(analysis)
        name = owner.name if owner is not None else None
        return (SourceNode(None, "", known, None, name),) if known else ()
    owned = owned_sites(analysis)
    if analysis.ros_version == 1 and len(makers) == 1 and makers[0].owner is None:
        makers = [replace(makers[0], owner=main_class(analysis))]
    return tuple(
        _source_node(maker, tuple(details.of(each) for each in sites if each not in again))
        for maker, sites in zip(makers, owned, strict=True)
    )


def _source_node(maker: NodeSite, endpoints: tuple[SourceEndpoint, ...]) -> SourceNode:
    place = maker.place
    return SourceNode(
        maker.name,
        maker.expression,
        endpoints,
        Span(place.start_byte, place.end_byte),
        None if maker.owner is None else maker.owner.name,
        maker.is_managed,
    )


def owned_sites(analysis: Analysis) -> list[list[Site]]:
    """Return the call sites of each node."""
    makers = analysis.nodes
    if len(makers) == 1:
        return [analysis.sites]
    owned: list[list[Site]] = [[] for _ in makers]
    for site in analysis.sites:
        owned[_owner(site, analysis)].append(site)
    return owned


def main_class(analysis: Analysis) -> Scope | None:
    """Return the class of ROS 1 that is the node: the one that creates most, None for none."""
    found: dict[int, list[Scope]] = {}
    for site in analysis.sites:
        owner = analysis.unit.class_of(site.call.scope)
        if owner is not None:
            found.setdefault(id(owner), []).append(owner)
    return max(found.values(), key=len)[0] if found else None


def _owner(site: Site, analysis: Analysis) -> int:
    """Return the number of the node that a call site belongs to."""
    unit, makers = analysis.unit, analysis.nodes
    for at, maker in enumerate(makers):
        if site.node is not None and maker.variable is site.node:
            return at
    for owner in (site.owner, unit.class_of(site.call.scope)):
        if owner is None:
            continue
        for at, maker in enumerate(makers):
            if maker.owner is owner:
                return at
        # A class that is no node itself is a part of what derives from it.
        for at, maker in enumerate(makers):
            if maker.owner is not None and unit.derives_from(maker.owner, owner):
                return at
    function = site.call.scope.enclosing("function")
    for at, maker in enumerate(makers):
        is_here = maker.file is site.file and maker.owner is None and function is not None
        if is_here and function is not None:
            is_here = function.start <= maker.place.start_byte < function.end
        if is_here:
            return at
    for at, maker in enumerate(makers):
        if maker.file is site.file and maker.owner is None:
            return at
    return next((at for at, maker in enumerate(makers) if maker.file is site.file), 0)
