"""Where something is sent through a variable that a file has: where that is seen."""

from __future__ import annotations

from dataclasses import replace

from ..analysis import Analysis, Site
from ..scopes import Variable
from .adding import Addition
from .place import Place, beside, start_rank
from .visibility import sees_member


def goes_where_it_is_seen(added: Addition, site: Site, variable: Variable) -> bool:
    """Let an endpoint go where a variable is seen as long as the node runs; tell whether it can.

    Args:
        added: the endpoint.
        site: what creates what the variable holds.
        variable: the variable.
    """
    analysis = added.analysis
    if variable.kind == "local":
        place = added.place if added.place.beside is site else beside(analysis, site)
        found = None if place is None else _in_its_block(place, site, variable)
    elif _is_seen(analysis, added.place, site, variable):
        return True
    else:
        found = beside(analysis, site)
    if found is None or not _is_seen(analysis, found, site, variable):
        return False
    if start_rank(analysis, found.function) is None or _is_called_back(analysis, found):
        return False
    added.place = found
    return True


def _in_its_block(place: Place, site: Site, variable: Variable) -> Place | None:
    """Return the place in the block that has a call, None where the variable ends before it."""
    after = site.call.node
    while after.parent is not None and after.parent.type != "compound_statement":
        after = after.parent
    if after.parent is None:
        return None
    if after.parent.id == place.body.id:
        after = place.after or after
    declared = variable.node
    is_within = after.start_byte <= declared.start_byte and declared.end_byte <= after.end_byte
    if declared.id != after.id and is_within and variable.file is place.file:
        # `if (T a = b)`: it is seen in that statement alone.
        return None
    block = after.parent
    return None if block is None else replace(place, body=block, after=after)


def _is_seen(analysis: Analysis, place: Place, site: Site, variable: Variable) -> bool:
    if variable.kind == "local":
        # A variable of a method is gone, or not seen, in the method that sends.
        is_there = place.beside is site
        return is_there and place.owner is None and not _is_called_back(analysis, place)
    if variable.kind == "member":
        return sees_member(analysis, place.owner, variable)
    return True


def _is_called_back(analysis: Analysis, place: Place) -> bool:
    node = place.function.node
    return any(
        each.node.id == node.id for site in analysis.sites for each in site.callback.functions
    )
