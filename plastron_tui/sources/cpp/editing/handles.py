"""The node handles of ROS 1 that are seen at a place, and which of them names an endpoint."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..analysis import Analysis
from ..node_sites import is_nodelet
from ..receivers import HANDLE, joined
from ..scopes import Scope, last_name
from .place import Place


def handle_for(
    analysis: Analysis, place: Place, name: str, *, in_method: bool = False
) -> tuple[str, str]:
    """Return what stands before a method of a node handle of ROS 1, and the name it is given.

    That of the call beside which the endpoint goes, where its namespace fits; else another one
    that is seen there; else one made for it alone.

    Args:
        analysis: what is known of the files.
        place: where it is.
        name: the name, as it is known in the node's namespace.
        in_method: whether another method of the class is to see the handle too.
    """
    found: list[tuple[str, str]] = []
    beside = place.beside
    is_handle = beside is not None and beside.shape.on == "handle" and not in_method
    if beside is not None and is_handle and beside.call.receiver is not None:
        call = beside.call
        assert call.name_node is not None and call.receiver is not None
        text = beside.file.syntax.between(call.receiver.start_byte, call.name_node.start_byte)
        prefix = analysis.receivers.prefix(call.receiver, call.scope)
        if prefix.text is not None and text.rstrip("->.").strip() not in _queued(analysis):
            found.append((text.removesuffix("template ").strip(), prefix.text))
    found += _handles(analysis, place, in_method=in_method)
    for text, prefix_text in found:
        own = _relative(name, prefix_text)
        if own is not None:
            return text, own
    if is_nodelet_place(analysis, place):
        getter = "getPrivateNodeHandle()" if name.startswith("~") else "getNodeHandle()"
        return f"{getter}.", name.removeprefix("~").lstrip("/") if name[0] == "~" else name
    if name.startswith("~"):
        return 'ros::NodeHandle("~").', name[1:].lstrip("/")
    return "ros::NodeHandle().", name


def is_constant(analysis: Analysis, place: Place, handle: str) -> bool:
    """Tell whether a node handle, as it stands before a method, may not be changed."""
    name = handle.removesuffix("->").removesuffix(".").removeprefix("this->")
    variable = analysis.unit.lookup(name, place.scope, place.offset)
    if variable is None:
        return False
    declared = variable.file.syntax.slice(variable.node)
    return re.match(r"(?:static\s+)?const\b|[\w:]+\s+const\b", declared) is not None


def _queued(analysis: Analysis) -> set[str]:
    """Return the names of the handles that have a queue of their own."""
    calls = analysis.unit.calls.get("setCallbackQueue", ())
    return {last_name(each.receiver, each.scope) for each in calls if each.receiver is not None}


def is_nodelet_place(analysis: Analysis, place: Place) -> bool:
    """Tell whether a place is in the class of a nodelet."""
    return place.owner is not None and is_nodelet(analysis, place.owner)


def _relative(name: str, prefix: str) -> str | None:
    """Return a name as a handle of a namespace is given it, None where it cannot be."""
    if name.startswith("/"):
        return name
    if not prefix:
        return None if name.startswith("~") else name
    own = name.removeprefix(f"{prefix.rstrip('/')}/")
    return own if own != name and joined(prefix, own) == name else None


def _handles(analysis: Analysis, place: Place, *, in_method: bool) -> Iterator[tuple[str, str]]:
    """Yield the node handles that are seen at a place, each with its namespace."""
    seen: set[str] = set()
    scopes: list[Scope] = list(place.scope.chain)
    if place.owner is not None:
        scopes += analysis.unit.bases(place.owner)
    for scope in scopes:
        for name, variables in scope.variables.items():
            variable = variables[0]
            if name in seen or analysis.receivers.type_of_variable(variable) != HANDLE:
                continue
            is_local = variable.kind in ("local", "parameter", "loop")
            if is_local and (in_method or variable.start > place.offset):
                continue
            seen.add(name)
            if name in _queued(analysis):
                continue
            if variable.declarator is None or variable.is_list:
                continue
            prefix = analysis.receivers.prefix(variable.declarator, variable.scope)
            if prefix.text is None:
                continue
            written = variable.type
            is_pointer = variable.is_pointer or "Ptr" in written or "ptr<" in written
            yield f"{name}{'->' if is_pointer else '.'}", prefix.text
