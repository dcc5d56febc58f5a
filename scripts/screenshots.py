"""Make the gallery, `docs/gallery.md`, and its pictures of the studio, from the running app.

python scripts/screenshots.py [NAME]...     takes all pictures, or those that are named

One of them shows nodes that run: it needs the ROS 2 of the extra `ros2`.
"""

from __future__ import annotations

import asyncio
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from textual.pilot import Pilot

from plastron_tui.studio.app import StudioApp

ROOT = Path(__file__).parents[1]
EXAMPLES = ROOT / "examples"
DOCS = ROOT / "docs"
LARGEST = 200_000
"""The most bytes of a picture."""


class Picture(NamedTuple):
    """A picture of the studio.

    Attributes:
        name: its file, without `.svg`.
        title: its heading in the gallery.
        about: what it shows, in a sentence or two.
        program: the example that is open, None for a new program.
        size: columns and rows.
        keys: what is pressed; words are keys, all else is typed.
        theme: the colours.
        seconds: how long to wait at the end.
    """

    name: str
    title: str
    about: str
    program: str | None
    size: tuple[int, int]
    keys: Sequence[str] = ()
    theme: str = "textual-dark"
    seconds: float = 0.8


class Drawing(NamedTuple):
    """A picture of what a program describes: its file, its heading, what it shows, the example."""

    name: str
    title: str
    about: str
    program: str


_OWN = "own_message.plastron"
_TALKER = "talker_listener.plastron"
_WIZARD = ["escape", "ctrl+u"]

PICTURES = (
    Picture(
        "studio-welcome", "Welcome",
        "What one begins with: the wizard, the tour, programs of late, and recipes, which are "
        "whole programs that work.",
        None, (100, 36),
    ),
    Picture(
        "studio", "Editor, nodes, preview",
        "The text, the nodes that it makes, and the file that the node at the cursor will become; "
        "all follow at every key.",
        "tour.plastron", (150, 40), ["down"] * 5,
    ),
    Picture(
        "studio-completion", "Completion",
        "What can stand at the cursor: words of the language, what the program has, every type of "
        "the ROS distribution with its fields.",
        _TALKER, (100, 26),
        ["ctrl+end", "subscribe talker to 'sonar' of message_type Ran"],
    ),
    Picture(
        "studio-problems", "Problems",
        "A mistake is underlined where it is, explained beside the line, and mended with one key.",
        _TALKER, (110, 30),
        ["ctrl+end", "unsubscribe listner from 'chatter'", "escape", "alt+7"], "nord",
    ),
    Picture(
        "studio-graph", "Graph",
        "Who sends what to whom.",
        "tour.plastron", (120, 34), ["alt+6", "ctrl+t"], "tokyo-night",
    ),
    Picture(
        "studio-wizard", "The wizard: what do you want?",
        "Words of purpose first, and the ROS word beside each.",
        None, (90, 26), _WIZARD,
    ),
    Picture(
        "studio-wizard-form", "The wizard: a form for a statement",
        "Every field has a suggestion. The statements grow below, beside them the graph and the "
        "file that they become.",
        None, (110, 32), [*_WIZARD, "enter", "enter", "enter"],
    ),
    Picture(
        "studio-wizard-type", "The wizard: types by what they are for",
        "Who does not know that a distance is a `Range` finds it by writing `distance`.",
        None, (110, 32),
        [*_WIZARD, "enter", "enter", "enter", "tab", "tab", "distance", "down"],
    ),
    Picture(
        "studio-wizard-library", "The wizard: Python or C++",
        "What each client library is for, and whether this machine has what its nodes are built "
        "with.",
        None, (110, 34), [*_WIZARD, "enter", "tab", "tab", "tab"],
    ),
    Picture(
        "studio-cpp", "A node in C++",
        "The source, its header where it has one, and the package that builds it.",
        "cpp_and_python.plastron", (150, 40), ["down"] * 8,
    ),
    Picture(
        "studio-generate", "Generate",
        "Each file that would be written, and what would change in it.",
        "tour.plastron", (110, 34), ["f6"], "dracula",
    ),
    Picture(
        "studio-run", "Run",
        "The nodes run in a panel, here on the ROS 2 that comes along.",
        _TALKER, (110, 30), ["f5"], seconds=5,
    ),
    Picture(
        "studio-change", "A node that somebody else wrote",
        "Only what the statements ask for changes; the preview is the difference.",
        "change_node.plastron", (150, 36), ["down"] * 8, "gruvbox",
    ),
    Picture(
        "studio-type", "A message of your own",
        "It is a line of the program; the preview is the package that builds it.",
        _OWN, (150, 36), ["down"],
    ),
    Picture(
        "studio-launch", "A launch file",
        "What it starts, and the file that `ros2 launch` takes.",
        _OWN, (150, 36), ["down"] * 11,
    ),
    Picture(
        "studio-package", "A package",
        "Everything that a workspace takes: manifest, build files, license, launch files, tests.",
        _OWN, (150, 40), ["ctrl+end", "up"],
    ),
    Picture(
        "studio-robot", "A robot",
        "Links and joints as a tree, and how the robot looks, drawn at every key; the part "
        "at the cursor stands out. It becomes a URDF file.",
        "rover.plastron", (120, 40), ["alt+l", *["down"] * 6],
    ),
    Picture(
        "studio-robot-wide", "A robot in a wide window",
        "Where there is room, all three views, in one scale.",
        "arm.plastron", (180, 40), ["alt+l", *["down"] * 4],
    ),
    Picture(
        "studio-wizard-robot", "The wizard: a part of a robot",
        "What it is like, and how large; the robot is drawn while one chooses.",
        "rover.plastron", (120, 40),
        ["ctrl+u", *["down"] * 6, "enter", "down", "down", "enter", "tab", "mast", "tab",
         "down", "tab", "0.03", "tab", "0.4", "tab"],
    ),
    Picture(
        "studio-light", "Light",
        "The editor follows the theme, of which there are twenty.",
        "tour.plastron", (150, 40), ["down"] * 15, "catppuccin-latte",
    ),
    Picture(
        "studio-narrow", "In a window of 80 by 24",
        "One panel beside the text; F7 goes through them.",
        "tour.plastron", (80, 24), ["down"] * 5,
    ),
)  # fmt: skip

