"""What a panel is. Each is declared once, in a file of its own that `registry.py` names."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass
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


@dataclass(frozen=True, slots=True)
class Panel:
    """A panel: dock, key, menu, help, what is remembered and what is analysed follow from it.

    Attributes:
        name: the id of its widget and of the action that shows it.
        title: what its tab says.
        dock: where it is.
        keys: the keys that show it, by commas.
        summary: a sentence for the menu.
        about: what its help says.
        widget: its widget, a `ProgramView` where `make` is given.
        make: makes what it shows, of an analysis and of what its widget asked for; in the worker.
        count: how much is in it, for the tab; in the worker, after each edit.
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
    widget: type[Widget]
    make: Callable[[Analysis, Any], object] | None = None
    count: Callable[[Analysis], int] | None = None
    is_alarm: bool = False
    is_slow: bool = False
    is_kept: bool = True
