"""What goes with a call that an edit takes out, though somebody wrote it by hand."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Endpoint, EndpointKind, kind_of
from plastron_tui.model.source import Update
from plastron_tui.ros.interfaces import InterfaceName

from .analysis import Analysis, Site
from .references import is_member
from .scopes import BindingKind


class _Gone(NamedTuple):
    kind: EndpointKind
    type: InterfaceName | None
    name: str
    options: list[str]


class Exchange:
    """What goes in an edit and what comes, which seems to take its place."""

    def __init__(self) -> None:
        self._gone: list[_Gone] = []
        self._new: list[Endpoint] = []

    def take(self, analysis: Analysis, site: Site, name: str) -> None:
        """Note a call that is taken out, of an endpoint that a statement calls by a name."""
        options = options_of(analysis, site)
        self._gone.append(_Gone(site.endpoint.kind, site.endpoint.type, name, options))

    def add(self, endpoint: Endpoint) -> None:
        """Note an endpoint that is written."""
        self._new.append(endpoint)

    def notes(self, after: Analysis) -> Iterator[Diagnostic]:
        """Yield what the calls that went said, and those that came do not."""
        for gone in self._gone:
            new = self._instead(gone)
            kept = {
                option
                for site in after.sites
                if new is not None
                and (site.endpoint.kind, site.endpoint.name) == (gone.kind, new.name)
                for option in options_of(after, site)
            }
            lost = [f"`{option}`" for option in gone.options if option not in kept]
            if new is not None and lost:
                message = f"{', '.join(lost)} of `{gone.name}` is not kept for `{new.name}`"
                yield written_anew(message, new, gone.name)

    def _instead(self, gone: _Gone) -> Endpoint | None:
        of_kind = [each for each in self._new if kind_of(type(each)) is gone.kind]
        alike = [each for each in of_kind if each.type == gone.type]
        is_one = len({each.name for each in self._gone if each.kind is gone.kind}) == 1
        return next(iter(alike or (of_kind if is_one and len(of_kind) == 1 else ())), None)


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
