"""Local variables that only served what is deleted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from tree_sitter import Node

from .analysis import Analysis
from .emptied_blocks import leaves_pass
from .purity import is_pure
from .references import identifiers, is_member, statement_of
from .scopes import BindingKind, Scope
from .splices import Splice

_FILLING = frozenset({"append", "extend"})
# A chain of locals that serve only each other is not longer than this.
_MOST_ROUNDS = 8


class Unused(NamedTuple):
    """What only makes local variables that nothing uses.

    Attributes:
        statements: what goes.
        splices: what is left of statements that do something besides: the call alone.
    """

    statements: list[Node]
    splices: list[Splice]


def unused_locals(analysis: Analysis, gone: Sequence[Splice]) -> Unused:
    """Find what only makes local variables which nothing uses any more.

    Args:
        analysis: the file.
        gone: what is deleted or replaced.
    """
    found: dict[int, Node] = {}
    calls: dict[int, Splice] = {}
    ranges = [(splice.start, splice.end) for splice in gone]
    for _ in range(_MOST_ROUNDS):
        more: dict[int, Node] = {}
        for scope, name in sorted(_locals_in(analysis, ranges), key=lambda each: each[1]):
            filling = _only_filling(analysis, scope, name, ranges) or []
            pure = [each for each in filling if _is_filling_pure(analysis, each)]
            if leaves_pass(analysis, pure, ranges):
                continue
            more.update({statement.id: statement for statement in pure})
            for each in filling:
                value = _value(each)
                if value is not None and not any(each.id == other.id for other in pure):
                    calls[each.id] = Splice(each.start_byte, value.start_byte)
        more = {key: each for key, each in more.items() if key not in found}
        if not more:
            break
        found.update(more)
        ranges += [(each.start_byte, each.end_byte) for each in more.values()]
    return Unused(list(found.values()), list(calls.values()))


def _locals_in(analysis: Analysis, ranges: Iterable[tuple[int, int]]) -> set[tuple[Scope, str]]:
    """Return the local variables that are read in parts of a file."""
    found = set()
    for start, end in ranges:
        pending = [analysis.syntax.root.descendant_for_byte_range(start, max(start, end - 1))]
        while pending:
            node = pending.pop()
            if node is None or node.end_byte <= start or node.start_byte >= end:
                continue
            pending.extend(node.named_children)
            if node.type != "identifier" or is_member(node) or node.start_byte < start:
                continue
            name = analysis.syntax.slice(node)
            holder = analysis.scopes.at(node.start_byte).lookup(name)
            if holder is not None and _is_local(holder[0], name):
                found.add((holder[0], name))
    return found


def _is_local(scope: Scope, name: str) -> bool:
    """Whether a variable is of one function alone, or of a script's loops and conditions."""
    bindings = scope.bindings.get(name, [])
    is_plain = all(each.kind is BindingKind.VALUE and each.value is not None for each in bindings)
    is_shared = name in scope.globals or name in scope.nonlocals
    if scope.parent is None:
        parents = [statement_of(each.node).parent for each in bindings]
        is_shared = any(parent is None or parent.type == "module" for parent in parents)
    return scope.kind in ("function", "module") and is_plain and not is_shared


def _only_filling(
    analysis: Analysis, scope: Scope, name: str, ranges: Iterable[tuple[int, int]]
) -> list[Node] | None:
    """Return the statements that make and fill a variable; None where something else is done."""
    found = []
    for node in identifiers(name, analysis):
        start = node.start_byte
        if is_member(node) or any(first <= start < last for first, last in ranges):
            continue
        holder = analysis.scopes.at(start).lookup(name)
        if holder is None or holder[0] is not scope:
            continue
        statement = statement_of(node)
        if not _fills(analysis, statement, node):
            return None
        found.append(statement)
    return found


def _fills(analysis: Analysis, statement: Node, variable: Node) -> bool:
    """Whether a statement only gives a value to a variable, or to a part of it.

    A call that works out the value may do something besides.
    """
    inner = _only_part(statement)
    if inner is None:
        return False
    if inner.type == "assignment":
        target, value = inner.child_by_field_name("left"), inner.child_by_field_name("right")
        if target is None or value is None or value.type == "assignment":
            return False
        is_made = value.type == "call" or is_pure(analysis, value)
        return _root(target) == variable and is_made and is_pure(analysis, target)
    if inner.type == "call":
        callee = inner.child_by_field_name("function")
        name = callee.child_by_field_name("attribute") if callee is not None else None
        arguments = inner.child_by_field_name("arguments")
        if callee is None or name is None or arguments is None:
            return False
        is_filling = analysis.syntax.slice(name) in _FILLING and _root(callee) == variable
        return is_filling and is_pure(analysis, arguments)
    return False


def _is_filling_pure(analysis: Analysis, statement: Node) -> bool:
    value = _value(statement)
    return value is None or is_pure(analysis, value)


def _value(statement: Node) -> Node | None:
    """Return what a statement assigns."""
    inner = _only_part(statement)
    is_assignment = inner is not None and inner.type == "assignment"
    return inner.child_by_field_name("right") if inner is not None and is_assignment else None


def _only_part(statement: Node) -> Node | None:
    is_one = statement.type == "expression_statement" and statement.named_child_count == 1
    return statement.named_children[0] if is_one else None


def _root(target: Node) -> Node:
    """Return the variable that `a.b[0].c` begins with."""
    while target.type in ("attribute", "subscript"):
        inner = target.child_by_field_name("object") or target.child_by_field_name("value")
        if inner is None:
            break
        target = inner
    return target
