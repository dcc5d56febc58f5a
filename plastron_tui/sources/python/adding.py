"""Adding an endpoint to a file, in the manner in which the file has its others."""

from __future__ import annotations

import re

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import (
    Client,
    Endpoint,
    Publisher,
    Service,
    Subscription,
    callback_of,
    is_sending,
    kind_of,
)
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface
from plastron_tui.ros.names import name_as_written

from .addition import Addition
from .analysis import Analysis, Site
from .calls import Argument, CallShape
from .conventions import (
    callback_naming,
    target_name,
    variable_naming,
)
from .dialect import Dialect
from .existing_callbacks import check_parameters, existing_callback
from .function_place import FunctionPlace, function_place, method_place
from .insertion_point import find_place, running_place
from .lifecycle import destroy_created, is_transition
from .messages import CannotAddError
from .place import beside
from .removal import callback_scope
from .scopes import Scope
from .sending import add_calls, add_publishing, keep_running
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

_METHODS = {
    EndpointKind.PUBLISHER: "create_publisher",
    EndpointKind.SUBSCRIPTION: "create_subscription",
    EndpointKind.SERVICE: "create_service",
    EndpointKind.CLIENT: "create_client",
}
_CLASSES = {
    EndpointKind.PUBLISHER: "Publisher",
    EndpointKind.SUBSCRIPTION: "Subscriber",
    EndpointKind.SERVICE: "Service",
    EndpointKind.CLIENT: "ServiceProxy",
}
# A plain name, which may be another one's profile as well.
_NAME = re.compile(r"[\w.]+")
# What a node has besides what creates endpoints.
_ONLY_OF_NODES = frozenset(
    {"create_timer", "declare_parameter", "destroy_node", "get_clock", "get_logger"}
    | {"get_parameter"}
)
_OF_NODES = _ONLY_OF_NODES | {*_METHODS.values()}
# A profile that may be made anew in each call.
_PROFILE = re.compile(r"[\w.]+|([\w.]+\.)?QoSProfile\([\w.=, ]*\)")
_QUEUED = (EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
_QUEUE = re.compile(r"[1-9]\d{0,5}$")


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
    kind, name = kind_of(type(endpoint)), endpoint.name
    present = [
        site for site in node.sites if site.endpoint.kind is kind and site.endpoint.name == name
    ]
    place = find_place(node, kind)
    if place is None:
        message = f"the file has no line behind which it could create `{name}` once, as it starts"
        remedy = "add it to the file that makes the node"
        raise CannotAddError(codes.EDIT_REFUSED, message, endpoint.span, remedy)
    if callback_of(endpoint) is None:
        # A callback that the file has may use what it waits for.
        place = Waits(node).step_before(place, kind)
    if is_sending(endpoint):
        place = running_place(node, place)
    added = Addition.at(place, analysis, kind, endpoint, catalog, dialect)
    writer = added.writer
    lines: list[str] = []
    if present:
        _use_present(added, present)
    else:
        lines = _create(added)
        if (note := shared_name(added)) is not None:
            writer.notes.append(note)
    sending: list[str] = []
    if isinstance(endpoint, Publisher):
        sending = add_publishing(added, endpoint)
    elif isinstance(endpoint, Client):
        sending = add_calls(added, endpoint)
    timers = timers_below(analysis, added.place) if len(sending) == 1 else None
    if timers is None:
        lines += sending
    if not isinstance(endpoint, Client):
        keep_running(added)
    destroy_created(added, lines)
    functions, writer.splices = writer.splices, []
    if lines:
        if starts_section(analysis, added.place, kind):
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


def _use_present(added: Addition, present: list[Site]) -> None:
    """Send through an endpoint that the file has."""
    for site in present:
        place = beside(added.analysis, site)
        variable = target_name(added.analysis, site)
        if place is not None and variable is not None:
            added.place = place
            added.variable = variable
            return
    lines = ", ".join(str(site.endpoint.line) for site in present)
    message = f"no variable of the file holds `{added.name}`, created in line {lines}"
    raise CannotAddError(codes.EDIT_REFUSED, message, added.endpoint.span)


def _create(added: Addition) -> list[str]:
    """Return the statement that creates the endpoint; its callback is written on the way."""
    interface = added.interface()
    class_ = added.messages.type_class(interface)
    callback = callback_for(added, interface)
    check_parameters(added, callback)
    model = _model(added)
    arguments = _arguments(added, model, class_, callback)
    callee = _callee(added, model)
    added.variable = _variable(added, model)
    call = f"{callee}({arguments})"
    name = callback.rpartition(".")[2] if callback else ""
    added.writer.endpoints.append((added.kind, added.name, str(interface.name), name))
    return [f"{added.variable} = {call}" if added.variable else call]


def _model(added: Addition) -> Site | None:
    """Return the call site of the same kind that the new one is modelled on."""
    shapes = added.analysis.library
    names = {*shapes.functions(), *shapes.methods()}
    beside = added.place.beside
    sites = [site for site in added.analysis.sites if site.endpoint.kind is added.kind]
    usual = _CLASSES[added.kind] if not added.is_rclpy else _METHODS[added.kind]
    sites = [
        site
        for site in sites
        if any(name in names and name.rpartition(".")[2] == usual for name in site.shape.callees)
        and not site.arguments.is_open
    ]
    if beside is not None and beside in sites:
        return beside
    return sites[-1] if sites else None


def _callee(added: Addition, model: Site | None) -> str:
    if added.is_rclpy:
        method = _METHODS[added.kind]
        if model is not None:
            callee = model.call.child_by_field_name("function")
            name = callee.child_by_field_name("attribute") if callee is not None else None
            method = added.analysis.syntax.slice(name) if name is not None else method
        return f"{added.place.receiver}.{method}"
    return added.rospy(_CLASSES[added.kind])


def _variable(added: Addition, model: Site | None) -> str:
    """Return the variable that holds the endpoint, named as the file names its others.

    rospy and rclpy hold subscriptions and services themselves: a local variable is of no use, and
    an attribute is where a lifecycle node has to destroy them.
    """
    is_sender = added.kind in (EndpointKind.PUBLISHER, EndpointKind.CLIENT)
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


def _arguments(added: Addition, model: Site | None, class_: str, callback: str) -> str:
    """Return the arguments of the call, by position or keyword as the model has them."""
    name = name_as_written(added.name, added.dialect.ros_version)
    topic = added.writer.conventions.string(name)
    shape = _shape(added)
    given = ((shape.name, topic), (shape.type, class_), (shape.callback, callback))
    values = {argument: value for argument, value in given if argument is not None and value}
    queue = _queue(added, model)
    parts = []
    is_keyword = model is None and _spells_keywords(added)
    equals = " = " if model is not None and _has_spaced_keywords(model) else "="
    for argument, value in sorted(values.items()):
        is_keyword = is_keyword or (
            model is not None and argument.keyword in model.arguments.keywords
        )
        parts.append(f"{argument.keyword}{equals}{value}" if is_keyword else value)
    if queue:
        # rclpy takes the depth by position, rospy by its keyword.
        keyword = "qos_profile" if added.is_rclpy else "queue_size"
        is_named = is_keyword or not added.is_rclpy
        if model is not None and keyword in model.arguments.keywords:
            is_named = True
        parts.append(f"{keyword}{equals}{queue}" if is_named else queue)
    if group := added.callback_group(added.kind):
        parts.append(f"callback_group{equals}{group}")
    return ", ".join(parts)


def _spells_keywords(added: Addition) -> bool:
    """Whether the file creates its endpoints of other kinds by keywords alone."""
    sites = [site for site in added.analysis.sites if site.endpoint.kind in _METHODS]
    return bool(sites) and not any(site.arguments.positional for site in sites)


def _has_spaced_keywords(model: Site) -> bool:
    """Whether a call has its keywords as in `queue_size = 1`."""
    return any(
        b" = " in (value.parent.text or b"")[: -len(value.text or b"")]
        for value in model.arguments.keywords.values()
        if value.parent is not None
    )


def _shape(added: Addition) -> CallShape:
    name = _METHODS[added.kind] if added.is_rclpy else f"rospy.{_CLASSES[added.kind]}"
    library = added.analysis.library
    return {**library.functions(), **library.methods()}[name]


def _queue(added: Addition, model: Site | None) -> str:
    """Return the length of the queue, as the model has it."""
    if added.kind not in _QUEUED:
        return ""
    at = _depth_at(added, added.kind)
    given = model.arguments.get(at) if model is not None else None
    text = added.analysis.syntax.slice(given) if given is not None else ""
    if alike := _given_for_same(added, at):
        return alike
    if _QUEUE.match(text):
        return text
    own = added.given_beside(added.kind, at)
    both = [each for kind in _QUEUED for each in added.given_beside(kind, _depth_at(added, kind))]
    if _PROFILE.fullmatch(text) and any(
        len(each) > 1 and set(each) == {text} for each in (own, both)
    ):
        return text
    is_needed = added.is_rclpy or added.kind is EndpointKind.PUBLISHER
    return "10" if is_needed else ""


def _depth_at(added: Addition, kind: EndpointKind) -> Argument:
    """Return where calls of a kind say the length of the queue, or the profile."""
    if not added.is_rclpy:
        return Argument(-1, "queue_size")
    return Argument(3 if kind is EndpointKind.SUBSCRIPTION else 2, "qos_profile")


def _given_for_same(added: Addition, at: Argument) -> str:
    """Return the profile of what has the same type and callback: it is to hear the same.

    Best effort, as sensors have it, hears every publisher: there the type is enough.
    """
    if not added.is_rclpy or not isinstance(added.endpoint, Subscription):
        return ""
    callback = added.endpoint.callback
    found = {
        added.analysis.syntax.slice(given): site.endpoint.callback
        for site in added.analysis.sites
        if site.endpoint.kind is added.kind and site.endpoint.type == added.endpoint.type
        if site.scope is added.place.scope and (given := site.arguments.get(at)) is not None
    }
    text, called = next(iter(found.items())) if len(found) == 1 else ("", None)
    is_fitting = _NAME.fullmatch(text) is not None and not text.isdigit()
    return text if is_fitting and (called == callback or "sensor" in text.lower()) else ""


def callback_for(added: Addition, interface: Interface) -> str:
    """Return the source of the callback; one that the file does not have is written."""
    endpoint = added.endpoint
    if not isinstance(endpoint, Subscription | Service):
        return ""
    wanted = callback_of(endpoint)
    existing = existing_callback(added, wanted) if wanted is not None else None
    if existing is not None:
        return existing
    name = wanted or added.free_name(callback_naming(added.analysis, added.kind).name(added.name))
    added.writer.names.add(name)
    added.stand(is_nested=False)
    added.writer.function(callback_place(added), _stub(added, name, interface))
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
        lines.append(f"\treturn {names[1] if added.is_rclpy else response}")
    return lines
