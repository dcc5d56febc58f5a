"""The menu of all actions and the program's names: what one types finds them, with their keys."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, ClassVar

from rich.cells import cell_len, set_cell_size
from textual import events, on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.content import Content
from textual.widgets import Input, Label, OptionList
from textual.widgets.option_list import Option

from plastron_tui.diagnostics.terminal import visible

from ..actions import ACTIONS, Action, grouped
from .dialog import Dialog, is_low
from .menu_search import Entry, answers, listed

if TYPE_CHECKING:
    from ..program_names import ProgramName

_ROOM = 9
"""Rows around the list: the frame, the line to type in, the help, the keys, the studio's lines."""
_LOW_ROOM = 6
"""Rows around it in a low window, where the help has one row and the studio's lines none."""


class ActionMenu(Dialog["Action | ProgramName | None"]):
    """Offers all actions and the names of the program; the result is what was chosen."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "close", "Close"),
        Binding("down,ctrl+n", "go(1)", "Down", show=False),
        Binding("up,ctrl+p", "go(-1)", "Up", show=False),
        Binding("pagedown", "go(10)", "Page down", show=False),
        Binding("pageup", "go(-10)", "Page up", show=False),
    ]
    AUTO_FOCUS = "#menu-query"

    def __init__(
        self,
        recent: Sequence[str],
        key_of: Callable[[str], str],
        names: Sequence[ProgramName] = (),
        query: str = "",
    ) -> None:
        """Make the menu.

        Args:
            recent: the ids of the actions that were chosen last, the latest first.
            key_of: tells the key of an action by its id.
            names: the names of the program.
            query: what is in the line to type in at first.
        """
        super().__init__()
        self._recent = recent
        self._names = names
        self._query = query
        self._actions = [action for action in ACTIONS if action.id != "menu"]
        self._keys = {action.id: key_of(action.id) for action in self._actions}
        self._column = max(map(cell_len, self._keys.values()), default=0)
        self._width = 0
        self.entries: tuple[Entry, ...] = ()

    def compose(self) -> ComposeResult:
        """Make the line to type in, the list, and the help for what is marked in it."""
        with Vertical(id="menu"):
            query = Input(
                self._query, "What do you want to do, or which name do you look for?",
                id="menu-query", compact=True, select_on_focus=False,
            )  # fmt: skip
            query.cursor_position = len(self._query)
            yield query
            options = OptionList(id="menu-list", compact=True, markup=False)
            # Keys are for the line to type in; it hands on those that move the mark.
            options.can_focus = False
            yield options
            yield Label("", id="menu-help", markup=False)
            yield Label("↑ ↓ choose   Enter do it   Esc closes", id="dialog-keys")

    def on_resize(self, event: events.Resize) -> None:
        """Give the list the rows and the columns that there are."""
        options = self.query_one(OptionList)
        room = _LOW_ROOM if is_low(event.size) else _ROOM
        options.styles.max_height = max(event.size.height - room, 1)
        self.call_after_refresh(self._fit)

    def _fit(self) -> None:
        """Put the keys at the right edge of the list."""
        width = self.query_one(OptionList).scrollable_content_region.width
        if width != self._width:
            self._width = width
            marked = self.query_one(OptionList).highlighted
            self._show()
            if marked is not None:
                self.query_one(OptionList).highlighted = marked

    @on(Input.Changed)
    def typed(self) -> None:
        """Show what fits."""
        if self._width:
            self._show()

    def _show(self) -> None:
        query = self.query_one(Input).value
        if query.strip():
            self.entries = answers(query, self._actions, self._recent, self._names)
        else:
            groups = [
                (group, [action for action in actions if action.id in self._keys])
                for group, actions in grouped()
            ]
            self.entries = listed(groups, self._recent)
        options = self.query_one(OptionList)
        options.clear_options()
        if self.entries:
            options.add_options([self._option(entry) for entry in self.entries])
            options.highlighted = 0 if self.entries[0].chosen else 1
        else:
            options.add_option(Option(" nothing is called that", disabled=True))
            self.query_one("#menu-help", Label).update("")
        # A list that is shorter than its place has no scrollbar, and a column more.
        self.call_after_refresh(self._fit)

    def _option(self, entry: Entry) -> Option:
        if entry.name is not None:
            return Option(self._row_of_name(entry.name))
        if entry.action is None:
            heading = Content.styled(entry.heading, "bold $text-primary")
            return Option(heading, disabled=True)
        key = self._keys[entry.action.id]
        room = max(self._width - self._column - 3, 8)
        title = f" {entry.action.title}"[:room]
        text = Content.assemble(title.ljust(room), (key.rjust(self._column), "$text-accent"), "  ")
        return Option(text)

    def _row_of_name(self, name: ProgramName) -> Content:
        """Return the line of a name: what it names, and at the right where that is."""
        where = visible(name.where)
        entry = name.entry
        said = " · ".join(filter(None, (name.kind, visible(entry.detail))))
        room = max(self._width - cell_len(where) - 4, 8)
        text = set_cell_size(f" {entry.sign} {visible(entry.text)}  ", room)
        shown = text.rstrip() + "  "
        if cell_len(shown) >= room:
            return Content.assemble(text, " ", (where, "$text-accent"), "  ")
        return Content.assemble(
            shown, (set_cell_size(said, room - cell_len(shown)), "$foreground 60%"), " ",
            (where, "$text-accent"), "  ",
        )  # fmt: skip

    @on(OptionList.OptionHighlighted)
    def marked(self, event: OptionList.OptionHighlighted) -> None:
        """Say what the marked action does, or what the program says there.

        The mark may have been in a list that has gone.
        """
        if event.option_index >= len(self.entries):
            return
        chosen = self.entries[event.option_index].chosen
        help_ = (
            chosen.help if isinstance(chosen, Action) else visible(chosen.line if chosen else "")
        )
        self.query_one("#menu-help", Label).update(help_)

    @on(OptionList.OptionSelected)
    def clicked(self, event: OptionList.OptionSelected) -> None:
        """Do what was clicked."""
        self.dismiss(self.entries[event.option_index].chosen)

    @on(Input.Submitted)
    def submitted(self) -> None:
        """Do what is marked."""
        at = self.query_one(OptionList).highlighted
        if at is not None and at < len(self.entries):
            self.dismiss(self.entries[at].chosen)

    def action_go(self, by: int) -> None:
        """Mark an action further down or up; the ends are not passed."""
        options = self.query_one(OptionList)
        places = [place for place, entry in enumerate(self.entries) if entry.chosen]
        if not places:
            return
        at = places.index(options.highlighted) if options.highlighted in places else 0
        options.highlighted = places[min(max(at + by, 0), len(places) - 1)]

    def action_close(self) -> None:
        """Do nothing."""
        self.dismiss(None)
