"""A program editor alone in an app, of a fixed size."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from idle_loop import until
from textual.app import App, ComposeResult
from textual.pilot import Pilot

from plastron_tui.session import Session
from plastron_tui.studio.editor import ProgramEditor

PROGRAM = """\
create_node 'talker' as talker
create_message hello of message_type String and input "hello"
talker publish hello to 'chatter' of message_type String
"""

NAMES = {" ": "space", "'": "apostrophe", "_": "underscore", "/": "slash", ".": "full_stop"}
NAMES |= {",": "comma", "=": "equals_sign", "(": "left_parenthesis", ")": "right_parenthesis"}
NAMES |= {'"': "quotation_mark", "[": "left_square_bracket", "]": "right_square_bracket"}
NAMES |= {"*": "asterisk", "\n": "enter"}


class Host(App[None]):
    def __init__(self, text: str) -> None:
        super().__init__()
        self.editor = ProgramEditor(Session(text.encode(), environ={}))
        self.changes = 0
        self.places: list[int] = []
        self.said: list[str] = []

    def compose(self) -> ComposeResult:
        yield self.editor

    def on_mount(self) -> None:
        self.editor.focus()

    def on_program_editor_changed(self) -> None:
        self.changes += 1

    def on_program_editor_cursor_moved(self, message: ProgramEditor.CursorMoved) -> None:
        self.places.append(message.offset)

    def notify(self, message: str, **_: object) -> None:  # type: ignore[override]
        self.said.append(message)


class Driver:
    """Types into an editor."""

    def __init__(self, app: Host, pilot: Pilot[None]) -> None:
        self.app = app
        self.editor = app.editor
        self.pilot = pilot

    async def press(self, *keys: str) -> None:
        await self.pilot.press(*keys)
        await self.pilot.pause()

    async def type(self, text: str) -> None:
        await self.press(*(NAMES.get(character, character) for character in text))

    async def understand(self) -> None:
        """Do what the app does when no key comes."""
        self.editor.set_diagnostics(self.editor.session.diagnostics)
        await self.pilot.pause()

    async def until(self, condition: Callable[[], object]) -> None:
        await until(self.pilot, condition)

    @property
    def marked(self) -> str:
        """The text with the selection in brackets."""
        text, selection = self.editor.text, self.editor.selection
        start, end = selection.start, selection.end
        return (text[:start] + b"[" + text[start:end] + b"]" + text[end:]).decode()

    @property
    def lines(self) -> list[str]:
        """What stands on the screen."""
        view = self.editor.view
        return [view.render_line(y).text.rstrip() for y in range(view.size.height)]


@asynccontextmanager
async def editing(
    text: str, cursor: int = 0, size: tuple[int, int] = (80, 24)
) -> AsyncIterator[Driver]:
    app = Host(text)
    async with app.run_test(size=size) as pilot:
        driver = Driver(app, pilot)
        driver.editor.go_to(cursor)
        await pilot.pause()
        yield driver
