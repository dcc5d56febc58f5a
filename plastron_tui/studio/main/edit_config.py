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
from ..config_reader import load_config
from ..editor.external_editor import external_editor, run_editor
from ..panels.styles import Piece


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
    if wrong and not await _is_opened(screen, wrong):
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
        return
    wrong = _wrong(screen)
    if wrong:
        screen.notify("\n".join((_count(wrong), wrong[0])), severity="warning", markup=False)


def _wrong(screen: Screen[None]) -> Sequence[str]:
    """Return what is wrong with the file as it is now."""
    return load_config(config_file(), key_owners(), screen.app.available_themes)[1]


def _count(wrong: Sequence[str]) -> str:
    return f"{counted(len(wrong), 'mistake')} in the settings"


async def _is_opened(screen: Screen[None], wrong: Sequence[str]) -> bool:
    """List what is wrong, and ask whether the file is to be opened."""
    from ..screens.question import Question

    answers = [("open", "Open the file"), ("close", "Close")]
    lines = tuple((Piece(each),) for each in wrong)
    question = Question(_count(wrong), answers, lines=lines)
    return await screen.app.push_screen_wait(question) == "open"
