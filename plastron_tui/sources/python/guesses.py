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

_KINDS = frozenset(InterfaceKind)
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
    """Whether a name that a module imported whole seems to bring in may be of something else.

    Python takes the last module that has it. A package of types that nothing is known of may have
    it. Where none is known to, so may any other module, or a package that the catalog knows to have
    such a type.
    """
    known = index(distribution)
    packages: list[tuple[str, InterfaceKind]] = []
    others = 0
    is_known = is_last = False
    for module in modules:
        package, dot, kind = module.partition(".")
        if not (dot and kind in _KINDS):
            others += package not in _WITHOUT_TYPES
            continue
        place = package, InterfaceKind(kind)
        packages.append(place)
        if InterfaceName(package, bare) in known.names[place[1]]:
            is_known = is_last = True
        elif place not in known.packages or package in known.partial:
            is_last = False
    if is_known:
        return not is_last
    return len({*packages}) + others > 1 or any(
        name.name == bare for _, kind in packages for name in known.names[kind]
    )
