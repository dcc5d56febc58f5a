"""What is done with a program: entries acted on, nodes generated, nodes run."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from textual import on, work
from textual.message import Message

from plastron_tui.diagnostics import Diagnostic, Edit, Severity, Span
from plastron_tui.regular_files import reason

from ..panels.acting import Asked
from ..panels.entry import Entry
from ..panels.text_view import TextView
from ..panels.tones import Line, Piece
from ..placing import is_generated_last, placed
from .part import Part

if TYPE_CHECKING:
    from ..analysis import Analysis
    from ..running import Running

_MOST_LINES = 5000
_SHOWN_AFTER = 0.05
"""Seconds for which lines that nodes print are gathered."""

_LOOK = 0.01
"""Seconds after which is looked again whether the worker knows what the text means."""


class Printed(Message):
    """Nodes that run printed something, or ended."""


class Doing(Part):
    """Acts on the program."""

    output: TextView
    _nodes_run: Running | None = None

    # Entries.

    @on(Asked)
    def entry_asked(self, message: Asked) -> None:
        """Do what was asked about an entry: as text in the editor."""
        entry = message.entry
        match message.what:
            case "end" if entry.statement is not None:
                self._write(entry.statement, entry.node, entry.span)
            case "generate" if entry.node is not None:
                self._generate(entry.node)
            case "fix" if entry.edits:
                self.editor.apply(entry.edits)
                self.editor.focus()
            case "rename":
                self._rename(entry)

    def _current(self) -> Analysis | None:
        """Return what the text means; say so when that is not known yet."""
        analysis = self.open.analysis
        if analysis is None or analysis.text != self.open.text:
            self.notify("the panels are not up to date yet; press it again", timeout=2)
            return None
        return analysis

    def _write(self, statement: str, node: str | None, after: Span | None = None) -> None:
        """Write a statement where it takes effect, and go there."""
        analysis = self._current()
        if analysis is None:
            return
        edit = placed(analysis.ground, node, [statement], after=after).edit
        self.editor.apply([edit])
        self.editor.go_to(edit.span.start + edit.text.startswith("\n"))
        self.editor.focus()

    def _generate(self, node: str) -> None:
        """Write the statement that generates a node; go to the one that does so already."""
        analysis = self._current()
        if analysis is None:
            return
        there = is_generated_last(analysis.program, analysis.workspace, node)
        if there is None:
            self._write(f"generate_node {node}", None)
            return
        self.notify(f"{node} is generated here; F6 writes the files", timeout=4, markup=False)
        self.editor.go_to(there.start)
        self.editor.focus()

    @work(exclusive=True, group="rename")
    async def _rename(self, entry: Entry) -> None:
        from ..renaming import old_name, renamed, wrong_name
        from .question import Prompt

        analysis = self._current()
        if analysis is None:
            return
        open_ = self.open
        old = old_name(entry, analysis.workspace)
        new = await self.app.push_screen_wait(Prompt(f"Rename {old} to", old))
        if not new or new == old or open_ is not self.open or analysis.text != open_.text:
            return
        problem = wrong_name(analysis, entry, new)
        if problem is not None:
            self.notify(problem, severity="warning", markup=False)
            return
        found = renamed(analysis, entry, new)
        said = []
        if found.edits:
            self.editor.apply(found.edits)
            count = len(found.edits)
            said.append(f"renamed in {count} place{'' if count == 1 else 's'}")
        said += [f"{file} has the name in its own code: change it there" for file in found.files]
        said = said or [f"{old} is not written in this program"]
        if found.files or not found.edits:
            self.notify("\n".join(said), severity="warning", timeout=6, markup=False)
        else:
            self.notify("\n".join(said), timeout=2, markup=False)

    def action_fix(self) -> None:
        """Apply the remedy of the mistake on the cursor's line."""
        analysis = self.open.analysis
        offset, text = self.editor.cursor_offset, self.open.text
        if analysis is None or analysis.text != text:
            return
        start = text.rfind(b"\n", 0, offset) + 1
        end = text.find(b"\n", offset)
        end = len(text) if end < 0 else end
        for found in analysis.diagnostics:
            span = found.span
            if found.fix is None or found.file is not None or span is None:
                continue
            if start <= span.start <= end:
                edits: tuple[Edit, ...] = found.fix.edits
                self.editor.apply(edits)
                self.notify(found.fix.title, timeout=2, markup=False)
                return
        self.notify("nothing on this line has a remedy that can be applied", timeout=3)

    # Generating.

    @work(exclusive=True, group="generate")
    async def action_generate(self) -> None:
        """Show what would be written, then write it."""
        from .generate import GenerateDialog

        if not await self._has_place():
            return
        session = self.open.session
        errors = await self._errors()
        if errors:
            self._say_errors(errors)
            return
        await self.app.push_screen_wait(GenerateDialog(session))
        session.files_changed()
        self.ask_anew()

    async def _has_place(self) -> bool:
        """Make sure that there is a folder to generate into: that of the program."""
        if self.open.path is not None:
            return True
        self.notify("the files go beside the program: save it first", timeout=4)
        return await self.save()

    async def _errors(self) -> list[Diagnostic]:
        """Return the mistakes of the text as it is now, as soon as they are known."""
        open_ = self.open
        while open_.analysis is None or open_.analysis.text != open_.text:
            if open_.failed == open_.text:
                break
            await asyncio.sleep(_LOOK)
        known = open_.analysis
        # What fails in the worker fails here too, and is said as the error that it is.
        is_known = known is not None and known.text == open_.text
        found = known.diagnostics if known and is_known else open_.session.diagnostics
        return [each for each in found if each.severity is Severity.ERROR]

    def _say_errors(self, errors: Sequence[Diagnostic]) -> None:
        count = len(errors)
        said = f"{count} {'mistake has' if count == 1 else 'mistakes have'} to be mended first"
        self.notify(self.trust_first(errors) or said, severity="warning")
        self.bring("problems", focus=True)

    # Running.

    @property
    def runs_nodes(self) -> bool:
        """Whether nodes run."""
        return self._nodes_run is not None

    @work(exclusive=True, group="run")
    async def action_run(self) -> None:
        """Save, then start the nodes; stop them where they run."""
        if self._nodes_run is not None:
            self.bring("output", focus=True)
            self._nodes_run.stop()
            return
        if not await self._has_place():
            return
        errors = await self._errors()
        if errors:
            self._say_errors(errors)
            return
        if self.open.is_changed and not await self.save():
            return
        assert self.open.path is not None
        self._start(self.open.path)

    def _start(self, path: Path) -> None:
        from ..running import Running

        try:
            self._nodes_run = Running(path, self.open.session.options, self._news)
        except OSError as error:
            self.notify(f"cannot run: {reason(error)}", severity="error", markup=False)
            return
        self.output.show(((Piece(f"plastron run {path.name}", "quiet"),),))
        self.show_title()
        self.bring("output", focus=True)

    def _news(self) -> None:
        """Tell the screen, from the thread that reads."""
        self.post_message(Printed())

    @on(Printed)
    def printed(self) -> None:
        """Show what nodes print, soon: all that comes until then at once."""
        self.set_timer(_SHOWN_AFTER, self._show_printed)

    def _show_printed(self) -> None:
        running = self._nodes_run
        if running is None:
            return
        status = running.status
        lines: list[Line] = [_printed_line(text) for text in running.take()]
        if status is not None:
            self._nodes_run = None
            words = "stopped" if running.was_stopped else f"ended with status {status}"
            tone = "quiet" if running.was_stopped else "success" if status == 0 else "error"
            lines.append((Piece(words, tone),))
            self.show_title()
        self.output.show((*self.output.lines, *lines)[-_MOST_LINES:], follow=True)

    def action_stop(self) -> None:
        """Stop what runs."""
        if self._nodes_run is None:
            self.notify("nothing runs", timeout=2)
        else:
            self._nodes_run.stop()

    def end_running(self) -> None:
        """Have the nodes ended, because the studio ends."""
        if self._nodes_run is not None:
            self._nodes_run.close()


def _printed_line(text: str) -> Line:
    from plastron_tui.diagnostics.terminal import visible

    shown = visible(text.expandtabs(4))
    lower = shown.lower()
    if "error" in lower or "traceback" in lower:
        return (Piece(shown, "error"),)
    if "warn" in lower:
        return (Piece(shown, "warning"),)
    name, colon, rest = shown.partition(" | ")
    return (Piece(name + colon, "primary"), Piece(rest)) if colon else (Piece(shown),)
