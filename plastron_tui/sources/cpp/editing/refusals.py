"""Why a change of a unit cannot be made, as it is told."""

from __future__ import annotations

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.model.source import Remove, Rename, Update

from ..analysis import Analysis


class RefusedError(Exception):
    """A change that cannot be made."""

    def __init__(self, message: str, span: Span | None = None, remedy: str | None = None) -> None:
        super().__init__(message)
        self.diagnostic = Diagnostic(codes.EDIT_REFUSED, message, span, help=remedy)


def not_there(analysis: Analysis, change: Remove | Rename | Update) -> RefusedError:
    """Say that the files have no such endpoint."""
    del analysis
    return RefusedError(f"the file has no {change.kind.word} `{change.name}`", change.span)
