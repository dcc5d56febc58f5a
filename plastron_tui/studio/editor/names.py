"""Where the variables of a program are, from its tree."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from tree_sitter import Node, Query, QueryCursor

from plastron_tui.diagnostics import Span
from plastron_tui.language import Document
from plastron_tui.language.grammar import LANGUAGE
from plastron_tui.language.keywords import KEYWORDS

_DEFINING = frozenset(
    {
        *("create_node_statement", "load_statement", "create_message_statement"),
        *("create_package_statement", "load_package_statement"),
        *("create_launch_statement", "load_launch_statement", "load_type_statement"),
        *("create_robot_statement", "load_robot_statement"),
    }
)
_DEFINING_TYPES = frozenset(
    {
        *("create_message_type_statement", "create_service_type_statement"),
        "create_action_type_statement",
    }
)


class Variable(NamedTuple):
    """A variable: its name, where it is defined, and all the places where it stands."""

    name: str
    definition: Span | None
    places: tuple[Span, ...]


@cache
def _variables() -> Query:
    return Query(LANGUAGE, "(variable) @variable (type !package name: (_) @type)")


def variable_at(document: Document, offset: int) -> Variable | None:
    """Return the variable at an offset, None where there is none."""
    root = document.tree.root_node
    node = next(
        (
            found
            for start, end in ((offset, offset + 1), (offset - 1, offset))
            if start >= 0
            and (found := root.descendant_for_byte_range(start, end)) is not None
            and (found.type == "variable" or _is_type(found))
        ),
        None,
    )
    if node is None:
        return None
    text = document.text
    name = text[node.start_byte : node.end_byte]
    captures = QueryCursor(_variables()).captures(root)
    places, types = (
        [
            place
            for place in captures.get(kind, [])
            if text[place.start_byte : place.end_byte] == name
        ]
        for kind in ("variable", "type")
    )
    # A type of ROS may be called as a variable is: only one of the program's own is meant.
    if any(_defines_type(place) for place in (*places, *types)):
        places += types
    elif node.type != "variable":
        return None
    places.sort(key=lambda place: place.start_byte)
    definition = next(
        (_span(place) for place in places if _defines(place) or _defines_type(place)), None
    )
    return Variable(name.decode("utf-8"), definition, tuple(map(_span, places)))


def _span(node: Node) -> Span:
    return Span(node.start_byte, node.end_byte)


def _defines(node: Node) -> bool:
    parent = node.parent
    if parent is None or parent.type not in _DEFINING:
        return False
    defined = parent.child_by_field_name("variable")
    return defined is not None and defined.start_byte == node.start_byte


def _is_type(node: Node) -> bool:
    """Tell whether a node is the name of a type that is written without its package."""
    parent = node.parent
    return (
        parent is not None
        and parent.type == "type"
        and parent.child_by_field_name("package") is None
    )


def _defines_type(node: Node) -> bool:
    """Tell whether a node gives a type of the program its name."""
    parent = node.parent
    if node.type == "variable":
        return parent is not None and parent.type == "load_type_statement"
    around = None if parent is None else parent.parent
    return around is not None and around.type in _DEFINING_TYPES and _is_type(node)


def wrong_name(document: Document, name: str) -> str | None:
    """Return why a name cannot be that of a variable, None when it can."""
    if not (name.isascii() and name.isidentifier() and name[0].isalpha()):
        return f"`{name}` is no variable: it has letters, digits and `_`, a letter first"
    if name in KEYWORDS:
        return f"`{name}` is a keyword and cannot be a variable"
    text, written = document.text, name.encode()
    root = document.tree.root_node
    if written in text and any(
        text[place.start_byte : place.end_byte] == written
        for place in QueryCursor(_variables()).captures(root).get("variable", [])
    ):
        return f"`{name}` is a variable already"
    return None
