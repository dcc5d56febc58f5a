"""Whether a line runs for each call of its function, and in each turn of its loop."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.sources.grammars import is_inside
from plastron_tui.sources.work_limits import Effort

from .classes import Classes
from .constants import MOST_BINDINGS
from .containers import Item
from .scopes import BindingKind, Scope, ScopeTree
from .syntax import Syntax, parts_of

LOOPS = frozenset({"for_statement", "for_in_clause"})

_MOST_STATEMENTS = 500
"""The most statements of a block, or nodes of a function, that are looked through."""

_EXITS = frozenset({"return_statement", "continue_statement", "break_statement", "raise_statement"})
_DEFINITIONS = frozenset({"function_definition", "class_definition", "lambda"})
_COMPREHENSIONS = frozenset(
    {"list_comprehension", "set_comprehension", "dictionary_comprehension", "generator_expression"}
)


@dataclass(frozen=True, slots=True)
class Frame:
    """A call of a function of the file.

    Attributes:
        function: the function.
        call: the call.
        world: the pass that its arguments are of, None for the one that the function is in: then
            the call is one of those that come to the line that is asked about.
    """

    function: Scope
    call: Node
    world: World | None = None


@dataclass(frozen=True, slots=True)
class Turn:
    """A turn of a loop, or of a `for` in a comprehension."""

    loop: Node
    scope: Scope
    item: Item


World = Mapping[int, Frame | Turn]
"""A pass: the call that a function runs for, and the turn of a loop, by the ids of their nodes."""

EVERYWHERE: World = {}
"""What holds in every pass."""


def is_made_in(world: World, call: Node, syntax: Syntax, effort: Effort) -> bool:
    """Whether a call is made in a pass, whatever is handed over or looped over there."""
    chosen = world.values()
    points = [call, *(each.call for each in chosen if isinstance(each, Frame))]
    for each in chosen:
        region = each.function.node if isinstance(each, Frame) else each.loop
        around = region.parent if region.type == "for_in_clause" else region
        inside = [point for point in points if around is not None and is_inside(point, around)]
        is_constructor = isinstance(each, Frame) and each.function.name == "__init__"
        if not inside and not is_constructor:
            return False
        names = {syntax.encode(name) for name in _varying(each)}
        if not all(is_always_reached(point, region, names, effort) for point in inside):
            return False
    return True


def is_related(
    world: World, call: Node, scopes: ScopeTree, classes: Classes, syntax: Syntax
) -> bool:
    """Whether the objects that a pass makes may be those that its calls are made for."""
    frames = [each for each in world.values() if isinstance(each, Frame)]
    points = [call, *(frame.call for frame in frames)]
    around = {scopes.at(point.start_byte).enclosing("class") for point in points}
    users = [user for user in around if user is not None]
    for frame in frames:
        owner = frame.function.parent
        made = made_class(frame.call, scopes.at(frame.call.start_byte), syntax)
        if frame.function.name != "__init__" or owner is None or made is None:
            continue
        for user in users:
            alike = {user, *classes.bases(user)}
            if owner in alike and made not in alike | {*classes.derived(user)}:
                return False
    return True


def is_making(call: Node, scope: Scope, function: Scope, classes: Classes, syntax: Syntax) -> bool:
    """Whether a call runs a constructor for sure: by the class's name, or that of an heir."""
    callee, owner = call.child_by_field_name("function"), function.parent
    made = made_class(call, scope, syntax)
    if callee is None or owner is None or made is None or made is owner:
        return made is not None and made is owner
    is_inherited = callee.type == "attribute" or "__init__" not in made.bindings
    return is_inherited and owner in classes.bases(made)


def made_class(call: Node, scope: Scope, syntax: Syntax) -> Scope | None:
    """Return the class that a call makes an instance of, or completes the making of."""
    callee = call.child_by_field_name("function")
    if callee is None or callee.type != "identifier":
        return scope.enclosing("class")
    found = scope.lookup(syntax.slice(callee))
    is_class = found is not None and [each.kind for each in found[1]] == [BindingKind.CLASS]
    return found[1][0].owner if found is not None and is_class else None


