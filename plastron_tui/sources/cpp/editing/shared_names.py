"""Endpoints of one name in a class whose objects have endpoints of names of their own."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.sources.shared_names import shares_name

from .adding import Addition
from .origins import name_argument
from .renaming import depends_on_parameter


def shared_name(added: Addition) -> Diagnostic | None:
    """Return a warning where each object of a class creates an endpoint of one name.

    An object that has to be told what its other endpoints are called is seldom the only one.
    """
    analysis, owner = added.analysis, added.owner
    if owner is None or any(each.owner is owner for each in analysis.nodes):
        return None
    if len(analysis.callers.makers(owner)) == 1:
        return None
    for site in added.sites:
        given = name_argument(site)
        if site.call.scope.around is not added.place.function or given is None:
            continue
        if site.shape.kind.facts.interface and depends_on_parameter(analysis, given, site.place):
            line = site.endpoint.line
            return shares_name(owner.name, added.endpoint, f"line {line}")
    return None
