"""The program in the editor."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ..editor import ProgramEditor
from ..open_program import Open

if TYPE_CHECKING:
    from ..analysis import Analysis
    from ..editor.card import Card


class ActiveProgram:
    """The program in the editor; another one takes its place when that is opened.

    Attributes:
        open: the program.
        editor: the editor, which goes from program to program.
    """

    def __init__(self, open_: Open) -> None:
        self.open = open_
        self.editor = ProgramEditor(open_.session, id="editor")
        self.editor.hover.card_of = self.card_at
        self.editor.border_title = "Program"

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

    def card_at(self, offset: int) -> Card | None:
        """Return what is said about the word at an offset, as it was last understood."""
        analysis = self.open.analysis
        if analysis is None:
            return None
        # Imported when somebody asks, not at the start.
        from ..cards import Known, card_at

        return card_at(Known(self.open.session, analysis.program, analysis.workspace), offset)

    def replace(self, open_: Open, cursor: int = 0) -> None:
        """Put another program in its place."""
        self.open = open_
        self.editor.set_session(open_.session)
        if cursor:
            self.editor.go_to(cursor)
