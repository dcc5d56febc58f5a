"""What a panel is. Each is declared once, in a file of its own that `registry.py` names."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol, runtime_checkable

from textual.message import Message

if TYPE_CHECKING:
    from textual.widget import Widget

    from ..analysis import Analysis


class Resized(Message):
    """What a panel shows is to be made in another size."""


class Request(NamedTuple):
    """What a panel has to be given: the panel's name, and which of all that it can show."""

    panel: str
    what: Hashable


@runtime_checkable
class ProgramView(Protocol):
    """The widget of a panel that shows what the program means."""

    def request(self, analysis: Analysis | None, offset: int) -> Hashable:
        """Return what is to be made for it, None for nothing.

        Args:
            analysis: what the text meant last.
            offset: where the cursor is.
        """

    def show(self, content: Any) -> None:
        """Show what was made; None for nothing."""

    def follow(self, offset: int) -> object:
        """Light what the statement at an offset is about."""


@dataclass(frozen=True, slots=True, eq=False)
class Panel:
    """A panel: dock, key, menu, help, what is remembered and what is analysed follow from it.

    Attributes:
        name: the id of its widget and of the action that shows it.
        title: what its tab says.
        short: what it says where there is little room; "" for the same.
        dock: where it is.
        keys: the keys that show it, by commas.
        summary: a sentence for the menu.
        about: what its help says.
        widget: the class of its widget, as `module:Class` in this folder; a `ProgramView` where
            there is a maker.
        maker: the module in this folder whose `make` makes what it shows, of an analysis and of
            what its widget asked for; "" where nothing is made.
        is_counted: whether its tab says how much is in it, as the maker's `count` has it.
        is_alarm: whether it is about what is wrong: then it is made unseen, and the count is red.
        is_slow: whether all others are shown before it is made.
        is_kept: whether it is in front at the next start if it was at the end: it has something
            to show then.
    """

    name: str
    title: str
    dock: Literal["outline", "result", "bottom"]
    keys: str
    summary: str
    about: str
    widget: str
    maker: str = ""
    is_counted: bool = False
    is_alarm: bool = False
    is_slow: bool = False
    is_kept: bool = True
    short: str = ""

    @property
    def widget_class(self) -> type[Widget]:
        """The class of its widget, imported when it is first asked for."""
        module, _, name = self.widget.partition(":")
        found: type[Widget] = getattr(import_module(f".{module}", __package__), name)
        return found

    def make(self, analysis: Analysis, what: Any) -> object:
        """Make what its widget asked for; in the worker."""
        return import_module(f".{self.maker}", __package__).make(analysis, what)

    def count(self, analysis: Analysis) -> int:
        """Return how much is in it; in the worker, after each edit."""
        number: int = import_module(f".{self.maker}", __package__).count(analysis)
        return number


class PanelWidgets(Mapping[str, "Widget"]):
    """The widgets of panels by the panels' names, each made when it is first asked for."""

    def __init__(self, panels: Iterable[Panel]) -> None:
        self._panels = {panel.name: panel for panel in panels}
        self.made: dict[str, Widget] = {}
        """Those that were asked for so far."""

    def __getitem__(self, name: str) -> Widget:
        if name not in self.made:
            self.made[name] = self._panels[name].widget_class(id=name)
        return self.made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._panels)

    def __len__(self) -> int:
        return len(self._panels)
