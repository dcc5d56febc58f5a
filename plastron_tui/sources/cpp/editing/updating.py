"""Changing an endpoint of a unit where it stands: what no change names stays as it is."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.kinds import (
    Client,
    Parameter,
    Service,
    Subscription,
    Timer,
    callback_of,
    is_sending,
)
from plastron_tui.model.source import EndpointKind, Update
from plastron_tui.ros.catalog import Catalog

from ..analysis import Analysis, Site
from ..scopes import Function
from .adding import Addition
from .addition import write_callback
from .interfaces import Interfaces
from .leftovers import functions_of, is_stub
from .manner import identifiers
from .pacing import set_period
from .place import beside, sites_of_node
from .plans import Plan
from .redeclaring import redeclare, says_default
from .refusals import not_there
from .replacing import NotInPlaceError, OtherCodeError, Replacement
from .requalifying import requalify
from .resending import resend
from .retyping import retype
from .units import key_of, labels_of, sites_of
from .uses import word

_ACTIONS = frozenset({EndpointKind.ACTION_CLIENT, EndpointKind.ACTION_SERVER})

# How many parameters the functions of a kind take.
_TAKEN = {EndpointKind.SUBSCRIPTION: 1, EndpointKind.SERVICE: 2}


def plan_update(analysis: Analysis, change: Update, catalog: Catalog) -> Plan:
    """Plan a change of an endpoint that has its new name already.

    Raises:
        NotInPlaceError: it is to be made apart.
        RefusedError: it cannot be made.
    """
    sites = sites_of(analysis, change)
    if not sites:
        raise not_there(analysis, change)
    if change.kind in _ACTIONS:
        raise NotInPlaceError
    if any(each.call is site.call for site in sites for each in analysis.sites if each is not site):
        raise NotInPlaceError
    if isinstance(change.endpoint, Parameter) and not any(map(says_default, sites)):
        raise NotInPlaceError
    plan, labels = Plan(), labels_of(analysis)
    for site in sites:
        update = Replacement(analysis, site, change, catalog, plan)
        if isinstance(change.endpoint, Parameter):
            redeclare(update, change.endpoint)
            continue
        key = _change(update)
        plan.lost.append(site)
        plan.added.append((labels.get(site, ""), key))
    plan.notes = list(dict.fromkeys(plan.notes))
    return plan


def _change(update: Replacement) -> tuple[EndpointKind, str | None, str, str]:
    """Change one call; return what a reader finds of it then."""
    site, endpoint = update.site, update.change.endpoint
    kind, name, type_, callback = key_of(site.endpoint)
    if isinstance(endpoint, Service) and endpoint.answer is not None:
        raise NotInPlaceError
    if isinstance(endpoint, Client) and is_sending(endpoint):
        raise NotInPlaceError
    if isinstance(endpoint, Timer):
        if endpoint.rate is not None:
            if endpoint.rate.parameter is not None or site.shape.name >= len(site.arguments):
                raise NotInPlaceError
            set_period(update, site.arguments[site.shape.name], site.place, endpoint.rate.hertz)
        wanted: str | None = endpoint.name
    else:
        wanted = callback_of(endpoint)
    type_name = endpoint.type or site.endpoint.type
    calls_other = wanted is not None and wanted != site.endpoint.callback
    if type_name is not None and type_name != site.endpoint.type:
        interface = update.change.kind.facts.interface
        assert interface is not None, "what has a type has a kind of it"
        try:
            retype(update, type_name, interface, calls_same=not calls_other)
        except OtherCodeError:
            retype(update, type_name, interface, calls_same=False)
            calls_other = True
        type_ = str(type_name)
    if calls_other:
        callback = _call(update, wanted, is_retyped=type_name != site.endpoint.type)
    requalify(update)
    resend(update)
    return kind, name, type_, callback


def _call(update: Replacement, wanted: str | None, *, is_retyped: bool) -> str:
    """Let an endpoint call another function of the file, a new one, or its stub be called so.

    Raises:
        NotInPlaceError: the call does not name a function.
    """
    analysis, site = update.analysis, update.site
    position = site.shape.callback
    given = (
        site.arguments[position]
        if position is not None and position < len(site.arguments)
        else None
    )
    own = [each for listed in functions_of(analysis, site) for each in listed]
    name_node = _named(site, given, site.endpoint.callback) if given is not None else None
    if name_node is None or not own:
        raise NotInPlaceError
    owner = analysis.unit.class_of_function(own[0])
    others = [
        each
        for each in analysis.unit.functions.get(wanted or "", ())
        if analysis.unit.class_of_function(each) is owner
    ]
    if wanted is not None and others:
        if is_retyped or not _takes_same(others[0], own[0]):
            raise NotInPlaceError
        update.put(site.place.file, name_node, wanted)
        return wanted
    is_stub_alone = all(is_stub(each) for each in own if each.scope is not None)
    if wanted is not None and is_stub_alone and not is_retyped and not _is_taken(analysis, wanted):
        _rename_function(update, own, wanted)
        return wanted
    if (
        update.change.kind is EndpointKind.TIMER
        or len(own[0].parameters) != _TAKEN[site.shape.kind]
    ):
        raise NotInPlaceError
    name = _write(update, is_retyped=is_retyped)
    update.put(site.place.file, name_node, name)
    return name


def _write(update: Replacement, *, is_retyped: bool) -> str:
    """Write a function that logs, in the manner of those that the files have."""
    analysis, site, change = update.analysis, update.site, update.change
    place = beside(analysis, site)
    type_ = change.endpoint.type or site.endpoint.type
    if place is None or type_ is None or not isinstance(change.endpoint, Subscription | Service):
        raise NotInPlaceError
    own = [each for listed in functions_of(analysis, site) for each in listed]
    if any(analysis.unit.class_of_function(each) is not place.owner for each in own):
        # The call names the class of its function.
        raise NotInPlaceError
    label = labels_of(analysis).get(site, "")
    sites = sites_of_node(analysis, change.node)
    interfaces = Interfaces(update.catalog, analysis.ros_version)
    endpoint = change.endpoint._replace(type=type_)
    added = Addition(
        analysis, change.kind, endpoint, place, interfaces, sites, identifiers(analysis), label
    )
    name = write_callback(added)
    for file, splices in added.plan.splices.items():
        update.plan.splices[file] += [
            each
            for each in splices
            if not (is_retyped and each.text.lstrip().startswith(b"#include"))
        ]
    update.plan.notes += added.plan.notes
    return name


def _named(site: Site, given: Node, name: str | None) -> Node | None:
    """Return what names a function in what is called back."""
    if name is None:
        return None
    found = []
    stack = [given]
    while stack:
        node = stack.pop()
        if node.type == "lambda_expression":
            return None
        is_name = node.type in ("identifier", "field_identifier")
        if is_name and site.place.file.syntax.word(node) == name:
            found.append(node)
        stack += node.named_children
    return found[0] if len(found) == 1 else None


def _takes_same(one: Function, other: Function) -> bool:
    """Tell whether two functions take parameters of the same types."""
    return [each.type for each in one.parameters] == [each.type for each in other.parameters]


def _is_taken(analysis: Analysis, name: str) -> bool:
    return any(word(name).search(file.syntax.code) for file in analysis.unit.files)


def _rename_function(update: Replacement, functions: list[Function], wanted: str) -> None:
    """Give a function another name where it is declared, defined and called."""
    name = functions[0].name
    for file in update.analysis.unit.files:
        for found in word(name).finditer(file.syntax.code):
            node = file.syntax.root.named_descendant_for_byte_range(found.start(), found.end())
            if node is not None and node.type.endswith("identifier"):
                update.put_between(file, found.start(), found.end(), wanted)
