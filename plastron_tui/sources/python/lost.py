"""What goes with a call that an edit takes out, though somebody wrote it by hand."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Endpoint, EndpointKind, kind_of
from plastron_tui.model.source import Update

from .analysis import Analysis, Site
from .scopes import BindingKind

_QUEUES = {
    EndpointKind.PUBLISHER: ("queue_size", "qos_profile"),
    EndpointKind.SUBSCRIPTION: ("queue_size", "qos_profile"),
}


def options_of(analysis: Analysis, site: Site) -> list[str]:
    """Return what a call says besides name, type, callback, and a plain length of a queue."""
    shape, arguments = site.shape, site.arguments
    known = [shape.name, shape.type, shape.callback, shape.node]
    said = {
        node.id for each in known if each is not None and (node := arguments.get(each)) is not None
    }
    slice_ = analysis.syntax.slice
    found = [
        slice_(node)
        for node in arguments.positional
        if node.id not in said and node.type != "integer"
    ]
    queues = _QUEUES.get(site.endpoint.kind, ())
    found += [
        f"{name}={slice_(node)}"
        for name, node in arguments.keywords.items()
        if node.id not in said and not (name in queues and node.type in ("integer", "none"))
    ]
    if arguments.splat is not None:
        found.append(slice_(arguments.splat))
    return [" ".join(each.split()) for each in found]


def is_computed(analysis: Analysis, expression: Node) -> bool:
    """Whether an expression uses what the node works out, and not only types and constants."""
    pending = [expression]
    while pending:
        node = pending.pop()
        pending.extend(node.named_children)
        if node.type != "identifier":
            continue
        parent = node.parent
        if parent is not None and parent.type == "keyword_argument":
            name = parent.child_by_field_name("name")
            if name is not None and name.id == node.id:
                continue
        if parent is not None and parent.type == "attribute":
            attribute = parent.child_by_field_name("attribute")
            if attribute is not None and attribute.id == node.id:
                continue
        found = analysis.scopes.at(node.start_byte).lookup(analysis.syntax.slice(node))
        if found is not None and any(b.kind is not BindingKind.IMPORT for b in found[1]):
            return True
    return False


def written_anew(message: str, endpoint: Endpoint, old: str) -> Diagnostic:
    """Return the warning that something of an endpoint goes, and what keeps it."""
    help_ = f"{_renames(endpoint, old)} keeps it" if old != endpoint.name else None
    return Diagnostic(codes.WRITTEN_ANEW, message, endpoint.span, help=help_)


def or_renames(refusal: Diagnostic, change: Update) -> Diagnostic:
    """Let a refusal offer to change the name and nothing else, where that is what differs."""
    if refusal.code is not codes.ENDPOINT_IN_USE or change.name == change.endpoint.name:
        return refusal
    said = _renames(change.endpoint, change.name)
    return refusal._replace(help=f"{refusal.help}, or keep them: {said}")


def _renames(endpoint: Endpoint, old: str) -> str:
    noun = kind_of(type(endpoint)).facts.named
    return f"`renames {noun} '{old}' to '{endpoint.name}'`"
