"""The keys of the panel that has the focus."""

from __future__ import annotations

from textual.screen import Screen

from ..panels.dock import Dock


def panel_keys(screen: Screen[None]) -> list[tuple[str, str]]:
    """Return the keys of the panel with the focus, each with what it does."""
    rows: dict[str, list[str]] = {}
    for active in screen.active_bindings.values():
        binding = active.binding
        if any(isinstance(each, Dock) for each in active.node.ancestors_with_self):
            key = screen.app.get_key_display(binding)
            rows.setdefault(binding.tooltip or binding.description, []).append(key)
    return [(" ".join(keys), what) for what, keys in rows.items()]
