"""Changing an endpoint of a file where it stands: what no change names stays as it is."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.kinds import callback_of
from plastron_tui.model.source import Update
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface
from plastron_tui.sources.written_anew import written_anew

from .adding import callback_for
from .addition import Addition
from .analysis import Analysis, Site
from .calls import ACTIONS
from .conventions import target_name
from .dialect import Dialect
from .existing_callbacks import check_parameters, misfit
from .functions import callback_scope
from .generated import body_of, is_stub
from .handed_on import HandedOn, handed_by_call, handed_by_partial
from .leftovers import stub_callbacks
from .message_filters import hands_on, takers
from .place import beside
from .qos_arguments import requalify
from .renaming import NotNamedError, plan_names
from .replacing import NotInPlaceError, Replacement
from .retyped_callbacks import missing_fields, needs_type, retype_callback
from .scopes import BindingKind, Scope
from .sent_messages import resend
from .splices import Splice, delete_statements


def plan_update(
    analysis: Analysis, site: Site, change: Update, catalog: Catalog, dialect: Dialect
) -> Replacement:
    """Plan what changes an endpoint of a node where it stands.

    Args:
        analysis: the file.
        site: the call that creates the endpoint.
        change: what is asked for.
        catalog: the interface types.
        dialect: the client library.

    Raises:
        NotInPlaceError: the call does not say what differs itself.
        CannotAddError: the new type is not known.
    """
    place = beside(analysis, site)
    if place is None or change.kind in ACTIONS:
        raise NotInPlaceError
    added = Addition.at(place, analysis, change.kind, change.endpoint, catalog, dialect)
    added.variable = target_name(analysis, site) or ""
    update = Replacement(added, site, lost=[site])
    name = _rename(update, change.name)
    interface = added.interface()
    is_retyped = interface.name != site.endpoint.type
    if is_retyped:
        _retype(update, interface)
    callback = callback_of(change.endpoint) or site.endpoint.callback
    is_lost = is_retyped and callback_of(change.endpoint) is None and needs_type(update, interface)
    if is_lost or callback != site.endpoint.callback:
        callback = _call(update, interface)
    elif is_retyped:
        retype_callback(update, interface)
        _respond(update, interface)
    if is_lost and site.endpoint.callback is not None:
        _tell_lost(update, interface)
    added.writer.endpoints.append((change.kind, name, str(interface.name), callback or ""))
    requalify(update)
    resend(update, interface)
    return update


def _rename(update: Replacement, name: str) -> str:
    """Write another name; return what a reader finds as the name."""
    wanted, found = update.added.name, update.site.endpoint
    if wanted == name:
        return found.expression if found.name is None else found.name
    try:
        renaming = plan_names(update.analysis, {update.site: wanted})
    except NotNamedError:
        raise NotInPlaceError from None
    update.splices += renaming.splices
    return renaming.names[0]


def _retype(update: Replacement, interface: Interface) -> None:
    shape, site = update.site.shape, update.site
    given = site.arguments.get(shape.type) if shape.type is not None else None
    if given is None or not _is_bound(update.analysis, given, site.scope, BindingKind.IMPORT):
        raise NotInPlaceError
    update.put(given, update.added.messages.type_class(interface))


def _call(update: Replacement, interface: Interface) -> str:
    """Let the endpoint call another function, and return its name; the stub that it called goes."""
    analysis, shape, site = update.analysis, update.site.shape, update.site
    given = site.arguments.get(shape.callback) if shape.callback is not None else None
    kinds = (BindingKind.FUNCTION, BindingKind.IMPORT)
    if given is None or (
        given.type == "identifier" and not _is_bound(analysis, given, site.scope, *kinds)
    ):
        raise NotInPlaceError
    callback = _put_callback(update, given, interface)
    gone = [Splice(given.start_byte, given.end_byte)]
    stubs = stub_callbacks(analysis, [site], gone)
    update.splices += delete_statements(analysis.syntax.text, stubs)
    return callback.rpartition(".")[2]


def _put_callback(update: Replacement, given: Node, interface: Interface) -> str:
    """Write another callback, which gets what the call, or a `partial` around it, hands on."""
    analysis, added, place = update.analysis, update.added, update.added.place
    added.handed = by_call = handed_by_call(analysis, update.site)
    wrapped = handed_by_partial(analysis, update.site, given)
    if wrapped is not None:
        before, keywords = wrapped[1].before, wrapped[1].behind
        behind = handed_by_call(analysis, update.site, len(before)).behind
        added.handed = HandedOn(before, (*behind, *keywords))
    callback = callback_for(added, interface)
    if added.place is not place:
        # The function is defined behind the call, which would have to move there.
        raise NotInPlaceError
    if wrapped is not None and misfit(added, callback) is not None:
        wrapped, added.handed = None, by_call
    check_parameters(added, callback)
    update.put(given if wrapped is None else wrapped[0], callback)
    if wrapped is None and given.type == "lambda":
        old = update.site.endpoint
        text = " ".join(analysis.syntax.slice(given).split())
        message = f"`{text}` of `{old.name}` is not kept for `{added.name}`"
        update.notes.append(written_anew(message, added.endpoint, old.name or added.name))
    return callback


def _respond(update: Replacement, interface: Interface) -> None:
    """Let a stub of rospy return a response of the new type; tell of a callback with code in it."""
    analysis = update.analysis
    function = callback_scope(analysis, update.site)
    if function is None or not is_stub(analysis, function, update.site):
        _tell_other_type(update, interface)
        return
    if update.added.is_rclpy:
        return
    update.added.stand(is_nested=False)
    for statement in body_of(function):
        value = next(iter(statement.named_children), None)
        if statement.type == "return_statement" and value is not None and value.type == "call":
            update.put(value, update.added.messages.response(interface))
    update.added.stand(is_nested=True)


def _tell_lost(update: Replacement, interface: Interface) -> None:
    """Tell that a function gets no messages any more, as they are not those it is made for."""
    added, found = update.added, update.site.endpoint
    message = f"`{found.callback}` no longer gets `{added.name}`: it was written for `{found.type}`"
    if missing := listed(f"`{each}`" for each in missing_fields(update, interface)):
        message += f", and `{interface.name}` has no {missing}"
    help_ = "keep it with `calling`, and change it by hand"
    update.notes.append(Diagnostic(codes.OTHER_TYPE, message, added.endpoint.span, help=help_))


def _tell_other_type(update: Replacement, interface: Interface) -> None:
    """Tell that code of the file takes messages of a type that it was not written for."""
    site, found = update.site, update.site.endpoint
    callback = site.shape.callback
    was, help_ = "was", "change it by hand"
    if callback is not None and site.arguments.get(callback) is not None:
        what = "its callback" if found.callback is None else f"`{found.callback}`"
        help_ += ", or name another function with `calling`"
    elif hands_on(site):
        names = takers(update.analysis, site)
        was = "was" if len(names) < 2 else "were"
        what = " and ".join(names) or f"what takes its messages from line {found.line} on"
    else:
        return
    missing = listed(f"`{each}`" for each in missing_fields(update, interface))
    if callback_of(update.added.endpoint) is None or missing:
        message = f"{what} {was} written for `{found.type}`, and gets `{interface.name}`"
        message += f", which has no {missing}" if missing else ""
        span = update.added.endpoint.span
        update.notes.append(Diagnostic(codes.OTHER_TYPE, message, span, help=help_))


def _is_bound(analysis: Analysis, node: Node, scope: Scope, *kinds: BindingKind) -> bool:
    """Whether a name means what its bindings of some kinds say, and no parameter or constant."""
    while node.type == "attribute" and (inner := node.child_by_field_name("object")):
        node = inner
    if node.type != "identifier":
        return False
    found = scope.lookup(analysis.syntax.slice(node))
    if found is None:
        return analysis.scopes.module.star_imports != []
    return all(binding.kind in kinds for binding in found[1])
