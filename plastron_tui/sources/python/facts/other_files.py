"""Functions of other files that a file calls: methods of its base classes, and what it imports."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.analysis import Analysis
from plastron_tui.sources.python.scopes import Binding, BindingKind, Scope

from .message_values import MessageValues

_MOST_DEEP = 4


def function_elsewhere(messages: MessageValues, callee: Node) -> tuple[Analysis, Scope] | None:
    """Return the function of another file that a call runs, and that file; None where not sure."""
    package = messages.analysis.package
    if package is None:
        return None
    if callee.type == "attribute" and (held := _method(messages, callee)) is not None:
        return held
    names = messages.analysis.resolver.qualified(callee, messages.scope(callee))
    bound = package.bound(names[0]) if len(names) == 1 else None
    return None if bound is None else _one(*bound)


def _method(messages: MessageValues, callee: Node) -> tuple[Analysis, Scope] | None:
    """Return the method of a base class in another file that `self.method` names."""
    holder, name_node = (callee.child_by_field_name(each) for each in ("object", "attribute"))
    owner = None if holder is None else messages.object_class(holder)
    if owner is None or name_node is None:
        return None
    name = messages.analysis.syntax.slice(name_node)
    file: Analysis = messages.analysis
    # A class that derives from this one may have a method of its own.
    classes = [*file.resolver.classes.derived(owner), owner]
    for _ in range(_MOST_DEEP):
        for each in (*classes, *file.resolver.classes.bases(classes[-1])):
            if name in each.attributes:
                return None
            if each.bindings.get(name):
                return None if file is messages.analysis else _one(file, each.bindings[name])
        package = file.package
        names = file.resolver.foreign_bases(classes[-1])
        known = [] if package is None else [package.class_(each) for each in names]
        held = [each for each in known if each is not None]
        if len(held) != 1 or package is None:
            return None
        file, classes = package.complete(held[0][0]), [held[0][1]]
    return None


def _one(file: Analysis, bindings: list[Binding]) -> tuple[Analysis, Scope] | None:
    is_one = len(bindings) == 1 and bindings[0].kind is BindingKind.FUNCTION
    function = bindings[0].owner if is_one else None
    return None if function is None or file.syntax.errors else (file, function)
