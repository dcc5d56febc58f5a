"""Changing an endpoint of a unit where it stands: what no change names stays as it is."""

from __future__ import annotations

from collections.abc import Set as AbstractSet

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import (
    ActionClient,
    Parameter,
    Publisher,
    Service,
    Subscription,
    Timer,
    callback_of,
    is_sending,
)
from plastron_tui.model.source import EndpointKind, Update
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.written_anew import written_anew

from ..analysis import Analysis, Site
from ..scopes import Function
from ..timers import recreated
from .accesses import access
from .addition import write_callback
from .clang_format import ClangFormat
from .deletions import Deletions
from .existing_callbacks import misfit
from .hearing import bound, existing
from .leftovers import functions_of, is_stub, remove_function
from .manner import held_by
from .pacing import set_period
from .place import beside
from .plans import Plan
from .redeclaring import redeclare, says_default
from .refilling import addition_at
from .refusals import not_there
from .replacing import NotInPlaceError, OtherCodeError, Replacement
from .requalifying import requalify
from .resending import answer, resend, sent_now
from .retyped_callbacks import vanishing
from .retyping import retype
from .units import key_of, labels_of, sites_of
from .uses import uses_of, word

# How many parameters the functions of a kind take.
_TAKEN = {EndpointKind.SUBSCRIPTION: 1, EndpointKind.SERVICE: 2}


def plan_update(
    analysis: Analysis,
    change: Update,
    catalog: Catalog,
    settings: ClangFormat | None = None,
    old: str | None = None,
) -> Plan:
    """Plan a change of an endpoint that has its new name already.

    Args:
        analysis: what is known of the files.
        change: what is asked for.
        catalog: the interface types.
        settings: what the settings around the files say of their layout.
        old: the name that it had before, None for the one that it has.

    Raises:
        NotInPlaceError: it is to be made apart.
        RefusedError: it cannot be made.
    """
    sites = sites_of(analysis, change)
    if not sites:
        raise not_there(analysis, change)
    if change.kind is EndpointKind.ACTION_SERVER:
        raise NotInPlaceError
    if any(each.call is site.call for site in sites for each in analysis.sites if each is not site):
        raise NotInPlaceError
    if isinstance(change.endpoint, Parameter) and not any(map(says_default, sites)):
        raise NotInPlaceError
    if len(sites) > 1 and is_sending(change.endpoint):
        raise NotInPlaceError
    plan, labels = Plan(), labels_of(analysis)
    again = recreated(analysis, sites)
    for site in sites:
        before = {name: list(each) for name, each in plan.splices.items()}
        update = Replacement(
            analysis, site, change, catalog, plan, settings or ClangFormat(), old or change.name
        )
        if isinstance(change.endpoint, Parameter):
            redeclare(update, change.endpoint)
            continue
        key = _change(update, is_again=site in again)
        for name, each in before.items():
            # What the call sites have in common is written once: a function, an include.
            new = plan.splices[name][len(each) :]
            plan.splices[name] = each + [splice for splice in new if splice not in each]
        plan.lost.append(site)
        plan.added.append((labels.get(site, ""), key))
    plan.lost += _parameters_in(analysis, plan)
    plan.notes = list(dict.fromkeys(plan.notes))
    return plan


def _parameters_in(analysis: Analysis, plan: Plan) -> list[Site]:
    """Return the parameters that were read in what is replaced."""
    return [
        site
        for site in analysis.sites
        if site.endpoint.kind is EndpointKind.PARAMETER
        and any(
            each.start <= site.call.node.start_byte < site.call.node.end_byte <= each.end
            for each in plan.splices.get(site.file.name, ())
        )
    ]


def _change(update: Replacement, *, is_again: bool) -> tuple[EndpointKind, str | None, str, str]:
    """Change one call; return what a reader finds of it then.

    A timer that is created again at a rate of its own keeps that.
    """
    site, endpoint = update.site, update.change.endpoint
    kind, name, type_, callback = key_of(site.endpoint)
    if isinstance(endpoint, Timer):
        try:
            _set_rate(update, endpoint, is_again=is_again)
        except NotInPlaceError:
            if not is_again:
                raise
        wanted: str | None = endpoint.name
    else:
        wanted = callback_of(endpoint)
    type_name = endpoint.type or site.endpoint.type
    is_retyped = type_name is not None and type_name != site.endpoint.type
    sent = sent_now(update, is_retyped=is_retyped) if is_sending(endpoint) else []
    calls_other = wanted is not None and wanted != site.endpoint.callback
    if type_name is not None and is_retyped:
        is_any = isinstance(endpoint, Publisher) or all(each.sent.is_helped for each in sent)
        if isinstance(endpoint, ActionClient) or not is_any:
            raise NotInPlaceError
        interface = update.change.kind.facts.interface
        assert interface is not None, "what has a type has a kind of it"
        try:
            retype(update, type_name, interface, calls_same=not calls_other, sent=sent)
        except OtherCodeError as error:
            retype(update, type_name, interface, calls_same=False)
            calls_other = True
            if not vanishing(update):
                _tell_lost(update, type_name, error.lack)
        type_ = str(type_name)
    if calls_other:
        callback = _call(update, wanted, is_retyped=is_retyped)
    elif isinstance(endpoint, Service) and endpoint.answer is not None:
        answer(update, endpoint)
    requalify(update)
    if is_sending(endpoint):
        resend(update, sent)
    return kind, name, type_, callback


