"""Which message a class of generated code is for."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.code_facts import MessageType, Part
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.scopes import BindingKind, Scope

_PARTS = {
    ("srv", "Request"): Part.REQUEST,
    ("srv", "Response"): Part.RESPONSE,
    ("action", "Goal"): Part.GOAL,
    ("action", "Result"): Part.RESULT,
    ("action", "Feedback"): Part.FEEDBACK,
}
_IMPORTABLE = frozenset({"identifier", "attribute"})


def message_class(analysis: Analysis, node: Node | None, scope: Scope) -> MessageType | None:
    """Return the message that an expression is the class of, None where that is not sure."""
    if node is None or node.type not in _IMPORTABLE:
        return None
    # The names of types begin so; most of what is called and looked into does not.
    last = node if node.type == "identifier" else node.child_by_field_name("attribute")
    if last is None or not (last.text or b"")[:1].isupper():
        return None
    resolver = analysis.resolver
    names = resolver.qualified(node, scope)
    found = {_of_name(name) for name in names}
    bound = scope.lookup(analysis.syntax.slice(node)) if node.type == "identifier" else None
    if node.type == "identifier" and bound is None:
        return _starred(found, resolver.interface(node, scope))
    if bound is not None and any(each.kind is BindingKind.CLASS for each in bound[1]):
        # The file has one of its own, where there is no other at least.
        return None
    if names:
        return found.pop() if len(found) == 1 else None
    # What `self.message_type` is hardly ever is the class of a message that is looked into.
    return None


def _starred(found: set[MessageType | None], named: InterfaceName | None) -> MessageType | None:
    """Return the message that one of several modules has which are imported whole."""
    if named is None:
        return None
    meant = {each for each in found if each is not None and each.name.package == named.package}
    return meant.pop() if len(meant) == 1 else MessageType(named)


def _of_name(qualified: str) -> MessageType | None:
    """Return the message of a class: `std_msgs.msg.String`, `std_srvs.srv.SetBool.Request`."""
    parts = qualified.split(".")
    if len(parts) > 3 and parts[2].startswith("_"):
        # `std_msgs.msg._String.String`
        del parts[2]
    if len(parts) < 3 or not all(parts):
        return None
    package, kind, name, *rest = parts
    if kind == "msg":
        return None if rest else MessageType(InterfaceName(package, name))
    if len(rest) == 1 and (kind, rest[0]) in _PARTS:
        return MessageType(InterfaceName(package, name), _PARTS[kind, rest[0]])
    if kind == "srv" and not rest:
        # rospy: `std_srvs.srv.SetBoolRequest`, and in rclpy what is behind `SetBool.Request`.
        for end in ("Request", "Response"):
            if name.endswith(end) and name != end:
                of = InterfaceName(package, name.removesuffix(end).removesuffix("_"))
                return MessageType(of, _PARTS["srv", end])
    return None
