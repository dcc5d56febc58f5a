"""Where something is sent through a variable that a file has: where that is seen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plastron_tui.diagnostics import listed

from ..analysis import Analysis, Site
from ..scopes import Variable
from .adding import Addition
from .manner import held_by
from .place import Place, beside, leaves, start_rank
from .refusals import RefusedError
from .visibility import sees_member


def goes_where_it_is_seen(added: Addition, site: Site, variable: Variable) -> bool:
    """Let an endpoint go where a variable is seen as long as the node runs; tell whether it can.

    Args:
        added: the endpoint.
        site: what creates what the variable holds.
        variable: the variable.
    """
    analysis = added.analysis
    place = added.place
    if variable.kind == "local":
        if place.beside is site and _may_name(analysis, place, variable):
            return True
        found = _behind_creation(analysis, site)
        if found is None or _is_declared_within(found, variable) or _ends(analysis, found):
            return False
    elif variable.kind != "member" or sees_member(analysis, place.owner, variable):
        _go_into_its_block(added, site, variable)
        return True
    else:
        found = beside(analysis, site)
        if found is None or not sees_member(analysis, found.owner, variable):
            return False
    if start_rank(analysis, found.function) is None or _is_called_back(analysis, found):
        return False
    added.place = found
    return True


def check_one_function_creates(added: Addition, sites: Sequence[Site]) -> None:
    """Refuse to send through what several functions create: any one of them may run.

    Raises:
        RefusedError: several do.
    """
    functions = {id(added.analysis.unit.function_of(site.call.scope)) for site in sites}
    if len(functions) > 1:
        lines = listed(str(site.endpoint.line) for site in sites)
        message = f"lines {lines} create `{added.endpoint.name}` in functions of which any may run"
        raise RefusedError(message, added.span, "let one function create it first")


def _go_into_its_block(added: Addition, site: Site, variable: Variable) -> None:
    """Let an endpoint go into the `if` that alone creates what it is sent through."""
    analysis, place = added.analysis, added.place
    creating = [each for each in analysis.sites if held_by(analysis, each) is variable]
    found = _behind_creation(analysis, site)
    if len(creating) == 1 and found is not None and found.function is place.function:
        added.place = place if found.body.id == place.body.id else found


def _may_name(analysis: Analysis, place: Place, variable: Variable) -> bool:
    named = analysis.unit.lookup(variable.name, place.scope, place.offset)
    return named is variable and not _ends(analysis, place)


def _ends(analysis: Analysis, place: Place) -> bool:
    """Tell whether what is local at a place ends before the node does."""
    return place.owner is not None or _is_called_back(analysis, place)


def _behind_creation(analysis: Analysis, site: Site) -> Place | None:
    """Return the place behind the statement of a call, in the block that has it."""
    place = beside(analysis, site)
    node = site.call.node
    while node.parent is not None and node.parent.type != "compound_statement":
        node = node.parent
    if place is None or node.parent is None or leaves(node):
        return None
    return replace(place, body=node.parent, after=node)


def _is_declared_within(place: Place, variable: Variable) -> bool:
    """Tell whether a variable ends with the statement behind which a place is: `if (T a = b)`."""
    after, node = place.after, variable.node
    if after is None or after.id == node.id or variable.file is not place.file:
        return False
    return after.start_byte <= node.start_byte and node.end_byte <= after.end_byte


def _is_called_back(analysis: Analysis, place: Place) -> bool:
    node = place.function.node
    return any(
        each.node.id == node.id for site in analysis.sites for each in site.callback.functions
    )
