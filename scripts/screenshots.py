"""Make the pictures of the studio in `docs/images/`, from the running app.

Usage: python scripts/screenshots.py [FOLDER]
"""

from __future__ import annotations

import asyncio
import os
import re
import shutil
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from plastron_tui.studio.app import StudioApp

ROOT = Path(__file__).parents[1]
EXAMPLES = ROOT / "examples"


class Picture(NamedTuple):
    """A picture: its name, the program, the size in cells, the keys, and the theme."""

    name: str
    program: str | None
    size: tuple[int, int]
    keys: Sequence[str] = ()
    theme: str = "textual-dark"


PICTURES = (
    Picture("studio", "tour.plastron", (150, 42), ["down"] * 5),
    Picture("studio-narrow", "tour.plastron", (80, 24), ["down"] * 5),
    Picture("studio-light", "tour.plastron", (150, 42), ["down"] * 15, "catppuccin-latte"),
    Picture("studio-graph", "tour.plastron", (120, 36), ["alt+6", "ctrl+t"], "tokyo-night"),
    Picture(
        "studio-problems",
        "talker_listener.plastron",
        (110, 30),
        ["ctrl+end", *"unsubscribe listner", "escape", "f8", "alt+7"],
        "nord",
    ),
    Picture(
        "studio-completion",
        "talker_listener.plastron",
        (110, 30),
        ["ctrl+end", *"subscribe talker to 'sonar' of message_type Ran"],
    ),
    Picture("studio-change", "change_node.plastron", (150, 36), ["down"] * 6, "gruvbox"),
    Picture("studio-generate", "tour.plastron", (110, 34), ["f6"], "dracula"),
    Picture("studio-welcome", None, (100, 30)),
)
# A picture asks nobody for a font: where there is none, any monospaced one will do.
_WEB_FONT = re.compile(r"\s*@font-face \{.*?\}", re.DOTALL)
_KEYS = {" ": "space", "_": "underscore", "'": "apostrophe"}


async def take(picture: Picture, folder: Path, work: Path) -> None:
    """Run the studio, press the keys, and save what it shows."""
    os.environ.update(
        XDG_STATE_HOME=str(work / "state"), XDG_CONFIG_HOME=str(work / "config"), ROS_VERSION="1"
    )
    app = StudioApp(None if picture.program is None else Path(picture.program))
    app.animation_level = "none"
    async with app.run_test(size=picture.size) as pilot:
        app.theme = picture.theme
        app.title = "plastron"
        await pilot.pause(0.8)
        for key in picture.keys:
            await pilot.press(_KEYS.get(key, key))
            if len(key) > 1:
                await pilot.pause(0.2)
        await pilot.pause(0.8)
        picture_text = _WEB_FONT.sub("", app.export_screenshot())
        (folder / f"{picture.name}.svg").write_text(picture_text, encoding="utf-8")
    shutil.rmtree(work / "state", ignore_errors=True)


def main(folder: Path) -> None:
    """Take all pictures."""
    folder.mkdir(parents=True, exist_ok=True)
    folder = folder.absolute()
    with TemporaryDirectory() as temporary:
        work = Path(temporary)
        shutil.copytree(EXAMPLES, work / "robot", ignore=shutil.ignore_patterns("output"))
        os.chdir(work / "robot")
        for picture in PICTURES:
            asyncio.run(take(picture, folder, work))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "images")
