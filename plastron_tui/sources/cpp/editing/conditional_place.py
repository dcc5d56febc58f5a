"""Where what is added goes so that no conditional of the preprocessor switches it off."""

from __future__ import annotations

import re
from collections.abc import Sequence

from tree_sitter import Node

from ..scopes import CppFile

_BODIES = frozenset({"compound_statement", "field_declaration_list"})
_WORD = re.compile(r"[A-Za-z_]\w*")


def end_of_conditional(file: CppFile, node: Node, lines: Sequence[str]) -> int | None:
    """Return where the outermost conditional ends that a node of a body stands in.

    None where it stands in none, or where a conditional begins outside of the body as well, or
    declares what the lines say, which would not be seen behind it.
    """
    outer = node.parent
    if outer is None or not (outer.type in _BODIES or _is_of_class(node)):
        return None
    around = [
        (start, end)
        for start, end in file.syntax.conditionals
        if outer.start_byte < start < node.start_byte and node.end_byte <= end <= outer.end_byte
    ]
    if not around:
        return None
    start, end = max(around, key=lambda each: each[1] - each[0])
    inner = [each for each in outer.named_children if start < each.start_byte < end]
    said = set(_WORD.findall("\n".join(lines)))
    return None if said & set(_declared(file, inner)) else end


def _is_of_class(node: Node) -> bool:
    """Tell whether a definition is that of a method, outside of its class."""
    head = node.child_by_field_name("declarator")
    while head is not None and head.type != "qualified_identifier":
        head = head.child_by_field_name("declarator")
    return node.type == "function_definition" and head is not None


def _declared(file: CppFile, statements: Sequence[Node]) -> list[str]:
    """Return the names of local variables that statements declare."""
    found = []
    for statement in statements:
        if statement.type != "declaration":
            continue
        for each in statement.children_by_field_name("declarator"):
            name = _WORD.search(file.syntax.word(each))
            found += [name[0]] if name is not None else []
    return found
