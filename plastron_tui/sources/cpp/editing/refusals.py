"""Why a change of a unit cannot be made, as it is told."""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.diagnostics import Diagnostic, Span, codes, listed
from plastron_tui.model.source import Remove, Rename, Update
from plastron_tui.sources.parts import refuse_part

from ..analysis import Analysis, Site
from ..scopes import CppFile


class RefusedError(Exception):
    """A change that cannot be made."""

    def __init__(self, message: str, span: Span | None = None, remedy: str | None = None) -> None:
        super().__init__(message)
        self.diagnostic = Diagnostic(codes.EDIT_REFUSED, message, span, help=remedy)


def not_there(analysis: Analysis, change: Remove | Rename | Update) -> RefusedError:
    """Say that the files have no such endpoint."""
    found = sorted(
        {
            each.endpoint.label
            for each in analysis.sites
            if each.endpoint.kind is change.kind and each.endpoint.label
        }
    )
    remedy = f"it has {listed(f'`{each}`' for each in found)}" if found else "look at what it has"
    message = f"the file has no {change.kind.word} `{change.name}`"
    return RefusedError(message, change.span, remedy)


def refuse_parts(change: Remove | Rename | Update, sites: Sequence[Site]) -> None:
    """Refuse to change what an object of a library creates and names.

    Raises:
        RefusedError: one of the call sites makes such an object.
    """
    for site in sites:
        if site.shape.on == "object":
            refusal = RefusedError("")
            found = site.endpoint
            refusal.diagnostic = refuse_part(change, found.expression, found.line)
            raise refusal


def in_use(change: Remove, used: Sequence[tuple[CppFile, int]]) -> RefusedError:
    """Say where an endpoint is used that is to go."""
    places = dict.fromkeys(
        file.place_of(line) for file, line in sorted(used, key=lambda each: (each[0].name, each[1]))
    )
    is_one = len(places) == 1
    name = change.kind.written(change.name)
    message = f"the {change.kind.word} `{name}` is used in line{'' if is_one else 's'} "
    message += listed(places)
    remedy = f"change {'this line' if is_one else 'these lines'} in the file first"
    refusal = RefusedError(message)
    refusal.diagnostic = Diagnostic(codes.ENDPOINT_IN_USE, message, change.span, help=remedy)
    return refusal
