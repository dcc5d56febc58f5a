"""What is offered for a file that is no program: a new program that loads it."""

from __future__ import annotations

from pathlib import Path

from textual.screen import Screen

from plastron_tui.project.other_files import OtherKind, loading_program, program_beside


async def ask_to_load(screen: Screen[None], file: Path, kind: OtherKind) -> bytes | Path | None:
    """Say what a file is, and offer a program for it.

    Returns:
        The text of a new program that loads the file, the path of one that is beside it already,
        or None where nothing is wanted, or nothing can be loaded.
    """
    from ..screens.question import Question

    if not file.is_file():
        message = f"there is no file {file.name}; a program's name ends in .plastron"
        screen.notify(message, severity="warning", markup=False)
        return None
    title = f"{file.name} is {kind.title}, not a program"
    beside, text = program_beside(file), loading_program(file, kind)
    is_there = beside.exists()
    if text is None and not is_there:
        screen.notify(f"{title}; no ROS node is found in it", severity="warning", markup=False)
        return None
    said = f"A program can load it. {file.name} stays as it is: what changes is written to a copy."
    words = f"Open {beside.name}" if is_there else "New program that loads it"
    answers = [("load", words), ("cancel", "Cancel")]
    answer = await screen.app.push_screen_wait(Question(title, answers, text=said))
    if answer != "load":
        return None
    return beside if is_there else text
