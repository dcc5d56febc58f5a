"""What lies over the main screen until it is answered."""

from __future__ import annotations

from pathlib import Path
from typing import ClassVar

from rich.cells import cell_len
from textual import events
from textual.await_complete import AwaitComplete
from textual.geometry import Size
from textual.screen import ModalScreen, ScreenResultType
from textual.types import CSSPathType

from ..textual_private import forget_removed_widgets

DIALOG_STYLES = Path(__file__).with_name("dialogs.tcss")
"""The colours and places of dialogs, which the app reads when the first one is opened."""

_ROOM = 9
"""Rows of a dialog besides its text and what it shows: frame, title, gaps, bar, answers, margin."""
_LOW = 18
"""With fewer rows dialogs have no gaps, and take the whole window if they need it."""


class Dialog(ModalScreen[ScreenResultType]):
    """A screen that gives one answer, however often it is pressed for."""

    CSS_PATH: ClassVar[CSSPathType | None] = DIALOG_STYLES

    def on_resize(self, event: events.Resize) -> None:
        """Spend nothing on gaps where the window is low."""
        self.set_class(is_low(event.size), "-low")

    def take_height(self, rows: int, text: str, size: Size) -> None:
        """Be as high as what is shown in it, or nearly as high as the window.

        Args:
            rows: how many rows are shown.
            text: the text above them.
            size: the window.
        """
        self.query_one("#dialog").set_class(is_tall(rows, text, size), "-tall")

    def dismiss(self, result: ScreenResultType | None = None) -> AwaitComplete:
        """Leave with an answer; Textual would take what lies on top, the main screen too."""
        if self.app.screen is not self:
            return AwaitComplete()
        return super().dismiss(result)

    def on_unmount(self) -> None:
        """Let go of its widgets."""
        forget_removed_widgets()


def is_low(size: Size) -> bool:
    """Tell whether a window has no rows for gaps."""
    return size.height < _LOW


def text_width(size: Size) -> int:
    """Return how many columns a dialog has for a text that is broken, in a window of a size."""
    return max(1, min(size.width * 9 // 10, 100) - 8)


def is_tall(rows: int, text: str, size: Size) -> bool:
    """Tell whether a dialog needs all the height that there is for a text and for some rows."""
    width = text_width(size)
    said = sum(1 + max(0, cell_len(line) - 1) // width for line in text.splitlines())
    return rows + said + _ROOM > size.height
