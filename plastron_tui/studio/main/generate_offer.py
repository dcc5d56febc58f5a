"""What is said where nothing would be written or started, and the line that changes that."""

from __future__ import annotations

from textual.screen import Screen

from plastron_tui.generating.nothing import missing_statements

from ..insertion_point import placed
from .active_program import ActiveProgram

_MOST_SHOWN = 6
"""The most statements that the question shows."""


async def offer_generating(screen: Screen[None], program: ActiveProgram, *, to_run: bool) -> bool:
    """Make sure that a program generates something; tell whether there is any use in going on.

    Where a `generate_node` is missing, it is offered: Enter adds it, as one step to undo.

    Args:
        screen: shows the question.
        program: the program; what its text means has to be known.
        to_run: whether nodes are to be started; else it is enough that a file is written.
    """
    analysis = program.analysis
    if analysis is None:
        return True
    workspace = analysis.workspace
    if workspace.may_run if to_run else workspace.is_written:
        return True
    lines = missing_statements(workspace)
    if to_run and not workspace.nodes:
        more = "; F6 writes the robot" if workspace.robots else ""
        text = f"there is no node to run yet: `create_node 'talker' as talker` makes one{more}"
        screen.notify(text, severity="warning", markup=False)
        return False
    if not lines:
        return True
    from ..screens.question import Question

    count = len(lines)
    hidden = count - _MOST_SHOWN
    shown = [*lines[:_MOST_SHOWN], *([f"… and {hidden} more"] if hidden > 0 else [])]
    words = "Add this line" if count == 1 else f"Add these {count} lines"
    question = Question(
        "The program generates nothing yet" if not workspace.is_written
        else "The program generates no node yet",
        [("add", words), ("cancel", "Cancel")],
        text="\n".join(["This is missing at its end:", *shown]),
    )  # fmt: skip
    if await screen.app.push_screen_wait(question) != "add" or program.analysis is not analysis:
        return False
    program.editor.apply([placed(analysis.ground, None, lines, is_apart=True).edit])
    return True
