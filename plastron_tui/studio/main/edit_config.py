"""The configuration file, in the user's own editor."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import suppress

from textual.app import SuspendNotSupported
from textual.screen import Screen

from plastron_tui.diagnostics import counted

from ..actions import ACTIONS, key_owners
from ..config import config_file, template
from ..config_reader import load_settings, told
from ..editor.external_editor import NO_EDITOR, external_editor, run_editor
from ..key_conflicts import Said


async def edit_config(screen: Screen[None]) -> None:
    """Write the configuration file, if there is none, and open it in the user's editor.

    What is wrong with it is listed before, all of it, and counted afterwards.
    """
    file = config_file()
    problem = template(file, [(action.id, action.keys) for action in ACTIONS])
    if problem is not None:
        screen.notify(problem, severity="error", markup=False)
        return
    wrong = _wrong(screen)
    line = await _line(screen, wrong) if wrong else 1
    if line is None:
        return
    screen.notify(
        f"{file}\nsettings count from the next start of the studio on", timeout=8, markup=False
    )
    command = external_editor(os.environ)
    if isinstance(command, str):
        if command != NO_EDITOR:
            screen.notify(command, severity="warning", markup=False)
        return
    with suppress(SuspendNotSupported), screen.app.suspend():
        problem = run_editor(command, file, line)
    screen.app.refresh()
    if problem is not None:
        screen.notify(problem, severity="warning", markup=False)
        return
    wrong = _wrong(screen)
    if wrong:
        screen.notify(
            "\n".join((_count(wrong), told(file, wrong[0]))), severity="warning", markup=False
        )


def _wrong(screen: Screen[None]) -> Sequence[Said]:
    """Return what is wrong with the file as it is now."""
    return load_settings(config_file(), key_owners(), screen.app.available_themes)[1]


def _count(wrong: Sequence[Said]) -> str:
    return f"{counted(len(wrong), 'mistake')} in the settings"


async def _line(screen: Screen[None], wrong: Sequence[Said]) -> int | None:
    """List what is wrong; return the line that somebody wants to mend, None for none."""
    from ..screens.line_list import LineList

    lines = LineList(_count(wrong), wrong)
    chosen = await screen.app.push_screen_wait(lines)
    return None if chosen < 0 else max(1, wrong[chosen].line)