def _varying(chosen: Frame | Turn) -> set[str]:
    """Return the names that may stand for something else in each pass."""
    if isinstance(chosen, Frame):
        return chosen.function.bindings.keys() - {chosen.function.self_name}
    return {
        name
        for name, bindings in chosen.scope.bindings.items()
        if any(is_inside(each.node, chosen.loop) for each in bindings[:MOST_BINDINGS])
    }


def result_of(function: Scope) -> Node | None:
    """Return the expression that a function gives, where it gives one in its last line alone."""
    body = function.node.child_by_field_name("body")
    if body is None or function.kind == "lambda":
        return body
    statements = parts_of(body)
    last = statements[-1] if statements else None
    if last is None or last.type != "return_statement" or function.kind != "function":
        return None
    pending = statements[:-1]
    for _ in range(_MOST_STATEMENTS):
        if not pending:
            return next(iter(parts_of(last)), None)
        node = pending.pop()
        if node.type in ("return_statement", "yield"):
            return None
        if node.type not in _DEFINITIONS:
            pending += node.named_children
    return None


def is_always_reached(node: Node, region: Node, names: set[bytes], effort: Effort) -> bool:
    """Whether nothing that differs from run to run of a region decides if a part of it runs.

    Args:
        node: the part.
        region: the function, the loop, or a comprehension's `for`.
        names: what stands for something that differs.
        effort: what is left for the file.
    """
    # The `for` of a comprehension is beside what it runs.
    end = region.parent if region.type == "for_in_clause" else region
    conditions: list[Node] = []
    current = node
    while end is not None and current.id != end.id:
        parent = current.parent
        if parent is None or not effort.spend():
            return False
        conditions += _conditions(parent, current)
        if parent.type == "block":
            if parent.named_child_count > _MOST_STATEMENTS:
                return False
            before = (each for each in parent.named_children if each.end_byte <= current.start_byte)
            for statement in before:
                conditions += _exits(statement, effort)
        current = parent
    return not any(_differs(condition, names, effort) for condition in conditions)


def _conditions(parent: Node, child: Node) -> Iterator[Node]:
    """Yield what decides whether a child of a node runs."""
    if parent.type == "boolean_operator":
        left = parent.child_by_field_name("left")
        if left is not None and left.id != child.id:
            yield left
    elif parent.type == "conditional_expression":
        parts = parts_of(parent)
        if len(parts) == 3 and parts[1].id != child.id:
            yield parts[1]
    elif parent.type in _COMPREHENSIONS:
        yield from (part for part in parent.named_children if part.type == "if_clause")
    elif parent.type == "match_statement":
        yield from parent.children_by_field_name("subject")
    elif parent.type == "if_statement":
        yield from _tests(parent)
    elif parent.type == "while_statement":
        yield from parent.children_by_field_name("condition")


def _tests(statement: Node) -> Iterator[Node]:
    yield from statement.children_by_field_name("condition")
    for clause in statement.named_children:
        if clause.type == "elif_clause":
            yield from clause.children_by_field_name("condition")


def _exits(statement: Node, effort: Effort) -> Iterator[Node]:
    """Yield the conditions under which a statement leaves its function, or its loop."""
    pending: list[tuple[Node, tuple[Node, ...]]] = [(statement, ())]
    while pending:
        node, around = pending.pop()
        if node.type in _EXITS:
            yield from around
        if node.type in _DEFINITIONS:
            continue
        if not effort.spend():
            yield statement
            return
        if node.type == "if_statement":
            around = (*around, *_tests(node))
        if node.type.endswith(("statement", "clause", "block")):
            pending += [(child, around) for child in node.named_children]


def _differs(condition: Node, names: set[bytes], effort: Effort) -> bool:
    """Whether a condition depends on what differs; `name in self.made` only asks for the rest."""
    pending = [condition]
    while pending:
        node = pending.pop()
        if not effort.spend():
            return True
        if _is_membership(node):
            pending.append(node.named_children[-1])
            continue
        if node.type == "identifier" and node.text in names:
            return True
        pending += node.named_children
    return False


def _is_membership(node: Node) -> bool:
    """Whether a condition asks for a thing among those that the object has made itself."""
    is_asking = node.type == "comparison_operator" and node.named_child_count == 2
    operator = node.children[1].type if is_asking and node.child_count == 3 else ""
    container = node.named_children[-1] if is_asking else None
    return operator in ("in", "not in") and container is not None and container.type == "attribute"
