"""Local variables that only served what is deleted."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis
from .emptied_blocks import leaves_pass
from .purity import FILLING, doing_part, is_fresh, is_pure
from .references import identifiers, is_member, statement_of
from .scopes import BindingKind, Scope
from .splices import Splice, around
from .syntax import holders, nodes_in, parts_of

_RUNS = re.compile(rb"""^if\s+__name__\s*==|^(rospy\.)?init_node\(|^rclpy\.init\(""", re.M)
_LITERALS = frozenset({"string", "concatenated_string", "integer", "float"})
# What nobody reads is called so: what else it is given is no matter of this edit.
_DUMMY = "_"
_SEVERAL = frozenset({"pattern_list", "tuple_pattern"})
# `a, b = ...` binds each to what nobody knows.
_OF_VALUES = frozenset({BindingKind.VALUE, BindingKind.UNKNOWN})
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
    unused = Unused([], [])
    ranges = [(splice.start, splice.end) for splice in gone]
    asked: set[Scope] = set()
    while scopes := {scope for scope, _ in _locals_in(analysis, ranges)} - asked:
        asked |= scopes
        for scope in sorted(scopes, key=lambda each: each.node.start_byte):
            own = _unused_in(analysis, scope, ranges, is_careful=False)
            if leaves_pass(analysis, own.statements, ranges):
                own = _unused_in(analysis, scope, ranges, is_careful=True)
            unused.statements.extend(own.statements)
            unused.splices.extend(own.splices)
            ranges += [(each.start_byte, each.end_byte) for each in own.statements]
    return unused


def _unused_in(
    analysis: Analysis, scope: Scope, gone: Sequence[tuple[int, int]], is_careful: bool
) -> Unused:
    """Find what is unused of one scope's variables; with care, a `pass` alone is never left."""
    found: dict[int, Node] = {}
    calls: dict[int, list[Splice]] = {}
    ranges = list(gone)
    for _ in range(_MOST_ROUNDS):
        more: dict[int, Node] = {}
        names = {name for holder, name in _locals_in(analysis, ranges) if holder is scope}
        for name in sorted(names - {_DUMMY}):
            filling = _only_filling(analysis, scope, name, ranges) or []
            pure = [each for each in filling if is_filling_pure(analysis, each)]
            if is_careful and leaves_pass(analysis, pure, ranges):
                continue
            more.update({statement.id: statement for statement in pure})
            for each in filling:
                value = value_of(each)
                part = doing_part(analysis, value) if value is not None else None
                if part is not None:
                    calls[each.id] = around(each, part)
        more = {key: each for key, each in more.items() if key not in found}
        if not more:
            break
        found.update(more)
        ranges += [(each.start_byte, each.end_byte) for each in more.values()]
    return Unused(list(found.values()), [each for both in calls.values() for each in both])


def _locals_in(analysis: Analysis, ranges: Iterable[tuple[int, int]]) -> set[tuple[Scope, str]]:
    """Return the local variables that are read in parts of a file."""
    found = set()
    for node in nodes_in(analysis.syntax.root, ranges):
        if node.type != "identifier" or is_member(node):
            continue
        name = analysis.syntax.slice(node)
        holder = analysis.scopes.at(node.start_byte).lookup(name)
        if holder is not None and _is_local(analysis, holder[0], name):
            found.add((holder[0], name))
    return found


def _is_local(analysis: Analysis, scope: Scope, name: str) -> bool:
    """Whether a variable is of one function alone, or of a script, or a script's constant."""
    bindings = scope.bindings.get(name, [])
    is_plain = all(each.kind in _OF_VALUES for each in bindings)
    is_shared = False
    if scope.parent is None:
        parents = [statement_of(each.node).parent for each in bindings]
        is_top = any(parent is None or parent.type == "module" for parent in parents)
        is_constant = all(_is_constant(analysis, each.value) for each in bindings)
        is_constant = is_constant and not _is_quoted(analysis, name)
        is_shared = is_top and not (is_constant and _is_script(analysis))
    return scope.kind in ("function", "module") and is_plain and not is_shared


def _is_constant(analysis: Analysis, value: Node | None) -> bool:
    """Whether a value is a literal, or a message."""
    if value is None or value.type in _LITERALS:
        return value is not None
    callee = value.child_by_field_name("function")
    return analysis.resolver.interface(callee, analysis.scopes.module) is not None


def _is_script(analysis: Analysis) -> bool:
    """Whether a file is run, so that no other file has what it defines."""
    return _RUNS.search(analysis.syntax.text) is not None


def _is_quoted(analysis: Analysis, name: str) -> bool:
    """Whether a text is a name: of `__all__`, or of what is looked up by it."""
    quoted = re.compile(rb"""["']%s["']""" % re.escape(analysis.syntax.encode(name)))
    return quoted.search(analysis.syntax.text) is not None


def _only_filling(
    analysis: Analysis,
    scope: Scope,
    name: str,
    ranges: Sequence[tuple[int, int]],
    known: frozenset[str] = frozenset(),
) -> list[Node] | None:
    """Return the statements that make and fill a variable; None where something else is done.

    Args:
        analysis: the file.
        scope: where the variable is.
        name: what it is called.
        ranges: what is gone.
        known: the variables that get a value together with it, which were asked before.
    """
    found = []
    for node in identifiers(name, analysis):
        start = node.start_byte
        if is_member(node) or any(first <= start < last for first, last in ranges):
            continue
        holder = analysis.scopes.at(start).lookup(name)
        if holder is None or holder[0] is not scope or _is_parameter(node):
            continue
        statement = statement_of(node)
        if not fills(analysis, statement, node):
            return None
        found.append(statement)
        for other in _other_targets(analysis, statement) - known - {name}:
            more = _only_filling(analysis, scope, other, ranges, known | {name})
            if more is None:
                return None
            found += [] if other == _DUMMY else more
    return found if is_of_its_own(analysis, found) else None


def _is_parameter(node: Node) -> bool:
    """Whether a name is that of a parameter, which is another variable."""
    parent = node.parent
    if parent is not None and parent.type.endswith("default_parameter"):
        return parent.child_by_field_name("name") == node
    return parent is not None and parent.type.endswith(("parameters", "typed_parameter"))


def _other_targets(analysis: Analysis, statement: Node) -> set[str]:
    """Return the names that `a, b = ...` gives a value to."""
    inner = _only_part(statement)
    target = inner.child_by_field_name("left") if inner is not None else None
    if target is None or target.type not in _SEVERAL:
        return set()
    return {analysis.syntax.slice(each) for each in parts_of(target)}


def is_of_its_own(analysis: Analysis, filling: Sequence[Node]) -> bool:
    """Whether what is filled was made for it: nobody else has `a.b` once `a.b.c` is set."""
    shared, parts = set(), set()
    for statement in filling:
        inner = _only_part(statement)
        target = inner.child_by_field_name("left") if inner is not None else None
        value = value_of(statement)
        if inner is None or target is None:
            changed = inner.child_by_field_name("function") if inner is not None else None
        else:
            changed = target
            if value is not None and inner.type == "assignment" and not is_fresh(analysis, value):
                shared.add(target.text)
            if inner.type == "augmented_assignment":
                parts.add(target.text)
        parts.update(each.text for each in holders(changed))
    return shared.isdisjoint(parts)


def fills(analysis: Analysis, statement: Node, variable: Node) -> bool:
    """Whether a statement only gives a value to a variable, or to a part of it.

    A call that works out the value may do something besides.
    """
    inner = _only_part(statement)
    if inner is None or _creates(analysis, statement):
        return False
    if inner.type in ("assignment", "augmented_assignment"):
        target, value = inner.child_by_field_name("left"), inner.child_by_field_name("right")
        if target is None or value is None:
            return False
        if value.type == "assignment":
            return _fills_parts(inner, variable)
        if not is_pure(analysis, value):
            part = doing_part(analysis, value)
            is_object = part == value and target.type == "identifier"
            if part is None or (is_object and _makes_object(analysis, part)):
                return False
        if target.type in _SEVERAL:
            is_plain = all(each.type == "identifier" for each in parts_of(target))
            return is_plain and variable.parent == target
        is_own = variable == target or variable in holders(target)
        return is_own and is_pure(analysis, target)
    if inner.type == "call":
        callee = inner.child_by_field_name("function")
        name = callee.child_by_field_name("attribute") if callee is not None else None
        arguments = inner.child_by_field_name("arguments")
        if callee is None or name is None or arguments is None:
            return False
        is_filling = analysis.syntax.slice(name) in FILLING and variable in holders(callee)
        return is_filling and is_pure(analysis, arguments)
    return False


def _fills_parts(chain: Node, variable: Node) -> bool:
    """Whether `a.b = a.c = 0` only fills one variable, with a literal."""
    links: Node | None = chain
    while links is not None and links.type == "assignment":
        target = links.child_by_field_name("left")
        held = [each.text for each in holders(target)]
        if target is None or target.type != "attribute" or variable.text not in held:
            return False
        links = links.child_by_field_name("right")
    return links is not None and links.type in _LITERALS


def _makes_object(analysis: Analysis, call: Node) -> bool:
    """Whether a call makes an object: that may do something for as long as a variable has it."""
    callee = call.child_by_field_name("function")
    if callee is None or analysis.syntax.called_name(call)[:1].isupper():
        return True
    return analysis.resolver.class_scope(callee, analysis.scopes.at(call.start_byte)) is not None


def _creates(analysis: Analysis, statement: Node) -> bool:
    """Whether a statement creates an endpoint or a node, which live as long as their variable."""
    start, end = statement.start_byte, statement.end_byte
    nodes = [each.call for each in analysis.nodes if each.call is not None and each.owner is None]
    return any(start <= call.start_byte < end for call in nodes) or any(
        start <= site.call.start_byte < end and site.endpoint.kind is not EndpointKind.PARAMETER
        for site in analysis.sites
    )


def is_filling_pure(analysis: Analysis, statement: Node) -> bool:
    """Whether to work out what a statement gives to a variable changes nothing."""
    value = value_of(statement)
    return value is None or is_pure(analysis, value)


def value_of(statement: Node) -> Node | None:
    """Return what a statement assigns."""
    inner = _only_part(statement)
    value = inner
    while value is not None and value.type in ("assignment", "augmented_assignment"):
        value = value.child_by_field_name("right")
    return value if value is not inner else None


def _only_part(statement: Node) -> Node | None:
    is_one = statement.type == "expression_statement" and statement.named_child_count == 1
    return statement.named_children[0] if is_one else None
