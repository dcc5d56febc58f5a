"""The call that creates a new endpoint, written as the file writes its others."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.names import name_as_written

from .addition import Addition
from .analysis import Site
from .calls import Argument, CallShape
from .qos_arguments import creation_qos

METHODS = {
    EndpointKind.PUBLISHER: "create_publisher",
    EndpointKind.SUBSCRIPTION: "create_subscription",
    EndpointKind.SERVICE: "create_service",
    EndpointKind.CLIENT: "create_client",
}
CLASSES = {
    EndpointKind.PUBLISHER: "Publisher",
    EndpointKind.SUBSCRIPTION: "Subscriber",
    EndpointKind.SERVICE: "Service",
    EndpointKind.CLIENT: "ServiceProxy",
}
_ACTIONS = {
    EndpointKind.ACTION_SERVER: "ActionServer",
    EndpointKind.ACTION_CLIENT: "ActionClient",
}
# A plain name, which may be another one's profile as well.
_NAME = re.compile(r"[\w.]+")
# A profile that may be made anew in each call.
_PROFILE = re.compile(r"[\w.]+|([\w.]+\.)?QoSProfile\([\w.=, ]*\)")
_QUEUED = (EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
# A comma that something parts from what is behind it, or a call that has none.
_COMMA = re.compile(rb",\s|^[^,]*$")
_TEXT = re.compile(rb"\"[^\"]*\"|'[^']*'")
_QUEUE = re.compile(r"[1-9]\d{0,5}$")


def callee_of(added: Addition, model: Site | None) -> str:
    """Return what is called: a method of the node, or a class."""
    if added.kind in _ACTIONS:
        module, _, class_ = _callee(added).rpartition(".")
        if added.is_rclpy:
            return added.imports.use(module, class_)
        return added.imports.library(module, class_, added.place.scope)
    if added.is_rclpy:
        method = METHODS[added.kind]
        if model is not None:
            callee = model.call.child_by_field_name("function")
            name = callee.child_by_field_name("attribute") if callee is not None else None
            method = added.analysis.syntax.slice(name) if name is not None else method
        return f"{added.place.receiver}.{method}"
    return added.rospy(CLASSES[added.kind])


def arguments_of(
    added: Addition,
    model: Site | None,
    class_: str,
    callback: str,
    more: Sequence[tuple[str, str]] = (),
) -> str:
    """Return the arguments of the call, by position or keyword as the model has them.

    Args:
        added: what is created.
        model: a call that creates one of its kind, None where there is none.
        class_: the source of its type.
        callback: the source of its callback, "" for none.
        more: keywords besides, with what they are.
    """
    name = name_as_written(added.name, added.dialect.ros_version)
    topic = _quoted(added, model, name)
    shape = _shape(added)
    given = [(shape.name, topic), (shape.type, class_), (shape.callback, callback)]
    given.append((shape.node, added.place.receiver))
    values = {argument: value for argument, value in given if argument is not None and value}
    asked = creation_qos(added)
    queue = "" if asked else _queue(added, model)
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
    for keyword, value in asked:
        is_named = is_keyword or not added.is_rclpy
        parts.append(f"{keyword}{equals}{value}" if is_named else value)
    parts += [f"{keyword}{equals}{value}" for keyword, value in more]
    if group := added.callback_group(added.kind):
        parts.append(f"callback_group{equals}{group}")
    is_tight = model is not None and _COMMA.search(_written(model)) is None
    return ("," if is_tight and len(parts) > 1 else ", ").join(parts)


def _quoted(added: Addition, model: Site | None, name: str) -> str:
    """Return a name as a text, in the quotes that the model has around its name."""
    given = model.arguments.get(model.shape.name) if model is not None else None
    quote = added.analysis.syntax.slice(given)[:1] if given is not None else ""
    conventions = added.writer.conventions
    if quote in ("'", '"'):
        conventions = replace(conventions, quote=quote)
    return conventions.string(name)


def _written(model: Site) -> bytes:
    """Return the arguments of a call, what is in texts left out."""
    arguments = model.call.child_by_field_name("arguments")
    return _TEXT.sub(b"", (arguments.text or b"") if arguments is not None else b"")


def _spells_keywords(added: Addition) -> bool:
    """Whether the file creates its endpoints of other kinds by keywords alone."""
    sites = [site for site in added.analysis.sites if site.endpoint.kind in METHODS]
    return bool(sites) and not any(site.arguments.positional for site in sites)


def _has_spaced_keywords(model: Site) -> bool:
    """Whether a call has its keywords as in `queue_size = 1`."""
    return any(
        b" = " in (value.parent.text or b"")[: -len(value.text or b"")]
        for value in model.arguments.keywords.values()
        if value.parent is not None
    )


def _shape(added: Addition) -> CallShape:
    library = added.analysis.library
    return {**library.functions(), **library.methods()}[_callee(added)]


def _callee(added: Addition) -> str:
    """Return the name, among the client library's shapes, of what makes an endpoint."""
    if added.kind in _ACTIONS:
        name = _ACTIONS[added.kind]
        return f"rclpy.action.{name}" if added.is_rclpy else f"actionlib.Simple{name}"
    return METHODS[added.kind] if added.is_rclpy else f"rospy.{CLASSES[added.kind]}"


def usual_callee(added: Addition) -> str:
    """Return the last part of the name of what makes an endpoint."""
    return _callee(added).rpartition(".")[2]


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
        (added.analysis.syntax.slice(given), site.endpoint.callback)
        for site in added.analysis.sites
        if site.endpoint.kind is added.kind and site.endpoint.type == added.endpoint.type
        if site.scope is added.place.scope and (given := site.arguments.get(at)) is not None
    }
    text = next(iter(found))[0] if len({given for given, _ in found}) == 1 else ""
    is_fitting = _NAME.fullmatch(text) is not None and not text.isdigit()
    return text if is_fitting and ((text, callback) in found or "sensor" in text.lower()) else ""
