"""Names of topics and services that are the value of a parameter, or the full name of the node."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.source import OWN_NAME
from plastron_tui.ros.names import name_as_read
from plastron_tui.sources.caller_limits import MOST_STEPS, are_followed

from .analysis import Analysis
from .arguments import Arguments
from .calls import Argument
from .constants import MOST_BINDINGS, Known, without_none
from .evaluation import Evaluator
from .flow import reaching
from .parameter_calls import READERS
from .scopes import Binding, BindingKind, Scope

_NAME = Argument(0, "name")
_OWN_NAMES = frozenset({"rospy.get_name", "rospy.names.get_name"})


def given_by(analysis: Analysis, node: Node | None, scope: Scope, depth: int = 0) -> str | None:
    """Return the parameter whose value an expression is as it stands: `~/topic` in ROS 1.

    `OWN_NAME` is the full name of the node. None where it is neither, or something is put to it.
    """
    if node is None or depth > MOST_STEPS:
        return None
    match node.type:
        case "parenthesized_expression" if node.named_child_count == 1:
            return given_by(analysis, node.named_children[0], scope, depth + 1)
        case "identifier":
            found = scope.lookup(analysis.syntax.slice(node))
            if found is None or len(found[1]) > MOST_BINDINGS:
                return None
            bindings = reaching(found[1], found[0], node, scope)
            return _bound(analysis, bindings, node, depth)
        case "attribute":
            read = Evaluator(analysis).read_parameter(node, scope)
            if read is not None:
                given = Arguments.of(read.node, analysis.syntax)
                return _named(analysis, given, read.scope)
            bindings = analysis.resolver.attribute_bindings(node, scope)
            return _bound(analysis, bindings, node, depth)
        case "call":
            return _called(analysis, node, scope, depth)
        case _:
            return None


def _bound(analysis: Analysis, bindings: list[Binding], node: Node, depth: int) -> str | None:
    bindings = without_none(bindings)
    if len(bindings) != 1:
        return None
    binding = bindings[0]
    if binding.kind is BindingKind.VALUE:
        return given_by(analysis, binding.value, binding.scope, depth + 1)
    if binding.kind is not BindingKind.PARAMETER:
        return None
    name = analysis.syntax.slice(node.child_by_field_name("attribute") or node)
    calls = analysis.resolver.given(binding, name)
    if not are_followed(len(calls), depth):
        return None
    found = {given_by(analysis, value, scope, depth + 1) for value, scope in calls}
    return found.pop() if len(found) == 1 else None


def _called(analysis: Analysis, call: Node, scope: Scope, depth: int) -> str | None:
    callee = call.child_by_field_name("function")
    given = Arguments.of(call, analysis.syntax)
    if callee is None or given.is_open:
        return None
    names = analysis.resolver.qualified(callee, scope)
    if not _OWN_NAMES.isdisjoint(names):
        return OWN_NAME
    if not READERS.keys().isdisjoint(names):
        return _named(analysis, given, scope)
    is_same = analysis.syntax.slice(callee) == "str" and scope.lookup("str") is None
    if not is_same or len(given.positional) != 1:
        return None
    return given_by(analysis, given.positional[0], scope, depth + 1)


def _named(analysis: Analysis, given: Arguments, scope: Scope) -> str | None:
    """Return the name of a parameter that is read."""
    name = None if given.is_open else analysis.resolver.fold(given.get(_NAME), scope)
    if not isinstance(name, Known) or not isinstance(name.value, str):
        return None
    found = name_as_read(name.value, analysis.library.ros_version)
    # Who else sets one of ROS 1 that is not private is not known.
    is_own = analysis.library.ros_version == 2 or found.startswith("~/")
    return found if is_own else None
