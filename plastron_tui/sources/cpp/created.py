"""What a call creates, as data."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import OWN_NAME, EndpointKind, SourceEndpoint
from plastron_tui.ros.interfaces import InterfaceName

from .analysis import Analysis
from .arguments import Call
from .callbacks import NONE, Callback, callback_of
from .given_names import given_by
from .listed_parameters import listed_parameters
from .qos import qos_of
from .receivers import HANDLE, Prefix
from .scopes import Function, type_text
from .shapes import Shape
from .worlds import worlds

if TYPE_CHECKING:
    from .found import Found

PARAMETER = EndpointKind.PARAMETER
_ACTIONS = (EndpointKind.ACTION_SERVER, EndpointKind.ACTION_CLIENT)
Bindings = tuple[tuple[Function, Call], ...]


class _Name(NamedTuple):
    name: str | None = None
    default: str | None = None
    is_guess: bool = False


def created_by(
    analysis: Analysis, found: Found
) -> Iterator[tuple[SourceEndpoint, Callback, Bindings]]:
    """Yield what a call creates, with the calls of its function that make it so."""
    for name, expression in _names(analysis, found):
        first, callback = _endpoint(analysis, found, name, expression)
        is_known = first.name is not None or first.default is not None
        if found.shape.kind is EndpointKind.TIMER:
            is_known = True
        if is_known and (first.type is not None or first.kind.facts.interface is None):
            yield from _with_second(found.shape, first, callback, ())
            continue
        seen: dict[SourceEndpoint, tuple[Callback, Bindings]] = {}
        for bindings in worlds(analysis, found, name):
            endpoint, called = _endpoint(analysis, found, name, expression)
            seen.setdefault(endpoint, (called, bindings))
        better = {
            endpoint: each
            for endpoint, each in seen.items()
            if endpoint.name or endpoint.default or (endpoint.type and not first.type)
        }
        if not better:
            yield from _with_second(found.shape, first, callback, ())
        for endpoint, (called, bindings) in (seen if better else {}).items():
            yield from _with_second(found.shape, endpoint, called, bindings)


def _with_second(
    shape: Shape, endpoint: SourceEndpoint, callback: Callback, bindings: Bindings
) -> Iterator[tuple[SourceEndpoint, Callback, Bindings]]:
    """Yield an endpoint, and the one that its call makes beside it."""
    yield endpoint, callback, bindings
    if shape.beside is not None:
        last, type_ = shape.beside
        name, default = (
            None if each is None else f"{each.rpartition('/')[0]}/{last}" if "/" in each else last
            for each in (endpoint.name, endpoint.default)
        )
        yield endpoint._replace(name=name, default=default, type=type_), callback, bindings


def _names(analysis: Analysis, found: Found) -> list[tuple[Node | None, str]]:
    """Return the arguments that name what a call creates, each with its source."""
    syntax = found.call.scope.file.syntax
    if found.call.name == "declare_parameters":
        return listed_parameters(found.arguments, found.call.scope)
    given = found.arguments
    node = given[found.shape.name] if found.shape.name < len(given) else None
    if found.options is not None:
        syntax = found.options.scope.file.syntax
    return [(node, syntax.slice(node) if node is not None else "")]


def _endpoint(
    analysis: Analysis, found: Found, node: Node | None, expression: str
) -> tuple[SourceEndpoint, Callback]:
    call, shape = found.call, found.shape
    named = _Name() if shape.kind is EndpointKind.TIMER else _name(analysis, found, node)
    callback = _callback(analysis, found)
    type_, text = _type(analysis, found, callback)
    place = call.node
    endpoint = SourceEndpoint(
        kind=shape.kind,
        name=named.name,
        expression=expression,
        span=Span(place.start_byte, place.end_byte),
        line=place.start_point.row + 1,
        type=type_,
        type_expression=text,
        callback=callback.name,
        default=named.default,
        file=call.scope.file.name,
        is_guess=named.is_guess,
        qos=qos_of(analysis, found),
        given_by=None if named.name is not None else _given_by(analysis, found, node),
    )
    return endpoint, callback


def _given_by(analysis: Analysis, found: Found, node: Node | None) -> str | None:
    """Return the parameter whose value is the name of an endpoint as it stands, if one is."""
    if node is None or found.shape.kind.facts.interface is None:
        return None
    given = given_by(analysis, node, (found.options or found.call).scope)
    if given is None or given == OWN_NAME:
        return given
    if analysis.ros_version == 1:
        return given if _prefix(analysis, found) == Prefix("") else None
    return given if _in_sub_node(analysis, found, given) == given else None


def _name(analysis: Analysis, found: Found, node: Node | None) -> _Name:
    """Return the name of an endpoint in the namespace of its node handle."""
    if node is None:
        return _Name()
    scope = (found.options or found.call).scope
    value = analysis.evaluator.fold(node, scope)
    if value is None or value.text is None or not value.text:
        return _Name()
    text = value.text
    if found.call.name == "declare_parameters":
        text = _in_namespace(analysis, found, text) or ""
        if not text:
            return _Name()
    prefix = Prefix("")
    if analysis.ros_version == 1:
        prefix = _prefix(analysis, found)
        name = prefix.joined(text)
    else:
        name = _in_sub_node(analysis, found, text)
    if name is None:
        return _Name()
    if value.is_default:
        return _Name(None, name)
    return _Name(name, None, value.is_guess or prefix.is_guess)


def _in_sub_node(analysis: Analysis, found: Found, name: str, depth: int = 0) -> str | None:
    """Return a name as a part of a node has it, that `create_sub_node("arm")` makes."""
    if found.handle is None or name.startswith(("/", "~")) or found.shape.kind is PARAMETER:
        return name
    held = analysis.holding.of(found.handle, found.scope)
    while held is not None and held.call is not None and held.call.name == "create_sub_node":
        space = analysis.evaluator.fold(held.call.argument(0), held.scope)
        if space is None or space.text is None or space.is_default or depth > 8:
            return None
        name = f"{space.text}/{name}"
        depth += 1
        held = analysis.holding.of(held.call.receiver, held.scope)
    return name


def _in_namespace(analysis: Analysis, found: Found, name: str) -> str | None:
    given = analysis.evaluator.fold(found.arguments[0], found.call.scope)
    if given is None or given.text is None:
        return None
    return f"{given.text}.{name}" if given.text else name


def _prefix(analysis: Analysis, found: Found) -> Prefix:
    """Return the namespace of the handle that a call is made on."""
    if found.handle is None:
        return Prefix("")
    receivers = analysis.receivers
    type_ = receivers.type_of(found.handle, found.scope)
    if type_ == "image_transport::ImageTransport":
        return _transport_prefix(analysis, found)
    if type_ and type_ != HANDLE and found.owner is None and found.shape.on != "handle":
        return Prefix(None)
    return receivers.prefix(found.handle, found.scope)


def _transport_prefix(analysis: Analysis, found: Found) -> Prefix:
    """Return the namespace of the handle that an image transport is made of."""
    return analysis.receivers.prefix(found.handle, found.scope)


def _callback(analysis: Analysis, found: Found) -> Callback:
    position = found.shape.callback
    if position is None or position >= len(found.arguments):
        return NONE
    scope = (found.options or found.call).scope
    return callback_of(analysis.unit, found.arguments[position], scope)


def _type(analysis: Analysis, found: Found, callback: Callback) -> tuple[InterfaceName | None, str]:
    shape = found.shape
    if shape.fixed is not None:
        return shape.fixed, ""
    if shape.type == "":
        return None, ""
    types = analysis.types
    call = found.options or found.call
    syntax, scope = call.scope.file.syntax, call.scope
    if shape.type == "text":
        return _told_type(analysis, found)
    if shape.type == "argument" or (shape.type == "message" and not call.type_nodes):
        given = call.argument(1 if shape.type == "argument" else 0)
        text = analysis.receivers.type_of(given, scope)
        return types.interface(text, scope, True), text
    if found.template:
        return _interface(analysis, found, found.template), found.template
    texts = [type_text(syntax.word(each)) for each in call.type_nodes[:2]]
    is_service = shape.kind in (EndpointKind.SERVICE, EndpointKind.CLIENT)
    # `advertiseService<Request, Response>`: parts of the service.
    of_parts = is_service and len(call.type_nodes) > 1
    for text in texts:
        type_ = types.interface(text, scope, of_parts)
        if type_ is not None:
            return _without_action(analysis, shape, type_), text
    if shape.type == "callback" and (not texts or analysis.ros_version == 1):
        position = 0
        said = callback.type_at(position)
        if said is not None:
            type_ = types.interface(*said, is_service)
            if type_ is not None:
                return type_, said[0]
            return None, texts[0] if texts else said[0]
    return None, texts[0] if texts else ""


def _told_type(analysis: Analysis, found: Found) -> tuple[InterfaceName | None, str]:
    """Return the type that a string names, `pkg/msg/Name`."""
    scope = found.call.scope
    given = found.arguments[1] if len(found.arguments) > 1 else None
    if given is None:
        return None, ""
    value = analysis.evaluator.fold(given, scope)
    text = scope.file.syntax.slice(given)
    parts = value.text.split("/") if value is not None and value.text is not None else []
    is_known = value is not None and not value.is_default and not value.is_guess
    is_type = len(parts) == 3 and parts[1] == "msg"
    return (InterfaceName(parts[0], parts[2]) if is_known and is_type else None), text


def _interface(analysis: Analysis, found: Found, text: str) -> InterfaceName | None:
    scope = found.call.scope
    first = text.partition(",")[0] if "<" not in text else text
    type_ = analysis.types.interface(first, scope)
    if type_ is None and found.call.node.type == "field_initializer":
        # The member's type is written where its class is.
        owner = analysis.unit.class_of(scope)
        type_ = analysis.types.interface(first, owner) if owner is not None else None
    return None if type_ is None else _without_action(analysis, found.shape, type_)


def _without_action(analysis: Analysis, shape: Shape, type_: InterfaceName) -> InterfaceName:
    """Return the action that the messages of ROS 1 are parts of."""
    if shape.kind in _ACTIONS and analysis.ros_version == 1:
        return type_._replace(name=type_.name.removesuffix("Action"))
    return type_
