"""Which members of classes may be named where."""

from __future__ import annotations

from tree_sitter import Node

from ..analysis import Analysis
from ..scopes import Scope, Variable


def sees_member(analysis: Analysis, owner: Scope | None, variable: Variable) -> bool:
    """Tell whether what is written in a class, or in none, may name a member of the files."""
    if owner is None or owner is variable.scope:
        return owner is not None
    is_inherited = any(each is variable.scope for each in analysis.unit.bases(owner))
    return is_inherited and access_of(variable.scope, variable.node) != "private"


def access_of(owner: Scope, node: Node) -> str:
    """Return who may name a member: `public`, `protected` or `private`."""
    body = owner.node.child_by_field_name("body")
    found = "public" if owner.node.type == "struct_specifier" else "private"
    for each in body.named_children if body is not None else ():
        if each.type == "access_specifier" and each.start_byte < node.start_byte:
            found = owner.file.syntax.word(each).strip()
    return found