def _set_rate(update: Replacement, timer: Timer, *, is_again: bool) -> None:
    site = update.site
    if timer.rate is None:
        return
    if timer.rate.parameter is not None or site.shape.name >= len(site.arguments):
        raise NotInPlaceError
    if _is_paced_elsewhere(update):
        raise NotInPlaceError
    given = site.arguments[site.shape.name]
    set_period(update, given, site.place, timer.rate.hertz, is_again=is_again)


def _is_paced_elsewhere(update: Replacement) -> bool:
    """Tell whether other code of the files overrules a period: `timer_.setPeriod(…)`."""
    held = held_by(update.analysis, update.site)
    used = () if held is None else uses_of(update.analysis, held)
    return any(access(update.analysis, file, node).method == "setPeriod" for file, node, _ in used)


def _tell_lost(update: Replacement, type_: InterfaceName, lack: str) -> None:
    """Tell that a function gets no messages any more, as they are not those it is made for."""
    endpoint, found = update.change.endpoint, update.site.endpoint
    if found.callback is None:
        return
    message = f"`{found.callback}` no longer gets `{endpoint.name}`: "
    message += f"it was written for `{found.type}`"
    if lack:
        message += f", and `{type_}` {lack}"
    help_ = "keep it with `calling`, and change it by hand"
    update.plan.notes.append(Diagnostic(codes.OTHER_TYPE, message, endpoint.span, help=help_))


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
    own = [each for functions in functions_of(analysis, site) for each in functions]
    name_node = _named(site, given, site.endpoint.callback) if given is not None else None
    if given is not None and given.type == "lambda_expression":
        return _replace_lambda(update, given, wanted, is_retyped=is_retyped)
    if name_node is None or not own:
        raise NotInPlaceError
    owner = analysis.unit.class_of_function(own[0])
    others = analysis.unit.functions_of(owner, wanted or "")
    if wanted is not None and others:
        if _has_answer(update):
            raise NotInPlaceError
        type_ = update.change.endpoint.type or site.endpoint.type
        if misfit(analysis, update.change.kind, others[0], type_) is not None:
            raise NotInPlaceError
        if not is_retyped and not _takes_same(others[0], own[0]):
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
    place = beside(analysis, site)
    if place is None or place.owner is not owner:
        # The call names the class of its function.
        raise NotInPlaceError
    gone = Deletions()
    stubs = vanishing(update) if is_retyped else []
    for each in stubs:
        remove_function(each, gone)
    name = _write(update, is_retyped=is_retyped, instead_of={each.name for each in stubs})
    update.put(site.place.file, name_node, name)
    for file in gone.files:
        update.plan.splices[file.name] += gone.splices(file)
    return name


def _has_answer(update: Replacement) -> bool:
    endpoint = update.change.endpoint
    return isinstance(endpoint, Service) and endpoint.answer is not None


def _replace_lambda(
    update: Replacement, given: Node, wanted: str | None, *, is_retyped: bool
) -> str:
    """Let an endpoint call a function instead of a lambda; what that did is told to go."""
    site, endpoint = update.site, update.change.endpoint
    takes = _TAKEN.get(site.shape.kind)
    added = addition_at(update)
    found = None if wanted is None else existing(added, wanted)
    says_type = bool(site.call.type_nodes)
    if takes is None or not says_type or (found is not None and _has_answer(update)):
        raise NotInPlaceError
    type_ = endpoint.type or site.endpoint.type
    if found is not None and (
        len(found.parameters) != takes
        or misfit(update.analysis, update.change.kind, found, type_) is not None
    ):
        raise NotInPlaceError
    name = found.name if found is not None else _write(update, is_retyped=is_retyped)
    handed = bound(added, name, takes)
    update.put(site.place.file, given, ", ".join(handed))
    text = " ".join(site.place.file.syntax.slice(given).split())
    message = f"`{text}` of `{update.old}` is not kept for `{endpoint.name}`"
    update.plan.notes.append(written_anew(message, endpoint, update.old))
    return name


def _write(
    update: Replacement, *, is_retyped: bool, instead_of: AbstractSet[str] = frozenset()
) -> str:
    """Write a function that logs, in the manner of those that the files have."""
    if not isinstance(update.change.endpoint, Subscription | Service):
        raise NotInPlaceError
    added = addition_at(update)
    added.taken -= instead_of
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
