"""Where a variable of a file is used, and how."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum

from tree_sitter import Node

from .analysis import Analysis
from .scopes import Binding, BindingKind, Scope

STATEMENT_PARENTS = frozenset({"module", "block"})


@dataclass(frozen=True, slots=True)
class Variable:
    """A name of a scope, or an attribute of a class's instances (`is_attribute`)."""

    scope: Scope
    name: str
    is_attribute: bool


class Use(Enum):
    """How a reference uses its variable."""

    PUBLISH = "publish"
    BARE = "bare"
    BINDING = "binding"
    NOTHING = "nothing"
    OTHER = "other"


@dataclass(frozen=True, slots=True)
class Reference:
    """A use of a variable: the expression that is the variable, and its statement."""

    node: Node
    statement: Node
    use: Use


def statement_of(node: Node) -> Node:
    """Return the statement that a node is in."""
    current = node
    parent = current.parent
    while parent is not None and parent.type not in STATEMENT_PARENTS:
        current, parent = parent, parent.parent
    return current


def variable_of(target: Node, analysis: Analysis) -> Variable | None:
    """Return the variable that an assignment's target is."""
    scope = analysis.scopes.at(target.start_byte)
    if target.type == "identifier":
        name = analysis.syntax.slice(target)
        found = scope.lookup(name)
        holder = found[0] if found is not None else scope
        return Variable(holder, name, holder.kind == "class")
    if target.type == "attribute":
        holder_node = target.child_by_field_name("object")
        name_node = target.child_by_field_name("attribute")
        if holder_node is None or name_node is None:
            return None
        owner = analysis.resolver.class_scope(holder_node, scope)
        if owner is None:
            return None
        return Variable(owner, analysis.syntax.slice(name_node), True)
    return None


def function_of(node: Node, analysis: Analysis) -> Scope | None:
    """Return the one function of the file that an expression names, None where none is known."""
    scope = analysis.scopes.at(node.start_byte)
    bindings: list[Binding] = []
    if node.type == "identifier":
        found = scope.lookup(analysis.syntax.slice(node))
        bindings = found[1] if found is not None else []
    elif node.type == "attribute":
        bindings = analysis.resolver.attribute_bindings(node, scope)
    if len(bindings) != 1 or bindings[0].kind is not BindingKind.FUNCTION:
        return None
    return bindings[0].owner


def identifiers(name: str, analysis: Analysis) -> tuple[Node, ...]:
    """Return the identifiers of a name in the code: not those in strings and comments."""
    known = analysis.answers.identifiers
    if name not in known:
        known[name] = tuple(_identifiers(name, analysis))
    return known[name]


def _identifiers(name: str, analysis: Analysis) -> Iterator[Node]:
    text = analysis.syntax.text
    pattern = re.compile(rb"(?<![\w])" + re.escape(analysis.syntax.encode(name)) + rb"(?![\w])")
    root = analysis.syntax.root
    for found in pattern.finditer(text):
        node = root.descendant_for_byte_range(found.start(), found.end())
        if node is not None and node.type == "identifier":
            yield node


def is_member(node: Node) -> bool:
    """Whether an identifier is the name after a dot, or a keyword of a call."""
    parent = node.parent
    if parent is None:
        return False
    if parent.type == "attribute":
        name = parent.child_by_field_name("attribute")
        return name is not None and name.id == node.id
    if parent.type == "keyword_argument":
        name = parent.child_by_field_name("name")
        return name is not None and name.id == node.id
    # `from std_msgs.msg import String`
    return parent.type == "dotted_name" and parent.named_children[0].id != node.id


def references(variable: Variable, analysis: Analysis) -> list[Reference]:
    """Return the uses of a variable in the order of the file."""
    found: list[Reference] = []
    for node in identifiers(variable.name, analysis):
        expression = _expression(node, variable, analysis)
        if expression is not None:
            statement = statement_of(expression)
            found.append(Reference(expression, statement, _use(expression, statement, analysis)))
    return found


def _expression(node: Node, variable: Variable, analysis: Analysis) -> Node | None:
    """Return the expression that is the variable, None where the name means something else."""
    scope = analysis.scopes.at(node.start_byte)
    if not is_member(node):
        found = scope.lookup(variable.name)
        return node if found is not None and found[0] is variable.scope else None
    attribute = node.parent
    if not variable.is_attribute or attribute is None or attribute.type != "attribute":
        return None
    holder = attribute.child_by_field_name("object")
    if holder is None or analysis.resolver.qualified(holder, scope):
        return None
    owner = analysis.resolver.class_scope(holder, scope)
    if owner is not None:
        return attribute if _is_related(owner, variable.scope, analysis) else None
    # An object that the file does not tell may be an instance: what looks like a use is one.
    user = attribute.parent
    is_called = user is not None and user.type in ("attribute", "call")
    instance = analysis.resolver.instance(holder, scope)
    return attribute if is_called and instance is None and holder.type != "call" else None


def _is_related(one: Scope, other: Scope, analysis: Analysis) -> bool:
    return (
        one is other
        or other in analysis.resolver.classes.bases(one)
        or one in analysis.resolver.classes.bases(other)
    )


def _use(node: Node, statement: Node, analysis: Analysis) -> Use:
    parent = node.parent
    if parent is None:
        return Use.OTHER
    if parent.type in ("global_statement", "nonlocal_statement"):
        return Use.NOTHING
    if parent.type == "expression_statement":
        return Use.BARE
    if parent.type == "assignment":
        left = parent.child_by_field_name("left")
        if left is not None and left.id == node.id:
            right = parent.child_by_field_name("right")
            is_placeholder = right is None or right.type == "none"
            return Use.NOTHING if is_placeholder else Use.BINDING
    if parent.type in ("pattern_list", "tuple_pattern", "list_pattern"):
        return Use.BINDING
    if parent.type == "attribute" and _is_publish(node, parent, statement, analysis):
        return Use.PUBLISH
    return Use.OTHER


def _is_publish(node: Node, attribute: Node, statement: Node, analysis: Analysis) -> bool:
    name = attribute.child_by_field_name("attribute")
    call = attribute.parent
    return (
        name is not None
        and analysis.syntax.slice(name) == "publish"
        and call is not None
        and call.type == "call"
        and call.parent is not None
        and call.parent.type == "expression_statement"
        and call.parent.id == statement.id
        and call.parent.named_child_count == 1
        # An object that the file does not tell may be another instance.
        and variable_of(node, analysis) is not None
    )
