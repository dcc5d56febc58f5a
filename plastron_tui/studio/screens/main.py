"""The main screen: the editor, and around it what its text means."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, cast

from textual import events, on, work
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Horizontal, Vertical
from textual.screen import Screen
from textual.timer import Timer

from ..actions import ACTIONS, BY_ID, bindings
from ..analyst import Analysed, AnalysisFailed, Analyst, Wanted
from ..editor import ProgramEditor
from ..editor.statement_help import help_of
from ..panels.acting import Acting, Chosen, Lit
from ..panels.bars import Bar, help_pieces
from ..panels.dock import Dock, Edge
from ..panels.entry import Entries
from ..panels.entry_list import EntryList
from ..panels.graph_panel import GraphPanel
from ..panels.key_bar import KeyBar
from ..panels.log_view import LogView
from ..panels.picture import Picture
from ..panels.preview_panel import PreviewPanel
from ..panels.program_panel import ProgramPanel
from ..panels.text_view import TextView
from ..state import Open
from .arranging import Arranging
from .doing import Doing
from .filing import Filing
from .trusting import Trusting
from .wizarding import Wizarding

if TYPE_CHECKING:
    from ..app import StudioApp

_PAUSE = 0.01
"""Seconds without a key after which the worker starts."""

_FIRST_PAUSE = 0.05
"""The same at the start: the worker has much to import, and the first key goes before it."""

LISTS = ("nodes", "topics", "services", "messages", "problems")


class MainScreen(Arranging, Filing, Doing, Wizarding, Trusting, Screen[None]):
    """Shows one program; its handlers own all that is open."""

    BINDINGS: ClassVar[list[BindingType]] = [*bindings()]
    AUTO_FOCUS = "EditorView"

    def __init__(self, open_: Open) -> None:
        super().__init__()
        self.open = open_
        self.analyst = Analyst(self.post_message)
        self.editor = ProgramEditor(open_.session, id="editor")
        self.lists = {name: ProgramPanel(id=name) for name in LISTS}
        self.preview = PreviewPanel(id="preview")
        self.graph = GraphPanel(id="graph")
        self.output = LogView(id="output")
        self.outline = Dock(
            "outline",
            [(name, name.capitalize(), self.lists[name]) for name in LISTS if name != "problems"],
        )
        self.result = Dock(
            "result", [("preview", "Preview", self.preview), ("graph", "Graph", self.graph)]
        )
        self.bottom = Dock(
            "bottom",
            [("problems", "Problems", self.lists["problems"]), ("output", "Output", self.output)],
        )
        self._pause: Timer | None = None
        self._asked: Wanted | None = None

    @property
    def studio(self) -> StudioApp:
        """The app."""
        return cast("StudioApp", self.app)

    def compose(self) -> ComposeResult:
        """Make the parts."""
        self.fill_docks()
        yield Bar(id="title")
        with Horizontal(id="body"):
            yield self.outline
            yield Edge(id="outline-edge")
            with Vertical(id="center"):
                yield self.editor
                yield self.bottom
            yield Edge(id="result-edge")
            yield self.result
        yield Bar(id="status")
        yield KeyBar()

    def on_mount(self) -> None:
        """Start the worker, and look at the file from time to time."""
        self.analyst.start()
        self.lay_docks()
        self.editor.view.soft_wrap = self.studio.config.wrap
        self.editor.view.line_numbers = self.studio.config.numbers
        self.show_title()
        self.show_status()
        self.call_after_refresh(self._settle)
        self.set_interval(2, self.look_at_disk)

    def _settle(self) -> None:
        """Begin to work, now that there is something to see."""
        self._pause = self.set_timer(_FIRST_PAUSE, self.ask_anew)
        self.editor.statement_help = help_of(self.editor.expected)
        self.show_status()

    def on_unmount(self) -> None:
        """Stop the worker and what runs."""
        self.analyst.stop()
        self.end_running()

    # What the text means.

    @on(ProgramEditor.Changed)
    def text_changed(self) -> None:
        """Find out, as soon as no key comes, what the text means; keep it in the journal."""
        if self._pause is None:
            self._pause = self.set_timer(_PAUSE, self.ask_anew)
        else:
            self._pause.reset()
        self.keep_soon()
        self.show_title()

    def ask_anew(self) -> None:
        """Ask what the text means now."""
        self._pause = None
        self._asked = self.wanted()
        self.analyst.ask(self._asked, self.open.session.snapshot())

    def ask_more(self) -> None:
        """Ask for what came in sight, if it is not known."""
        wanted = self.wanted()
        if self._pause is None and wanted != self._asked:
            self._asked = wanted
            self.analyst.ask(wanted)

    def wanted(self) -> Wanted:
        """Return what is in sight."""
        names = {dock.active for dock in self.docks if dock.display}
        analysis = self.open.analysis
        node = None
        if "preview" in names and analysis is not None:
            node = analysis.node_at(self.editor.cursor_offset) or self._shown_node()
        lists = tuple(name for name in LISTS if name in names or name == "problems")
        return Wanted(lists, node, self.graph.room if "graph" in names else None)

    def _shown_node(self) -> str | None:
        """Return the node that the preview shows, or else the first one."""
        analysis = self.open.analysis
        if analysis is None:
            return None
        nodes = analysis.workspace.nodes
        last = self._asked.preview if self._asked is not None else None
        return last if last in nodes else next(iter(nodes), None)

    @on(Analysed)
    def analysed(self, message: Analysed) -> None:
        """Show what the text means, if it is still that text."""
        analysis = message.analysis
        if analysis.text != self.open.text:
            return
        is_new = analysis is not self.open.analysis
        self.open.analysis = analysis
        if is_new:
            self.editor.set_diagnostics(
                analysis.diagnostics, (analysis.program, analysis.workspace)
            )
            self.show_counts()
            self.show_title()
            self.tell_what_waits(analysis)
        for name, entries in analysis.entries.items():
            self.lists[name].show(entries)
        if analysis.drawing is not None:
            self.graph.show(analysis.drawing)
        self.follow()

    @on(AnalysisFailed)
    def analysis_failed(self, message: AnalysisFailed) -> None:
        """Show an error of Plastron's own; the text is safe in the editor."""
        self.open.failed = self.open.text
        self.studio.show_error(message.error)

    # The cursor and the panels.

    @on(ProgramEditor.CursorMoved)
    def cursor_moved(self) -> None:
        """Let the panels follow."""
        self.show_status()
        self.follow()

    def follow(self) -> None:
        """Light in each panel what the statement at the cursor is about."""
        analysis = self.open.analysis
        if analysis is None or analysis.text != self.open.text:
            return
        offset = self.editor.cursor_offset
        for name, panel in self.lists.items():
            if self.is_in_sight(name):
                panel.follow(offset)
        if self.is_in_sight("graph"):
            self.graph.follow(offset)
        self.ask_more()
        node = self._asked.preview if self._asked is not None else None
        if self.is_in_sight("preview") and (node is None or node in analysis.previews):
            self.preview.show(analysis.previews.get(node or ""))

    @on(Chosen)
    def entry_chosen(self, message: Chosen) -> None:
        """Go to the statement of an entry."""
        span = message.entry.span
        if span is None:
            self.notify(message.entry.elsewhere, markup=False)
            return
        self.editor.go_to(span.start)
        self.editor.focus()

    @on(Lit)
    def entry_lit(self, message: Lit) -> None:
        """Bring the statement of an entry in sight; the panel keeps the focus."""
        if message.entry.span is not None:
            self.editor.go_to(message.entry.span.start)

    @on(GraphPanel.Resized)
    def graph_resized(self) -> None:
        """Have the graph drawn so that it fits."""
        self.ask_more()

    def show_counts(self) -> None:
        """Show beside the names of the panels how much is in them."""
        analysis = self.open.analysis
        if analysis is None:
            return
        self.counts = {name: str(number) for name, number in analysis.counts.items() if number}
        self.show_tabs()

    def show_title(self) -> None:
        """Show the program's name, whether it is saved, and what is the case with it."""
        open_ = self.open
        sign = "●" if open_.is_changed else " "
        left = (("plastron ", "quiet"), (open_.name, "strong"), (f" {sign} ", "here"))
        right: list[tuple[str, str]] = []
        if self.runs_nodes:
            key = self.studio.key_of("run", BY_ID["run"].keys)
            right.append((f"running: {key} stops  ", "here"))
        right.append((self.setting_text(), "quiet"))
        self.query_one("#title", Bar).show(left, tuple(right))

    def fall_back_to(self, library: str) -> None:
        """Take the client library that can run here, where nobody chose one."""
        session = self.open.session
        before = session.library
        session.fall_back_to(library)
        if session.library != before:
            self.show_title()
            self.ask_anew()

    def setting_text(self) -> str:
        """Return the client library and the file's folder in a few words."""
        session = self.open.session
        path = self.open.path
        where = "" if path is None else f"{path.absolute().parent.name}/  "
        return f"{where}{session.library}"

    def show_status(self) -> None:
        """Show the sentence of the statement at the cursor, and where the cursor is."""
        offset = self.editor.cursor_offset
        text = self.open.text
        line_start = text.rfind(b"\n", 0, offset) + 1
        row = text.count(b"\n", 0, offset) + 1
        column = len(text[line_start:offset].decode("utf-8", "replace")) + 1
        bar = self.query_one("#status", Bar)
        bar.show(help_pieces(self.editor.statement_help), ((f"{row}:{column}", "quiet"),))

    # What the editor does.

    def action_edit(self, call: str) -> None:
        """Do something that the editor can do."""
        name, _, rest = call.partition("(")
        arguments = [int(rest.rstrip(")"))] if rest else []
        self.editor.focus()
        method: Callable[..., Any] = getattr(self.editor, f"action_{name}")
        method(*arguments)

    def action_help(self) -> None:
        """Show help for what has the focus."""
        from .help import Help, action_lines

        focused = self.focused
        part = "editor"
        if focused is not None:
            known = (widget.id for widget in focused.ancestors_with_self)
            part = next((name for name in known if name in self._parts), "editor")
        studio = self.studio
        keys = {action.id: studio.key_of(action.id, action.keys) for action in ACTIONS}
        self.app.push_screen(Help(part, self._keys_here(), action_lines(keys.items())))

    _parts: ClassVar[frozenset[str]] = frozenset({*LISTS, "preview", "graph", "output"})

    def _keys_here(self) -> list[tuple[str, str]]:
        """Return the keys of the panel with the focus."""
        rows: dict[str, list[str]] = {}
        for active in self.active_bindings.values():
            binding = active.binding
            if isinstance(active.node, Dock | Acting | EntryList | PreviewPanel | TextView):
                key = self.app.get_key_display(binding)
                rows.setdefault(binding.tooltip or binding.description, []).append(key)
        return [(" ".join(keys), what) for what, keys in rows.items()]

    def action_keys(self) -> None:
        """Show the keys of what has the focus, at the side."""
        if self.query("HelpPanel"):
            self.app.action_hide_help_panel()
        else:
            self.app.action_show_help_panel()

    @work(exclusive=True, group="tour")
    async def action_tour(self) -> None:
        """Take the tour, with a recipe when there is no text."""
        from ..recipes import recipes
        from .tour import Tour

        if not self.open.text.strip():
            for recipe in recipes()[:1]:
                await self.take_recipe(recipe)
        await self.app.push_screen_wait(Tour())
        self.studio.remembered.toured = True
        self.editor.focus()

    @work(exclusive=True, group="file")
    async def action_config(self) -> None:
        """Open the configuration file in $EDITOR, and take what it says at the next start."""
        from ..config import config_file, template

        file = config_file()
        problem = template(file, [(action.id, action.keys) for action in ACTIONS])
        if problem is not None:
            self.notify(problem, severity="error", markup=False)
            return
        self.notify(f"{file}\nit counts from the next start on", timeout=8, markup=False)
        self.edit_outside(file)

    def edit_outside(self, file: Path) -> None:
        """Open a file in the user's own editor, where there is one."""
        from textual.app import SuspendNotSupported

        from ..editor.coding import external_editor, run_editor

        command = external_editor(os.environ)
        if command is None:
            return
        problem = None
        with suppress(SuspendNotSupported), self.app.suspend():
            problem = run_editor(command, file)
        self.app.refresh()
        if problem is not None:
            self.notify(problem, severity="warning", markup=False)

    def on_resize(self, event: events.Resize) -> None:
        """Lay the panels out for another size."""
        self.lay_docks()

    def clear_panels(self) -> None:
        """Show nothing, because another program is there."""
        for panel in self.lists.values():
            panel.show(Entries())
        self.preview.show(None)
        self.graph.show(Picture())
        self.counts = {}
        self.show_tabs()
