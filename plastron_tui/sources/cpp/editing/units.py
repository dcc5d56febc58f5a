"""A unit as an editor sees it: its files, its call sites, and the nodes that have them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from plastron_tui.model.source import EndpointKind, FileSet, Remove, Rename, SourceEndpoint, Update

from ..analysis import Analysis, Site
from ..nodes import group, owned_sites
from ..reader import LIBRARIES, analyze
from ..scopes import CppFile
from ..structure import outline
from ..syntax import parse
from ..unit import Unit

Key = tuple[EndpointKind, str | None, str, str]

Found = Counter[tuple[str, Key]]
"""The endpoints of a unit, each with the label of its node."""


def outlines_of(files: FileSet) -> list[CppFile]:
    """Return the files of a unit, parsed."""
    texts = [("" if at == 0 else name, text) for at, (name, text) in enumerate(files.texts)]
    return [outline(name, parse(text)) for name, text in texts]


def analyze_files(
    files: Iterable[CppFile], library: str, beside: Iterable[CppFile] = ()
) -> Analysis:
    """Return what is known of the files of a unit of a client library.

    Args:
        files: the files, the main one first.
        library: the client library.
        beside: other files that say what these leave open, see `sources_beside`.
    """
    analysis = analyze(Unit(files, beside), LIBRARIES[library])
    group(analysis)
    return analysis


def key_of(endpoint: SourceEndpoint) -> Key:
    """Return what makes two endpoints of a node equal; a timer's period may change."""
    if endpoint.kind is EndpointKind.TIMER:
        return (endpoint.kind, None, "", endpoint.callback or "")
    name = endpoint.name if endpoint.name is not None else endpoint.default
    name = endpoint.expression if name is None else name
    return (endpoint.kind, name, str(endpoint.type), endpoint.callback or "")


def labels_of(analysis: Analysis) -> dict[Site, str]:
    """Return the label of the node of each call site; "" where the files have one node only."""
    if len(analysis.nodes) < 2:
        return dict.fromkeys(analysis.sites, "")
    labels = [node.label for node in group(analysis)]
    owned = zip(labels, owned_sites(analysis), strict=True)
    return {site: label for label, sites in owned for site in sites}


def endpoints_of(analysis: Analysis, sites: Iterable[Site] | None = None) -> Found:
    """Return the endpoints of a unit, or of some of its call sites.

    By these an edit is held against what it was for.
    """
    labels = labels_of(analysis)
    found = analysis.sites if sites is None else sites
    return Counter((labels.get(site, ""), key_of(site.endpoint)) for site in found)


def sites_of(analysis: Analysis, change: Remove | Rename | Update) -> list[Site]:
    """Return the call sites of what a change is about; a default of a name counts as one."""
    labels, is_one = labels_of(analysis), len(analysis.nodes) < 2
    return [
        site
        for site in analysis.sites
        if site.endpoint.kind is change.kind
        and change.name in (site.endpoint.label, site.endpoint.default)
        and (is_one or change.node in (None, labels.get(site, "")))
    ]
