"""Adding an endpoint to a unit, in the manner in which its files have their others."""

from __future__ import annotations

import re
from dataclasses import replace

from plastron_tui.diagnostics import codes
from plastron_tui.model.kinds import (
    ActionClient,
    ActionServer,
    Client,
    Parameter,
    Publisher,
    Service,
    Timer,
    callback_of,
    is_sending,
    kind_of,
)
from plastron_tui.model.source import Add, EndpointKind
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Interface
from plastron_tui.ros.names import name_as_written
from plastron_tui.ros.qos import DEFAULT, Qos
from plastron_tui.ros.qos_words import WORDS
from plastron_tui.sources import naming

from .. import literals
from ..analysis import Analysis, Site
from ..nodes import group
from ..qos_code import latch, profile
from ..shapes import TRANSFORMS
from .actions import request_action, serve_action
from .adding import Addition, variables_like
from .calling import add_requests
from .clang_format import ClangFormat
from .computing import computing_for
from .existing_callbacks import check_callback
from .functions import write_function
from .handles import handle_for
from .hearing import (
    bound,
    existing,
    idle_callback,
    message_parameter,
    service_parameters,
)
from .include_place import order_includes
from .interfaces import Interfaces, refuse
from .lambdas import Lambda, NewLambda, callback_names, model_lambda
from .logging import log_line
from .manner import Naming, callback_naming, held_by, identifiers, split_words
from .members import hold, is_local, open_private, type_of
from .parameters import declare_parameter
from .place import find_place, sites_of_node
from .plans import Plan
from .sender_place import check_one_function_creates, goes_where_it_is_seen
from .sending import Sender, add_publishing
from .shared_names import shared_name
from .timers import create_timer, event_parameter, node_captures, period_of, timer_name

K = EndpointKind

_METHODS = {
    (1, K.PUBLISHER): "advertise",
    (1, K.SUBSCRIPTION): "subscribe",
    (1, K.SERVICE): "advertiseService",
    (1, K.CLIENT): "serviceClient",
    (2, K.PUBLISHER): "create_publisher",
    (2, K.SUBSCRIPTION): "create_subscription",
    (2, K.SERVICE): "create_service",
    (2, K.CLIENT): "create_client",
}
_COPIED = re.compile(r"\d+|rclcpp::\w+\([\w(): .]*\)(?:\.\w+\(\))*")


def plan_addition(
    analysis: Analysis, change: Add, catalog: Catalog, settings: ClangFormat | None = None
) -> Plan:
    """Plan what adds an endpoint to a node, or more messages to one that it has.

    Args:
        analysis: what is known of the files.
        change: what is asked for.
        catalog: the interface types.
        settings: what the settings around the files say of their layout.

    Raises:
        RefusedError: the files have no place for it, or its type is not known.
    """
    endpoint = change.endpoint
    kind = kind_of(type(endpoint))
    nodes = group(analysis)
    if len(nodes) < 2:
        change = change._replace(node=None)
    label = "" if len(nodes) < 2 else change.node or nodes[0].label
    place = find_place(analysis, change, kind)
    interfaces = Interfaces(catalog, analysis.ros_version)
    sites = sites_of_node(analysis, change.node)
    added = Addition(
        analysis, kind, endpoint, place, interfaces, sites, identifiers(analysis), label
    )
    added.settings = settings or ClangFormat()
    match endpoint:
        case Parameter():
            declare_parameter(added, endpoint)
        case Timer():
            _repeat(added, endpoint)
        case ActionServer():
            serve_action(added, endpoint, _interface(added))
        case ActionClient():
            request_action(added, endpoint, _interface(added))
        case _:
            _add(added)
    added.put_at_place()
    open_private(added)
    added.include_types(added.place.file)
    shared = shared_name(added)
    added.plan.notes += [] if shared is None else [shared]
    for splices in added.plan.splices.values():
        order_includes(splices)
    return added.plan


