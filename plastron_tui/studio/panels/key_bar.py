"""The line below everything: the keys that matter here. One widget, so that it costs nothing."""

from __future__ import annotations

from typing import ClassVar

from rich.cells import cell_len
from rich.segment import Segment
from textual import events
from textual.binding import Binding
from textual.screen import Screen
from textual.strip import Strip

from .styles import Toned


class KeyBar(Toned):
    """Shows the bindings of what has the focus, and does what is clicked."""

    COMPONENT_CLASSES: ClassVar[set[str]] = {"key-bar--key"}

    def __init__(self) -> None:
        super().__init__()
        self._shown: tuple[tuple[str, str, str], ...] = ()
        self._places: list[tuple[int, int, str]] = []

    def on_mount(self) -> None:
        """Follow the focus."""
        self.screen.bindings_updated_signal.subscribe(self, self._update)

    def _update(self, screen: Screen[object]) -> None:
        if not self.is_attached or screen is not self.screen or not screen.is_current:
            return
        shown: dict[str, tuple[Binding, str]] = {}
        for active in screen.active_bindings.values():
            binding = active.binding
            if binding.show and active.enabled:
                shown.setdefault(binding.action, (binding, binding.key))
        keys = tuple(
            (self.app.get_key_display(binding), binding.description, key)
            for binding, key in shown.values()
        )
        if keys != self._shown:
            self._shown = keys
            self.refresh()

    @property
    def text(self) -> str:
        """What the line says."""
        return "  ".join(f"{key} {title}" for key, title, _ in self._shown)

    def render_line(self, y: int) -> Strip:
        """Draw the line: as many keys as fit."""
        base, width = self.rich_style, self.size.width
        segments = [Segment(" ", base)]
        x = 1
        self._places = []
        for key, title, name in self._shown:
            size = cell_len(key) + cell_len(title) + 3
            if x + size - 2 > width:
                break
            segments.append(Segment(key, base + self.tone("key", "key-bar")))
            segments.append(Segment(f" {title}  ", base))
            self._places.append((x, x + size - 2, name))
            x += size
        return Strip(segments).adjust_cell_length(width, base)

    def on_click(self, event: events.Click) -> None:
        """Press the key that was clicked."""
        for start, end, key in self._places:
            if start <= event.x < end:
                self.app.simulate_key(key)
