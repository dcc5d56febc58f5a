"""What others write meanwhile: to the program's file, and to those that it loads."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from textual.screen import Screen

from plastron_tui.regular_files import stamp_of

from ..files import OnDisk, lost, read_again
from ..open_program import Open
from .active_program import ActiveProgram
from .file_actions import FileActions
from .recovery import Recovery
from .workers import start_exclusive


class DiskWatch:
    """Looks at files that others may write."""

    def __init__(
        self,
        screen: Screen[None],
        program: ActiveProgram,
        files: FileActions,
        recovery: Recovery,
        on_files: Callable[[], object],
        on_change: Callable[[], object],
    ) -> None:
        """Prepare to look.

        Args:
            screen: shows the question what is to become of the file.
            program: what is looked at.
            files: reads the file again.
            recovery: keeps the text that the file no longer has.
            on_files: called when a file is another one that the program loads.
            on_change: called when the program's own file counts as another one.
        """
        self._screen = screen
        self._program = program
        self._files = files
        self._recovery = recovery
        self._on_files = on_files
        self._on_change = on_change
        self._stamps: Mapping[Path, object] = {}

    def look(self) -> None:
        """Take what somebody else wrote to the file, or ask; read anew what the program loads.

        A text that nobody has touched since it was read or saved gives way to the file without a
        question.
        """
        self._look_at_loaded()
        open_ = self._program.open
        disk = open_.disk
        if disk is None or not disk.is_changed or not self._screen.is_current:
            return
        now = read_again(disk)
        if now.text in (disk.text, open_.text):
            open_.disk = now
            self._on_change()
        elif now.text is None:
            if open_.told is None or open_.told.text is not None:
                open_.told = now
                self._screen.notify(lost(disk.path), severity="warning", markup=False)
        elif open_.told is None or open_.told.stamp != now.stamp:
            open_.told = now
            if open_.is_changed:
                start_exclusive(self._screen, "disk", self._ask, open_, now)
            else:
                self._load(now)

    def _look_at_loaded(self) -> None:
        """Run the program anew when a file that it loads, or would load, is another one."""
        analysis, session = self._program.analysis, self._program.open.session
        if analysis is None:
            return
        from plastron_tui.diagnostics import codes
        from plastron_tui.model.source import place_of

        sources = (node.source for node in analysis.workspace.nodes.values())
        paths = [
            place_of(source.path, name)
            for source in sources
            if source is not None
            for name in source.files.names
        ]
        if any(found.code == codes.FILE_NOT_FOUND for found in analysis.diagnostics):
            paths += [session.folder, session.output]
        stamps = {path: stamp_of(path) for path in paths}
        before, self._stamps = self._stamps, stamps
        if before.keys() == stamps.keys() and before != stamps:
            session.files_changed()
            self._on_files()

    async def _ask(self, open_: Open, now: OnDisk) -> None:
        from ..panels.diff_lines import difference
        from ..screens.question import Question

        assert now.text is not None
        answer = await self._screen.app.push_screen_wait(
            Question(
                f"{now.path.name} was changed by another program",
                [("keep", "Keep my text"), ("load", "Load the file")],
                text="This is how the file differs from the text in the editor:",
                lines=difference(open_.text, now.text, now.path),
                is_unasked=True,
            )
        )
        if open_ is not self._program.open:
            return
        if answer == "keep":
            # What is there now is known, and may be saved over.
            open_.disk = now
            self._recovery.keep_soon()
        elif answer == "load":
            self._load(now)
            return
        self._on_change()

    def _load(self, now: OnDisk) -> None:
        """Put what the file holds into the editor, as one step to undo; say why not, if not."""
        found = self._files.read(now.path)
        if found.disk is None:
            message = found.problem.message if found.problem is not None else "it has gone"
            self._screen.notify(message, severity="error", markup=False)
            return
        open_ = self._program.open
        if not open_.is_changed:
            message = f"{now.path.name} was changed by another program: this is the new text"
            self._screen.notify(message, timeout=4, markup=False)
        open_.disk = found.disk
        self._program.editor.replace_all(found.disk.text or b"")
        self._on_change()
