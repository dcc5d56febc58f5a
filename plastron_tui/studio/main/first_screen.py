"""The screen that an app starts with, without what Textual would do for nothing."""

from __future__ import annotations

from textual import events
from textual.geometry import Size
from textual.screen import Screen

from ..textual_private import leave_as_drawn


class FirstScreen(Screen[None]):
    """A screen that what is in it covers, and whose widgets have just been styled when it shows."""

    BLANK = True

    _was_shown = False
    _fitted: Size | None = None
    """The size that all was laid out for last."""

    def on_screen_resume(self, event: events.ScreenResume) -> None:
        """Style nothing again the first time: each widget was styled when it was mounted."""
        if not self._was_shown:
            event.refresh_styles = False
            self._was_shown = True
            if self.outer_size != self.app.size:
                # Textual's own handler, which follows, lays all out and draws it.
                self._fitted = self.app.size
                self.call_next(leave_as_drawn, self)

    def on_resize(self, event: events.Resize) -> None:
        """Lay nothing out again for the size that all was laid out for; others tell of it too."""
        if event.size == self._fitted:
            event.prevent_default()
        self._fitted = event.size
