"""Help for what has the focus, its keys at the side, and the menu of all actions."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from typing import TYPE_CHECKING

from textual.screen import Screen

from ..actions import ACTIONS, Action, grouped
from ..config import Remembered
from ..panels.dock import Dock
from ..panels.styles import Lines
from .dock_layout import DockLayout

if TYPE_CHECKING:
    from ..program_names import ProgramName


def show_help(screen: Screen[None], panels: Collection[str], key_of: Callable[[str], str]) -> None:
    """Show help for what has the focus.

    Args:
        screen: the main screen.
        panels: the ids of the panels.
        key_of: returns the key of an action.
    """
    from ..screens.help import Help

    around = [] if screen.focused is None else screen.focused.ancestors_with_self
    part = next((each.id for each in around if each.id in panels), None)
    actions = {action.id: key_of(action.id) for action in ACTIONS}
    screen.app.push_screen(Help(part or "editor", _panel_keys(screen), actions))


def _panel_keys(screen: Screen[None]) -> list[tuple[str, str]]:
    """Return the keys of the panel with the focus, each with what it does."""
    rows: dict[str, list[str]] = {}
    for active in screen.active_bindings.values():
        binding = active.binding
        if any(isinstance(each, Dock) for each in active.node.ancestors_with_self):
            key = screen.app.get_key_display(binding)
            rows.setdefault(binding.tooltip or binding.description, []).append(key)
    return [(" ".join(keys), what) for what, keys in rows.items()]


def toggle_keys(screen: Screen[None], layout: DockLayout, key_of: Callable[[str], str]) -> None:
    """Show the keys of what has the focus at the side, or take them away."""
    if layout.side is not None:
        layout.put_at_side(None)
        return
    from ..panels.key_list import KeyList, key_lines

    def lines() -> Lines:
        groups = [(group, [(key_of(each.id), each.title) for each in actions])
                  for group, actions in grouped()]  # fmt: skip
        return key_lines([("Here", _panel_keys(screen)), *groups])

    layout.put_at_side(KeyList(lines, key_of("keys")))


async def choose_action(
    screen: Screen[None],
    remembered: Remembered,
    key_of: Callable[[str], str],
    names: Sequence[ProgramName],
    query: str,
) -> Action | ProgramName | None:
    """Offer all actions, those of late first, and names; return what is chosen."""
    from ..screens.menu import ActionMenu

    menu = ActionMenu(remembered.actions, key_of, names, query)
    chosen = await screen.app.push_screen_wait(menu)
    if isinstance(chosen, Action):
        remembered.did(chosen.id)
    return chosen
