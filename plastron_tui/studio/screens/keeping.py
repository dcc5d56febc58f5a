"""The journal: what was typed is kept while it is not saved, and offered after a crash."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, cast

from textual import work
from textual.timer import Timer

from ..files import open_file
from ..journal import Kept, kept_texts
from ..state import Open, opened
from .part import Part

if TYPE_CHECKING:
    from ..app import StudioApp
    from ..panels.tones import Lines

_KEEP = 0.5
"""Seconds after which what was typed is in the journal, at most."""


class Keeping(Part):
    """Keeps what is typed."""

    _keeping: Timer | None = None
    _journal_failed = False

    @property
    def _studio(self) -> StudioApp:
        return cast("StudioApp", self.app)

    def keep_soon(self) -> None:
        """Keep the text within half a second."""
        if self._keeping is None:
            self._keeping = self.set_timer(_KEEP, self._keep)

    def _keep(self) -> None:
        self._keeping = None
        if not self.open.is_changed:
            self.open.journal.drop()
            return
        self._write_journal(self.open, self.open.text, self.editor.cursor_offset)

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
    def _write_journal(self, open_: Open, text: bytes, cursor: int) -> None:
        error = open_.journal.write(text, cursor)
        if error is not None:
            self.app.call_from_thread(self._journal_refused, error)

    def _journal_refused(self, error: OSError) -> None:
        if not self._journal_failed:
            self._journal_failed = True
            reason = (error.strerror or str(error)).lower()
            self.notify(f"what you type is not kept: {reason}; save often", severity="warning",
                        markup=False)  # fmt: skip

    def offer_of(self, path: Path) -> None:
        """Offer what was typed in a file and not saved before the studio ended."""
        whole = path.absolute()
        for kept in kept_texts(self._studio.state_folder):
            if kept.path == whole and kept.file != self.open.journal.file:
                self.offer_kept(kept)
                return

    @work(exclusive=True, group="kept", description="kept")
    async def offer_kept(self, kept: Kept, after: str | None = None) -> None:
        """Offer a text that was not saved before the studio ended; then do an action."""
        await self._offer(kept)
        if after is not None:
            await self.run_action(after)

    async def _offer(self, kept: Kept) -> None:
        from datetime import datetime

        from .question import Question

        name = "a new program" if kept.path is None else kept.path.name
        found = None if kept.path is None else open_file(kept.path).disk
        before = b"" if found is None or found.text is None else found.text
        if before == kept.text:
            kept.drop()
            return
        when = datetime.fromtimestamp(kept.when).strftime("%H:%M on %d %B")
        answer = await self.app.push_screen_wait(
            Question(
                f"{name} was not saved",
                [("restore", "Restore"), ("later", "Later"), ("drop", "Forget it")],
                text=f"The studio ended at {when} with these changes:",
                lines=difference_of(before, kept.text),
            )
        )
        if answer == "drop":
            kept.drop()
        if answer != "restore":
            return
        if kept.path is None:
            folder, options = self._studio.state_folder, self.open.session.options
            self.take(opened(None, folder, options, kept.text), kept.cursor)
        elif not self.take_file(kept.path, kept=kept):
            return
        if kept.file != self.open.journal.file:
            self.call_after_refresh(partial(self._adopt, kept))

    def _adopt(self, kept: Kept) -> None:
        """Forget the old journal as soon as the new one is written."""
        if self.open.journal.write(self.open.text, kept.cursor) is None:
            kept.drop()


def difference_of(before: bytes, after: bytes) -> Lines:
    """Return how two texts differ, coloured."""
    from ..preview import difference

    return difference(before, after)
