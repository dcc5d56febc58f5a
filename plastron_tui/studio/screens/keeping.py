"""The journal: what was typed is kept while it is not saved, and offered after a crash."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from textual import work
from textual.timer import Timer

from plastron_tui.regular_files import reason

from ..files import open_file
from ..journal import Journal, Kept, kept_texts
from ..shown_places import shown_name, shown_place
from ..state import opened
from .part import Part

if TYPE_CHECKING:
    from ..panels.tones import Lines

_KEEP = 0.5
"""Seconds after which what was typed is in the journal, at most."""


class Keeping(Part):
    """Keeps what is typed."""

    _keeping: Timer | None = None
    _is_writing = False
    _journal_failed = False

    def keep_soon(self) -> None:
        """Keep the text within half a second."""
        if self._keeping is None:
            self._keeping = self.set_timer(_KEEP, self._keep)

    def _keep(self) -> None:
        self._keeping = None
        if not self.open.is_changed:
            self.open.journal.drop()
            return
        if self._is_writing:
            # The disk is slower than who types: one text at a time, and then the latest.
            self.keep_soon()
            return
        self._is_writing = True
        journal = self.open.journal
        self._write_journal(journal, self.open.text, self.editor.cursor_offset, journal.turn())

    def keep_no_longer(self) -> None:
        """Let go of what was to be kept soon: it is saved, or not wanted."""
        if self._keeping is not None:
            self._keeping.stop()
            self._keeping = None

    def keep_now(self) -> None:
        """Keep the text at once: something has gone wrong."""
        if self.open.is_changed:
            self.open.journal.write(self.open.text, self.editor.cursor_offset)

    # Without a description Textual would make one of the whole text.
    @work(thread=True, group="journal", exit_on_error=False, description="journal")
    def _write_journal(self, journal: Journal, text: bytes, cursor: int, turn: int) -> None:
        error = journal.write(text, cursor, turn)
        self._is_writing = False
        if error is not None:
            self.app.call_from_thread(self._journal_refused, error)

    def _journal_refused(self, error: OSError) -> None:
        if not self._journal_failed:
            self._journal_failed = True
            message = f"what you type is not kept: {reason(error)}; save often"
            self.notify(message, severity="warning", markup=False)

    def offer_of(self, path: Path) -> None:
        """Offer what was typed in a file and not saved before the studio ended."""
        for kept in self.not_saved():
            if kept.belongs_to(path, path.parent):
                self.offer_kept(kept)
                return

    def not_saved(self) -> list[Kept]:
        """Return what studios that have ended did not save, the newest first."""
        kept = kept_texts(self.studio.state_folder)
        return [each for each in kept if each.file != self.open.journal.file]

    @work(exclusive=True, group="kept", description="kept")
    async def offer_kept(self, kept: Kept, after: str | None = None) -> None:
        """Offer a text that was not saved before the studio ended; then do an action."""
        await self._offer(kept)
        if after is not None:
            await self.run_action(after)

    async def _offer(self, kept: Kept) -> None:
        from datetime import datetime

        from .question import Question

        found = None if kept.path is None else open_file(kept.path).disk
        before = b"" if found is None or found.text is None else found.text
        if before == kept.text:
            kept.drop()
            return
        when = datetime.fromtimestamp(kept.when).strftime("%H:%M on %d %B")
        answer = await self.app.push_screen_wait(
            Question(
                "A new program was not saved"
                if kept.path is None
                else f"{shown_name(kept)} was not saved",
                [("restore", "Restore"), ("later", "Later"), ("drop", "Forget it")],
                text=_sentence(kept, when),
                lines=difference_of(before, kept.text),
            )
        )
        if answer == "drop":
            kept.drop()
        if answer != "restore" or (self.open.is_changed and not await self.may_leave()):
            return
        if kept.path is None:
            self._restore_new(kept)
        elif not self.take_file(kept.path, kept=kept):
            return
        if kept.file != self.open.journal.file:
            self.call_after_refresh(partial(self._adopt, kept))

    def _restore_new(self, kept: Kept) -> None:
        """Open a program that had no file, in the folder in which it was begun."""
        begun = kept.folder
        if begun is not None and not begun.is_dir():
            begun = None
            self.notify("the folder in which it was begun is gone", severity="warning")
        journals, options = self.studio.state_folder, self.open.session.options
        self.take(opened(None, journals, options, kept.text, begun), kept.cursor)

    def _adopt(self, kept: Kept) -> None:
        """Forget the old journal as soon as the new one is written."""
        if self.open.journal.write(self.open.text, kept.cursor) is None:
            kept.drop()


def _sentence(kept: Kept, when: str) -> str:
    place = shown_place(kept)
    start = f"{place[0].upper()}{place[1:]}: the" if place else "The"
    return f"{start} studio ended at {when} with these changes:"


def difference_of(before: bytes, after: bytes) -> Lines:
    """Return how two texts differ, coloured."""
    from ..preview import difference

    return difference(before, after)
