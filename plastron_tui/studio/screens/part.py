"""What the parts of the main screen ask of each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from textual.screen import Screen

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from plastron_tui.diagnostics import Diagnostic

    from ..app import StudioApp
    from ..editor import ProgramEditor
    from ..journal import Kept
    from ..state import Open


class Part(Screen[None]):
    """A part of the main screen; another part, or the screen itself, does what is named here."""

    # Only type checkers see this: whatever the order of the bases is, none of it hides the real.
    if TYPE_CHECKING:
        open: Open
        editor: ProgramEditor

        @property
        def studio(self) -> StudioApp:
            """The app."""

        def take(self, open_: Open, cursor: int = 0) -> None:
            """Show another program."""

        def take_file(self, path: Path, *, kept: Kept | None = None) -> bool:
            """Open a file, or say why that cannot be."""

        async def save(self, *, other: bool = False) -> bool:
            """Save, and ask what has to be asked; tell whether it was done."""

        async def may_leave(self) -> bool:
            """Ask about what is not saved; tell whether the program may be closed."""

        def show_title(self) -> None:
            """Show the program's name."""

        def clear_panels(self) -> None:
            """Show nothing."""

        def remember_layout(self) -> None:
            """Remember how the screen is laid out."""

        def bring(self, name: str, *, focus: bool = False) -> None:
            """Bring a panel in sight."""

        def trust_first(self, errors: Sequence[Diagnostic]) -> str | None:
            """Say that trust is all that is missing, where that is so."""

        def ask_anew(self) -> None:
            """Ask what the text means."""

        def ask_more(self) -> None:
            """Ask for what came in sight."""

        def follow(self) -> None:
            """Let what is in sight be about the statement at the cursor."""
