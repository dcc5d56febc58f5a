"""What lies over the main screen until it is answered."""

from __future__ import annotations

from pathlib import Path
from typing import ClassVar

from textual import events
from textual.await_complete import AwaitComplete
from textual.screen import ModalScreen, ScreenResultType
from textual.types import CSSPathType

from ..textual_private import forget_removed_widgets

DIALOG_STYLES = Path(__file__).with_name("dialogs.tcss")
"""The colours and places of dialogs, which the app reads when the first one is opened."""

_LOW = 18
"""With fewer rows dialogs have no gaps, and take the whole window if they need it."""


class Dialog(ModalScreen[ScreenResultType]):
    """A screen that gives one answer, however often it is pressed for."""

    CSS_PATH: ClassVar[CSSPathType | None] = DIALOG_STYLES

    def on_resize(self, event: events.Resize) -> None:
        """Spend nothing on gaps where the window is low."""
        self.set_class(event.size.height < _LOW, "-low")

    def dismiss(self, result: ScreenResultType | None = None) -> AwaitComplete:
        """Leave with an answer; Textual would take what lies on top, the main screen too."""
        if self.app.screen is not self:
            return AwaitComplete()
        return super().dismiss(result)

    def on_unmount(self) -> None:
        """Let go of its widgets."""
        forget_removed_widgets()
