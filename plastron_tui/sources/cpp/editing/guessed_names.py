"""Changes of endpoints whose names are no more than likely: what is told of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.source import Add, Change

from ..analysis import Analysis
from .units import sites_of


def tell_guessed_names(analysis: Analysis, changes: Sequence[Change]) -> Iterator[Diagnostic]:
    """Warn of each change that finds its endpoint by a default.

    Args:
        analysis: the files as they are before the changes.
        changes: what is asked for.
    """
    for change in changes:
        if isinstance(change, Add):
            continue
        lines = [
            str(each.endpoint.line)
            for each in sites_of(analysis, change)
            if each.endpoint.label is None or each.endpoint.is_guess
        ]
        if lines:
            found = dict.fromkeys(lines)
            where = f"{'line' if len(found) == 1 else 'lines'} {listed(found)}"
            message = (
                f"the name `{change.name}` in {where} is a default, for which others may give "
                "another name"
            )
            yield Diagnostic(codes.GUESSED_NAME, message, change.span)
