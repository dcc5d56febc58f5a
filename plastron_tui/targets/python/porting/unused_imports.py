"""Imports of a ported file that nothing of it uses any more."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.sources.python.splices import Splice, apply, delete_item, delete_statements
from plastron_tui.sources.python.syntax import Syntax, parse

from .port_state import IMPORTS, walk


@dataclass(frozen=True, slots=True)
class _Import:
    """A name that an import binds.

    Attributes:
        item: what binds it.
        module: the module that it is of, or that it is.
        name: the name.
        path: how the file gets at a module that is imported whole, the name otherwise.
    """

    item: Node
    module: str
    name: str
    path: str


def without_unused(text: bytes, roots: Iterable[str], freed: Iterable[str]) -> bytes:
    """Take away imports that nothing uses.

    Args:
        text: the ported file.
        roots: the modules of the client library that it comes from.
        freed: names that the file used, and that the port wrote otherwise.
    """
    syntax = parse(text)
    gone_roots, gone_names = frozenset(roots), frozenset(freed)
    statements = [node for node in walk(syntax.root) if node.type in IMPORTS]
    names, paths = _used(syntax)
    dead: list[Node] = []
    splices: list[Splice] = []
    is_more = False
    for statement in statements:
        bound = list(_bound(syntax, statement))
        unused = [
            each
            for each in bound
            if (each.module.partition(".")[0] in gone_roots or each.name in gone_names)
            and each.path not in (paths if "." in each.path else names)
        ]
        if unused and len(unused) == len(bound):
            dead.append(statement)
        elif unused:
            items = [each.item for each in bound]
            splices.append(delete_item(text, items, unused[0].item))
            is_more |= len(unused) > 1
    made = apply(text, [*splices, *delete_statements(text, dead)])
    # What stands between two items is known when the one before is gone.
    return without_unused(made, gone_roots, gone_names) if is_more else made


def _bound(syntax: Syntax, statement: Node) -> Iterable[_Import]:
    module = statement.child_by_field_name("module_name")
    for item in statement.children_by_field_name("name"):
        alias, name = item.child_by_field_name("alias"), item.child_by_field_name("name") or item
        written = syntax.slice(name)
        if module is not None:
            used = syntax.slice(alias or name)
            yield _Import(item, syntax.slice(module), used, used)
        else:
            used = syntax.slice(alias) if alias is not None else written
            yield _Import(item, written, used.partition(".")[0], used)


def _used(syntax: Syntax) -> tuple[set[str], set[str]]:
    """Return the names that a file uses outside of its imports, and the dotted ones."""
    names: set[str] = set()
    paths: set[str] = set()
    pending = [syntax.root]
    while pending:
        node = pending.pop()
        if node.type in IMPORTS:
            continue
        if node.type == "identifier":
            names.add(syntax.slice(node))
        elif node.type == "attribute":
            paths.add(syntax.slice(node))
        part = {"attribute": "attribute", "keyword_argument": "name"}.get(node.type, "")
        unbound = node.child_by_field_name(part) if part else None
        pending += [each for each in node.named_children if each != unbound]
    return names, paths
