"""Pictures of whole screens, compared to the letter with those that are committed.

After a change that is meant, `PLASTRON_SNAPSHOTS=write ./dev test tests/studio/test_snapshots.py`
writes them anew; they are SVG, and any browser shows what has changed.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import pytest
from studio_driver import PROGRAM, Driver, studio
from textual.widgets import Input

FOLDER = Path(__file__).parent / "snapshots"

MISTAKES = """\
create_node 'talker' as talker
create_message corner of message_type Point and input x="one", y=2.5, w=3
talkr publish corner to 'corners' of message_type Point // one letter is missing
subscribe talker to 'pose' of message_type Pos
generate_node talker
"""
BRANCHES = (
    PROGRAM
    + """
listener provides_service 'mute' of service_type SetBool
create_node 'switch' as switch
switch client_requests 'mute' of service_type SetBool with input True
generate_node switch
"""
)


class Scene(NamedTuple):
    """A picture: the program, the size, the keys, and the dialog that they open, if they do."""

    name: str
    program: str
    size: tuple[int, int]
    keys: Sequence[str] = ()
    theme: str = "textual-dark"
    dialog: str | None = None


SCENES = (
    Scene("mistakes", MISTAKES, (80, 24), ["down", "f8"]),
    Scene(
        "completion",
        PROGRAM,
        (80, 24),
        ["ctrl+end", *"subscribe talker to 'sonar' of message_type Ran"],
    ),
    Scene("nodes", BRANCHES, (120, 40), ["alt+1", "down", "down"]),
    Scene("graph", BRANCHES, (120, 40), ["alt+6", "ctrl+t"]),
    Scene("light", MISTAKES, (120, 40), ["ctrl+f", *"talk"], "textual-light"),
    Scene("generate", BRANCHES, (80, 24), ["f6"], dialog="GenerateDialog"),
)

_NAMES = {" ": "space", "_": "underscore", "'": "apostrophe"}
_CLIP = re.compile(r'<clipPath id="terminal-line-\d+">.*?</clipPath>\s*', re.DOTALL)
_FONT = re.compile(r"\s*@font-face \{.*?\}", re.DOTALL)


def picture(driver: Driver) -> str:
    """Return what is on the screen, without what is another number each time, or never seen."""
    svg = re.sub(r"terminal-\d+-", "terminal-", driver.app.export_screenshot())
    svg = re.sub(r' clip-path="url\(#terminal-line-\d+\)"', "", svg)
    return _CLIP.sub("", _FONT.sub("", svg)).rstrip() + "\n"


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.name)
async def test_a_screen_looks_as_before(
    scene: Scene, program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Input, "cursor_blink", False)
    monkeypatch.chdir(program.parent)
    program.write_text(scene.program)
    async with studio(Path(program.name), scene.size) as driver:
        driver.app.theme = scene.theme
        for key in scene.keys:
            await driver.pilot.press(_NAMES.get(key, key))
        if scene.dialog is not None:
            await driver.dialog(scene.dialog)
        else:
            await driver.settle()
        await driver.until(lambda: not driver.main.editor._settle.is_waiting)
        # Textual reckons with the gutter of the other bar in one of two places that set the room
        # of a bar, and which comes last depends on the machine.
        view = driver.main.editor.view
        view._scroll_update(view.virtual_size)
        await driver.pilot.pause()
        shown = picture(driver)
    file = FOLDER / f"{scene.name}.svg"
    if os.environ.get("PLASTRON_SNAPSHOTS") == "write":
        file.write_text(shown, encoding="utf-8")
    if not file.exists() or file.read_text(encoding="utf-8") != shown:
        new = tmp_path / file.name
        new.write_text(shown, encoding="utf-8")
        pytest.fail(f"{new} does not look like {file}", pytrace=False)
