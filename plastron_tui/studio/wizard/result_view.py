"""The code and the graph that the wizard's statements make, beside its pages."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from textual.app import ComposeResult
from textual.containers import Vertical
from textual.content import Content
from textual.geometry import Region
from textual.widgets import Label

from plastron_tui.session import Session

from ..panels.folding import folded
from ..panels.styles import Lines
from ..panels.text_view import TextView
from .code_changes import Code, changed_rows, place_of
from .outcome import arrows_of, code_of, code_of_robot, drawing_of, look_of_robot
from .pages import Look

WIDE = 116
"""From so many columns of the screen on, the graph is a picture."""


_GRAPH, _LOOKS = "Who sends what to whom", "How it looks"
_LEAST_ROWS = 6
"""The least rows of a robot's picture."""


class ResultView(Vertical):
    """Shows what comes of the statements, a robot too; what changed scrolls into view."""

    _code: Lines = ()
    _here = range(0)
    """The lines that are to be in sight."""

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
        self,
        look: Look,
        session: Session,
        lock: asyncio.Lock,
        is_due: Callable[[], bool],
        *,
        is_last: bool,
    ) -> None:
        """Find the code and the graph in a thread, and show them.

        Args:
            look: what follows from what was entered.
            session: the program without it.
            lock: who holds it is the only one to look at the wizard's state.
            is_due: tells, once they are found, whether they are to be shown still.
            is_last: whether all of it is looked at before it is written, and not what was just
                entered.
        """
        outcome = look.outcome
        # As long as something is wrong, what was right before it stays in view.
        if outcome is None or (look.problems and self._code):
            return
        is_wide = self.app.size.width >= WIDE
        room = self.size.width - 5, self.size.height // 3
        robot = look.robot if look.robot in outcome.session.workspace.robots else None

        def find() -> tuple[Code, Lines]:
            if robot is not None:
                rows = max(room[1], _LEAST_ROWS)
                seen = look_of_robot(outcome.session, robot, look.part, room[0], rows)
                return code_of_robot(look.before, outcome.session, robot), seen
            code = code_of(look.before, outcome.session, look.node)
            if is_wide:
                return code, drawing_of(session, outcome.session, *room)
            return code, arrows_of(session, outcome.session)

        async with lock:
            code, graph = await asyncio.to_thread(find)
        if is_due() and self.is_attached:
            seen = _GRAPH if robot is None else _LOOKS
            self.query_one("#wizard-seen", Label).update(seen)
            picture = self.query_one("#wizard-graph", TextView)
            picture.set_class(robot is not None, "-robot")
            picture.show(graph)
            self.call_after_refresh(_show_new, picture)
            name = code.name or "The file of the node"
            self.query_one("#wizard-file", Label).update(name)
            picture.border_title = Content(seen)
            self.query_one("#wizard-code", TextView).border_title = Content(name)
            self._show_code(code, is_last=is_last)

    def _show_code(self, code: Code, *, is_last: bool) -> None:
        is_other = bool(self._code) and self._code != code.lines
        self._here = changed_rows(self._code, code.lines) if is_other else self._here
        if is_last or not self._code:
            self._here = code.change
        self._code = code.lines
        self._draw()

    def _draw(self) -> None:
        """Fold the code as there is room, with the lines of `_here` in sight."""
        view = self.query_one("#wizard-code", TextView)
        view.show(self._folded(self._code))
        start = len(self._folded(self._code[: self._here.start]))
        rows = len(self._folded(self._code[self._here.start : self._here.stop]))
        top = place_of(range(start, start + rows), view.size.height)
        self.call_after_refresh(view.scroll_to, y=top, animate=False)

    @property
    def code(self) -> Lines:
        """The lines of the code as they are in the file, with the marks of what changes."""
        return self._code

    def on_resize(self) -> None:
        """Fold the code anew: it has more room, or less."""
        self._draw()

    def _folded(self, lines: Lines) -> Lines:
        """Return lines as there is room for them; where nothing is in sight there is none."""
        width = self.query_one("#wizard-code", TextView).scrollable_content_region.width
        return folded(lines, width) if width else lines


def _show_new(graph: TextView) -> None:
    """Have what is new in a graph in sight."""
    for y, line in enumerate(graph.lines):
        x = 0
        for piece in line:
            if piece.tone == "added":
                where = Region(x, y, len(piece.text), 1)
                graph.scroll_to_region(where, animate=False, force=True)
                return
            x += len(piece.text)
