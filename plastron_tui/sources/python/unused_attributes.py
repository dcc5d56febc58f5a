"""Attributes of a node that only served what is deleted."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from tree_sitter import Node

from .analysis import Analysis
from .emptied_blocks import leaves_pass
from .references import identifiers, is_member, statement_of
from .scopes import BindingKind, Scope
from .splices import Splice
from .syntax import nodes_in
from .unused_locals import fills, is_filling_pure, is_of_its_own, value_of

# Any other base class may read what is defined below it.
_ONLY_NODE = re.compile(
    rb"\(\s*((rclpy\.)?((node\.)?Node|(lifecycle\.)?LifecycleNode)|object)?\s*\)"
)


def unused_attributes(analysis: Analysis, gone: Sequence[Splice]) -> list[Node]:
    """Return what gives values to attributes that nothing reads any more.

    What another function or a caller keeps in an attribute stays: nobody said that it is of no use.

    Args:
        analysis: the file.
        gone: what is deleted or replaced.
    """
    found: dict[int, Node] = {}
    ranges = [(splice.start, splice.end) for splice in gone]
    for (owner, name), functions in _read_in(analysis, ranges).items():
        filling = _filling(analysis, owner, name, ranges)
        if not filling or _is_named_otherwise(analysis, owner, name):
            continue
        places = {_function(analysis, each) for each in filling}
        is_near = all(each is not None and each.name == "__init__" for each in places - functions)
        if is_near and not leaves_pass(analysis, filling, ranges):
            found.update({statement.id: statement for statement in filling})
    return list(found.values())


def is_plain_class(owner: Scope) -> bool:
    """Whether a class is only a node, or nothing: no class of other files has to do with it."""
    bases = owner.node.child_by_field_name("superclasses")
    return bases is None or _ONLY_NODE.fullmatch(bases.text or b"") is not None


def _read_in(
    analysis: Analysis, ranges: Iterable[tuple[int, int]]
) -> dict[tuple[Scope, str], set[Scope | None]]:
    """Return the attributes of `self` that parts of a file mention, and in which functions."""
    found: dict[tuple[Scope, str], set[Scope | None]] = {}
    for node in nodes_in(analysis.syntax.root, ranges):
        owner, name = _owner(analysis, node), node.child_by_field_name("attribute")
        if owner is not None and name is not None:
            key = (owner, analysis.syntax.slice(name))
            found.setdefault(key, set()).add(_function(analysis, node))
    return found


def _function(analysis: Analysis, node: Node) -> Scope | None:
    return analysis.scopes.at(node.start_byte).enclosing("function")


def _owner(analysis: Analysis, node: Node) -> Scope | None:
    """Return the plain class of whose object `self.a` takes an attribute."""
    function = _function(analysis, node) if node.type == "attribute" else None
    holder = node.child_by_field_name("object")
    if function is None or holder is None or function.parent is None:
        return None
    is_self = function.self_name and analysis.syntax.slice(holder) == function.self_name
    return function.parent if is_self and is_plain_class(function.parent) else None


def _filling(
    analysis: Analysis, owner: Scope, name: str, ranges: Sequence[tuple[int, int]]
) -> list[Node]:
    """Return the statements that give an attribute its values; none where more is done with it."""
    found = []
    for node in identifiers(name, analysis):
        if any(first <= node.start_byte < last for first, last in ranges) or not is_member(node):
            continue
        attribute = node.parent
        if attribute is None or attribute.type != "attribute":
            continue
        statement = statement_of(node)
        if _owner(analysis, attribute) is not owner or not fills(analysis, statement, attribute):
            return []
        if not is_filling_pure(analysis, statement) or _keeps_given(analysis, statement):
            return []
        found.append(statement)
    return found if is_of_its_own(analysis, found) else []


def _keeps_given(analysis: Analysis, statement: Node) -> bool:
    """Whether a statement keeps what a caller gave: `self.node = node`."""
    value = value_of(statement)
    if value is None or value.type != "identifier":
        return False
    found = analysis.scopes.at(value.start_byte).lookup(analysis.syntax.slice(value))
    return found is not None and any(each.kind is BindingKind.PARAMETER for each in found[1])


def _is_named_otherwise(analysis: Analysis, owner: Scope, name: str) -> bool:
    """Whether a class has the name itself, or a text is the name."""
    quoted = re.compile(rb"""["']%s["']""" % re.escape(analysis.syntax.encode(name)))
    return name in owner.bindings or quoted.search(analysis.syntax.text) is not None
