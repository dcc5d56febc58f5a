"""The dialog that shows what would be written, writes it, and says how to run it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.widgets import Button, Label

from plastron_tui.diagnostics import counted, has_errors
from plastron_tui.generating.node_files import name_of
from plastron_tui.generating.nothing import nothing_to_generate
from plastron_tui.output.plan import FilePlan, FileState, PlannedFile
from plastron_tui.output.writer import WriteResult, write_current
from plastron_tui.session import Session

from ..panels.diff_lines import difference, planned_diff
from ..panels.entry_keys import Chosen, Lit
from ..panels.file_tree import FileTree, TreeFile, first_seen
from ..panels.source_lines import coloured
from ..panels.styles import Lines, Piece
from ..panels.text_view import TextView
from .dialog import Dialog

_MOST_SAID = 4
"""The most lines about the plan; below them are the files."""


class GenerateDialog(Dialog[bool]):
    """Lists the files; the result is whether they were written."""

    takes_bursts = True
    """A text that comes as keys writes nothing."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "close", "Close"),
        Binding("f6", "write", "Write"),
        Binding("f5", "run", "Run"),
        Binding("d", "toggle_diff", "Another view"),
    ]
    AUTO_FOCUS = "#dialog-files"

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._take(session)
        self.is_written = False
        self._view = 0

    def _take(self, session: Session) -> None:
        """Find out what would be written."""
        made = session.generated()
        self.plan, self.problems = session.plan_of(made)
        self._origins = {
            name_of(each.files.name, name): (source.path.name, text)
            for each in made
            if each.files is not None and (source := each.generation.node.source) is not None
            for name, text in source.files.texts
        }

    def compose(self) -> ComposeResult:
        """Make the list, the diff and the buttons."""
        with Vertical(id="dialog", classes="-tall"):
            yield Label(self._heading(), id="dialog-title", markup=False)
            yield FileTree(id="dialog-files")
            yield Label("", id="dialog-text", markup=False)
            yield Label("", id="dialog-seen", markup=False)
            yield TextView(id="dialog-view")
            with Horizontal(id="dialog-buttons"):
                yield Button(self._write_words(), id="write", variant="primary", compact=True)
                yield Button("Overwrite, keep a backup", id="force", compact=True)
                yield Button("Run", id="run", compact=True)
                yield Button("Close", id="close", compact=True)

    def on_mount(self) -> None:
        """Offer what can be done."""
        self._offer()
        self._show_files()
        if not self.plan.files:
            self.query_one(TextView).show(self._reasons())

    def _heading(self) -> str:
        if not self.plan.files:
            return "Nothing to generate"
        return f"Generate into {_short(self.plan.folder)}"

    def _write_words(self) -> str:
        return f"Write {counted(len(self._waiting()), 'file')}"

    def _waiting(self) -> list[PlannedFile]:
        return [file for file in self.plan.files
                if file.state in (FileState.CREATE, FileState.CHANGED)]  # fmt: skip

    def _show_files(self) -> None:
        """List the files, the cursor on one about which there is something to decide."""
        files = [TreeFile(file.name, file.state, len(file.text)) for file in self.plan.files]
        tree = self.query_one(FileTree)
        tree.display = bool(files)
        is_first = not tree.entries.all
        tree.show_files(files)
        if is_first:
            tree.go_to(first_seen(files))

    def _reasons(self) -> Lines:
        found = self.problems or (nothing_to_generate(self._session.workspace),)
        return tuple(
            (Piece(f" {one.message}" + (f" — {one.help}" if one.help else ""), "warning"),)
            for one in found
        )

    def _offer(self) -> None:
        """Show the buttons that lead somewhere, and say what is the case."""
        has_problem = has_errors(self.problems)
        conflicts = self.plan.conflicts
        can_write = bool(self._waiting()) and not (has_problem or conflicts or self.is_written)
        self.query_one("#write", Button).display = can_write
        self.query_one("#force", Button).display = bool(conflicts) and not self.is_written
        all_there = self.is_written or all(
            file.state is FileState.IDENTICAL for file in self.plan.files
        )
        may_run = self._session.workspace.may_run
        self.query_one("#run", Button).display = bool(self.plan.files) and all_there and may_run
        said = []
        if self.plan.files and all_there and not has_problem:
            how = f" To run: F5, or in a shell: plastron run {self._program()}" if may_run else ""
            said.append(
                f"{'Written' if self.is_written else 'Everything is written already'}.{how}"
            )
        elif conflicts and not has_problem:
            said.append("Files marked ! were changed by hand, and are left alone.")
        if not self.is_written and self.plan.files:
            said += [found.message for found in (*self.problems, *conflicts)]
        if len(said) > _MOST_SAID:
            said[_MOST_SAID - 1 :] = [f"… and {len(said) - _MOST_SAID + 1} more"]
        text = self.query_one("#dialog-text", Label)
        text.update("\n".join(said))
        text.display = bool(said)

    def _program(self) -> str:
        return "FILE" if self._session.path is None else _short(self._session.path)

    @on(Lit)
    def highlighted(self, message: Lit) -> None:
        """Show the diff of the file."""
        message.stop()
        self._view = 0
        self._draw()

    @on(Chosen)
    def selected(self, message: Chosen) -> None:
        """Take Enter on a file for the first button."""
        message.stop()
        self.action_write()

    def _draw(self) -> None:
        number = self.query_one(FileTree).number
        if number is None or number >= len(self.plan.files):
            return
        views = list(self._views(self.plan.files[number]))
        title, lines, numbers = views[self._view % len(views)]
        more = f"   d: {views[(self._view + 1) % len(views)][0]}" if len(views) > 1 else ""
        self.query_one("#dialog-seen", Label).update(title + more)
        view = self.query_one(TextView)
        view.show(lines, numbers=numbers)
        view.scroll_home(animate=False)

    def _views(self, file: PlannedFile) -> Iterator[tuple[str, Lines, bool]]:
        """Yield how a file can be looked at: what it is called, the lines, whether numbered."""
        if file.before is not None and file.before != file.text:
            yield "what changes on the disk", planned_diff(file), False
        name, text = self._origins.get(file.name, ("", file.text))
        if text not in (file.text, file.before):
            yield f"what differs from {name}", difference(text, file.text, file.path), False
        yield "the whole file", coloured(file.text.decode("utf-8", "replace"), file.path), True

    def action_toggle_diff(self) -> None:
        """Show the file in another way: what changes in it, or the whole of it."""
        self._view += 1
        self._draw()

    @on(Button.Pressed, "#write")
    def action_write(self) -> None:
        """Write the files, where nothing stands against it."""
        if self.query_one("#write", Button).display:
            self._write(force=False)
        elif self.query_one("#run", Button).display:
            self.query_one("#run", Button).focus()

    @on(Button.Pressed, "#force")
    def _force(self) -> None:
        self._write(force=True)

    def _write(self, *, force: bool) -> None:
        before = self.plan
        result = write_current(self.plan, self._plan_again, force=force)
        is_wrong = has_errors(result.diagnostics)
        for found in result.diagnostics:
            if has_errors([found]) or not is_wrong:
                self.notify(found.message + (f"\n{found.help}" if found.help else ""),
                            severity="error" if is_wrong else "warning", timeout=10,
                            markup=False)  # fmt: skip
        if not is_wrong:
            self._wrote(result)
        elif self.plan is not before:
            self._show_plan()

    def _plan_again(self) -> FilePlan | None:
        """Find out anew what would be written: another process wrote to the folder meanwhile."""
        session = self._session
        fresh = Session(session.document.text, session.path, session.options, begun=session.folder)
        self._take(fresh)
        return None if has_errors((*fresh.diagnostics, *self.problems)) else self.plan

    def _wrote(self, result: WriteResult) -> None:
        backups = [written.backup.name for written in result.written if written.backup]
        if backups:
            self.notify("kept as " + ", ".join(backups), markup=False)
        self.is_written = True
        # What was written is what is there: look again.
        self._plan_again()
        self._show_plan()

    def _show_plan(self) -> None:
        self._show_files()
        self._draw()
        self._offer()
        self.query_one("#run", Button).focus()

    @on(Button.Pressed, "#run")
    def action_run(self) -> None:
        """Start the nodes."""
        self.dismiss(self.is_written)
        self.app.call_later(self.app.run_action, "screen.run(True)")

    @on(Button.Pressed, "#close")
    def action_close(self) -> None:
        """Close the dialog."""
        self.dismiss(self.is_written)


def _short(path: Path) -> str:
    try:
        return str(path.absolute().relative_to(Path.cwd()))
    except (OSError, ValueError):
        return str(path)
