from __future__ import annotations

import os
from collections.abc import AsyncIterator, Callable, Iterable, Sequence
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from drawn_screens import draw
from idle_loop import until
from machine import mostly_long
from textual import events
from textual.pilot import Pilot
from textual.widgets import Label

from plastron_tui.session import Options
from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.journal import Journal
from plastron_tui.studio.key_order import Unread
from plastron_tui.studio.main.screen import MainScreen
from plastron_tui.user_folders import state_folder

PROGRAM = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String
generate_node talker

create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
generate_node listener
"""

SIZES = mostly_long([(80, 24), (120, 40)], [(80, 24)])

KEYS = {"\n": "enter", " ": "space", "/": "slash", "'": "apostrophe", "_": "underscore"}
"""How Textual calls keys that no letter or digit is on."""


def fail(*_: object) -> None:
    """Stand for something of Plastron's own that has a mistake in it."""
    raise RuntimeError("a deliberate error")


def leave_behind(path: Path | None, text: str, folder: Path | None = None, cursor: int = 0) -> Path:
    """Leave a journal as a studio does that was killed; the folder is that of a new program."""
    journal = Journal(state_folder() / "journal", path, folder)
    # The process that tests is the one that finds it.
    journal.file = journal.file.with_stem(f"{journal.file.stem}-{os.urandom(4).hex()}")
    assert journal.write(text.encode(), cursor) is None
    return journal.file


class Driver:
    """A studio that runs headless, and what tests ask of it."""

    def __init__(self, app: StudioApp, pilot: Pilot[None]) -> None:
        self.app = app
        self.pilot = pilot
        self._said: list[str] = []
        self._notify = app.notify
        app.notify = self._hear  # type: ignore[method-assign]

    def _hear(self, message: str, **options: Any) -> None:
        self._said.append(message)
        self._notify(message, **options)

    @property
    def main(self) -> MainScreen:
        return self.app.main

    @property
    def text(self) -> str:
        return self.main.editor.text.decode()

    async def press(self, *keys: str) -> None:
        for key in keys:
            await self.pilot.press(key)
        await self.settle()

    async def show(self, panel: str) -> None:
        """Show a panel, and wait until it has its entries: a key would find none before."""
        self.main.action_show(panel)
        await self.settle()

    async def type(self, text: str) -> None:
        self.send(text)
        await self.all_in()
        await self.settle()

    def send(self, keys: Iterable[str]) -> None:
        """Press keys faster than it is looked at: what they lead to is shown once, for all."""
        for key in keys:
            name = KEYS.get(key, key)
            is_character = len(key) == 1 and key != "\n"
            self.app.post_message(events.Key(name, key if is_character else None))

    async def all_in(self) -> None:
        """Wait until no key waits for another one."""
        app = self.app
        await self.until(
            lambda: not app._waiting and (not app._keys_worker or app._keys_worker.is_finished)
        )

    async def settle(self) -> None:
        """Wait until what the text means is known and shown."""
        try:
            await self.until(lambda: not self.is_missing)
        except AssertionError as error:
            raise AssertionError(f"{error}: {self.is_missing}") from None
        # As after a second without a key.
        self.main.feed.held_back.rest()
        await self.pilot.pause()

    @property
    def is_missing(self) -> str:
        """What is not yet known, or not shown, of what the text means; empty where nothing is."""
        main = self.main
        analysis = main.open.analysis
        if main.feed.is_pausing:
            return "a pause in typing"
        if not main.feed.worker.is_idle:
            return "an answer"
        if analysis is None or analysis.text != main.open.text:
            return "an analysis of this text"
        if analysis.session.library != main.open.session.library:
            return "an analysis for this library"
        missing = [request for request in main.feed.wanted() if request not in analysis.made]
        return str(missing) if missing else ""

    async def until(self, condition: Callable[[], bool]) -> None:
        await until(self.pilot, condition)

    async def dialog(self, name: str) -> Any:
        """Wait for a dialog, by the name of its class; a question hears keys then."""
        await self.until(lambda: type(self.app.screen).__name__ == name)
        await self.pilot.pause()
        if isinstance(self.app.screen, Unread):
            await self.until(lambda: self.app.screen.appeared is not None)
        return self.app.screen

    async def failure(self, text: bytes) -> Any:
        """Wait until a deliberate error is said, with the place where the text is kept."""
        dialog = await self.dialog("Failure")
        assert "a deliberate error" in dialog.report
        said = str(dialog.query_one("#dialog-text", Label).content)
        journal = self.main.open.journal.file
        assert str(journal) in said
        assert journal.read_bytes().endswith(text)
        return dialog

    async def back(self) -> None:
        """Wait until the main screen is in front again."""
        await self.until(lambda: self.app.screen is self.main)
        await self.settle()

    def shown(self, name: str) -> list[str]:
        """Return the lines of a panel of entries, as one reads them."""
        panel = self.main.panels[name]
        return [
            " ".join(part for part in (entry.sign, entry.text, entry.detail, entry.warning) if part)
            for entry in panel._shown
        ]

    def notes(self) -> str:
        """Return what was said in the corner, also what has gone from there."""
        before = [note.message for note in self.app._notifications]
        return "\n".join([*(note for note in before if note not in self._said), *self._said])


@asynccontextmanager
async def studio(
    path: Path | None,
    size: tuple[int, int] = (120, 40),
    *,
    welcome: bool = False,
    options: Options | None = None,
    others: Sequence[Path] = (),
) -> AsyncIterator[Driver]:
    """Run the studio; without a file it is past the welcome, unless that is what is tested."""
    app = StudioApp(path, options, others=others)
    app.animation_level = "none"
    async with app.run_test(size=size) as pilot:
        driver = Driver(app, pilot)
        main = driver.main
        if path is None and not welcome:
            await driver.dialog("Welcome")
            await pilot.press("escape")
        if not welcome:
            await driver.back()
        yield driver
        draw(app)
    main.feed.worker.join(5)
