"""Where something is sent through a variable that a file has: where that is seen."""

from __future__ import annotations

from ..analysis import Analysis, Site
from ..scopes import Variable
from .adding import Addition
from .place import Place, beside, start_rank


def goes_where_it_is_seen(added: Addition, site: Site, variable: Variable) -> bool:
    """Let an endpoint go where a variable is seen as long as the node runs; tell whether it can.

    Args:
        added: the endpoint.
        site: what creates what the variable holds.
        variable: the variable.
    """
    analysis = added.analysis
    if _is_seen(analysis, added.place, site, variable):
        return True
    found = beside(analysis, site)
    if found is None or not _is_seen(analysis, found, site, variable):
        return False
    if start_rank(analysis, found.function) is None or _is_called_back(analysis, found):
        return False
    added.place = found
    return True


def _is_seen(analysis: Analysis, place: Place, site: Site, variable: Variable) -> bool:
    if variable.kind == "local":
        # A variable of a method is gone, or not seen, in the method that sends.
        is_there = place.beside is site
        return is_there and place.owner is None and not _is_called_back(analysis, place)
    if variable.kind == "member":
        owner = place.owner
        return owner is not None and analysis.unit.member(owner, variable.name) is variable
    return True


def _is_called_back(analysis: Analysis, place: Place) -> bool:
    node = place.function.node
    return any(
        each.node.id == node.id for site in analysis.sites for each in site.callback.functions
    )
