"""The programs that are open, each in a tab, and the one of them in the editor."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.regular_files import is_same_file

from ..editor import ProgramEditor
from ..editor.state import EditingState
from ..open_program import Open

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from plastron_tui.session import Session

    from ..analysis import Analysis
    from ..editor.card import Card


@dataclass(repr=False, eq=False)
class Tab:
    """The place of a program; a text that gets another file stays in its tab.

    Attributes:
        open: the program.
        editing: where the editor was in it; None while it is in the editor, or never was.
    """

    open: Open
    editing: EditingState | None = None


class ActiveProgram:
    """The program in the editor; others wait in their tabs, as texts that can be undone.

    Attributes:
        tabs: all programs that are open, as the line of tabs has them.
        tab: the one in the editor.
        editor: the editor, which goes from program to program.
        said_now: tells what comes at a topic now, "" where nobody listens.
    """

    def __init__(self, open_: Open, others: Sequence[Open] = ()) -> None:
        self.tab = Tab(open_)
        self.tabs = [self.tab, *map(Tab, others)]
        self.editor = ProgramEditor(open_.session, id="editor")
        self.editor.hover.card_of = self.card_at
        self.said_now: Callable[[str], str] = lambda _: ""
        self.editor.border_title = "Program"

    @property
    def open(self) -> Open:
        """The program."""
        return self.tab.open

    @property
    def text(self) -> bytes:
        """The program's text."""
        return self.open.text

    @property
    def path(self) -> Path | None:
        """The program's file."""
        return self.open.path

    @property
    def analysis(self) -> Analysis | None:
        """What the text means, None as long as that is not known."""
        analysis = self.open.analysis
        return analysis if analysis is not None and analysis.text == self.open.text else None

    def tab_of(self, path: Path) -> Tab | None:
        """Return the tab that has a file open, None for no tab."""
        return next((tab for tab in self.tabs if is_same_file(path, tab.open.path)), None)

    def tab_with(self, session: Session) -> Tab | None:
        """Return the tab that has the text of a session, None for no tab."""
        return next((tab for tab in self.tabs if tab.open.session is session), None)

    def cursor_of(self, tab: Tab) -> int:
        """Return where the cursor of a tab is, in bytes."""
        if tab is self.tab:
            return self.editor.cursor_offset
        return 0 if tab.editing is None else tab.editing.selection.head

    def card_at(self, offset: int) -> Card | None:
        """Return what is said about the word at an offset, as it was last understood."""
        analysis = self.open.analysis
        if analysis is None:
            return None
        # Imported when somebody asks, not at the start.
        from ..cards import Known, card_at

        diagnostics = analysis.diagnostics if analysis is self.analysis else ()
        meaning = analysis.program, analysis.workspace
        card = card_at(Known(self.open.session, *meaning, diagnostics), offset)
        now = self.said_now(card.title) if card is not None and card.kind == "topic" else ""
        return card.with_row("now", now) if card is not None and now else card

    def replace(self, open_: Open, cursor: int = 0) -> None:
        """Put another program in the place of the one in the editor."""
        self.editor.jumps.hand_on(self.tab.open.session, open_.session)
        self.tab.open = open_
        self.editor.set_session(open_.session)
        if cursor:
            self.show_at(cursor)

    def add(self, open_: Open, cursor: int = 0) -> None:
        """Put a program into a tab of its own, behind the one in front."""
        tab = Tab(open_)
        self.tabs.insert(self.tabs.index(self.tab) + 1, tab)
        self.bring(tab)
        if cursor:
            self.show_at(cursor)

    def show_at(self, offset: int) -> None:
        """Put the cursor at an offset, or at the text's end; no way back leads from there."""
        self.editor.state.move(offset)
        self.editor.done(center=True)

    def bring(self, tab: Tab) -> None:
        """Bring a tab in front; of the one that was there, what its text means is forgotten."""
        if tab is self.tab:
            return
        self._leave()
        self.tab = tab
        self.editor.set_session(tab.open.session, tab.editing)
        tab.editing = None

    def _leave(self) -> None:
        left = self.tab
        left.editing = self.editor.editing
        left.open.analysis = None
        # What it loads may be another text by the time that it is in front again.
        left.open.session.files_changed()

    def remove(self) -> None:
        """Take the tab in front away, where there is another one; its neighbour comes in front."""
        at = self.tabs.index(self.tab)
        others = [tab for tab in self.tabs if tab is not self.tab]
        self.editor.jumps.forget(self.open.session)
        self.bring(others[min(at, len(others) - 1)])
        self.tabs = others
