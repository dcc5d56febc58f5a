"""Endpoints of a lifecycle node that one transition creates: another one has to destroy them."""

from __future__ import annotations

import re

from tree_sitter import Node

from .addition import Addition
from .analysis import Analysis
from .conventions import leading_space, target_name
from .function_place import method_place
from .place import Place
from .references import statement_of
from .scopes import Scope
from .splices import line_end, line_start
from .syntax import parts_of
from .transitions import MANAGED

# https://design.ros2.org/articles/node_lifecycle.html
_UNDONE_BY = {"on_configure": "on_cleanup", "on_activate": "on_deactivate"}
_CREATION = re.compile(r"\w+\.(\w+) = \w+\.create_(\w+)\(")
_DESTROYING = re.compile(r"(.*\.)?destroy_(?!node$)\w+")


def is_transition(analysis: Analysis, place: Place) -> bool:
    """Whether a place is in a transition of a lifecycle node, which runs once in each cycle."""
    if place.owner is None or place.scope.name not in _UNDONE_BY:
        return False
    is_managed = analysis.resolver.derives_from(place.owner, MANAGED)
    return is_managed and place.receiver == place.self_name


def destroy_created(added: Addition, lines: list[str]) -> None:
    """Destroy what lines of a transition create where the file destroys its others, or should."""
    created = [found for line in lines if (found := _CREATION.match(line)) is not None]
    if not created or not is_transition(added.analysis, added.place):
        return
    calls = [(_destroying_method(added.analysis, each[2]), each[1]) for each in created]
    undoing = _destroying(added) or _undoing(added)
    for function, statement in undoing.items():
        holder = function.self_name
        written = [f"{holder}.{method}({holder}.{name})" for method, name in calls]
        text, is_before = added.analysis.syntax.text, _returns(statement)
        start = line_start(text, statement.start_byte)
        offset = start if is_before else line_end(text, statement.end_byte)
        added.writer.lines(offset, leading_space(added.analysis, statement), written)
    if not undoing:
        holder, transition = added.place.self_name, _UNDONE_BY[added.place.scope.name]
        lines = [
            f"def {transition}({holder}, state):",
            *(f"\t{holder}.{method}({holder}.{name})" for method, name in calls),
            f"\treturn super().{transition}(state)",
        ]
        added.writer.function(method_place(added.analysis, added.place, ()), lines)


def _returns(statement: Node) -> bool:
    """Whether a statement may leave the function."""
    pending = [statement]
    while pending:
        node = pending.pop()
        if node.type == "return_statement":
            return True
        if not node.type.endswith("_definition"):
            pending += node.named_children
    return False


def _destroying_method(analysis: Analysis, noun: str) -> str:
    """Return the method that destroys what `create_…` makes, as the file does it."""
    method, plain = f"destroy_{noun}", f"destroy_{noun.removeprefix('lifecycle_')}"
    is_plain = f"{plain}(".encode() in analysis.syntax.text
    is_own = f"{method}(".encode() in analysis.syntax.text
    return plain if is_plain and not is_own else method


def _destroys(analysis: Analysis, callee: Node) -> bool:
    return _DESTROYING.fullmatch(analysis.syntax.slice(callee)) is not None


def _destroying(added: Addition) -> dict[Scope, Node]:
    """Return the methods that destroy what the transition creates, with the last statement."""
    analysis, place = added.analysis, added.place
    created = {
        name.rpartition(".")[2]
        for site in analysis.sites
        if site.scope.enclosing("function") is place.scope
        and (name := target_name(analysis, site)) is not None
    }
    found: dict[Scope, Node] = {}
    for call in analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        given = parts_of(call.child_by_field_name("arguments"))
        if callee is None or len(given) != 1 or not _destroys(analysis, callee):
            continue
        function = analysis.scopes.at(call.start_byte).enclosing("function")
        name = analysis.syntax.slice(given[0]).rpartition(".")[2]
        if function is not None and function.parent is place.owner and name in created:
            found[function] = _in_body(call, function)
    return found


def _in_body(node: Node, function: Scope) -> Node:
    """Return the statement of a function's body that a part of it is in."""
    body = function.node.child_by_field_name("body")
    statement = statement_of(node)
    while body is not None and statement.parent is not None and statement.parent.id != body.id:
        statement = statement_of(statement.parent)
    return statement


def _undoing(added: Addition) -> dict[Scope, Node]:
    """Return the transition that undoes the one of the place, with its last statement."""
    owner = added.place.owner
    name = _UNDONE_BY[added.place.scope.name]
    bindings = owner.bindings.get(name, []) if owner is not None else []
    function = bindings[0].owner if len(bindings) == 1 else None
    statements = parts_of(function.node.child_by_field_name("body")) if function else []
    return {function: statements[-1]} if function is not None and statements else {}