def _add(added: Addition) -> None:
    """Create a part of a topic or service, or use the one that is there, and send through it."""
    endpoint = added.endpoint
    present = [
        site
        for site in added.sites
        if site.endpoint.kind is added.kind
        and site.endpoint.name == endpoint.name
        and site.shape.on != "object"
    ]
    if present and is_sending(endpoint):
        sender = _present(added, present)
    else:
        variable = _create(added)
        sender = Sender(variable, added.is_ros2, is_local(added))
    match endpoint:
        case Publisher():
            add_publishing(added, endpoint, sender)
        case Client():
            add_requests(added, endpoint, sender, _interface(added).name)


def _present(added: Addition, present: list[Site]) -> Sender:
    """Return what the files have to send with."""
    endpoint = added.endpoint
    once = isinstance(endpoint, Publisher) and any(each.is_once for each in endpoint.publications)
    check_one_function_creates(added, present)
    for site in reversed(present):
        variable = held_by(added.analysis, site)
        if variable is None or site.endpoint.type == TRANSFORMS:
            continue
        if added.analysis.receivers.type_of_variable(variable).endswith("::CameraPublisher"):
            # It publishes an image together with what its camera is like.
            continue
        if not goes_where_it_is_seen(added, site, variable):
            continue
        qos = site.endpoint.qos
        if once and (qos is None or qos.durability != "transient_local"):
            how = "transient_local" if added.is_ros2 else "latched"
            line = site.endpoint.line
            message = (
                f"the publisher of `{endpoint.name}` in line {line} keeps no message for those"
            )
            remedy = f"make it {how} by hand, or let the node stop publishing to it first"
            refuse(codes.EDIT_REFUSED, f"{message} who listen later", added.span, remedy)
        written = added.analysis.types.expand(variable.type, variable.scope)
        is_pointer = variable.is_pointer or "Ptr" in written or "ptr<" in written
        is_pointer = is_pointer or (written == "auto" and added.is_ros2)
        sender = Sender(variable.name, is_pointer, variable.kind == "local")
        type_ = added.analysis.receivers.type_of_variable(variable)
        is_of_images = type_ == "image_transport::Publisher"
        return replace(sender, count="getNumSubscribers") if is_of_images else sender
    lines = ", ".join(str(site.endpoint.line) for site in present)
    message = f"no variable of the file holds `{endpoint.name}`, created in line {lines}"
    remedy = "keep it in a variable first"
    return refuse(codes.EDIT_REFUSED, message, added.span, remedy)


def _repeat(added: Addition, timer: Timer) -> None:
    """Call a function at a rate."""
    added.taken.add(timer.name)
    found = existing(added, timer.name)
    if found is not None:
        check_callback(added.analysis, K.TIMER, found, None, added.span)
    else:
        body = [log_line(added, f"{naming.label(timer.name, 'a timer')} ticks", "")]
        event = [each for each in (event_parameter(added),) if each]
        write_function(added, timer.name, event, body, "Called at a rate.")
    words = "_".join(split_words(timer.name))
    period = period_of(added, timer.rate or 1.0)
    variable = timer_name(added, words)
    create_timer(added, variable, period, timer.name)


def _interface(added: Addition) -> Interface:
    folder = added.kind.facts.interface
    assert folder is not None, "what statements make is of a type"
    if added.endpoint.type is None:
        message = f"the type of `{added.endpoint.name}` is not known"
        refuse(codes.UNKNOWN_TYPE, message, added.span, "name its type in the source file")
    return added.interfaces.find(added.endpoint.type, folder, added.span)


