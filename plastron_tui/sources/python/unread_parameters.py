"""Parameters that a file read only for what an edit takes out."""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.source import Change, EndpointKind, Remove, Update

from .analysis import Analysis


def tell_unread(before: Analysis, after: Analysis, changes: Sequence[Change]) -> Diagnostic | None:
    """Return a warning that names the parameters which a file does not read any more.

    Args:
        before: the file as it was.
        after: the file as it is.
        changes: what was asked for.
    """
    taking = [change for change in changes if isinstance(change, Remove | Update)]
    left = set(_parameters(after))
    named = {change.name for change in taking if change.kind is EndpointKind.PARAMETER}
    gone = [each for each in _parameters(before) if each not in left and each not in named]
    if not gone or not taking:
        return None
    message = f"no longer read: {listed(f'`{each}`' for each in dict.fromkeys(gone))}"
    span = taking[0].span if len(taking) == 1 else None
    help_ = "take it out of launch files and settings too" if len(set(gone)) == 1 else None
    help_ = help_ or "take them out of launch files and settings too"
    return Diagnostic(codes.UNREAD_PARAMETER, message, span, help=help_)


def _parameters(analysis: Analysis) -> list[str]:
    return [
        site.endpoint.name or site.endpoint.expression
        for site in analysis.sites
        if site.endpoint.kind is EndpointKind.PARAMETER
    ]
