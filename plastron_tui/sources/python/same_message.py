"""Whether a file says literally the message that a statement gives."""

from __future__ import annotations

from collections.abc import Callable

from tree_sitter import Node

from plastron_tui.model.values import MessageValue, Value
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName

from .analysis import Analysis
from .arguments import Arguments
from .constants import Known
from .references import references, variable_of

Interfaces = Callable[[InterfaceName, InterfaceKind], Interface | None]
"""What finds an interface type, None where it is not known."""

_BOOLEANS = {"true": True, "false": False}


def is_message(analysis: Analysis, interfaces: Interfaces, node: Node, value: MessageValue) -> bool:
    """Whether an expression is a message, or the one field of it that rospy takes instead."""
    interface = interfaces(value.type, InterfaceKind.MESSAGE)
    names = [field.name for field in interface.fields] if interface is not None else []
    scope = analysis.scopes.at(node.start_byte)
    given = _filled(analysis, node) if node.type == "identifier" else {}
    if given:
        node = given.pop("", node)
    callee = node.child_by_field_name("function")
    if callee is None or analysis.resolver.interface(callee, scope) != value.type:
        is_first = list(value.fields) == names[:1] != []
        return is_first and _is_value(analysis, interfaces, node, value.fields[names[0]])
    arguments = Arguments.of(node, analysis.syntax)
    if arguments.is_open or len(arguments.positional) > len(names):
        return False
    given |= {**dict(zip(names, arguments.positional, strict=False)), **arguments.keywords}
    return given.keys() == value.fields.keys() and all(
        _is_value(analysis, interfaces, each, value.fields[name]) for name, each in given.items()
    )


def _filled(analysis: Analysis, node: Node) -> dict[str, Node]:
    """Return the values of fields in `m = String()` and `m.data = 'on'`, and at "" what makes it.

    Empty where anything else is done with the variable than to publish it, where a field has its
    value under some condition, or gets it once the message is sent.
    """
    variable = variable_of(node, analysis)
    found: dict[str, Node] = {}
    blocks: set[int | None] = set()
    for use in references(variable, analysis) if variable is not None else ():
        parent, name = use.node.parent, ""
        if parent is not None and parent.type == "attribute":
            name = analysis.syntax.slice(parent.child_by_field_name("attribute") or parent)
            parent = parent.parent
        if (
            parent is not None
            and parent.type == "argument_list"
            and _is_published(analysis, parent)
        ):
            continue
        value = parent.child_by_field_name("right") if parent is not None else None
        is_assigned = parent is not None and parent.type == "assignment"
        if (
            value is None
            or not is_assigned
            or use.node.end_byte > value.start_byte
            or name in found
            or use.node.start_byte > node.start_byte
        ):
            return {}
        found[name] = value
        block = use.statement.parent
        blocks.add(block.id if block is not None else None)
    return found if "" in found and len(blocks) == 1 else {}


def _is_published(analysis: Analysis, arguments: Node) -> bool:
    call = arguments.parent
    return call is not None and analysis.syntax.called_name(call) == "publish"


def _is_value(analysis: Analysis, interfaces: Interfaces, node: Node, value: Value) -> bool:
    if isinstance(value, MessageValue):
        return node.type == "call" and is_message(analysis, interfaces, node, value)
    if node.type in _BOOLEANS:
        return value is _BOOLEANS[node.type]
    folded = analysis.resolver.fold(node, analysis.scopes.at(node.start_byte))
    return isinstance(folded, Known) and not isinstance(value, bool) and folded.value == value
