"""What a file does with its endpoints: which of them an expression holds."""

from __future__ import annotations

from collections.abc import Container, Iterator

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python.analysis import Site
from plastron_tui.sources.python.constants import without_none
from plastron_tui.sources.python.references import statement_of
from plastron_tui.sources.python.scopes import BindingKind

from .port_state import Work, walk
from .rclpy_node import has_node

_DESTROYED = {
    (EndpointKind.PUBLISHER, "unregister"): "destroy_publisher",
    (EndpointKind.SUBSCRIPTION, "unregister"): "destroy_subscription",
    (EndpointKind.SERVICE, "shutdown"): "destroy_service",
}
_COUNT = "get_num_connections"
_COUNTS = {
    EndpointKind.PUBLISHER: "get_subscription_count",
    EndpointKind.SUBSCRIPTION: "get_publisher_count",
}


def sites_of(work: Work, holder: Node) -> list[Site]:
    """Return the calls that make what an expression holds, none where it may be another thing."""
    values = [each.value for each in without_none(work.bindings(holder))]
    ids = {each.id for each in ([holder] if holder.type == "call" else values) if each is not None}
    sites = [each for each in work.analysis.sites if each.call.id in ids]
    return sites if None not in values and len(sites) == len(ids) else []


def site_of(work: Work, holder: Node, kind: EndpointKind) -> Site | None:
    """Return a call that makes the endpoint of an expression; others make one of the same type."""
    sites = sites_of(work, holder)
    if not sites or len({each.endpoint.type for each in sites}) > 1:
        return None
    return sites[0] if all(each.endpoint.kind is kind for each in sites) else None


def visible_type(work: Work, site: Site, at: Node) -> str | None:
    """Return what a place calls the type of an endpoint, None where it may not see it."""
    given = site.arguments.get(site.shape.type) if site.shape.type is not None else None
    if given is None or given.type not in ("identifier", "attribute"):
        return None
    names = work.analysis.resolver.qualified(given, site.scope)
    if not names or names != work.analysis.resolver.qualified(given, work.scope(at)):
        return None
    first = given
    while first.type == "attribute" and first.named_children:
        first = first.named_children[0]
    found = work.scope(at).lookup(work.slice(first))
    is_import = found is None or all(each.kind is BindingKind.IMPORT for each in found[1])
    return work.slice(given) if is_import else None


def destroys_endpoints(work: Work) -> bool:
    """Tell whether the file ends an endpoint for good while others go on."""
    return any(method != _COUNT for _, _, method, _ in _methods(work))


def port_endpoint_methods(work: Work, node: str) -> None:
    """Rewrite what ends an endpoint for good, and what counts those at its other end."""
    for call, holder, method, kind in _methods(work):
        callee = call.child_by_field_name("function")
        part = callee.child_by_field_name("attribute") if callee is not None else None
        assert part is not None
        work.done.update((part.id, call.id))
        if method == _COUNT:
            work.replace(part, _COUNTS[kind])
        else:
            work.replace(call, f"{node}.{_DESTROYED[kind, method]}({work.slice(holder)})")


_SAME = {
    EndpointKind.PUBLISHER: {"publish"},
    EndpointKind.SUBSCRIPTION: {"registerCallback"},
    EndpointKind.CLIENT: {"call", "wait_for_service"},
    EndpointKind.SERVICE: set[str](),
    EndpointKind.TIMER: set[str](),
}


def mark_endpoint_attributes(work: Work, known: Container[str]) -> None:
    """Mark what is asked of an endpoint that the other library's class has not.

    Args:
        work: the file.
        known: the attributes that are marked wherever they stand.
    """
    for node in walk(work.analysis.syntax.root):
        part = node.child_by_field_name("attribute") if node.type == "attribute" else None
        holder = node.child_by_field_name("object")
        if part is None or holder is None or work.is_gone(node) or part.id in work.done:
            continue
        name = work.slice(part)
        is_call = node.parent is not None and node.parent.id in work.done
        if node.id in work.done or is_call or name in known:
            continue
        kinds = {
            site.endpoint.kind for site in sites_of(work, holder) if not site.shape.gives_message
        }
        for kind in kinds:
            if name not in _SAME.get(kind, {name}):
                version = work.catalog.ros_version
                work.mark(node, f".{name}", f"the {kind.value} of ROS {version} have no `{name}`")


def _methods(work: Work) -> Iterator[tuple[Node, Node, str, EndpointKind]]:
    """Yield the calls of methods that end or count, what they are of, and the kind of that."""
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        part = callee.child_by_field_name("attribute") if callee is not None else None
        holder = callee.child_by_field_name("object") if callee is not None else None
        if part is None or holder is None or work.is_gone(call):
            continue
        method = work.slice(part)
        if method != _COUNT and all(method != ending for _, ending in _DESTROYED):
            continue
        kinds = {site.endpoint.kind for site in sites_of(work, holder)}
        if len(kinds) != 1 or not has_node(work, call):
            continue
        [kind] = kinds
        is_statement = statement_of(call).named_children == [call]
        is_count = method == _COUNT and kind in _COUNTS
        if is_count or (is_statement and (kind, method) in _DESTROYED):
            yield call, holder, method, kind