def _create(added: Addition) -> str:
    """Create the endpoint, and what it calls; return what holds it."""
    interface = _interface(added)
    folder = added.kind.facts.interface
    assert folder is not None, "what is created here is of a type"
    class_ = added.interfaces.class_of(interface.name, folder)
    arguments: list[str] = []
    needs_type = added.is_ros2 or added.kind in (K.PUBLISHER, K.CLIENT)
    called, written = "", None
    if added.kind in (K.SUBSCRIPTION, K.SERVICE):
        like = model_lambda(added, added.kind) if callback_of(added.endpoint) is None else None
        if like is not None:
            written = _lambda(added, interface, class_, like)
        else:
            called = _callback(added, interface, class_)
            arguments += _handed(added, called)
            is_bound = added.owner is not None and len(arguments) == 1
            needs_type = needs_type or (is_bound and added.kind is K.SUBSCRIPTION)
    name, queue = added.endpoint.name, _queue(added)
    if added.is_ros2:
        before, given = added.place.node, name_as_written(name, 2)
    else:
        before, given = handle_for(added.analysis, added.place, name)
    if queue:
        arguments.insert(0, queue)
    arguments.insert(0, literals.string(given))
    type_ = type_of(added, added.kind, class_)
    variable, declaring = hold(added, added.kind, type_)
    if declaring is not None and added.is_ros2:
        added.include_types(declaring)
    template = f"<{class_}>" if needs_type or written is not None else ""
    if written is not None and added.kind is K.SERVICE and not added.is_ros2:
        template = f"<{class_}::Request, {class_}::Response>"
    head = f"{before}{_METHODS[added.analysis.ros_version, added.kind]}{template}("
    head = f"{_declared(added, type_)}{variable} = {head}"
    if written is not None:
        called = written.name
        added.lines += written.lines(added, head, arguments)
    else:
        added.lines.append(f"{head}{', '.join(arguments)});")
    added.expect(added.kind, name, interface.name, called)
    return variable


def _declared(added: Addition, type_: str) -> str:
    """Write the type before a local variable that holds the endpoint; "" for any other."""
    if not is_local(added):
        return ""
    autos = [each.type == "auto" for _, each in variables_like(added, added.kind)]
    return "auto " if added.is_ros2 or autos.count(True) * 2 > len(autos) else f"{type_} "


def _queue(added: Addition) -> str:
    """Write the depth, or the quality of service, of a topic; that of the others for none."""
    if added.kind not in (K.PUBLISHER, K.SUBSCRIPTION):
        return ""
    qos = getattr(added.endpoint, "qos", None)
    is_publisher = added.kind is K.PUBLISHER
    sent = added.endpoint.publications if isinstance(added.endpoint, Publisher) else ()
    if any(each.is_once for each in sent):
        qos = (qos or Qos()).over(WORDS["latched"].says)
    if isinstance(qos, Qos) and qos.known:
        return profile(qos) if added.is_ros2 else latch(qos, is_publisher=is_publisher)
    found = set()
    for site in added.like():
        position = site.shape.queue
        if position is not None and position < len(site.arguments):
            found.add(site.place.file.syntax.slice(site.arguments[position]))
    text = found.pop() if len(found) == 1 else ""
    return text if _COPIED.fullmatch(text) else str(DEFAULT.depth or 10)


def _handed(added: Addition, called: str) -> list[str]:
    """Write what is called as the call that creates the endpoint is handed it."""
    handed = bound(added, called, 1 if added.kind is K.SUBSCRIPTION else 2)
    if added.is_ros2 or added.owner is None or added.kind is K.SUBSCRIPTION or len(handed) > 1:
        return handed
    # What is bound does not say the types of a service of ROS 1.
    return [f"&{added.owner.name}::{called}", "this"]


def write_callback(added: Addition) -> str:
    """Write what an endpoint that is there shall call, where the files have it not.

    Returns its name.
    """
    interface = _interface(added)
    folder = added.kind.facts.interface
    assert folder is not None, "what calls a function with messages is of a type"
    return _callback(added, interface, added.interfaces.class_of(interface.name, folder))


