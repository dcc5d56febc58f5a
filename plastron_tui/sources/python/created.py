"""What a call creates, as data."""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.source import EndpointKind, SourceEndpoint
from plastron_tui.ros.names import name_as_read
from plastron_tui.ros.qos import Qos, common

from .analysis import Analysis
from .arguments import Arguments
from .callbacks import callback_name
from .calls import ACTIONS, Argument, CallShape
from .constants import Defaulted, Known
from .given_names import given_by
from .guesses import is_default_guess, is_star_guess
from .qos import qos_of
from .runs import EVERYWHERE, World
from .scopes import Scope
from .syntax import parts_of


def created_by(
    analysis: Analysis, call: Node, shape: CallShape, scope: Scope, arguments: Arguments
) -> Iterator[tuple[SourceEndpoint, tuple[World, ...]]]:
    """Yield what a call creates, each with the passes through its function or loop that create it.

    There are none where nothing calls the function with something else, and no loop repeats it.
    """
    resolver = analysis.resolver
    for name in _name_nodes(shape, arguments):
        passes = [EVERYWHERE]
        if name is not None and shape.type is not None:
            passes = resolver.passes(name, scope, call)
        found: dict[SourceEndpoint, list[tuple[World, Qos | None]]] = {}
        for each in passes:
            with resolver.during(each):
                endpoint = _endpoint(analysis, call, shape, scope, arguments, name)
                qos = qos_of(analysis, call, shape, scope, arguments)
            found.setdefault(endpoint, []).append((each, qos))
        for endpoint, creating in found.items():
            worlds = tuple(each for each, _ in creating if passes != [EVERYWHERE])
            yield endpoint._replace(qos=common(qos for _, qos in creating)), worlds


def _name_nodes(shape: CallShape, arguments: Arguments) -> list[Node | None]:
    """Return the argument that names the endpoint, or each name of a list of parameters."""
    node = arguments.get(shape.name)
    if "declare_parameters" not in shape.callees or node is None:
        return [node]
    if node.type not in ("list", "tuple"):
        return [node]
    found: list[Node | None] = []
    for item in parts_of(node):
        inner = parts_of(item) if item.type == "tuple" else []
        found.append(inner[0] if inner else item)
    return found


def _endpoint(
    analysis: Analysis,
    call: Node,
    shape: CallShape,
    scope: Scope,
    arguments: Arguments,
    name_node: Node | None,
) -> SourceEndpoint:
    syntax, resolver = analysis.syntax, analysis.resolver
    name: str | None = None
    default: str | None = None
    if name_node is not None and shape.kind is not EndpointKind.TIMER:
        folded = resolver.fold(name_node, scope)
        if isinstance(folded, Known) and isinstance(folded.value, str):
            read = name_as_read(folded.value, analysis.library.ros_version)
            name = _in_namespace(analysis, read, shape, arguments, scope)
        elif isinstance(folded, Defaulted):
            default = name_as_read(folded.value, analysis.library.ros_version)
    is_given = name is None and shape.kind.facts.interface is not None
    type_node = arguments.get(shape.type) if shape.type is not None else None
    callback = arguments.get(shape.callback) if shape.callback is not None else None
    type_ = resolver.interface(type_node, scope) if type_node is not None else None
    if type_ is not None and shape.kind in ACTIONS and analysis.library.ros_version == 1:
        # Code of ROS 1 names the message that all parts of an action are in.
        type_ = type_._replace(name=type_.name.removesuffix("Action"))
    text = name_node if name_node is not None else arguments.splat
    if shape.fixed is not None:
        name, type_ = shape.fixed
        text = call.child_by_field_name("function")
    return SourceEndpoint(
        kind=shape.kind,
        name=name,
        expression=syntax.slice(text) if text is not None else "",
        span=Span(call.start_byte, call.end_byte),
        line=call.start_point.row + 1,
        type=type_,
        type_expression=syntax.slice(type_node) if type_node is not None else "",
        callback=callback_name(analysis, callback, scope),
        default=default,
        is_guess=_is_guess(
            analysis,
            None if name is None else name_node,
            None if type_ is None else type_node,
            scope,
        ),
        given_by=given_by(analysis, name_node, scope) if is_given else None,
    )


def _is_guess(analysis: Analysis, name: Node | None, type_: Node | None, scope: Scope) -> bool:
    """Whether another file may give an endpoint another name, or bring another type in."""
    syntax, resolver = analysis.syntax, analysis.resolver
    if name is not None and is_default_guess(name, scope, resolver, analysis.scopes, syntax):
        return True
    if type_ is None or type_.type != "identifier" or scope.lookup(syntax.slice(type_)):
        return False
    modules = resolver.star_modules(scope)
    return is_star_guess(syntax.slice(type_), modules, analysis.library.distribution)


def _in_namespace(
    analysis: Analysis, name: str, shape: CallShape, arguments: Arguments, scope: Scope
) -> str | None:
    """Put the namespace of `declare_parameters` before a name; None where it is unknown."""
    if "declare_parameters" not in shape.callees:
        return name
    given = arguments.get(Argument(0, "namespace"))
    folded = analysis.resolver.fold(given, scope)
    if not isinstance(folded, Known) or not isinstance(folded.value, str):
        return None
    return f"{folded.value}.{name}" if folded.value else name
