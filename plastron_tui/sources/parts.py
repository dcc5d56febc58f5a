"""Endpoints that an object of a library creates and names, whatever language uses it."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.source import Remove, Rename, Update


def refuse_part(change: Remove | Rename | Update, what: str, line: int) -> Diagnostic:
    """Say that an endpoint is a part of an object, as `/tf` is of tf2's broadcaster.

    No argument of the object names it; where the node is started it can get another name.

    Args:
        change: what is asked for.
        what: what makes the object.
        line: the line in which it does.
    """
    message = f"the {change.kind.word} `{change.name}` is a part of `{what}` in line {line}"
    to = change.name
    if isinstance(change, Rename):
        to = change.to
    elif isinstance(change, Update):
        to = change.endpoint.name
    help_ = "change the line by hand"
    if to != change.name:
        help_ = (
            f"remap it where the node is started: `starts … remapping '{change.name}' to '{to}'`"
        )
    return Diagnostic(codes.EDIT_REFUSED, message, change.span, help=help_)
