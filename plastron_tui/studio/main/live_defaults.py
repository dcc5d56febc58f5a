"""What a running node was given goes into the program, as the default of its parameter."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Edit, Span

from ..panels.live_row import LiveRow
from .active_program import ActiveProgram

if TYPE_CHECKING:
    from ..wizard.values import Path


def default_place(program: ActiveProgram, row: LiveRow) -> Span | None:
    """Return where the program in front says what a parameter is, None for nowhere."""
    from ..parameter_default import default_span

    analysis, parameter = program.analysis, row.parameter
    if analysis is None or parameter is None:
        return None
    return default_span(analysis, row.owner, parameter.name)


def write_default(
    program: ActiveProgram,
    row: LiveRow,
    given: Mapping[Path, str],
    on_written: Callable[[], object],
) -> str:
    """Let a parameter begin with a value that it was given; return what is said of that.

    Args:
        program: the program in front.
        row: the parameter.
        given: what was entered for it.
        on_written: called when the program has it.
    """
    from ..wizard.live_orders import default_text

    place = default_place(program, row)
    text = None if row.parameter is None else default_text(row.parameter, given)
    if place is None or text is None:
        return "the program cannot have this value; the node has it until it ends"
    program.editor.apply([Edit(place, text)])
    on_written()
    return f"the program begins with {row.name} {text} now"
