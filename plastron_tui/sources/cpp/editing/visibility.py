"""What may be named where: the members of classes, and the variables of functions."""

from __future__ import annotations

from tree_sitter import Node

from ..analysis import Analysis
from ..scopes import Scope, Variable
from .place import Place


def sees(analysis: Analysis, place: Place, variable: Variable) -> bool:
    """Tell whether what is written at a place may name a variable of the files."""
    if variable.kind == "global":
        return True
    if variable.kind != "member":
        return analysis.unit.lookup(variable.name, place.scope, place.offset) is variable
    if place.owner is None or place.owner is variable.scope:
        return place.owner is not None
    is_inherited = any(each is variable.scope for each in analysis.unit.bases(place.owner))
    return is_inherited and access_of(variable.scope, variable.node) != "private"


def access_of(owner: Scope, node: Node) -> str:
    """Return who may name a member: `public`, `protected` or `private`."""
    body = owner.node.child_by_field_name("body")
    found = "public" if owner.node.type == "struct_specifier" else "private"
    for each in body.named_children if body is not None else ():
        if each.type == "access_specifier" and each.start_byte < node.start_byte:
            found = owner.file.syntax.word(each).strip()
    return found
