"""Where a program names a topic, service, action or parameter, from its tree."""

from __future__ import annotations

import re
from collections.abc import Collection
from functools import cache
from typing import NamedTuple

from tree_sitter import Node, Query, QueryCursor

from plastron_tui.diagnostics import Span
from plastron_tui.language import Document
from plastron_tui.language.grammar import LANGUAGE

_WORDS = {
    "topic": "topic",
    "trigger": "topic",
    "service": "service",
    "action": "action",
    "parameter": "parameter",
}
"""The fields of the grammar that have such a name, and what it is the name of."""


class Name(NamedTuple):
    """A name that statements share.

    Attributes:
        what: `topic`, `service`, `action` or `parameter`.
        text: the name, without the slash that it may begin with.
        owner: the variable of the node whose name it is, "" where all nodes mean the same by it.
    """

    what: str
    text: str
    owner: str = ""

    def is_same(self, other: Name) -> bool:
        """Tell whether two names mean one thing; a message has parameters of no node yet."""
        is_same_node = self.owner == other.owner
        if self.what == "parameter":
            is_same_node = is_same_node or "" in (self.owner, other.owner)
        return self[:2] == other[:2] and is_same_node


@cache
def _loaded() -> Query:
    return Query(LANGUAGE, "(load_statement variable: (variable) @loaded)")


def name_at(document: Document, offset: int) -> Name | None:
    """Return the name at an offset, None where none is."""
    node = _node_at(document, offset, "ros_name")
    return None if node is None else _name_of(node)


def function_at(document: Document, offset: int) -> str | None:
    """Return the function that is named at an offset, None where none is."""
    node = _node_at(document, offset, "function")
    return None if node is None else _text(node)


def same_words(document: Document, offset: int, kind: str) -> tuple[str, tuple[Span, ...]] | None:
    """Return the function or the type at an offset, and where the same stands; None for none.

    A function is that of one node; another node's of that name is another one.

    Args:
        document: the program.
        offset: the place.
        kind: `function` or `type`, as the grammar has it.
    """
    node = _node_around(document, offset, kind)
    if node is None:
        return None
    owner = _owner(node) if kind == "function" else ""
    found = QueryCursor(_all_of(kind)).captures(document.tree.root_node).get("found", [])
    same = [each for each in found if each.text == node.text]
    own = (each for each in same if kind != "function" or _owner(each) == owner)
    places = sorted(Span(*each.byte_range) for each in own)
    return _text(node), tuple(places)


@cache
def _all_of(kind: str) -> Query:
    return Query(LANGUAGE, f"({kind}) @found")


def _node_around(document: Document, offset: int, type_: str) -> Node | None:
    """Return the node of a type that a word at an offset is, or is a part of."""
    root = document.tree.root_node
    for start, end in ((offset, offset + 1), (offset - 1, offset)):
        node = root.descendant_for_byte_range(start, end) if start >= 0 else None
        while node is not None and node.type != type_:
            node = node.parent
        if node is not None:
            return node
    return None


def is_file_at(document: Document, offset: int) -> bool:
    """Tell whether the file that a node is loaded from is named at an offset."""
    found = (_node_at(document, offset, each) for each in ("path", "module"))
    return any(each is not None and _is_of_load(each) for each in found)


def _is_of_load(node: Node) -> bool:
    return node.parent is not None and node.parent.type == "load_statement"


def uses_of(document: Document, name: Name, loaded: Collection[str] = ()) -> list[Span]:
    """Return where the program names something, in its order.

    Args:
        document: the program.
        name: the name.
        loaded: the variables of nodes that have it from their files: the statements that load
            these are uses too.
    """
    root = document.tree.root_node
    uses = []
    for match in re.finditer(b"'/?%b'" % re.escape(name.text.encode()), document.text):
        node = root.descendant_for_byte_range(*match.span())
        if node is not None and node.type == "ros_name":
            found = _name_of(node)
            if found is not None and name.is_same(found):
                uses.append(Span(*match.span()))
    if loaded:
        nodes = QueryCursor(_loaded()).captures(root).get("loaded", [])
        uses += [Span(*each.byte_range) for each in nodes if _text(each) in loaded]
    return sorted(uses)


def next_use(uses: list[Span], offset: int) -> Span | None:
    """Return the first use behind the one at an offset, after the last one the first."""
    here = [each for each in uses if each.start <= offset <= each.end]
    others = [each for each in uses if each not in here]
    return next((each for each in others if each.start > offset), others[0] if others else None)


def _name_of(node: Node) -> Name | None:
    """Return the name that a node of the tree has, None for that of something else."""
    parent = node.parent
    if parent is None:
        return None
    text = _text(node).strip("'").removeprefix("/")
    if parent.type == "parameter":
        return Name("parameter", text, _owner(parent))
    if parent.type == "rename_statement":
        what = parent.child_by_field_name("what")
        return None if what is None else _owned(_text(what), text, node)
    fields = (word for field, word in _WORDS.items() if parent.child_by_field_name(field) == node)
    what_word = next(fields, None)
    return None if what_word is None else _owned(what_word, text, node)


def _owned(what: str, text: str, node: Node) -> Name:
    is_private = what == "parameter" or text.startswith("~")
    return Name(what, text, _owner(node) if is_private else "")


def _owner(node: Node) -> str:
    """Return the variable of the node that a statement is about, "" where it is about none."""
    around: Node | None = node
    while around is not None:
        variable = around.child_by_field_name("node")
        if variable is not None:
            return _text(variable)
        around = around.parent
    return ""


def _node_at(document: Document, offset: int, type_: str) -> Node | None:
    root = document.tree.root_node
    for start, end in ((offset, offset + 1), (offset - 1, offset)):
        node = root.descendant_for_byte_range(start, end) if start >= 0 else None
        if node is not None and node.type == type_:
            return node
    return None


def _text(node: Node) -> str:
    return (node.text or b"").decode("utf-8", "replace")
