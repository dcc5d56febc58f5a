"""What goes with a call that an edit takes out, though somebody wrote it by hand."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.kinds import Publisher, is_sending
from plastron_tui.model.source import EndpointKind, Update
from plastron_tui.sources.written_anew import no_longer_decides, no_longer_sends

from ..analysis import Analysis, Site
from .creation import creation_of
from .refilling import STAMP, is_worked_out
from .sent import PUBLISHING, Sent, sent_through
from .units import sites_of

_PLAIN = frozenset({EndpointKind.PARAMETER, EndpointKind.TIMER})


def options_of(site: Site) -> list[str]:
    """Return what a call says besides name, type and callback, with the object of that."""
    if site.endpoint.kind in _PLAIN:
        return []
    shape, syntax = site.shape, site.place.file.syntax
    texts = (
        syntax.slice(node)
        for at, node in enumerate(site.arguments)
        if at not in (shape.name, shape.callback) and node.type != "this"
    )
    return [" ".join(each.split()) for each in texts]


def lost_sending(analysis: Analysis, change: Update) -> Iterator[Diagnostic]:
    """Yield what is told of what a file publishes, where other lines publish something else."""
    new = change.endpoint
    if not isinstance(new, Publisher) or not is_sending(new):
        return
    sent: list[Sent] = []
    for site in sites_of(analysis, change):
        creation = creation_of(analysis, site)
        if creation is not None and creation.variable is not None:
            sent += sent_through(analysis, creation.variable, PUBLISHING)
    said = (text for each in sent for text in worked_out(analysis, each))
    yield from no_longer_sends(said, new, change.name)
    in_order = sorted(sent, key=lambda each: (each.file.name, each.call.start_byte))
    lines = dict.fromkeys(each.file.place_of(each.call.start_point.row + 1) for each in in_order)
    yield from no_longer_decides(list(lines), new, change.name)


def worked_out(analysis: Analysis, sent: Sent) -> Iterator[str]:
    """Yield what of a message the node works out."""
    variable = sent.variable
    if variable is None:
        if sent.given is not None and is_worked_out(sent.given, sent.file):
            yield sent.file.syntax.slice(sent.given)
        return
    for node, path, given, scope in analysis.fields.of(variable.name):
        found = analysis.unit.lookup(variable.name, scope, node.start_byte)
        if found is variable and path != STAMP and is_worked_out(given, scope.file):
            yield scope.file.syntax.slice(given)
