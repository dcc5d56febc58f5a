"""The line below everything: the keys that matter here. One widget, so that it costs nothing."""

from __future__ import annotations

from collections.abc import Collection, Container, Mapping, Sequence
from typing import ClassVar, NamedTuple

from rich.cells import cell_len
from rich.segment import Segment
from textual import events
from textual.binding import Binding
from textual.screen import Screen
from textual.strip import Strip

from .dock import Dock
from .styles import Toned

_GAP = 2
"""The cells between two keys."""


class Key(NamedTuple):
    """A key of the line: what it is called, what it does, as Textual writes it, and its id."""

    name: str
    title: str
    key: str
    id: str

    @property
    def width(self) -> int:
        """The cells that it takes, without the gap behind it."""
        return cell_len(self.name) + 1 + cell_len(self.title)


def fitting(keys: Sequence[Key], kept: Container[str], width: int) -> list[Key]:
    """Return the keys that fit, in their order: those that are `kept` before any other.

    Args:
        keys: the keys, by importance.
        kept: the ids of those that are to be there however narrow the line is.
        width: its cells.
    """
    room = width - 1 + _GAP
    chosen = set()
    for is_kept in (True, False):
        for at, key in enumerate(keys):
            if (key.id in kept) is is_kept and key.width + _GAP <= room:
                chosen.add(at)
                room -= key.width + _GAP
    return [key for at, key in enumerate(keys) if at in chosen]


class KeyBar(Toned):
    """Shows the bindings of what has the focus, and does what is clicked."""

    COMPONENT_CLASSES: ClassVar[set[str]] = {"key-bar--key"}

    def __init__(self, kept: Container[str] = frozenset(), order: Sequence[str] = ()) -> None:
        """Make the line.

        Args:
            kept: the ids of bindings that are to be there however narrow the line is.
            order: the ids of bindings that come last, whatever their keys are, in their order.
        """
        super().__init__()
        self._kept = kept
        self._ranks = {id_: rank for rank, id_ in enumerate(order)}
        self._shown: tuple[Key, ...] = ()
        self._is_old = False
        self._titles: Mapping[str, str] = {}
        self._added: Collection[str] = ()
        self._kept_now: Collection[str] = ()
        self._places: list[tuple[int, int, str]] = []

    def on_mount(self) -> None:
        """Follow the focus."""
        self.screen.bindings_updated_signal.subscribe(self, self._update)

    def retitle(self, titles: Mapping[str, str], added: Collection[str] = ()) -> None:
        """Call bindings, by their ids, otherwise than they are declared for now.

        Args:
            titles: what they are called.
            added: the ids of those that are shown as well for now, while no panel has the focus.
        """
        if (titles, added) != (self._titles, self._added):
            self._titles, self._added = titles, added
            self._update(self.screen)

    def _update(self, screen: Screen[object]) -> None:
        """Look at the bindings again, once however often they have changed by then."""
        if not self._is_old and self.is_attached and screen is self.screen and screen.is_current:
            self._is_old = True
            self.call_later(self._renew)

    def _renew(self) -> None:
        """Show the bindings, if they have changed since they were looked at."""
        if not self._is_old:
            return
        self._is_old = False
        if not self.is_attached or not self.screen.is_current:
            return
        focused = self.screen.focused
        around = () if focused is None else focused.ancestors_with_self
        self._kept_now = () if any(isinstance(each, Dock) for each in around) else self._added
        titles = {**self._titles, **getattr(focused, "key_titles", {})}
        shown: dict[str, Binding] = {}
        for active in self.screen.active_bindings.values():
            binding = active.binding
            if (binding.show or binding.id in self._kept_now) and active.enabled:
                shown.setdefault(binding.action, binding)
        keys = tuple(
            Key(
                self.app.get_key_display(each),
                titles.get(each.id or "", each.description),
                each.key,
                each.id or "",
            )
            for each in sorted(shown.values(), key=self._rank)
        )
        if keys != self._shown:
            self._shown = keys
            self.refresh()

    def _rank(self, binding: Binding) -> int:
        """Return where a binding comes: Textual puts those with other keys behind all the rest."""
        return self._ranks.get(binding.id or "", -1)

    @property
    def text(self) -> str:
        """What the line says."""
        return "  ".join(f"{each.name} {each.title}" for each in self._fitting)

    @property
    def _fitting(self) -> list[Key]:
        self._renew()
        kept = [
            each.id for each in self._shown if each.id in self._kept or each.id in self._kept_now
        ]
        return fitting(self._shown, kept, self.size.width)

    def render_line(self, y: int) -> Strip:
        """Draw the line: as many keys as fit."""
        base, width = self.rich_style, self.size.width
        segments = [Segment(" ", base)]
        x = 1
        self._places = []
        for each in self._fitting:
            segments.append(Segment(each.name, base + self.tone("key", "key-bar")))
            segments.append(Segment(f" {each.title}{' ' * _GAP}", base))
            self._places.append((x, x + each.width, each.key))
            x += each.width + _GAP
        return Strip(segments).adjust_cell_length(width, base)

    def on_click(self, event: events.Click) -> None:
        """Press the key that was clicked."""
        for start, end, key in self._places:
            if start <= event.x < end:
                self.app.simulate_key(key)
