"""Adding an endpoint to a file, in the manner in which the file has its others."""

from __future__ import annotations

import re

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    Endpoint,
    Parameter,
    Publisher,
    Service,
    Subscription,
    Timer,
    callback_of,
    is_sending,
    kind_of,
)
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface

from .addition import Addition
from .analysis import Analysis, Site
from .by_hand import refuse_answer, refuse_by_hand
from .calling import add_calls
from .calls import ACTIONS
from .conventions import (
    callback_naming,
    target_name,
    variable_naming,
)
from .dialect import Dialect
from .existing_callbacks import check_parameters, existing_callback
from .function_place import FunctionPlace, function_place, method_place
from .functions import callback_scope
from .goals import add_goals, check_first
from .insertion_point import find_place, once_named, running_place
from .lifecycle import destroy_created, is_transition
from .messages import CannotAddError
from .new_call import METHODS, arguments_of, callee_of, usual_callee
from .new_parameter import declare, parameter_place
from .own_calls import keep_running
from .place import Place, beside
from .qos_arguments import check_policies
from .reacting import place_before_hearing, react, shared
from .repeating import place_behind_rates, repeat, tick_stub
from .scopes import Scope
from .sending import add_publishing
from .sending_once import check_kept
from .serving import Serving, serve, serve_with
from .shared_names import shared_name
from .signatures import parameter_names, signatures_of
from .surroundings import (
    holds_handles,
    is_attribute_style,
    is_followed,
    starts_section,
    timers_below,
)
from .waits import Waits
from .writing import Writer

# What a node has besides what creates endpoints.
_ONLY_OF_NODES = frozenset(
    {"create_timer", "declare_parameter", "destroy_node", "get_clock", "get_logger"}
    | {"get_parameter"}
)
_OF_NODES = _ONLY_OF_NODES | {*METHODS.values()}


def plan_addition(
    analysis: Analysis, node: Analysis, endpoint: Endpoint, catalog: Catalog, dialect: Dialect
) -> Writer:
    """Plan what adds an endpoint to a node, or more messages to one that it has.

    Args:
        analysis: the file.
        node: what is known of the node alone, where the file holds several.
        endpoint: the endpoint.
        catalog: the interface types.
        dialect: the client library.

    Raises:
        CannotAddError: the file has no place for it, or its type is not known.
    """
    refuse_by_hand(endpoint)
    kind, name = kind_of(type(endpoint)), endpoint.name
    present = [
        site for site in node.sites if site.endpoint.kind is kind and site.endpoint.name == name
    ]
    is_asking = isinstance(endpoint, Client | ActionClient) and is_sending(endpoint)
    place = find_place(node, kind, needs_function=is_asking)
    if isinstance(endpoint, Parameter):
        place = parameter_place(node, place)
    if place is None:
        message = f"the file has no line behind which it could create `{name}` once, as it starts"
        remedy = "add it to the file that makes the node"
        raise CannotAddError(codes.EDIT_REFUSED, message, endpoint.span, remedy)
    if callback_of(endpoint) is None and not isinstance(endpoint, Parameter):
        # A callback that the file has may use what it waits for.
        place = Waits(node).step_before(place, kind)
    if is_sending(endpoint) or isinstance(endpoint, Timer):
        place = running_place(node, place)
    added = Addition.at(place, analysis, kind, endpoint, catalog, dialect)
    writer = added.writer
    lines: list[str] = []
    is_section = True
    if isinstance(endpoint, Parameter):
        lines = declare(added, endpoint)
    elif isinstance(endpoint, Timer):
        place_behind_rates(added, node)
        callback = callback_for(added, None)
        check_parameters(added, callback)
        lines = repeat(added, endpoint, callback)
    elif present:
        _use_present(added, node, present)
        place_behind_rates(added, node)
    else:
        place_behind_rates(added, node)
        place_before_hearing(added, node)
        lines = _create(added)
        above = shared(added, node)
        is_section = added.place is place and not above
        lines = [*above, *lines]
        if (note := shared_name(added)) is not None:
            writer.notes.append(note)
    sending: list[str] = []
    if isinstance(endpoint, Publisher):
        sending = add_publishing(added, endpoint)
        react(added, node, endpoint)
    elif isinstance(endpoint, Client):
        sending = add_calls(added, endpoint)
    elif isinstance(endpoint, ActionClient):
        sending = add_goals(added, endpoint)
    timers = timers_below(analysis, added.place) if len(sending) == 1 else None
    if timers is None:
        lines += sending
    if not isinstance(endpoint, Client):
        keep_running(added)
    destroy_created(added, lines)
    functions, writer.splices = writer.splices, []
    if lines:
        if is_section and starts_section(analysis, added.place, kind):
            lines = ["", *lines, *[""] * is_followed(analysis, added.place)]
        writer.lines(added.place.offset, added.place.indent, lines)
    if timers is not None:
        writer.lines(timers.offset, timers.indent, sending)
    _check_methods(added)
    # A method may go right behind the statements: these come first then.
    imported = added.imports.splices()
    writer.has_imports = bool(imported)
    writer.splices = [*imported, *writer.splices, *functions]
    return writer


