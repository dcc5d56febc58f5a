"""The methods of a node that ROS calls as a base class of another file hands them over."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.base_classes import inherited_sites
from plastron_tui.sources.python.scopes import BindingKind, Scope

from .called_back import COUNTS, CalledBack, is_certain, with_arguments
from .unconditional import runs_each_time


def inherited_callbacks(analysis: Analysis) -> Iterator[CalledBack]:
    """Yield the methods of the file that stand for what a base class hands over as `self.method`.

    Where the base has that method, too, it is the one of the node that is called.
    """
    counts = COUNTS[analysis.library.module]
    found: set[tuple[Scope, int]] = set()
    owners = dict.fromkeys(each.owner for each in analysis.nodes if each.owner is not None)
    for owner in owners:
        for file, site in inherited_sites(analysis, owner):
            kind, callback = site.endpoint.kind, site.shape.callback
            if callback is None or kind not in counts or not is_certain(site, file):
                continue
            if not _is_always_created(site, file, analysis):
                continue
            name = _method(site.arguments.get(callback), site, file)
            function = None if name is None else _own(name, owner, analysis)
            at = None if function is None else function.node.child_by_field_name("name")
            if function is None or at is None or (function, site.call.id) in found:
                continue
            found.add((function, site.call.id))
            given = with_arguments(site, counts[kind])
            scope = function.parent or owner
            yield CalledBack(kind, at, scope, function, given, site, is_inherited=True)


def _is_always_created(site: Site, file: Analysis, analysis: Analysis) -> bool:
    """Tell whether each node of a base has an endpoint, not only those that ask for it."""
    method = site.scope.enclosing("function")
    if method is None or not runs_each_time(site.call, method.node):
        return False
    called = re.compile(rb"self\.%s\(" % re.escape(file.syntax.encode(method.name)))
    texts = (file.syntax.text, analysis.syntax.text)
    return method.name == "__init__" or any(called.search(text) for text in texts)


def _method(value: Node | None, site: Site, file: Analysis) -> str | None:
    """Return the name in `self.name`, None for any other value."""
    method = site.scope.enclosing("function")
    if value is None or value.type != "attribute" or method is None:
        return None
    holder = value.child_by_field_name("object")
    if holder is None or file.syntax.slice(holder) != method.self_name:
        return None
    return file.syntax.slice(value.child_by_field_name("attribute") or value)


def _own(name: str, owner: Scope, analysis: Analysis) -> Scope | None:
    """Return the method of a class that the file defines, where it is sure to be this one."""
    for each in (owner, *analysis.resolver.classes.bases(owner)):
        if name in each.attributes:
            return None
        bindings = each.bindings.get(name, [])
        if bindings:
            is_one = len(bindings) == 1 and bindings[0].kind is BindingKind.FUNCTION
            return bindings[0].owner if is_one else None
    return None