def _callback(added: Addition, interface: Interface, class_: str) -> str:
    """Return the name of what the endpoint calls; what the files have not is written."""
    wanted = callback_of(added.endpoint)
    found = existing(added, wanted) if wanted is not None else None
    if wanted is not None and found is not None:
        check_callback(added.analysis, added.kind, found, interface.name, added.span)
        if isinstance(added.endpoint, Service) and added.endpoint.answer is not None:
            message = f"the answer of `{added.endpoint.name}` is not written into a function that"
            remedy = "leave out `answering`, and fill in the response by hand in its function"
            refuse(codes.EDIT_REFUSED, f"{message} is there", added.span, remedy)
        return wanted
    left = None if wanted else idle_callback(added, _naming(added).name(added.topic), class_)
    if left is not None:
        return left
    name = wanted or _callback_name(added)
    added.taken.add(name)
    parameters, body = _served(added, interface, class_)
    returns = "bool" if added.kind is K.SERVICE and not added.is_ros2 else "void"
    said = "message" if added.kind is K.SUBSCRIPTION else "request"
    said = f"Called for each {said} of {added.prose}."
    file = write_function(added, name, parameters, body, said, returns)
    added.include_types(file)
    return name


def _naming(added: Addition) -> Naming:
    called = callback_names(added.analysis, added.sites)
    return callback_naming(added.analysis, added.kind, called)


def _callback_name(added: Addition) -> str:
    manner = _naming(added)
    return added.free(manner.name(added.topic), manner.end)


def _lambda(added: Addition, interface: Interface, class_: str, like: Lambda) -> NewLambda:
    """Write a lambda for the endpoint as another one is written.

    What that one does nothing but hand on is handed on to a method here too.
    """
    own = like if like.site.endpoint.kind is added.kind else None
    if not like.handed_to or added.owner is None:
        parameters, body = _served(added, interface, class_, own)
        name = _callback_name(added) if like.variable is not None else ""
        captures = None
        if added.owner is None:
            uses_node = bool(added.place.node) and any(added.place.node in each for each in body)
            # Without any, a lambda is a pointer to a function too, and a call of ROS 1 ambiguous.
            none = () if added.is_ros2 else ("&",)
            captures = node_captures(added) if uses_node else none
        return NewLambda(like, parameters, body, name, captures)
    called = _callback(added, interface, class_)
    if added.kind is K.SUBSCRIPTION:
        given = [message_parameter(added, class_, own)]
    else:
        given = [*service_parameters(added, class_, own)]
    handed = ", ".join(
        f"std::move({each.name})" if "UniquePtr" in each.text else each.name for each in given
    )
    returned = "return " if added.kind is K.SERVICE and not added.is_ros2 else ""
    name = _callback_name(added) if like.variable is not None else ""
    return NewLambda(like, [each.text for each in given], [f"{returned}{called}({handed});"], name)


def _served(
    added: Addition, interface: Interface, class_: str, like: Lambda | None = None
) -> tuple[list[str], list[str]]:
    """Return what a callback takes, and what it does."""
    if added.kind is K.SUBSCRIPTION:
        parameter = message_parameter(added, class_, like)
        value = f"to_yaml({parameter.value})" if added.is_ros2 else parameter.value
        return [parameter.text], [log_line(added, added.prose, value)]
    request, response = service_parameters(added, class_, like)
    value = f"to_yaml({request.value})" if added.is_ros2 else request.value
    body = [log_line(added, added.prose, value)]
    if isinstance(added.endpoint, Service) and added.endpoint.answer is not None:
        body += _answer(added, interface, added.endpoint.answer, request.holder, response.holder)
    if not any(response.holder in line for line in body):
        body.append(f"(void){response.name};")
    if not added.is_ros2:
        body.append("return true;")
    return [request.text, response.text], body


def _answer(
    added: Addition, interface: Interface, answer: MessageValue, request: str, response: str
) -> list[str]:
    """Return the lines that fill an answer; what no field can hold leaves it as it is."""
    computing, conditions = computing_for(added, added.span)
    fields = interface.response.fields
    lines = added.interfaces.fill(
        interface, fields, answer, response, computing, added.span, request, interface.fields
    )
    if not conditions:
        return lines
    return added.style(added.place.file).block(f"if ({conditions.text})", lines)