def _check_methods(added: Addition) -> None:
    """Refuse to call a node's methods on what the file does not show to be a node.

    A class of another file may have methods of the same names, and not all of them.
    """
    owner, receiver = added.place.owner, added.place.receiver
    if owner is None or not receiver or receiver != added.place.self_name:
        return
    resolver, classes = added.analysis.resolver, added.analysis.library.node_classes
    bases = resolver.foreign_bases(owner)
    if not classes.isdisjoint(bases) or any("node" in name.lower() for name in bases):
        return
    shown = re.findall(rf"\b{receiver}\.(\w+)\(", added.analysis.syntax.slice(owner.node))
    missing = _OF_NODES & added.writer.words - {*shown}
    if missing and _ONLY_OF_NODES.isdisjoint(shown):
        message = f"the file does not show that `{owner.name}` is a node: it may not have"
        message += f" `{min(missing)}`"
        remedy = "add it to the file that makes the node"
        raise CannotAddError(codes.EDIT_REFUSED, message, added.endpoint.span, remedy)


def _use_present(added: Addition, node: Analysis, present: list[Site]) -> None:
    """Send through an endpoint that the file has: behind the last of its like, or behind it."""
    sent = added.endpoint.publications if isinstance(added.endpoint, Publisher) else ()
    check_first(added, present)
    for site in present:
        if any(each.is_once for each in sent):
            check_kept(added, site)
        check_policies(added, site)
        place = beside(added.analysis, site)
        variable = target_name(added.analysis, site)
        if place is not None and variable is not None:
            if not _is_further_down(added.place, place):
                added.place = running_place(node, once_named(node, place))
            added.variable = variable
            return
    lines = ", ".join(str(site.endpoint.line) for site in present)
    message = f"no variable of the file holds `{added.name}`, created in line {lines}"
    raise CannotAddError(codes.EDIT_REFUSED, message, added.endpoint.span)


def _is_further_down(place: Place, other: Place) -> bool:
    """Whether a place is in the same block as another one, and behind it."""
    block, above = place.statement.parent, other.statement.parent
    is_same = block is not None and above is not None and block.id == above.id
    return is_same and place.offset > other.offset


def _create(added: Addition) -> list[str]:
    """Return the statement that creates the endpoint; its callback is written on the way."""
    interface = added.interface()
    class_ = added.messages.type_class(interface)
    if added.kind in ACTIONS and is_transition(added.analysis, added.place):
        message = f"`{added.place.scope.name}` would make the action `{added.name}` in each cycle"
        remedy = "make it by hand, and destroy it in the transition that undoes this one"
        raise CannotAddError(codes.EDIT_REFUSED, message, added.endpoint.span, remedy)
    serving = _serving(added, interface)
    callback = serving.callback
    check_parameters(added, callback)
    model = _model(added)
    arguments = arguments_of(added, model, class_, callback, serving.more)
    callee = callee_of(added, model)
    added.variable = added.variable or _variable(added, model)
    call = f"{callee}({arguments})"
    name = callback.rpartition(".")[2] if callback else ""
    added.writer.endpoints.append((added.kind, added.name, str(interface.name), name))
    made = f"{added.variable} = {call}" if added.variable else call
    return [*serving.above, made, *serving.below]


def _serving(added: Addition, interface: Interface) -> Serving:
    """Return the callback, with what an action server needs besides; it is written on the way."""
    endpoint = added.endpoint
    if not isinstance(endpoint, ActionServer):
        return Serving(callback_for(added, interface))
    wanted = endpoint.callback
    existing = existing_callback(added, wanted) if wanted is not None else None
    # What works on the goals talks to the server.
    added.variable = _variable(added, _model(added))
    if existing is not None:
        return serve_with(added, existing)
    return serve(added, interface, wanted, callback_place(added))


