"""What lies over the main screen until it is answered."""

from __future__ import annotations

from textual.await_complete import AwaitComplete
from textual.screen import ModalScreen, ScreenResultType

from ..textual_private import forget_removed_widgets


class Dialog(ModalScreen[ScreenResultType]):
    """A screen that gives one answer, however often it is pressed for."""

    def dismiss(self, result: ScreenResultType | None = None) -> AwaitComplete:
        """Leave with an answer.

        Textual would take away whatever lies on top, the main screen too.
        """
        if self.app.screen is not self:
            return AwaitComplete()
        return super().dismiss(result)

    def on_unmount(self) -> None:
        """Let go of its widgets."""
        forget_removed_widgets()
