"""What goes with a call that an edit takes out, though somebody wrote it by hand."""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.sources.written_anew import Said

from .analysis import Analysis, Site
from .references import is_member
from .scopes import BindingKind


def said_by(analysis: Analysis) -> Iterator[Said]:
    """Yield each endpoint of a file, and what its call says besides name, type and callback."""
    for site in analysis.sites:
        yield site.endpoint, options_of(analysis, site)


def options_of(analysis: Analysis, site: Site) -> list[str]:
    """Return what a call says besides name, type and callback."""
    shape, arguments = site.shape, site.arguments
    known = [shape.name, shape.type, shape.callback, shape.node]
    said = {
        node.id for each in known if each is not None and (node := arguments.get(each)) is not None
    }
    slice_ = analysis.syntax.slice
    found = [slice_(node) for node in arguments.positional if node.id not in said]
    found += [
        f"{name}={slice_(node)}"
        for name, node in arguments.keywords.items()
        if node.id not in said and node.type != "none"
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
        if node.type != "identifier" or is_member(node):
            continue
        found = analysis.scopes.at(node.start_byte).lookup(analysis.syntax.slice(node))
        if found is not None and any(b.kind is not BindingKind.IMPORT for b in found[1]):
            return True
    return False
