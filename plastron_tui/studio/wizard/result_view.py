"""The code and the graph that the wizard's statements make, beside its pages."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from textual.app import ComposeResult
from textual.containers import Vertical
from textual.widgets import Label

from plastron_tui.session import Session

from ..panels.folding import folded
from ..panels.styles import Lines
from ..panels.text_view import TextView
from .flow import Look
from .outcome import (
    arrows_of,
    changed_rows,
    code_of,
    code_of_robot,
    drawing_of,
    look_of_robot,
)

WIDE = 116
"""From so many columns of the screen on, the graph is a picture."""


_GRAPH, _LOOKS = "Who sends what to whom", "How it looks"
_LEAST_ROWS = 6
"""The least rows of a robot's picture."""


class ResultView(Vertical):
    """Shows what comes of the statements, a robot too; what changed scrolls into view."""

    _code: Lines = ()

    def compose(self) -> ComposeResult:
        """Make the graph, and the code below it."""
        yield Label(_GRAPH, id="wizard-seen", classes="wizard-caption", markup=False)
        yield TextView(id="wizard-graph")
        yield Label("", id="wizard-file", classes="wizard-caption", markup=False)
        yield TextView(id="wizard-code")

    def forget(self) -> None:
        """Take whatever comes next for new."""
        self._code = ()

    async def show(
        self, look: Look, session: Session, lock: asyncio.Lock, is_due: Callable[[], bool]
    ) -> None:
        """Find the code and the graph in a thread, and show them.

        Args:
            look: what follows from what was entered.
            session: the program without it.
            lock: who holds it is the only one to look at the wizard's state.
            is_due: tells, once they are found, whether they are to be shown still.
        """
        outcome = look.outcome
        # As long as something is wrong, what was right before it stays in view.
        if outcome is None or (look.problems and self._code):
            return
        is_wide = self.app.size.width >= WIDE
        room = self.size.width - 3, self.size.height // 3
        robot = look.robot if look.robot in outcome.session.workspace.robots else None

        def find() -> tuple[str, Lines, Lines]:
            if robot is not None:
                rows = max(room[1], _LEAST_ROWS)
                seen = look_of_robot(outcome.session, robot, look.part, room[0], rows)
                return *code_of_robot(outcome.session, robot), seen
            name, lines = code_of(outcome.session, look.node)
            if is_wide:
                return name, lines, drawing_of(session, outcome.session, *room)
            return name, lines, arrows_of(session, outcome.session)

        async with lock:
            name, lines, graph = await asyncio.to_thread(find)
        if is_due() and self.is_attached:
            self.query_one("#wizard-seen", Label).update(_GRAPH if robot is None else _LOOKS)
            picture = self.query_one("#wizard-graph", TextView)
            picture.set_class(robot is not None, "-robot")
            picture.show(graph)
            self.query_one("#wizard-file", Label).update(name or "The file of the node")
            self._show_code(lines)

    def _show_code(self, lines: Lines) -> None:
        code = self.query_one("#wizard-code", TextView)
        before, after = self._folded(self._code), self._folded(lines)
        rows = changed_rows(before, after) if self._code else range(0)
        code.show(after)
        if rows:
            middle = rows.start + min(len(rows), code.size.height) // 2
            top = max(0, middle - code.size.height // 2)
            self.call_after_refresh(code.scroll_to, y=top, animate=False)
        elif not self._code:
            self.call_after_refresh(code.scroll_home, animate=False)
        self._code = lines

    @property
    def code(self) -> Lines:
        """The lines of the code as they are in the file."""
        return self._code

    def on_resize(self) -> None:
        """Fold the code anew: it has more room, or less."""
        self.query_one("#wizard-code", TextView).show(self._folded(self._code))

    def _folded(self, lines: Lines) -> Lines:
        """Return lines as there is room for them; where nothing is in sight there is none."""
        width = self.query_one("#wizard-code", TextView).scrollable_content_region.width
        return folded(lines, width) if width else lines
