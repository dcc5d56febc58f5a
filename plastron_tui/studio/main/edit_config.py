"""The configuration file, in the user's own editor."""

from __future__ import annotations

import os
from contextlib import suppress

from textual.app import SuspendNotSupported
from textual.screen import Screen

from ..actions import ACTIONS
from ..config import config_file, template
from ..editor.external_editor import external_editor, run_editor


def edit_config(screen: Screen[None]) -> None:
    """Write the configuration file, if there is none, and open it in $EDITOR, if there is one."""
    file = config_file()
    problem = template(file, [(action.id, action.keys) for action in ACTIONS])
    if problem is not None:
        screen.notify(problem, severity="error", markup=False)
        return
    screen.notify(
        f"{file}\nsettings count from the next start of the studio on", timeout=8, markup=False
    )
    command = external_editor(os.environ)
    if command is None:
        return
    with suppress(SuspendNotSupported), screen.app.suspend():
        problem = run_editor(command, file)
    screen.app.refresh()
    if problem is not None:
        screen.notify(problem, severity="warning", markup=False)
