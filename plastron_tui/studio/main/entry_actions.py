"""What is done about an entry of a panel: it becomes text in the editor."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from textual.screen import Screen

from plastron_tui.diagnostics import Span, counted

from ..panels.entry import Entry
from ..panels.entry_keys import Asked
from .active_program import ActiveProgram
from .workers import start_exclusive

if TYPE_CHECKING:
    from ..analysis import Analysis
    from ..program_names import ProgramName
    from ..renaming import Renamed


class EntryActions:
    """Ends, renames and generates what an entry is about, and mends mistakes."""

    def __init__(
        self,
        screen: Screen[None],
        program: ActiveProgram,
        show_code: Callable[[Entry], object],
    ) -> None:
        """Prepare to act; `show_code` shows the file that an entry is in."""
        self._screen = screen
        self._program = program
        self._show_code = show_code

    def go(self, entry: Entry) -> None:
        """Go to the statement of an entry, or say where that is."""
        if entry.span is None:
            self._screen.notify(entry.elsewhere, markup=False)
        else:
            self._go_to(entry.span.start, walk="panel")

    @property
    def names(self) -> tuple[ProgramName, ...]:
        """The names of the program, as it was last understood."""
        known = self._program.open.analysis
        if known is None:
            return ()
        from ..program_names import names_of

        return names_of(known.text, known.program, known.workspace)

    def go_to_name(self, name: ProgramName) -> None:
        """Go to what the program says first of a name; what is in another file is shown there."""
        # By now more may be known than when the names were listed.
        key = name.entry.key
        entry = next((each.entry for each in self.names if each.entry.key == key), name.entry)
        if entry.span is None:
            self._show_code(entry)
        else:
            self._go_to(entry.span.start)

    def do(self, asked: Asked) -> None:
        """Do what was asked about an entry."""
        entry, editor = asked.entry, self._program.editor
        match asked.what:
            case "end" if entry.statement is not None:
                self._write(entry.statement, entry.owner, entry.span)
            case "generate" if entry.writing is not None:
                self._generate(*entry.writing)
            case "fix" if entry.edits:
                editor.apply(entry.edits)
                editor.focus()
            case "code":
                self._show_code(entry)
            case "rename":
                start_exclusive(self._screen, "rename", self._rename, entry)

    def rename_here(self) -> None:
        """Rename what the name at the cursor is about."""
        analysis = self._current()
        if analysis is None:
            return
        from ..named_entry import named_entry

        offset = self._program.editor.cursor_offset
        found = named_entry(analysis.ground.document, analysis.program, offset)
        if isinstance(found, str):
            self._warn(found)
        elif found is not None:
            start_exclusive(self._screen, "rename", self._rename, found)

    def _current(self) -> Analysis | None:
        """Return what the text means; say so when that is not known yet."""
        analysis = self._program.analysis
        if analysis is None:
            self._say("the panels are not up to date yet: press the key again")
        return analysis

    def _say(self, text: str, seconds: float = 2) -> None:
        self._screen.notify(text, timeout=seconds, markup=False)

    def _warn(self, text: str) -> None:
        self._screen.notify(text, severity="warning", markup=False)

    def _write(self, statement: str, owner: str | None, after: Span | None = None) -> None:
        """Write a statement, or a line each, where they take effect, and go there."""
        analysis = self._current()
        if analysis is None:
            return
        from ..insertion_point import placed

        edit = placed(analysis.ground, owner, statement.split("\n"), after=after).edit
        self._program.editor.apply([edit])
        self._go_to(edit.span.start + edit.text.startswith("\n"))

    def _go_to(self, offset: int, walk: str = "") -> None:
        self._program.editor.go_to(offset, walk)
        self._program.editor.focus()

    def _generate(self, statement: str, variable: str) -> None:
        """Write the statement that generates something; go to the one that does so already."""
        analysis = self._current()
        if analysis is None:
            return
        from ..insertion_point import is_generated_last

        there = is_generated_last(analysis.program, analysis.workspace, variable)
        if there is None:
            self._write(statement, None)
            return
        self._say(f"{variable} is generated here; F6 writes the files", 4)
        self._go_to(there.start)

    async def _rename(self, entry: Entry) -> None:
        from ..renaming import fixed_name, old_name, renamed, wrong_name
        from ..screens.question import Prompt

        analysis = self._current()
        if analysis is None:
            return
        fixed = fixed_name(analysis, entry)
        if fixed is not None:
            self._warn(fixed)
            return
        open_ = self._program.open
        old = old_name(entry, analysis.workspace)
        where = _places(renamed(analysis, entry, old))
        dialog = Prompt(f"Rename {old} to", old, text=where)
        new = await self._screen.app.push_screen_wait(dialog)
        if not new or new == old or open_ is not self._program.open or analysis.text != open_.text:
            return
        problem = wrong_name(analysis, entry, new)
        if problem is not None:
            self._warn(problem)
            return
        found = renamed(analysis, entry, new)
        said = []
        if found.edits:
            self._program.editor.apply(found.edits)
            said.append(f"renamed in {counted(len(found.edits), 'place')}")
        said += [f"{file} has the name in its own code: change it there" for file in found.files]
        text = "\n".join(said) or f"{old} is not written in this program"
        if found.files or not found.edits:
            self._screen.notify(text, severity="warning", timeout=6, markup=False)
        else:
            self._say(text)

    def fix(self) -> None:
        """Apply the remedy of the mistake on the cursor's line."""
        analysis = self._program.analysis
        if analysis is None:
            return
        offset, text = self._program.editor.cursor_offset, self._program.text
        start = text.rfind(b"\n", 0, offset) + 1
        end = text.find(b"\n", offset)
        end = len(text) if end < 0 else end
        for found in analysis.diagnostics:
            span = found.span
            if found.fix is None or found.file is not None or span is None:
                continue
            if start <= span.start <= end:
                self._program.editor.apply(found.fix.edits)
                self._say(found.fix.title)
                return
        self._say("no problem on this line has a fix", 3)


def _places(found: Renamed) -> str:
    """Say where something has its name: how often in the program, and in which files."""
    said = [f"in {counted(len(found.edits), 'place')} of the program"] if found.edits else []
    said += [f"{file} has it in its own code, and keeps it" for file in found.files]
    return "\n".join(said)
