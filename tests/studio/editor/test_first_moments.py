"""What is asked of the editor before all of it is there."""

from __future__ import annotations

import pytest
from editor_host import editing
from idle_loop import until
from textual.app import App, ComposeResult
from textual.strip import Strip

from plastron_tui.session import Session
from plastron_tui.studio.editor import ProgramEditor


class _App(App[None]):
    """Asks for a bar as soon as there is an editor."""

    def __init__(self, action: str) -> None:
        super().__init__()
        self.editor = ProgramEditor(Session(b"n stop_service 'a'\n", environ={}))
        self.action = action

    def compose(self) -> ComposeResult:
        yield self.editor

    def on_mount(self) -> None:
        self.editor.call_later(self.editor.action_edit, self.action)


async def test_the_first_frame_has_whole_lines() -> None:
    app = _App("find")
    view = app.editor.view
    drawn: list[str] = []
    draw = view.render_line

    def render_line(y: int) -> Strip:
        strip = draw(y)
        drawn.append(strip.text)
        return strip

    view.soft_wrap = True
    view.render_line = render_line  # type: ignore[method-assign]
    async with app.run_test() as pilot:
        await until(pilot, lambda: drawn)
    assert "n stop_service 'a'" in drawn[0]
    assert not any("↪" in line for line in drawn)


@pytest.mark.parametrize("action", ["find", "replace", "go_to_line", "rename"])
async def test_a_bar_can_be_asked_for_before_it_is_made(action: str) -> None:
    app = _App(action)
    async with app.run_test() as pilot:
        editor = app.editor
        bar = editor.find_bar if action in ("find", "replace") else editor.prompt_bar
        await until(pilot, lambda: bar.has_focus_within)
        assert bar.display
        await pilot.press("x")
        assert editor.text == b"n stop_service 'a'\n"


@pytest.mark.parametrize(("key", "offered"), [("", ["talker"]), ("x", []), ("left", [])])
async def test_names_that_are_not_known_yet_are_offered_as_soon_as_they_are(
    key: str, offered: list[str]
) -> None:
    async with editing("create_node 'talker' as talker\n\ntalker publish m to 'a'\n") as driver:
        editor = driver.editor
        editor.completer.waits = True
        editor.go_to(editor.text.index(b"\n\n") + 1)
        await driver.type("tal")
        assert not editor.popup.is_open
        if key:
            await driver.press(key)
        editor.set_diagnostics([])
        assert [each.text for each in editor.popup.candidates] == offered
