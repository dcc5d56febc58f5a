"""Local variables that only served what is deleted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tree_sitter import Node

from .analysis import Analysis
from .references import identifiers, is_member, statement_of
from .scopes import BindingKind, Scope
from .splices import Splice
from .syntax import parts_of

_PURE_BUILTINS = frozenset(
    {"abs", "bool", "dict", "float", "int", "len", "list", "max", "min", "range", "round", "set"}
    | {"sorted", "str", "sum", "tuple", "zip"}
)
_PURE_FUNCTIONS = frozenset(
    {"rospy.Time.now", "rospy.get_rostime", "rospy.get_time", "rospy.Time", "rospy.Duration"}
    | {"rospy.Time.from_sec", "rospy.Duration.from_sec", "time.time"}
    | {"rclpy.duration.Duration", "rclpy.qos.QoSProfile"}
)
# What a node's clock is asked; nothing else of these names changes anything either.
_PURE_METHODS = frozenset({"get_clock", "now", "to_msg", "to_sec", "format", "copy", "tolist"})
_PURE_TYPES = frozenset(
    {"identifier", "string", "integer", "float", "true", "false", "none", "attribute", "subscript"}
    | {"list", "tuple", "dictionary", "pair", "set", "parenthesized_expression", "binary_operator"}
    | {"unary_operator", "not_operator", "boolean_operator", "comparison_operator", "slice"}
    | {"conditional_expression", "concatenated_string", "interpolation", "string_content"}
    | {"string_start", "string_end", "escape_sequence", "expression_list", "keyword_argument"}
    | {"argument_list", "format_specifier", "type_conversion", "comment"}
)
_FILLING = frozenset({"append", "extend"})
# A chain of locals that serve only each other is not longer than this.
_MOST_ROUNDS = 8


def unused_locals(analysis: Analysis, gone: Sequence[Splice]) -> list[Node]:
    """Return the statements that only make local variables which nothing uses any more.

    A statement that may do something besides stays.

    Args:
        analysis: the file.
        gone: what is deleted or replaced.
    """
    found: dict[int, Node] = {}
    ranges = [(splice.start, splice.end) for splice in gone]
    for _ in range(_MOST_ROUNDS):
        more: dict[int, Node] = {}
        for scope, name in _locals_in(analysis, ranges):
            filling = _only_filling(analysis, scope, name, ranges) or []
            if not _empties_block(filling, ranges):
                more.update({statement.id: statement for statement in filling})
        more = {key: each for key, each in more.items() if key not in found}
        if not more:
            break
        found.update(more)
        ranges += [(each.start_byte, each.end_byte) for each in more.values()]
    return list(found.values())


def empty_conditions(analysis: Analysis, gone: Sequence[Node]) -> list[Node]:
    """Return the `if` statements that have nothing to decide once statements are gone."""
    known = {statement.id for statement in gone}
    found: list[Node] = []
    pending = list(gone)
    while pending:
        block = pending.pop().parent
        owner = block.parent if block is not None else None
        if owner is None or owner.type != "if_statement" or owner.id in known:
            continue
        condition = owner.child_by_field_name("condition")
        is_empty = all(part.id in known for part in parts_of(block))
        is_whole = not owner.children_by_field_name("alternative")
        if is_empty and is_whole and condition is not None and _is_pure(analysis, condition):
            known.add(owner.id)
            found.append(owner)
            pending.append(owner)
    return found


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
    bindings = scope.bindings.get(name, [])
    is_plain = all(each.kind is BindingKind.VALUE and each.value is not None for each in bindings)
    is_shared = name in scope.globals or name in scope.nonlocals
    return scope.kind == "function" and is_plain and not is_shared


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


def _empties_block(statements: Sequence[Node], ranges: Iterable[tuple[int, int]]) -> bool:
    """Whether nothing would be left of a block, whose owner somebody wrote for them."""
    gone = {statement.id for statement in statements}
    blocks = {each.parent.id: each.parent for each in statements if each.parent is not None}
    return any(
        block.type == "block"
        and all(
            each.id in gone or any(start <= each.start_byte < end for start, end in ranges)
            for each in parts_of(block)
        )
        for block in blocks.values()
    )


def _fills(analysis: Analysis, statement: Node, variable: Node) -> bool:
    """Whether a statement gives a value to a variable, or to a part of it, and nothing more."""
    if statement.type != "expression_statement" or statement.named_child_count != 1:
        return False
    inner = statement.named_children[0]
    if inner.type == "assignment":
        target, value = inner.child_by_field_name("left"), inner.child_by_field_name("right")
        if target is None or value is None or value.type == "assignment":
            return False
        return (
            _root(target) == variable and _is_pure(analysis, value) and _is_pure(analysis, target)
        )
    if inner.type == "call":
        callee = inner.child_by_field_name("function")
        name = callee.child_by_field_name("attribute") if callee is not None else None
        arguments = inner.child_by_field_name("arguments")
        if callee is None or name is None or arguments is None:
            return False
        is_filling = analysis.syntax.slice(name) in _FILLING and _root(callee) == variable
        return is_filling and _is_pure(analysis, arguments)
    return False


def _root(target: Node) -> Node:
    """Return the variable that `a.b[0].c` begins with."""
    while target.type in ("attribute", "subscript"):
        inner = target.child_by_field_name("object") or target.child_by_field_name("value")
        if inner is None:
            break
        target = inner
    return target


def _is_pure(analysis: Analysis, expression: Node) -> bool:
    """Whether to evaluate an expression changes nothing."""
    pending = [expression]
    while pending:
        node = pending.pop()
        if node.type == "call":
            if not _is_pure_call(analysis, node):
                return False
        elif node.is_named and node.type not in _PURE_TYPES:
            return False
        pending.extend(node.named_children)
    return True


def _is_pure_call(analysis: Analysis, call: Node) -> bool:
    callee = call.child_by_field_name("function")
    if callee is None:
        return False
    scope = analysis.scopes.at(call.start_byte)
    if callee.type == "identifier":
        name = analysis.syntax.slice(callee)
        if name in _PURE_BUILTINS and scope.lookup(name) is None:
            return True
    resolver = analysis.resolver
    if resolver.interface(callee, scope) is not None:
        return True
    names = resolver.qualified(callee, scope)
    if names:
        return all(each in _PURE_FUNCTIONS or each.startswith("math.") for each in names)
    method = callee.child_by_field_name("attribute")
    return method is not None and analysis.syntax.slice(method) in _PURE_METHODS
