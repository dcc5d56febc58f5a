"""What is left in a file of the client library that it came from."""

from __future__ import annotations

from collections.abc import Mapping

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python.conventions import target_name

from .port_state import IMPORTS, Work, is_imported, is_inner, walk

_OF_TIMERS = frozenset({"cancel", "reset", "is_canceled", "time_until_next_call"})


def mark_leftovers(
    work: Work,
    roots: frozenset[str],
    attributes: Mapping[str, str],
    remedies: Mapping[str, str],
) -> None:
    """Mark every use of a module of the old ROS, and every attribute that only it has.

    Args:
        work: the file.
        roots: the modules of the old ROS.
        attributes: what the attributes are of, or are called in the new ROS.
        remedies: what to write for qualified names.
    """
    done = set(work.done)
    for node in walk(work.analysis.syntax.root):
        if node.type in IMPORTS:
            _mark_import(work, node, roots, remedies)
        if node.type not in ("identifier", "attribute") or is_inner(node) or work.is_gone(node):
            continue
        if _is_done(node, done) or is_imported(node):
            continue
        names = [name for name in _names(work, node) if name.partition(".")[0] in roots]
        if names:
            work.mark(node, ".".join(names[0].split(".")[:3]), _remedy(names[0], remedies))
        elif node.type == "attribute":
            _mark_attribute(work, node, attributes)


def port_ending(work: Work, renamed: Mapping[str, str], remedies: Mapping[str, str]) -> None:
    """Rewrite or mark what ends an endpoint: `cancel` of a timer, `shutdown` of a service.

    What a callback ends is marked, where the file does not show that it is a timer.

    Args:
        work: the file.
        renamed: the methods of a timer that the other library has by another name.
        remedies: the methods that the other library lacks, and what to write instead.
    """
    held = {
        name.rpartition(".")[2]: site.endpoint.kind
        for site in work.analysis.sites
        if (name := target_name(work.analysis, site)) is not None
    }
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        part = callee.child_by_field_name("attribute") if callee is not None else None
        holder = callee.child_by_field_name("object") if callee is not None else None
        if callee is None or part is None or holder is None or work.is_gone(call):
            continue
        if call.id in work.done:
            continue
        method, name = work.slice(part), work.slice(holder).rpartition(".")[2]
        kind = held.get(name, EndpointKind.TIMER if "timer" in name.lower() else None)
        is_timer = kind is EndpointKind.TIMER
        is_own = name in held or not work.is_in_callback(call)
        if is_timer and method in renamed and is_own:
            work.replace(part, renamed[method])
        elif kind is not None and (is_timer or method not in _OF_TIMERS) and method in remedies:
            work.mark(callee, f".{method}", remedies[method])


def _names(work: Work, node: Node) -> tuple[str, ...]:
    """Return what a name stands for; one that the file does not bind may be the module."""
    first = work.slice(node).partition(".")[0]
    is_bound = work.scope(node).lookup(first) is not None
    return work.qualified(node) or (() if is_bound else (work.slice(node),))


def _mark_import(
    work: Work, node: Node, roots: frozenset[str], remedies: Mapping[str, str]
) -> None:
    """Mark the import of a package that goes with the old ROS, and stays in the file."""
    # `import tf, rospy` loses a name alone.
    is_rest = node.type == "import_statement" and work.is_rewritten(node)
    if work.is_gone(node) or (node.id in work.done and not is_rest):
        return
    module = node.child_by_field_name("module_name")
    parts = [module] if module is not None else node.children_by_field_name("name")
    for part in parts:
        name = part.child_by_field_name("name") or part
        is_left = work.slice(name).partition(".")[0] in roots
        if is_left and (not is_rest or work.is_written(name)):
            work.mark(node, work.slice(name), _remedy(work.slice(name), remedies))


def _mark_attribute(work: Work, node: Node, attributes: Mapping[str, str]) -> None:
    current: Node | None = node
    while current is not None and current.type == "attribute":
        part = current.child_by_field_name("attribute")
        name = work.slice(part) if part is not None else ""
        is_own = work.analysis.resolver.attribute_bindings(current, work.scope(current))
        if name in attributes and part is not None and part.id not in work.done and not is_own:
            work.mark(node, f".{name}", attributes[name])
        current = current.child_by_field_name("object")


def _remedy(name: str, remedies: Mapping[str, str]) -> str | None:
    found = [remedy for start, remedy in remedies.items() if (name + ".").startswith(start + ".")]
    return found[0] if found else None


def _is_done(node: Node, done: set[int]) -> bool:
    parent = node.parent
    return node.id in done or (
        parent is not None
        and parent.type == "call"
        and parent.id in done
        and (callee := parent.child_by_field_name("function")) is not None
        and callee.id == node.id
    )
