"""Messages that are published once, right after their publisher is created: nobody hears them.

Sources: `ros/publisher.h` of Noetic: a subscriber connects after it has heard from the master;
discovery of DDS for ROS 2. Only what is latched, or transient local, waits for it.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.model.code_facts import EarlyPublish
from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.cpp.analysis import Analysis, Site
from plastron_tui.sources.cpp.holders import holder_of
from plastron_tui.sources.cpp.node_sites import is_nodelet
from plastron_tui.sources.cpp.scopes import Scope, type_text
from plastron_tui.sources.unreachable import is_unreachable

from .fields import method_of
from .mentions import mentions
from .message_types import MessageTypes
from .places import span_of

_QUICK = frozenset(
    {
        "RCLCPP_DEBUG", "RCLCPP_ERROR", "RCLCPP_INFO", "RCLCPP_WARN", "ROS_DEBUG", "ROS_ERROR",
        "ROS_INFO", "ROS_INFO_STREAM", "ROS_WARN", "RCLCPP_INFO_STREAM", "advertise",
        "advertiseService", "bind", "c_str", "createTimer", "create_client", "create_publisher",
        "create_service", "create_subscription", "create_wall_timer", "declare_parameter",
        "get_logger", "getParam", "move", "now", "param", "printf",
        "publish", "push_back", "resize", "serviceClient", "size", "str", "subscribe", "to_string",
    }
)  # fmt: skip
"""What is called between the two in no time to speak of."""

_QUICK_TYPES = re.compile(
    r"(?:const )?(?:auto|std::|ros::|rclcpp::|(?:\w+::)*(?:msg|srv)::|\w+_(?:msgs|srvs)::).*"
)
"""What objects are made of in no time; those of other classes may wait for something."""

_MOST_CALLERS = 4
_LOOPS = re.compile(r"(?:while|for|do)_(?:statement|range_loop)|for_range_loop")


def early(analysis: Analysis, types: MessageTypes) -> Iterator[EarlyPublish]:
    """Yield the only messages of publishers, where they are sent right after those are created."""
    publishers = [s for s in analysis.sites if s.endpoint.kind is EndpointKind.PUBLISHER]
    names = Counter(site.endpoint.name for site in publishers)
    for site in publishers:
        is_alone = site.endpoint.name is None or names[site.endpoint.name] == 1
        is_plain = site.shape.on in ("node", "handle") and not site.endpoint.is_guess
        if not is_alone or not is_plain or site.bindings or _is_kept(analysis, site):
            continue
        sent = _only_message(analysis, site)
        if sent is not None and _is_right_behind(analysis, types, site, sent):
            yield EarlyPublish(span_of(sent), span_of(site.call.node), site.file.name)


def _is_kept(analysis: Analysis, site: Site) -> bool:
    """Tell whether a publisher keeps its message for who comes later, or may do so."""
    if analysis.ros_version == 1:
        return len(site.arguments) > 2 or site.options is not None
    qos = site.endpoint.qos
    return qos is None or qos.durability not in (None, "volatile")


def _only_message(analysis: Analysis, site: Site) -> Node | None:
    """Return the call that publishes, where it is all that is done with a publisher."""
    named_by = site.call.node.parent
    if named_by is not None and named_by.type == "field_expression":
        # It has no name: `create_publisher<…>(…)->publish(…)`.
        return named_by.parent if method_of(named_by) == "publish" else None
    holder = holder_of(analysis, site)
    if holder is None or holder.is_list or holder.kind == "parameter":
        return None
    named = mentions(analysis.unit, holder)
    if named is None:
        return None
    calls: list[Node] = []
    for file, node in named:
        if file is not site.file:
            return None
        # What creates it, or declares it, is named by what gets it.
        outer = node.parent
        if outer is not None and outer.type == "field_expression" and node.type != "identifier":
            node, outer = outer, outer.parent
        is_target = outer is not None and outer.type in (
            "assignment_expression", "field_initializer"
        )  # fmt: skip
        if is_target and outer is not None and _holds(outer, site.call.node):
            continue
        if outer is None or outer.type != "field_expression" or method_of(outer) != "publish":
            return None
        if outer.parent is None:
            return None
        calls.append(outer.parent)
    return calls[0] if len(calls) == 1 else None


def _holds(outer: Node, inner: Node) -> bool:
    return bool(outer.start_byte <= inner.start_byte and inner.end_byte <= outer.end_byte)


def _is_right_behind(analysis: Analysis, types: MessageTypes, site: Site, sent: Node) -> bool:
    """Tell whether a message is sent once, in the block that creates its publisher, at once."""
    created, sending = _statement(site.call.node), _statement(sent)
    block = created.parent
    if not _runs_once(analysis, site.call.scope) or b"static" in (created.text or b"")[:40]:
        return False
    if block is None or block.type != "compound_statement" or sending.parent is None:
        return False
    is_behind = sending.id == created.id or sending.start_byte >= created.end_byte
    if sending.parent.id != block.id or not is_behind or _is_in_loop(block):
        return False
    if is_unreachable(sent):
        return False
    between = [
        each
        for each in block.named_children
        if created.end_byte <= each.start_byte < sending.end_byte
    ]
    scope = site.call.scope
    return all(_takes_no_time(analysis, types, each, scope, sent) for each in between)


def _runs_once(analysis: Analysis, scope: Scope) -> bool:
    """Tell whether a function is called once: what starts a node, or what is only called there.

    A node starts in `main`, in its constructor, or in `onInit` of a nodelet.
    """
    for _ in range(_MOST_CALLERS):
        around = scope.enclosing("function", "lambda")
        function = None if around is None else around.function
        if around is None or function is None or around.kind == "lambda":
            return False
        owner = analysis.unit.class_of_function(function)
        if function.name == "main" or (owner is not None and owner.name == function.name):
            return True
        if function.name == "onInit" and owner is not None and is_nodelet(analysis, owner):
            return True
        calls = analysis.callers.of(function)
        if len(calls) != 1:
            return False
        scope = calls[0].scope
    return False


def _statement(node: Node) -> Node:
    while node.parent is not None and node.parent.type != "compound_statement":
        node = node.parent
    return node


def _is_in_loop(block: Node) -> bool:
    node: Node | None = block
    while node is not None and node.type not in ("function_definition", "lambda_expression"):
        if _LOOPS.fullmatch(node.type):
            return True
        node = node.parent
    return node is None or node.type == "lambda_expression"


def _takes_no_time(
    analysis: Analysis, types: MessageTypes, statement: Node, scope: Scope, sent: Node
) -> bool:
    if b"spin" in (statement.text or b"") or b"sleep" in (statement.text or b""):
        return False
    pending = [statement]
    while pending:
        node = pending.pop()
        if node.type == "lambda_expression" or node.start_byte >= sent.end_byte:
            continue
        if _LOOPS.fullmatch(node.type) or _makes_slow_object(analysis, node, scope):
            return False
        if node.type == "call_expression" and node.id != sent.id:
            called = node.child_by_field_name("function")
            name = (called.text or b"").decode("utf-8", "replace") if called is not None else ""
            last = re.search(r"(\w+)\s*(?:<.*>)?\s*\Z", name, re.DOTALL)
            is_quick = last is not None and last[1] in _QUICK
            if not is_quick and types.of(node, scope) is None:
                return False
        pending += node.named_children
    return True


def _makes_slow_object(analysis: Analysis, node: Node, scope: Scope) -> bool:
    """Tell whether a declaration makes an object of a class that may take its time."""
    type_ = node.child_by_field_name("type") if node.type == "declaration" else None
    if type_ is None or type_.type not in ("type_identifier", "qualified_identifier"):
        return False
    text = analysis.types.expand(type_text(scope.file.syntax.word(type_)), scope)
    return _QUICK_TYPES.fullmatch(text) is None