DRAWINGS = (
    Drawing(
        "robot-rover", "A rover",
        "Its links and joints, and how it looks from three sides, with the axes of what turns.",
        "rover.plastron",
    ),
    Drawing(
        "robot-arm", "An arm", "Two joints with limits.", "arm.plastron",
    ),
)  # fmt: skip

# A picture asks nobody for a font: where there is none, any monospaced one will do.
_WEB_FONT = re.compile(r"\s*@font-face \{.*?\}", re.DOTALL)
_KEYS = {" ": "space", "_": "underscore", "'": "apostrophe"}
_KEY = re.compile(
    r"(?:(?:ctrl|alt|shift)\+)?(?:[a-z0-9]|end|f\d+)|escape|enter|tab|up|down|home|end"
)


async def take(picture: Picture, folder: Path, work: Path) -> None:
    """Run the studio, press the keys, and save what it shows."""
    app = StudioApp(None if picture.program is None else Path(picture.program))
    app.animation_level = "none"
    async with app.run_test(size=picture.size) as pilot:
        app.theme = picture.theme
        app.title = "plastron"
        await pilot.pause(0.8)
        for word in picture.keys:
            await press(pilot, word)
        await pilot.pause(picture.seconds)
        # Only what the program itself shows: no toast that comes and goes.
        app.clear_notifications()
        await pilot.pause(0.3)
        text = _WEB_FONT.sub("", app.export_screenshot())
    shutil.rmtree(work / "state", ignore_errors=True)
    size = len(text.encode())
    if size > LARGEST or str(work) in text:
        sys.exit(f"{picture.name}: {size} bytes, or a path of this machine")
    (folder / f"{picture.name}.svg").write_text(text, encoding="utf-8")


async def press(pilot: Pilot[None], word: str) -> None:
    """Press a key, or type a text."""
    keys = [word] if _KEY.fullmatch(word) else [_KEYS.get(each, each) for each in word]
    await pilot.press(*keys)
    await pilot.pause(0.3)


def draw(drawing: Drawing, folder: Path) -> None:
    """Have a picture drawn by the command line."""
    command = [sys.executable, "-m", "plastron_tui", "graph", "--format", "svg", drawing.program]
    done = subprocess.run(command, check=True, capture_output=True)
    (folder / f"{drawing.name}.svg").write_bytes(done.stdout)


def page() -> str:
    """Return the gallery."""
    parts = ["# Gallery\n\nThe studio, as `plastron` opens it in a terminal.\n"]
    parts += [
        f"## {each.title}\n\n{each.about}\n\n![{each.title}](images/{each.name}.svg)\n"
        for each in PICTURES
    ]
    parts.append("# Drawings\n\nWhat `plastron graph --format svg` draws.\n")
    parts += [
        f"## {each.title}\n\n{each.about}\n\n![{each.title}](images/{each.name}.svg)\n"
        for each in DRAWINGS
    ]
    return "\n".join(parts)


def main(names: Sequence[str]) -> None:
    """Take pictures, and write the page."""
    images = DOCS / "images"
    images.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory() as temporary:
        work = Path(temporary)
        os.environ.update(
            XDG_STATE_HOME=str(work / "state"),
            XDG_CONFIG_HOME=str(work / "config"),
            ROS_LOG_DIR=str(work / "log"),
            ROS_AUTOMATIC_DISCOVERY_RANGE="LOCALHOST",
        )
        for picture in PICTURES:
            if not names or picture.name in names:
                robot = work / "robot"
                shutil.rmtree(robot, ignore_errors=True)
                shutil.copytree(EXAMPLES, robot, ignore=shutil.ignore_patterns("output"))
                (robot / "plastron.yaml").write_text(
                    f"target: {'rospy' if picture.name == 'studio-change' else 'rclpy'}\n"
                )
                os.chdir(robot)
                asyncio.run(take(picture, images, work))
                print(picture.name)
        os.chdir(EXAMPLES)
        for drawing in DRAWINGS:
            if not names or drawing.name in names:
                draw(drawing, images)
                print(drawing.name)
        os.chdir(ROOT)
    (DOCS / "gallery.md").write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
