"""The classes of other files that the nodes of a file derive from, where all of them are read."""

from __future__ import annotations

from collections.abc import Container, Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.scopes import Scope

_MOST_CLASSES = 32
_PLAIN = frozenset({"abc", "enum", "typing"})
"""Modules whose classes do nothing with what derives from them."""


class Base(NamedTuple):
    """A class, and the file that has it, with the call sites of that."""

    file: Analysis
    owner: Scope


def read_bases(
    analysis: Analysis, owner: Scope | None = None, plain: Container[str] = _PLAIN
) -> tuple[Base, ...] | None:
    """Return the classes of other files that the nodes of a file derive from, directly or not.

    None where one of them, up to those of the client library, is not read.

    Args:
        analysis: the file.
        owner: the class of one of its nodes, None for those of all.
        plain: modules whose classes do nothing that is asked about.
    """
    found: dict[Scope, Base] = {}
    owners = [each.owner for each in analysis.nodes] if owner is None else [owner]
    pending = [Base(analysis, each) for each in owners if each is not None]
    seen: set[Scope] = set()
    while pending:
        file, owner = pending.pop()
        if owner in seen:
            continue
        seen.add(owner)
        others = list(_others(file, owner, plain))
        if any(each is None for each in others) or len(seen) > _MOST_CLASSES:
            return None
        for each in others:
            if each is not None:
                found[each.owner] = each
                pending.append(each)
    return tuple(found.values())


def _others(file: Analysis, owner: Scope, plain: Container[str]) -> Iterator[Base | None]:
    """Yield the classes of other files that a class derives from, None for what is not read."""
    known = file.library.node_classes
    for each in (owner, *file.resolver.classes.bases(owner)):
        for base in each.bases:
            names = file.resolver.qualified(base, each.parent or each)
            if any(name in known for name in names) or _is_own(file, base):
                continue
            if names and all(name.partition(".")[0] in plain for name in names):
                continue
            if not names and file.syntax.slice(base) == "object":
                continue
            yield _held(file, names)


def _held(file: Analysis, names: tuple[str, ...]) -> Base | None:
    package = file.package
    if package is None or len(names) != 1:
        return None
    held = package.class_(names[0])
    module = None if held is None else package.complete(held[0])
    return None if held is None or module is None or module.syntax.errors else Base(module, held[1])


def _is_own(file: Analysis, base: Node) -> bool:
    """Tell whether a base is a class of the file."""
    name = file.syntax.slice(base)
    return any(scope.name == name for scope in file.scopes.classes())
