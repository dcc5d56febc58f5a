"""Why a change of a file cannot be made, as it is told."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.source import Remove, Rename, Update
from plastron_tui.sources.parts import refuse_part

from .analysis import Analysis, Site
from .base_classes import inherited
from .creation import Removal
from .removal import find_sites


class RefusedError(Exception):
    """A change that cannot be made."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(diagnostic.message)
        self.diagnostic = diagnostic


def not_there(analysis: Analysis, change: Remove | Rename) -> RefusedError:
    """Say that a file has no such endpoint, and what it has of that name."""
    message = f"the file has no {change.kind.word} `{change.name}`"
    for site in find_sites(replace(analysis, sites=analysis.disguised), change):
        return RefusedError(refuse_part(change, site.endpoint.expression, site.endpoint.line))
    for each in inherited(analysis, None):
        if each.kind is change.kind and change.name in (each.name, each.default):
            place = f"`{each.file}`, line {each.line}"
            message = f"the {change.kind.word} `{change.name}` is of a base class, in {place}"
    return RefusedError(Diagnostic(codes.EDIT_REFUSED, message, change.span))


def refuse_passes(change: Remove | Rename | Update, sites: Sequence[Site]) -> None:
    """Refuse to change one of the endpoints that a call creates one after the other."""
    site = next((site for site in sites if site.passes), None)
    if site is None:
        return
    line, given = site.endpoint.line, site.endpoint.expression
    message = f"line {line} creates the {change.kind.word} `{change.name}` among others"
    remedy = f"change by hand what gives `{given}` its values"
    raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, change.span, help=remedy))


def not_named(site: Site, changes: Sequence[Rename]) -> RefusedError:
    """Say that a call takes its name from where no edit can change it."""
    kind, name = site.endpoint.kind, site.endpoint.name or site.endpoint.default
    spans = [each.span for each in changes if (each.kind, each.name) == (kind, name)]
    message = f"line {site.endpoint.line} does not say the name of the {kind.word} `{name}` itself"
    remedy = f"change by hand what `{site.endpoint.expression}` is"
    return RefusedError(
        Diagnostic(codes.EDIT_REFUSED, message, next(iter(spans), None), help=remedy)
    )


def in_use(change: Remove, removal: Removal) -> RefusedError:
    """Say where an endpoint is used that is to go."""
    lines = listed(map(str, sorted(removal.lines)))
    plural, these = ("s", "these lines") if len(removal.lines) > 1 else ("", "this line")
    name = change.kind.written(change.name)
    message = f"the {change.kind.word} `{name}` is used in line{plural} {lines}"
    help_ = f"change {these} in the file first"
    return RefusedError(Diagnostic(codes.ENDPOINT_IN_USE, message, change.span, help=help_))
