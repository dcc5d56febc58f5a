"""Writing the files of a program without asking, where there is nothing to decide."""

from __future__ import annotations

from plastron_tui.diagnostics import has_errors
from plastron_tui.output.plan import FileState
from plastron_tui.output.writer import write
from plastron_tui.session import Session

_PLAIN = frozenset({FileState.CREATE, FileState.IDENTICAL})


def write_new(session: Session) -> bool:
    """Write the files of a program that are not there yet.

    Returns:
        Whether all files are there now; nothing is written where one is there already and would
        change, or where something is to be said first.
    """
    plan, problems = session.plan()
    if problems or not plan.files or any(file.state not in _PLAIN for file in plan.files):
        return False
    return not has_errors(write(plan).diagnostics)
