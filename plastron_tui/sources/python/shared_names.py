"""Endpoints of one name in a class whose objects have endpoints of names of their own."""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.sources.shared_names import shares_name

from .addition import Addition
from .analysis import Analysis, Site
from .scopes import BindingKind, Scope

# Parameters that tell one object of a class from another, as ROS has them in its graph.
_NAMESPACE = re.compile(r"(\w+_)?(ns|namespace)")
_TELLING = re.compile(r"(\w+_)?(ns|namespace)|(robot_|topic_)?(name|prefix)")


def shared_name(added: Addition) -> Diagnostic | None:
    """Return a warning where each object of a class creates an endpoint of one name.

    An object that has to be told what its other endpoints are called is seldom the only one.
    rospy takes no second service of a name: `rospy/service.py`.
    """
    place, analysis = added.place, added.analysis
    owner = place.owner
    if owner is None:
        return None
    is_node = any(
        node.owner is owner or (node.scope.enclosing("function") is place.scope)
        for node in analysis.nodes
    )
    telling = _telling(analysis, added, owner, is_node=is_node)
    for site in () if is_node else analysis.sites:
        function = site.scope.enclosing("function")
        if function is place.scope and _has_parameter(analysis, site, function):
            telling = f"line {site.endpoint.line}"
            break
    if not telling:
        return None
    return shares_name(owner.name, added.endpoint, telling)


def _telling(analysis: Analysis, added: Addition, owner: Scope, *, is_node: bool) -> str:
    """Return the parameter of a constructor that tells apart what other files make of a class.

    A node has its namespace before the names of all that it has, but for absolute ones.
    """
    found = owner.bindings.get("__init__", [])
    made = found[0].owner if len(found) == 1 else None
    if made is None or (is_node and not added.name.startswith("/")):
        return ""
    calls = analysis.captures.get("call", [])
    if sum(analysis.syntax.called_name(call) == owner.name for call in calls) == 1:
        return ""
    telling = _NAMESPACE if is_node else _TELLING
    for name, bindings in made.bindings.items():
        is_given = all(each.kind is BindingKind.PARAMETER and not each.value for each in bindings)
        if is_given and telling.fullmatch(name):
            return f"`{name}`"
    return ""


def _has_parameter(analysis: Analysis, site: Site, function: Scope) -> bool:
    """Whether the name of an endpoint is made of what has to be given to make the object."""
    given = site.arguments.get(site.shape.name)
    pending: list[Node] = [given] if given is not None else []
    seen: set[int] = set()
    while pending:
        node = pending.pop()
        if node.id in seen:
            continue
        seen.add(node.id)
        if _is_given(analysis, node, function):
            return True
        if node.type == "attribute":
            for each in analysis.resolver.attribute_bindings(node, site.scope):
                if each.value is not None and _is_given(analysis, each.value, each.scope):
                    return True
        pending += [*node.named_children, *_sources(analysis, node, function)]
    return False


def _sources(analysis: Analysis, node: Node, function: Scope) -> list[Node]:
    """Return what a local variable is made of: `name, kind = ask(topic)`."""
    name = analysis.syntax.slice(node) if node.type == "identifier" else ""
    values = (
        each.node.child_by_field_name("right")
        for each in function.bindings.get(name, [])
        if each.kind is not BindingKind.PARAMETER
    )
    return [each for each in values if each is not None]


def _is_given(analysis: Analysis, node: Node, function: Scope) -> bool:
    """Whether a name is a parameter of a method that has no default."""
    name = analysis.syntax.slice(node)
    return (
        node.type == "identifier"
        and name != function.self_name
        and any(
            each.kind is BindingKind.PARAMETER and each.value is None
            for each in function.bindings.get(name, [])
        )
    )
