"""The functions of a file: where they are defined, what mentions and what calls them."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .callbacks import callback_target
from .references import function_of, identifiers, is_member
from .scopes import Scope


def callback_scope(analysis: Analysis, site: Site) -> Scope | None:
    """Return the function of the file that a call site's callback is."""
    if site.shape.callback is None:
        return None
    node = callback_target(site.arguments.get(site.shape.callback), site.scope, analysis)
    return function_of(node, analysis) if node is not None else None


def definition(function: Scope) -> Node:
    """Return the statement that defines a function, with its decorators."""
    parent = function.node.parent
    is_decorated = parent is not None and parent.type == "decorated_definition"
    return parent if is_decorated and parent is not None else function.node


def function_uses(analysis: Analysis, function: Scope) -> list[Node]:
    """Return the places that mention a function, its definition aside."""
    is_method = function.parent is not None and function.parent.kind == "class"
    found = []
    for node in identifiers(function.name, analysis):
        name = function.node.child_by_field_name("name")
        if name is not None and node.id == name.id:
            continue
        parent = node.parent
        if parent is not None and parent.type == "keyword_argument" and is_member(node):
            continue
        if not is_method and is_member(node):
            continue
        found.append(node)
    return found


def timers_of(analysis: Analysis, function: Scope) -> list[Site]:
    """Return the timers that call a function."""
    return [
        site
        for site in analysis.sites
        if site.endpoint.kind is EndpointKind.TIMER and callback_scope(analysis, site) is function
    ]
