"""What a file says of an endpoint only as far as no other file says otherwise."""

from __future__ import annotations

import sys

from tree_sitter import Node

from plastron_tui.ros.catalog.data import index
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .constants import MOST_BINDINGS
from .names import Resolver
from .scopes import BindingKind, Scope, ScopeTree
from .syntax import Syntax

_KINDS = tuple(kind.value for kind in InterfaceKind)
_WITHOUT_TYPES = sys.stdlib_module_names | {"rospy", "rclpy"}


def is_default_guess(
    node: Node, scope: Scope, resolver: Resolver, scopes: ScopeTree, syntax: Syntax
) -> bool:
    """Whether a constant is the default of a parameter of what the file itself never calls."""
    return guessed_parameter(node, scope, resolver, scopes, syntax) is not None


def guessed_parameter(
    node: Node, scope: Scope, resolver: Resolver, scopes: ScopeTree, syntax: Syntax
) -> tuple[str, Scope] | None:
    """Return the parameter whose default a constant is, and its function that nothing calls."""
    if node.type == "string":
        return None
    for read in resolver.read_for(node, scope):
        if read.type != "identifier":
            continue
        name = syntax.slice(read)
        found = scopes.at(read.start_byte).lookup(name)
        for binding in found[1][:MOST_BINDINGS] if found is not None else ():
            is_parameter = binding.kind is BindingKind.PARAMETER
            if is_parameter and binding.owner and not resolver.callers_of(binding.owner):
                return name, binding.owner
    return None


def is_star_guess(bare: str, modules: list[str], distribution: str) -> bool:
    """Whether nothing but a lack of others says that a name is of a module imported whole.

    Nothing is known to have it there, and something else may: another module, or a package that
    the catalog knows to have such a type.
    """
    names = index(distribution).names
    packages, has_others = set(), False
    for module in modules:
        package, dot, kind = module.partition(".")
        if dot and kind in _KINDS:
            packages.add((package, InterfaceKind(kind)))
        elif package not in _WITHOUT_TYPES:
            has_others = True
    if any(InterfaceName(package, bare) in names[kind] for package, kind in packages):
        return False
    return has_others or any(name.name == bare for _, kind in packages for name in names[kind])
