"""Endpoints and callbacks of parameters whose handle nobody keeps, and which end with it.

Sources: `rclcpp/node_interfaces/node_base.hpp` of Jazzy: a group of callbacks has weak pointers to
what it calls; `node_parameters.hpp` and `rclcpp/parameter_event_handler.hpp`: so have the lists of
callbacks of parameters; `ros/subscriber.h`, `ros/publisher.h`, `ros/timer.h`,
`ros/service_server.h` of Noetic: the last copy of a handle ends what it is of.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.code_facts import Dropped
from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.arguments import Call
from plastron_tui.sources.cpp.holders import holder_of_call
from plastron_tui.sources.cpp.receivers import HANDLE
from plastron_tui.sources.cpp.scopes import Scope, Variable, body_of, last_name
from plastron_tui.sources.cpp.shapes import FILLED

from .called_back import CALLED
from .fields import method_of
from .mentions import mentions
from .places import span_of

_KINDS = CALLED | {EndpointKind.PUBLISHER}
_HANDLE_NAME = re.compile(r"\w*(?:nh|node_?handle)\w*_?", re.IGNORECASE)
_SPINNING = re.compile(
    rb"\b(?:\w*[sS]pin\w*|\w*[eE]xec\w*)\s*\(|\bwhile\s*\(\s*(?:\w+(?:::|\.|->))?ok\s*\("
)
_STAYING = re.compile(
    rb"\b(?:\w*[sS]pin\w*|ok|u?sleep\w*|\w*[wW]ait\w*|join|\w*[eE]xec\w*|getline)\s*\("
    rb"|\bwhile\b|\bfor\s*\(\s*;\s*;|\bgoto\b|\bcin\b"
)
_KEPT_BY_OTHERS = frozenset({"empty", "lazy", "filter"})
_OF_NODE = (
    "add_on_set_parameters_callback",
    "add_post_set_parameters_callback",
    "add_pre_set_parameters_callback",
)
"""Methods of a node, and of its interface for parameters, that give a handle back."""

_OF_HANDLER = ("add_parameter_callback", "add_parameter_event_callback")
_HANDLER = "rclcpp::ParameterEventHandler"
_OF_LIBRARY = ("rclcpp::", "rclcpp_lifecycle::")


def dropped(analysis: Analysis) -> Iterator[Dropped]:
    """Yield them, each once."""
    found: dict[tuple[str, int], Dropped] = {}
    for site in analysis.sites:
        endpoint = site.endpoint
        # `sub.subscribe(nh, "x", 1)` fills an object that somebody has.
        is_filled = site.call.name in FILLED and site.shape.on == "function"
        if endpoint.kind not in _KINDS or site.shape.on in _KEPT_BY_OTHERS or is_filled:
            continue
        if site.call.name in ("waitForMessage", "wait_for_message"):
            continue
        if _is_plain(analysis, site) and _is_dropped(analysis, site.call, endpoint.kind):
            span, file = span_of(site.call.node), site.file.name
            found.setdefault((file, span.start), Dropped(endpoint.kind, span, file))
    for call in _parameter_callbacks(analysis):
        if _is_dropped(analysis, call):
            span, file = span_of(call.node), call.scope.file.name
            found.setdefault((file, span.start), Dropped(None, span, file))
    yield from (found[key] for key in sorted(found))


def _parameter_callbacks(analysis: Analysis) -> Iterator[Call]:
    """Yield the calls that add a callback of parameters and give its handle back."""
    unit = analysis.unit
    if analysis.ros_version == 1:
        return
    for name in (*_OF_NODE, *_OF_HANDLER):
        for call in () if name in unit.functions else unit.calls.get(name, ()):
            if not call.scope.file.is_beside and _is_of_library(analysis, call):
                yield call


def _is_of_library(analysis: Analysis, call: Call) -> bool:
    """Tell whether a method is that of the client library."""
    owner = analysis.unit.class_of(call.scope)
    if call.receiver is None or call.receiver.type == "this":
        is_node = owner is not None and analysis.receivers.is_node_class(owner)
        return is_node and call.name in _OF_NODE
    type_ = analysis.receivers.type_of(call.receiver, call.scope)
    if call.name in _OF_HANDLER:
        return type_ == _HANDLER
    # What else has a method of this name is no class of the files.
    return type_.startswith(_OF_LIBRARY) or analysis.receivers.is_node(type_, call.scope)


def _is_dropped(analysis: Analysis, call: Call, kind: EndpointKind | None = None) -> bool:
    """Tell whether nobody keeps what a call gives back."""
    return _is_discarded(call) or _is_left(analysis, call, kind)


def _is_plain(analysis: Analysis, site: Site) -> bool:
    """Tell whether what creates an endpoint of ROS 1 is a node handle."""
    if site.shape.on != "handle":
        return True
    receiver, scope = site.call.receiver, site.call.scope
    if receiver is None or receiver.type == "this":
        return True
    type_ = analysis.receivers.type_of(receiver, scope)
    return type_ == HANDLE or (
        not type_ and _HANDLE_NAME.fullmatch(last_name(receiver, scope)) is not None
    )


def _is_discarded(call: Call) -> bool:
    """Tell whether a call is a statement of its own."""
    node = call.node
    if node.type != "call_expression":
        return False
    while node.parent is not None and node.parent.type == "cast_expression":
        node = node.parent
    return node.parent is not None and bool(node.parent.type == "expression_statement")


def _is_left(analysis: Analysis, call: Call, kind: EndpointKind | None) -> bool:
    """Tell whether a variable of a function that returns is all that has a handle."""
    holder = holder_of_call(analysis, call)
    if holder is None or holder.kind != "local" or holder.is_reference or holder.is_pointer:
        return False
    function = holder.scope.enclosing("function", "lambda")
    if function is None or function.kind != "function" or function.function is None:
        return False
    # What a block has ends with it, that of `main` too.
    block = _block(holder.node)
    body = body_of(function.node)
    if block is None or body is None or (block.id == body.id and function.name == "main"):
        return False
    code = holder.file.syntax.code
    if b"static" in code[holder.node.start_byte : holder.start]:
        return False
    # A constructor that waits is done some time.
    staying = _SPINNING if _is_constructor(analysis, function) else _STAYING
    if staying.search(code, block.start_byte, block.end_byte):
        return False
    return _is_only_used(analysis, holder, kind)


def _block(node: Node) -> Node | None:
    """Return the innermost block around a statement."""
    block: Node | None = node
    while block is not None and block.type != "compound_statement":
        block = block.parent
    return block


def _is_constructor(analysis: Analysis, function: Scope) -> bool:
    made = function.function
    if made is None:
        return False
    owner = analysis.unit.class_of_function(made)
    # The class may be in a header that is not read.
    name = made.qualifier.rpartition("::")[2] if owner is None else owner.name
    return name == made.name


def _is_only_used(analysis: Analysis, holder: Variable, kind: EndpointKind | None) -> bool:
    """Tell whether all that is done with a variable is to call its methods, if anything."""
    named = mentions(analysis.unit, holder)
    if named is None:
        return False
    is_used = False
    for _, node in named:
        parent = node.parent
        if parent is not None and _is_cast_to_void(parent):
            continue
        is_holder = parent is not None and parent.type == "field_expression"
        if not is_holder or parent is None or method_of(parent) is None:
            return False
        if _is_in_lambda(node, holder):
            # What is called later may have a copy.
            return False
        is_used = True
    # A publisher that sends, and then is left, may be meant.
    return not (is_used and kind is EndpointKind.PUBLISHER)


def _is_cast_to_void(node: Node) -> bool:
    """Tell whether a cast only says that a variable is not used: `(void)timer;`."""
    is_cast = node.type == "cast_expression"
    type_ = node.child_by_field_name("type") if is_cast else None
    is_statement = node.parent is not None and node.parent.type == "expression_statement"
    return type_ is not None and type_.text == b"void" and is_statement


def _is_in_lambda(node: Node, holder: Variable) -> bool:
    """Tell whether a mention of a variable stands in a lambda behind its declaration."""
    around = node.parent
    while around is not None and around.start_byte > holder.start:
        if around.type == "lambda_expression":
            return True
        around = around.parent
    return False
