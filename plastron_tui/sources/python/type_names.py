"""Which interface type an expression of a file names."""

from __future__ import annotations

from typing import Protocol

from tree_sitter import Node

from plastron_tui.ros.interfaces import InterfaceName

from .arguments import Arguments
from .calls import Argument
from .constants import Folded, Known
from .scopes import Binding, Scope
from .stars import star_interface
from .syntax import Syntax

_WRAPPED_TYPES = frozenset({"rospy.numpy_msg.numpy_msg", "numpy_msg.numpy_msg"})
_CLASS_LOADERS = frozenset({"roslib.message.get_message_class", "roslib.message.get_service_class"})
_KINDS = ("msg", "srv", "action")


class _Names(Protocol):
    def interface(self, node: Node | None, scope: Scope, depth: int = 0) -> InterfaceName | None:
        """Return the interface type that an expression names."""

    def qualified(self, node: Node | None, scope: Scope, depth: int = 0) -> tuple[str, ...]:
        """Return the qualified names that an expression may stand for."""

    def attribute_bindings(self, node: Node, scope: Scope, depth: int = 0) -> list[Binding]:
        """Return what an attribute of an object of the file is bound to."""

    def star_modules(self, scope: Scope) -> list[str]:
        """Return the modules that are imported whole where a scope sees them."""

    def fold(self, node: Node | None, scope: Scope, depth: int = 0) -> Folded:
        """Return the constant that an expression is."""


class Types:
    """Finds the interface types that the expressions of one file name."""

    def __init__(self, names: _Names, syntax: Syntax, distribution: str) -> None:
        self._names = names
        self._syntax = syntax
        self._ros = distribution

    def named(self, node: Node | None, scope: Scope, depth: int) -> InterfaceName | None:
        """Return the type that an expression names, None where the file does not say it."""
        if node is None:
            return None
        if node.type == "parenthesized_expression" and node.named_child_count == 1:
            return self._names.interface(node.named_children[0], scope, depth + 1)
        if node.type == "call":
            return self._wrapped(node, scope, depth)
        if node.type == "attribute":
            values = self._names.attribute_bindings(node, scope)
            of_values = {self._names.interface(v.value, v.scope, depth + 1) for v in values}
            if len(of_values) == 1 and None not in of_values:
                return of_values.pop()
        if node.type == "identifier" and scope.lookup(self._syntax.slice(node)) is None:
            modules = self._names.star_modules(scope)
            starred = star_interface(self._syntax.slice(node), modules, self._ros)
            if starred is not None:
                return starred
        found = {_interface_name(name) for name in self._names.qualified(node, scope)} - {None}
        return found.pop() if len(found) == 1 else None

    def _wrapped(self, node: Node, scope: Scope, depth: int) -> InterfaceName | None:
        names = self._names.qualified(node.child_by_field_name("function"), scope)
        argument = Arguments.of(node, self._syntax).get(Argument(0, ""))
        if any(name in _WRAPPED_TYPES for name in names):
            return self._names.interface(argument, scope, depth + 1)
        if any(name in _CLASS_LOADERS for name in names):
            folded = self._names.fold(argument, scope, depth + 1)
            if isinstance(folded, Known) and isinstance(folded.value, str):
                package, slash, name = folded.value.partition("/")
                return InterfaceName(package, name) if slash and name else None
        return None


def _interface_name(qualified: str) -> InterfaceName | None:
    parts = qualified.split(".")
    if len(parts) > 3 and not parts[2].startswith("_"):
        # A class within a type's class, such as the request of a service, is no interface.
        return None
    for kind in _KINDS:
        if len(parts) >= 3 and parts[1] == kind and parts[0] not in ("rospy", ""):
            return InterfaceName(parts[0], parts[-1])
    return None
