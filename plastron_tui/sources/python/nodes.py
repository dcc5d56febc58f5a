"""The nodes of a file, and which of its call sites belong to which."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import SourceEndpoint, SourceNode

from .analysis import Analysis, NodeSite, Site
from .base_classes import inherited
from .details import Details
from .site_owner import Owners
from .timers import is_wait
from .transitions import is_managed


def group(analysis: Analysis) -> tuple[SourceNode, ...]:
    """Sort the call sites into the nodes of the file; what only waits is none of theirs."""
    analysis = replace(
        analysis, sites=[each for each in analysis.sites if not is_wait(analysis, each)]
    )
    makers = makers_of(analysis)
    details = Details(analysis)
    if analysis.disguised:
        sites = [*analysis.sites, *analysis.disguised]
        sites.sort(key=lambda site: site.call.start_byte)
        analysis = replace(analysis, sites=sites)
    if not makers:
        found = inherited(analysis, None)
        known = [*map(details.of, analysis.sites), *found]
        return (SourceNode(None, "", tuple(known)),) if known else ()
    return tuple(
        _source_node(maker, (*map(details.of, sites), *inherited(analysis, maker.owner)), analysis)
        for maker, sites in zip(makers, owned_sites(makers, analysis), strict=True)
    )


def part_of(analysis: Analysis, label: str | None) -> Analysis:
    """Return what is known of one of the nodes alone; of all for None."""
    makers = makers_of(analysis) if label is not None else []
    for maker, sites in zip(makers, owned_sites(makers, analysis), strict=True):
        if _label(maker) == label:
            return replace(analysis, sites=sites, nodes=[maker])
    return analysis


def labels_of(analysis: Analysis) -> dict[Site, str]:
    """Return the label of the node that each call site belongs to."""
    makers = makers_of(analysis)
    labels: dict[Site, str] = {}
    for maker, sites in zip(makers, owned_sites(makers, analysis), strict=True):
        labels.update(dict.fromkeys(sites, _label(maker)))
    return labels


def makers_of(analysis: Analysis) -> Sequence[NodeSite]:
    """Return what makes the nodes; the calls that name the one of a rospy file may disagree."""
    nodes = analysis.nodes
    if analysis.library.node_classes or len(nodes) < 2:
        return nodes
    first = nodes[0]
    if all(node.name == first.name for node in nodes):
        return [first]
    return [replace(first, name=None)]


def _source_node(
    maker: NodeSite, endpoints: tuple[SourceEndpoint, ...], analysis: Analysis
) -> SourceNode:
    place = maker.call if maker.call is not None else maker.scope.node
    span = Span(place.start_byte, place.end_byte)
    class_name = None if maker.owner is None else maker.owner.name
    managed = is_managed(analysis, maker)
    return SourceNode(maker.name, maker.expression, endpoints, span, class_name, managed)


def _label(maker: NodeSite) -> str:
    """Return what a program calls a node."""
    class_name = None if maker.owner is None else maker.owner.name
    return SourceNode(maker.name, "", (), None, class_name).label


def owned_sites(makers: Sequence[NodeSite], analysis: Analysis) -> Sequence[Sequence[Site]]:
    """Return the call sites of each node."""
    if len(makers) < 2:
        return [analysis.sites for _ in makers]
    owned: list[list[Site]] = [[] for _ in makers]
    owners = Owners(makers, analysis)
    for site in analysis.sites:
        owned[owners.owner(site)].append(site)
    return owned
