"""The parameters of `declare_parameters("namespace", {{"a", 1}, {"b", 2}})`."""

from __future__ import annotations

from tree_sitter import Node

from .scopes import Scope

MOST_LISTED = 400


def listed_parameters(arguments: list[Node], scope: Scope) -> list[tuple[Node | None, str]]:
    """Return what names each parameter of a list, with its source; one unknown for no list."""
    syntax = scope.file.syntax
    listed = arguments[1] if len(arguments) > 1 else None
    if listed is not None and listed.type in ("compound_literal_expression",):
        listed = listed.child_by_field_name("value")
    if listed is None or listed.type != "initializer_list":
        return [(None, syntax.slice(listed) if listed is not None else "")]
    found: list[tuple[Node | None, str]] = []
    for item in listed.named_children[:MOST_LISTED]:
        name = item.named_children[0] if item.named_child_count else item
        if item.type == "string_literal":
            name = item
        found.append((name, syntax.slice(name)))
    return found


def value_of(arguments: list[Node], name: Node | None) -> Node | None:
    """Return what stands behind a name in the list."""
    if name is None:
        return None
    item = name.parent
    if item is None or item.type != "initializer_list" or item.named_child_count < 2:
        return None
    return item.named_children[1]
