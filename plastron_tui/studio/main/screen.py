"""The main screen: the editor, and around it what its text means."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from textual import events, on, work
from textual.app import ComposeResult
from textual.binding import Binding, BindingType

from ..actions import BY_ID, KEPT, Action, bindings
from ..analysis_worker import Analysed, AnalysisFailed, Preloaded
from ..config import Profile
from ..editor import ProgramEditor
from ..editor.preload import is_preloaded
from ..journal import Kept
from ..key_order import Paged
from ..open_program import Open
from ..panels.entry import Entry
from ..panels.entry_keys import Asked, Chosen, Lit
from ..panels.key_bar import KeyBar
from ..panels.panel import Resized
from ..sparing_compositor import draw_sparingly
from ..textual_private import tell_first_sizes
from .active_program import ActiveProgram
from .first_screen import FirstScreen
from .key_help import choose_action, show_help, toggle_keys
from .parts import Hooks, parts_of
from .program_bars import StatusBar, TitleBar, status_of
from .tab_line import TabLine

if TYPE_CHECKING:
    from .run_actions import RunActions

_LOOK_AT_DISK = 2
"""Seconds after which the files are looked at again."""

_LEAST_ROWS = 8
"""With fewer rows the line with the keys gives way to the text."""


class MainScreen(FirstScreen, Paged):
    """Shows the programs that are open: hands keys and messages to the part that they are for.

    Attributes:
        panels: the widget of each panel, by the panel's name, made when it is first shown.
    """

    BINDINGS: ClassVar[list[BindingType]] = [*bindings()]
    AUTO_FOCUS = "EditorView"

    def __init__(self, open_: Open, profile: Profile, others: Sequence[Open] = ()) -> None:
        super().__init__()
        # In this order: the first has another compositor put in place, which the second mends.
        draw_sparingly(self)
        tell_first_sizes(self)
        self.profile = profile
        self.program = ActiveProgram(open_, others)
        self.tab_line = TabLine(id="tabs")
        self._title, self._status = TitleBar(id="title"), StatusBar(id="status")
        self._keys = KeyBar(KEPT, tuple(BY_ID))
        hooks = Hooks(self._show_anew, self.show_title, self.key_of, self.action_code)
        parts = self._parts = parts_of(self, self.program, profile, hooks)
        self.panels, self.dock_layout, self.feed = parts.panels, parts.dock_layout, parts.feed
        self.recovery, self.files, self._runs = parts.recovery, parts.files, parts.runs

    @property
    def runner(self) -> RunActions:
        """What generates and runs nodes."""
        return self._runs.actions

    @property
    def open(self) -> Open:
        """The program that is open."""
        return self.program.open

    @property
    def editor(self) -> ProgramEditor:
        """The editor."""
        return self.program.editor

    @property
    def is_turning(self) -> bool:
        """Whether a file is looked for that keys are meant for."""
        return self._parts.code.is_finding

    def compose(self) -> ComposeResult:
        """Make the parts."""
        yield from (self._title, self.tab_line, self.dock_layout, self._status, self._keys)

    def on_mount(self) -> None:
        """Start the worker, and look at the files from time to time."""
        self.feed.worker.start()
        self.on_resize()
        self.editor.view.soft_wrap = self.profile.config.wrap
        self.editor.view.line_numbers = self.profile.config.numbers
        self.show_title()
        self.show_status()
        self.call_after_refresh(self.feed.start)
        self.set_interval(_LOOK_AT_DISK, self.look_at_disk)

    def on_unmount(self) -> None:
        """Stop the worker and what runs."""
        self.feed.worker.stop()
        self._runs.close()

    def on_resize(self, event: events.Resize | None = None) -> None:
        """Lay the panels out for another size, or for the first."""
        self._keys.display = self.app.size.height >= _LEAST_ROWS
        self.dock_layout.fit()

    def look_at_disk(self) -> None:
        """Find out what others have written."""
        self._parts.disk.look()

    # The text, and what it means.

    @on(ProgramEditor.Changed)
    def text_changed(self) -> None:
        """Find out what the text means; keep it in the journal."""
        self.feed.edited()
        self.recovery.keep_soon()
        self.show_title()

    @on(ProgramEditor.CursorMoved)
    def cursor_moved(self) -> None:
        """Let the panels follow."""
        self.show_status()
        self.feed.moved()

    @on(Preloaded)
    def preloaded(self) -> None:
        """Show what could not be known before; find out what the text means."""
        self.show_title()
        self.show_status()
        self.feed.ask_anew()

    @on(Analysed)
    def analysed(self, message: Analysed) -> None:
        """Show what the text means, if it is still that text."""
        is_new = self.feed.take(message.analysis)
        self.show_status()
        if is_new:
            self._runs.known(message.analysis)
            self.show_title()
            self._parts.trust.tell_what_waits(message.analysis)

    @on(AnalysisFailed)
    def analysis_failed(self) -> None:
        """Note that the text cannot be known; the app shows the error."""
        self.open.failed = self.open.text

    def _show_anew(self) -> None:
        """Show nothing of the program before: another one is there."""
        self.feed.clear()
        self._runs.follow()
        self.show_title()
        self.feed.ask_anew()
        self.call_later(self.look_at_disk)

    @on(Chosen)
    def entry_chosen(self, message: Chosen) -> None:
        """Go to the statement of an entry."""
        self._parts.entries.go(message.entry)

    @on(Lit)
    def entry_lit(self, message: Lit) -> None:
        """Bring the statement of an entry in sight; the panel keeps the focus."""
        if message.entry.span is not None:
            self.editor.go_to(message.entry.span.start, walk="panel")

    @on(Asked)
    def entry_asked(self, message: Asked) -> None:
        """Do what was asked about an entry."""
        self._parts.entries.do(message)

    @on(Resized)
    def panel_resized(self) -> None:
        """Have what is drawn for a size drawn so that it fits."""
        self.feed.ask_more()
        self.show_status()

    def on_printed(self) -> None:
        """Show what nodes print: `Printed` comes from `run_actions.py`."""
        self.runner.show_soon()

    def show_title(self) -> None:
        """Show the program's name, whether it is saved, and what is the case with it; the tabs."""
        stage = self._runs.stage
        ros = self.open.session.ros if is_preloaded() else None
        self._title.show_program(self.open, ros, stage, self.key_of)
        self._keys.retitle({"run": "Stop"} if stage else {}, ["live"] if stage else [])
        self.tab_line.show_programs(self.program, self._runs.runs_in)

    @on(events.DescendantFocus)
    def show_status(self) -> None:
        """Show where the cursor is, and what the focused part says: of the text the statement."""
        said = status_of(self.focused, self.editor)
        self._status.show_place(said, self.open.text, self.editor.cursor_offset)

    def key_of(self, action: str) -> str:
        """Return the key of an action, as a person writes it; "" where it has none."""
        keys = self.profile.config.keys.get(action, BY_ID[action].keys)
        key = keys.split(",")[0]
        return self.app.get_key_display(Binding(key, "")) if key else ""

    # Actions: panels.

    def action_show(self, name: str) -> None:
        """Bring a panel in sight and give it the focus."""
        self.dock_layout.bring(name, focus=True)

    def action_next_panel(self) -> None:
        """Give the next panel the focus; after the last one the editor."""
        self.dock_layout.next_panel()

    def action_panels(self) -> None:
        """Hide all panels, or show them again."""
        self.dock_layout.toggle()

    def action_zoom(self) -> None:
        """Let the panel with the focus have the window, or its place again."""
        self.dock_layout.zoom()

    def action_resize(self, by: int) -> None:
        """Give the panel with the focus more room or less."""
        self.dock_layout.enlarge(by)

    # Actions: the text.

    async def action_edit(self, command: str) -> None:
        """Do something that the editor can do."""
        self.editor.focus()
        await self.editor.action_edit(command)

    def action_fix(self) -> None:
        """Apply the remedy of the mistake on the cursor's line."""
        self._parts.entries.fix()

    @work(exclusive=True, group="code")
    async def action_code(self, of: Entry | str | None = None) -> None:
        """Show the code of an entry, of a service's answer, or of what the cursor is on."""
        await self._parts.code.show_of(of)

    @work(exclusive=True, group="uses")
    async def action_uses(self) -> None:
        """List where what the cursor is on is used, and go to one of the places."""
        from .use_list import choose_use

        await choose_use(self, self.editor)

    def action_rename(self) -> None:
        """Give what the name at the cursor is about another one."""
        self._parts.entries.rename_here()

    def action_wizard(self) -> None:
        """Build statements from menus and forms."""
        self.recovery.hush()
        self._parts.wizard.open()

    # Actions: tabs.

    @on(TabLine.Picked)
    def tab_picked(self, message: TabLine.Picked) -> None:
        """Bring a tab in front, or close it."""
        self._parts.tabs.bring(message.number)
        if message.closes:
            self.action_close_tab()

    def action_turn_tab(self, by: int) -> None:
        """Bring the next program in front, or with -1 the one before."""
        self._parts.tabs.turn(by)

    def action_jump(self, by: int) -> None:
        """Go back to where one jumped from, or with 1 forward again."""
        self._parts.tabs.jump(by)

    @work(exclusive=True, group="file")
    async def action_close_tab(self) -> None:
        """Close the program in front."""
        await self._parts.tabs.close()

    # Actions: files. Each asks what it has to, one at a time.

    def action_new(self) -> None:
        """Start an empty program."""
        self.files.new()

    @work(exclusive=True, group="file")
    async def action_open(self) -> None:
        """Open a program."""
        await self.files.choose()

    @work(exclusive=True, group="file")
    async def action_save(self) -> None:
        """Write the program to its file."""
        await self.files.save()

    @work(exclusive=True, group="file")
    async def action_save_as(self) -> None:
        """Write the program to another file."""
        await self.files.save(other=True)

    @work(exclusive=True, group="file")
    async def action_welcome(self) -> None:
        """Show recent programs, examples and the tour."""
        await self.files.welcome()

    @work(exclusive=True, group="recipe")
    async def action_start_from(self, path: str) -> None:
        """Open the recipe of a path."""
        await self.files.start_from(path)

    @work(exclusive=True, group="kept", description="kept")
    async def offer_first(self, found: Sequence[Kept | Path], after: str | None = None) -> None:
        """Offer texts that were not saved, and what loads files that are no programs; then act."""
        for each in found:
            await self.files.offer_any(each)
        if after is not None:
            await self.run_action(after)

    @work(exclusive=True, group="file")
    async def action_quit(self) -> None:
        """Leave the studio."""
        if await self._parts.tabs.may_quit():
            self.recovery.stop()
            self.dock_layout.remember()
            self.app.exit()

    # Actions: nodes.

    @work(exclusive=True, group="generate")
    async def action_generate(self) -> None:
        """Show what would be written, then write it."""
        if await self.runner.generate():
            self.feed.ask_anew()

    @work(exclusive=True, group="run")
    async def action_run(self, anew: bool = False, looks: bool = False) -> None:
        """Save, then start the nodes; those that run are stopped, and started `anew` if asked.

        Who `looks` at them gets the focus there.
        """
        await self.runner.run(anew=anew, looks=looks)

    def action_stop(self) -> None:
        """Stop what runs."""
        self.runner.stop()

    @work(exclusive=True, group="trust")
    async def action_trust(self) -> None:
        """Ask whether the project is trusted, and do then what waited for it."""
        if await self._parts.trust.ask():
            self.feed.ask_anew()

    # Actions: help and settings.

    @work(exclusive=True, group="menu")
    async def action_menu(self, query: str = "") -> None:
        """Offer all actions, and do the one that is chosen, or go to a name."""
        names, remembered = self._parts.entries.names, self.profile.remembered
        chosen = await choose_action(self, remembered, self.key_of, names, query)
        if isinstance(chosen, Action):
            await self.app.run_action(chosen.chosen or chosen.call, self)
        elif chosen is not None:
            self._parts.entries.go_to_name(chosen)

    def action_help(self, of_word: bool = True) -> None:
        """Say what the word at the cursor means; asked again, help for what has the focus."""
        hover = self.editor.hover
        is_first = of_word and self.focused is self.editor.view and not hover.is_asked
        if is_first and hover.show_at_cursor(f"{self.key_of('help')} again: help for all"):
            return
        hover.close()
        show_help(self, self.panels, self.key_of)

    def action_keys(self) -> None:
        """Show the keys of what has the focus, at the side."""
        toggle_keys(self, self.dock_layout, self.key_of)

    @work(exclusive=True, group="tour")
    async def action_tour(self) -> None:
        """Take the tour, with a recipe when there is no text."""
        from .take_tour import take_tour

        await take_tour(self, self.program, self.files, self.dock_layout)
        self.profile.remembered.toured = True

    @work(exclusive=True, group="file")
    async def action_config(self) -> None:
        """Open the configuration file in $EDITOR, and take what it says at the next start."""
        from .edit_config import edit_config

        await edit_config(self)
