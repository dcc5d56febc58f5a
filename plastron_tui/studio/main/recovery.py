"""The journal: what was typed is kept while it is not saved, and offered after a crash."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from textual.screen import Screen

from plastron_tui.regular_files import reason

from ..config import Remembered
from ..delay import Delay
from ..files import SUFFIX, open_file
from ..folder_labels import not_saved, shown_name, shown_place
from ..journal import Kept, kept_texts
from .active_program import ActiveProgram, Tab
from .said_notes import SaidNotes

_KEEP = 0.5
"""Seconds after which what was typed is in the journal, at most."""


class Recovery:
    """Keeps what is typed, and offers what a studio that has ended did not save."""

    def __init__(self, screen: Screen[None], program: ActiveProgram, journals: Path) -> None:
        """Prepare to keep the text of a program; `journals` is the folder of all journals."""
        self._screen = screen
        self._program = program
        self._journals = journals
        self._delay = Delay(screen, self._keep)
        self._due: set[Tab] = set()
        self._is_writing = False
        self._has_failed = False
        self._notes = SaidNotes(screen)

    def keep_soon(self) -> None:
        """Keep the text within half a second, also when another one is in front by then."""
        self._due.add(self._program.tab)
        if not self._delay.is_waiting:
            self._delay.start(_KEEP)

    def keep_now(self) -> None:
        """Keep all that is not saved at once: something has gone wrong."""
        for tab in self._program.tabs:
            if tab.open.is_changed:
                tab.open.journal.write(tab.open.text, self._program.cursor_of(tab))

    def stop(self) -> None:
        """Let go of what was to be kept soon: it is saved, or not wanted."""
        self._delay.stop()

    def _keep(self) -> None:
        if self._is_writing:
            # The disk is slower than who types: one text at a time, and then the latest.
            self._delay.start(_KEEP)
            return
        due, self._due = self._due, set()
        writes = []
        for tab in due.intersection(self._program.tabs):
            open_, journal = tab.open, tab.open.journal
            if open_.is_changed:
                cursor = self._program.cursor_of(tab)
                writes.append(partial(journal.write, open_.text, cursor, journal.turn()))
            else:
                journal.drop()
        if not writes:
            return
        self._is_writing = True
        self._screen.run_worker(
            partial(self._write, writes), group="journal", exit_on_error=False, thread=True
        )

    def _write(self, writes: Sequence[Callable[[], OSError | None]]) -> None:
        """Write journals, in a thread."""
        errors = [write() for write in writes]
        error = next((error for error in errors if error is not None), None)
        self._is_writing = False
        if error is not None:
            self._screen.app.call_from_thread(self._refused, error)

    def _refused(self, error: OSError) -> None:
        if not self._has_failed:
            self._has_failed = True
            message = f"what you type is not kept: {reason(error)}; save often"
            self._screen.notify(message, severity="warning", markup=False)

    def tell(self, kept: Sequence[Kept], remembered: Remembered, page: str) -> None:
        """Say once of each text that it was not saved, and which page has it."""
        names = {f"{each.file.name} {each.when}": each for each in kept}
        new = [each for name, each in names.items() if name not in remembered.told]
        remembered.told = list(names)
        if new:
            self._notes.say(f"{not_saved(new)}\n{page} has what was typed", timeout=10)

    def hush(self) -> None:
        """Say no more of it for now."""
        self._notes.forget()

    def not_saved(self) -> list[Kept]:
        """Return what studios that have ended did not save, the newest first."""
        own = {tab.open.journal.file for tab in self._program.tabs}
        return [each for each in kept_texts(self._journals) if each.file not in own]

    async def is_wanted(self, kept: Kept, *, is_asked_for: bool) -> bool:
        """Ask whether a text that was not saved is to be opened; forget it where it is not.

        Args:
            kept: the text.
            is_asked_for: whether somebody chose it, so that the question comes as no surprise.
        """
        from datetime import datetime

        from ..panels.diff_lines import difference
        from ..screens.question import Question

        found = None if kept.path is None else open_file(kept.path).disk
        before = b"" if found is None or found.text is None else found.text
        if before == kept.text:
            kept.drop()
            return False
        when = datetime.fromtimestamp(kept.when).strftime("%H:%M on %d %B")
        name = "A new program" if kept.path is None else shown_name(kept)
        answer = await self._screen.app.push_screen_wait(
            Question(
                f"{name} was not saved",
                [("restore", "Restore"), ("later", "Later"), ("drop", "Forget it")],
                text=_sentence(kept, when),
                lines=difference(before, kept.text, Path(f"text{SUFFIX}")),
                is_unasked=not is_asked_for,
            )
        )
        if answer == "drop":
            kept.drop()
        return answer == "restore"

    def adopt(self, kept: Kept) -> None:
        """Keep a text that was opened again, and forget its old journal as soon as that is so."""
        if kept.file != self._program.open.journal.file:
            self._screen.call_after_refresh(self._adopt, kept)

    def _adopt(self, kept: Kept) -> None:
        open_ = self._program.open
        if open_.journal.write(open_.text, kept.cursor) is None:
            kept.drop()


def _sentence(kept: Kept, when: str) -> str:
    place = shown_place(kept)
    start = f"{place[0].upper()}{place[1:]}: the" if place else "The"
    return f"{start} studio ended at {when} with these changes:"