def _model(added: Addition) -> Site | None:
    """Return the call site of the same kind that the new one is modelled on."""
    shapes = added.analysis.library
    names = {*shapes.functions(), *shapes.methods()}
    beside = added.place.beside
    sites = [site for site in added.analysis.sites if site.endpoint.kind is added.kind]
    usual = usual_callee(added)
    sites = [
        site
        for site in sites
        if any(name in names and name.rpartition(".")[2] == usual for name in site.shape.callees)
        and not site.arguments.is_open
    ]
    if beside is not None and beside in sites:
        return beside
    return sites[-1] if sites else None


def _variable(added: Addition, model: Site | None) -> str:
    """Return the variable that holds the endpoint, named as the file names its others.

    rospy and rclpy hold subscriptions and services themselves: a local variable is of no use, and
    an attribute is where a lifecycle node has to destroy them.
    """
    # What nothing holds of an action is soon gone, or cannot be started.
    is_sender = added.kind in (EndpointKind.PUBLISHER, EndpointKind.CLIENT, *ACTIONS)
    is_attribute = is_attribute_style(added.analysis, added.place, added.kind)
    if is_transition(added.analysis, added.place):
        is_attribute = True
    elif not is_sender:
        is_held = added.is_rclpy and is_attribute
        if model is not None:
            is_local = not is_attribute and added.place.scope.parent is not None
            is_held = not is_local and target_name(added.analysis, model) is not None
        elif holds_handles(added.analysis, added.place, added.kind):
            is_held = is_attribute
        if not is_held:
            return ""
    wanted = variable_naming(added.analysis, added.kind).name(added.name)
    # A name of a function or of the module is private to nothing.
    name = added.free_name(wanted if is_attribute else wanted.lstrip("_"))
    return f"{added.place.self_name}.{name}" if is_attribute else name


def callback_for(added: Addition, interface: Interface | None) -> str:
    """Return the source of the callback; one that the file does not have is written."""
    endpoint = added.endpoint
    if not isinstance(endpoint, Subscription | Service | Timer):
        return ""
    wanted = callback_of(endpoint)
    existing = existing_callback(added, wanted) if wanted is not None else None
    if existing is not None:
        refuse_answer(endpoint)
        return existing
    name = wanted or added.free_name(callback_naming(added.analysis, added.kind).name(added.name))
    added.writer.names.add(name)
    added.stand(is_nested=False)
    stub = tick_stub(added, name) if interface is None else _stub(added, name, interface)
    added.writer.function(callback_place(added), stub)
    added.stand(is_nested=True)
    return f"{added.place.self_name}.{name}" if added.place.owner is not None else name


def callback_place(added: Addition) -> FunctionPlace:
    """Return where a callback goes: behind one of its kind, or as near as can be."""
    callbacks: list[Scope] = []
    for kind in (None, added.kind):
        found = [
            scope
            for site in added.analysis.sites
            if kind is None or site.endpoint.kind is kind
            if (scope := callback_scope(added.analysis, site)) is not None
        ]
        if found:
            callbacks = sorted(found, key=lambda scope: scope.start)
    if added.place.owner is not None:
        return method_place(added.analysis, added.place, callbacks)
    gap = added.writer.conventions.blank_lines
    return function_place(added.analysis, added.place, callbacks, gap)


def _stub(added: Addition, name: str, interface: Interface) -> list[str]:
    """Return the lines of a callback that logs what it gets, as the file writes its callbacks."""
    manner, messages = signatures_of(added.analysis, added.kind), added.messages
    own = [(added.place.self_name, "")] if added.place.owner is not None else []
    if added.kind is EndpointKind.SUBSCRIPTION:
        takes = ["message"]
        does, types, returns = f"Log what comes over {added.label}.", [""], "None"
        if manner.says_types:
            types = [messages.type_class(interface)]
    else:
        takes = ["request", "response"] if added.is_rclpy else ["request"]
        does, response = f"Answer {added.label}.", messages.response(interface)
        returns = response.removesuffix("()")
        types = [messages.request_class(interface) if manner.says_types else "", returns]
    names = parameter_names(added.analysis, added.kind, takes)
    given = added.handed.around(list(zip(names, types, strict=False)))
    lines = [manner.head(name, [*own, *given], returns)]
    if manner.is_documented:
        lines.append(f'\t"""{does}"""')
    lines.append("\t" + added.log("info", names[0]))
    if added.kind is EndpointKind.SERVICE:
        answer = added.endpoint.answer if isinstance(added.endpoint, Service) else None
        returned = names[1] if added.is_rclpy else response
        if answer is not None:
            answered = f"return {messages.answer(interface, answer, names[0])}"
            lines += [f"\t{each}" for each in messages.conditions.around([answered])]
        if answer is None or messages.conditions:
            lines.append(f"\treturn {returned}")
    return lines
