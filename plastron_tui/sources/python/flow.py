"""Which of the values that a function gives a name one by one is the one that a line sees."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.grammars import is_inside

from .scopes import Binding, BindingKind, Scope
from .syntax import REPEATING

_BLOCKS = frozenset({"block", "module"})
# What may bind a name without the lines behind it seeing that for sure.
_UNSURE = frozenset({"except_clause", "named_expression", "case_pattern", "match_statement"})


def reaching(bindings: list[Binding], owner: Scope, node: Node, scope: Scope) -> list[Binding]:
    """Return the one binding that a use of a name sees, or all where that is not sure.

    Args:
        bindings: what binds the name.
        owner: the scope that has the name.
        node: the use.
        scope: the scope of the use.
    """
    if len(bindings) < 2 or _running(scope) is not owner:
        return bindings
    if any(binding.node.type in _UNSURE or not _is_of(binding, owner) for binding in bindings):
        return bindings
    before = [binding for binding in bindings if _bound_at(binding) <= node.start_byte]
    if not before:
        return bindings
    last = max(before, key=_bound_at)
    region = _region(last)
    if region is None or not region.start_byte <= node.start_byte < region.end_byte:
        return bindings
    is_sure = not _comes_round(last, bindings, node, owner)
    return [last] if is_sure else bindings


def straight_line(bindings: list[Binding], owner: Scope) -> list[Node]:
    """Return the assignments of a local that run one after the other, each once in a call.

    They are in the order of the file and in one block; none where anything else binds the name.
    """
    nodes = [binding.node for binding in bindings]
    is_plain = all(node.type == "assignment" for node in nodes)
    if len(nodes) < 2 or owner.kind != "function" or not is_plain:
        return []
    # Around an assignment is its statement, but for the inner one of `a = b = value`.
    blocks = {node.parent.parent for node in nodes if node.parent is not None}
    around = blocks.pop()
    while around is not None and around.id != owner.node.id:
        if blocks or around.type in REPEATING:
            return []
        around = around.parent
    return sorted(nodes, key=lambda node: node.start_byte)


def _running(scope: Scope) -> Scope:
    """Return the scope whose code runs where a comprehension is."""
    while scope.kind == "comprehension" and scope.parent is not None:
        scope = scope.parent
    return scope


def _is_of(binding: Binding, owner: Scope) -> bool:
    """Whether the owner of a name binds it itself, and no function that says `global`."""
    if binding.kind is BindingKind.PARAMETER:
        return binding.owner is owner
    return binding.scope is owner


def _bound_at(binding: Binding) -> int:
    """Return the offset from which on a name has its value."""
    target = binding.node.child_by_field_name("left")
    if binding.node.type in ("for_statement", "for_in_clause") and target is not None:
        return target.end_byte
    if binding.kind in (BindingKind.CLASS, BindingKind.FUNCTION):
        return binding.node.start_byte
    return binding.node.end_byte


def _region(binding: Binding) -> Node | None:
    """Return the part of the file in which whatever runs has passed a binding; None for none."""
    if binding.kind is BindingKind.PARAMETER:
        return binding.owner.node if binding.owner is not None else None
    if binding.node.type == "for_statement":
        return binding.node.child_by_field_name("body")
    current = binding.node.parent
    while current is not None and current.type not in _BLOCKS:
        if current.type in _UNSURE:
            return None
        current = current.parent
    return current


def _comes_round(last: Binding, bindings: list[Binding], node: Node, owner: Scope) -> bool:
    """Whether a loop may bring the value of a later line to the use."""
    current = node.parent
    while current is not None and current.id != owner.node.id:
        if current.type in REPEATING:
            if current.start_byte <= last.node.start_byte:
                return False
            if any(is_inside(binding.node, current) for binding in bindings):
                return True
        current = current.parent
    return False
