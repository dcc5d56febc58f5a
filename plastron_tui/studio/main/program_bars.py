"""The line above everything, and the one about the statement at the cursor."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from rich.cells import cell_len
from textual.widget import Widget

from ..editor import ProgramEditor
from ..open_program import Open
from ..panels.bars import Bar, help_pieces

if TYPE_CHECKING:
    from collections.abc import Callable

    from plastron_tui.project.ros_choice import RosChoice

OLDER = "running an older text"
"""What is said of nodes that run, and whose program says something else by now."""

Pieces = tuple[tuple[str, str], ...]


class Title(NamedTuple):
    """What the line above everything says.

    Attributes:
        name: the program's name.
        is_changed: whether it is not saved.
        folder: the folder that it is in, "" for a new program.
        ros: the client library of nodes that name none, and the ROS that it is for.
        library: that library alone.
        stage: how far the nodes are that run, "" where none do.
        stop_key: the key that stops them.
        anew_key: the key that starts them anew where they are older than the text, else "".
    """

    name: str
    is_changed: bool
    folder: str
    ros: str
    library: str
    stage: str
    stop_key: str
    anew_key: str = ""

    def pieces(self, width: int) -> tuple[Pieces, Pieces]:
        """Return the left and the right side: what matters less goes first where room is short."""
        sides = [self._sides(*each) for each in _TITLES]
        return next((each for each in sides if _cells(each) <= width), sides[-1])

    def _sides(self, brand: str, folder: bool, stops: bool, is_full: bool) -> tuple[Pieces, Pieces]:
        sign = " ● " if self.is_changed else "   "
        left = ((brand, "quiet"), (self.name, "strong"), (sign, "here"))
        running = self.stage and f"{self.stage}  "
        if running and stops and self.stop_key:
            anew = f", {self.anew_key} runs anew" if self.anew_key else ""
            running = f"{self.stage}: {self.stop_key} stops{anew}  "
        shown_folder = f"{self.folder}/  " if folder and self.folder else ""
        ros = self.ros if is_full else self.library
        return left, ((running, "here"), (shown_folder, "quiet"), (ros, "quiet"))


_TITLES = (
    ("plastron ", True, True, True),
    ("", True, True, True),
    ("", False, True, True),
    ("", False, True, False),
    ("", False, False, False),
)
"""How the title is written, the roomiest first: brand, folder, how to stop, the ROS in full."""


def _cells(sides: tuple[Pieces, Pieces]) -> int:
    """Return the cells of both sides, with one at each end."""
    return 2 + sum(cell_len(text) for side in sides for text, _ in side)


class TitleBar(Bar):
    """The program's name, and what is the case with it."""

    _title: Title | None = None

    def show_program(
        self, open_: Open, ros: RosChoice | None, stage: str, key_of: Callable[[str], str]
    ) -> None:
        """Show a program, whether it is saved, its ROS if that is known by now.

        Where nodes run, how far they are, and the keys that stop them or start them anew as well.
        """
        words, library = ("", "") if ros is None else (ros.words, ros.library)
        folder = "" if open_.path is None else open_.path.absolute().parent.name
        keys = key_of("run"), key_of("run_anew") if stage == OLDER else ""
        self._title = Title(
            open_.name, open_.is_changed, folder, words, library, stage, *keys
        )  # fmt: skip
        self.on_resize()

    def on_resize(self) -> None:
        """Say as much as there is room for."""
        if self._title is not None:
            self.show(*self._title.pieces(self.app.size.width))


def status_of(focused: Widget | None, editor: ProgramEditor) -> str:
    """Return what is said about what has the focus.

    Of the text that is the sentence of the statement at the cursor, of a panel its `hint`, if it
    has one.
    """
    if focused is None or editor in focused.ancestors_with_self:
        return editor.statement_help
    return str(getattr(focused, "hint", ""))


class StatusBar(Bar):
    """What is said about what has the focus, and where the cursor is in the text."""

    def show_place(self, said: str, text: bytes, offset: int) -> None:
        """Show a line, such as the sentence of a statement, and the place of an offset."""
        line_start = text.rfind(b"\n", 0, offset) + 1
        row = text.count(b"\n", 0, offset) + 1
        column = len(text[line_start:offset].decode("utf-8", "replace")) + 1
        self.show(help_pieces(said), ((f"{row}:{column}", "quiet"),))
