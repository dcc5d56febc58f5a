"""Two minutes around the screen: a few steps, each about one part of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, NamedTuple

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.css.types import AlignHorizontal, AlignVertical
from textual.geometry import Region
from textual.widgets import Label

from .dialog import Dialog


class Step(NamedTuple):
    """A step: what it is called, what is said, and the panel that it is about."""

    title: str
    text: str
    panel: str | None = None


STEPS = (
    Step(
        "A program is sentences",
        "One statement a line. This one makes two nodes: a talker that sends a greeting to the "
        "topic `chatter`, and a listener that hears it.\n\nThe line below the text always says "
        "how the statement at the cursor goes on.",
    ),
    Step(
        "What it means",
        "Nodes, topics, services and messages appear here while you type. A ⚠ marks a topic that "
        "only one side uses.\n\nEnter on an entry goes to its statement. Delete on a "
        "subscription writes the `unsubscribe`.",
        "nodes",
    ),
    Step(
        "What it becomes",
        "The file of the node at the cursor, as it will be written. Move the cursor to another "
        "statement and it follows.",
        "preview",
    ),
    Step("How it hangs together", "Who speaks to whom, as a picture. Ctrl-T enlarges it.", "graph"),
    Step(
        "What is wrong",
        "Problems are underlined, and listed here. F8 goes to the next one; Alt-Enter fixes it "
        "where the fix is known.",
        "problems",
    ),
    Step(
        "Write it, run it",
        "F6 shows each file before anything is written; what you changed by hand is never lost. "
        "F5 starts the nodes, and stops them.\n\nCtrl-U is the wizard, which builds statements "
        "from menus; F10 lists all that can be done, F1 explains where you are. Have a try!",
    ),
)

_CORNERS: tuple[tuple[AlignHorizontal, AlignVertical], ...] = (
    ("right", "bottom"),
    ("right", "top"),
    ("left", "bottom"),
    ("left", "top"),
)


class Tour(Dialog[None]):
    """Goes through the steps; the screen behind it shows what each is about."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("enter,right,space", "go(1)", "Next"),
        Binding("left,backspace", "go(-1)", "Back"),
        Binding("escape", "close", "Enough"),
    ]

    def __init__(
        self, bring: Callable[[str], object], region_of: Callable[[str | None], Region]
    ) -> None:
        """Begin a tour.

        Args:
            bring: brings a panel in sight.
            region_of: returns where a panel is, for None where the text is.
        """
        super().__init__()
        self._bring = bring
        self._region_of = region_of
        self.at = 0

    def compose(self) -> ComposeResult:
        """Make the box."""
        with Vertical(id="tour"):
            yield Label("", id="dialog-title")
            yield Label("", id="dialog-text", markup=False)
            yield Label("", id="dialog-keys")

    def on_mount(self) -> None:
        """Begin."""
        # Where the card and the panels are is known when both screens are laid out.
        for screen in self.app.screen_stack:
            screen.screen_layout_refresh_signal.subscribe(self, self._place)
        self._show()

    def _show(self) -> None:
        step = STEPS[self.at]
        self.query_one("#dialog-title", Label).update(step.title)
        self.query_one("#dialog-text", Label).update(step.text)
        last = self.at + 1 == len(STEPS)
        self.query_one("#dialog-keys", Label).update(
            f"{self.at + 1} of {len(STEPS)}   Enter {'ends the tour' if last else 'goes on'}"
            + ("   ← back" if self.at else "") + ("" if last else "   Esc leaves")
        )  # fmt: skip
        if step.panel is not None:
            self._bring(step.panel)
        self.refresh(layout=True)

    def _place(self, _: object) -> None:
        """Go to the corner where the card hides least of what the step is about."""
        about = self._region_of(STEPS[self.at].panel)
        card = self.query_one("#tour").outer_size
        width, height = self.size

        def hidden(corner: tuple[str, str]) -> int:
            x = width - card.width - 1 if corner[0] == "right" else 1
            y = height - card.height - 2 if corner[1] == "bottom" else 1
            return about.intersection(Region(x, y, *card)).area

        corner = min(_CORNERS, key=hidden)
        if self.styles.align != corner:
            self.styles.align = corner

    def action_go(self, by: int) -> None:
        """Go to the next step, or the one before."""
        if self.at + by >= len(STEPS):
            self.dismiss(None)
        else:
            self.at = max(0, self.at + by)
            self._show()

    def action_close(self) -> None:
        """Leave."""
        self.dismiss(None)
