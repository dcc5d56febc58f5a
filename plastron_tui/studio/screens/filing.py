"""Opening, saving and leaving, and what others do to the file meanwhile."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

from textual import work

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.regular_files import stamp_of

from ..analyst import Analyst
from ..files import OnDisk, Opened, Saved, open_file, read_again, save_file, with_suffix
from ..journal import Kept
from ..state import Open, opened
from .keeping import Keeping, difference_of

if TYPE_CHECKING:
    from ..recipes import Recipe


class Filing(Keeping):
    """Owns the file of the program that is open."""

    analyst: Analyst
    _stamps: Mapping[Path, object] = MappingProxyType({})

    # Opening.

    def take(self, open_: Open, cursor: int = 0) -> None:
        """Show another program."""
        self.open = open_
        self.editor.set_session(open_.session)
        if cursor:
            self.editor.go_to(cursor)
        if open_.path is not None:
            self.studio.opened(open_.path)
        self.clear_panels()
        self.show_title()
        self.ask_anew()
        if open_.is_changed:
            self.keep_soon()
        self.editor.focus()

    def _say_notes(self, found: Opened) -> None:
        for text in found.said:
            self.notify(text, severity="warning", timeout=10, markup=False)

    def take_file(self, path: Path, *, kept: Kept | None = None) -> bool:
        """Open a file, or say why that cannot be; the text that is open is then left alone."""
        found = open_file(path)
        self._say_notes(found)
        if found.problem is not None:
            self._say_problem(found.problem)
            return False
        text = None if kept is None else kept.text
        options = self.open.session.options
        self.take(opened(found.disk, self.studio.state_folder, options, text),
                  0 if kept is None else kept.cursor)  # fmt: skip
        if kept is None:
            self.offer_of(path)
        return True

    @work(exclusive=True, group="file")
    async def action_new(self) -> None:
        """Start an empty program."""
        if await self.may_leave():
            self.take(opened(None, self.studio.state_folder, self.open.session.options))

    @work(exclusive=True, group="file")
    async def action_open(self) -> None:
        """Open a program."""
        from .choose_file import ChooseFile

        if not await self.may_leave():
            return
        start = self.open.session.folder
        path = await self.app.push_screen_wait(ChooseFile("Open", start, must_be=True))
        if path is not None:
            self.take_file(path)

    @work(exclusive=True, group="file")
    async def open_path(self, path: Path) -> None:
        """Open a file that was chosen elsewhere."""
        if await self.may_leave():
            self.take_file(path)

    # Saving.

    @work(exclusive=True, group="file")
    async def action_save(self) -> None:
        """Write the program to its file."""
        await self.save()

    @work(exclusive=True, group="file")
    async def action_save_as(self) -> None:
        """Write the program to another file."""
        await self.save(other=True)

    async def save(self, *, other: bool = False) -> bool:
        """Save, and ask what has to be asked; tell whether it was done."""
        path = self.open.path
        if path is None or other:
            path = await self._ask_path()
            if path is None:
                return False
        saved = await self._save_asking(path, self.open.text, self.open.disk)
        return saved is not None and self._saved(path, saved)

    async def _save_asking(self, path: Path, text: bytes, known: OnDisk | None) -> Saved | None:
        """Save, and ask about each other text that is found there; None where it is to stay."""
        saved = save_file(path, text, known)
        while saved.found is not None:
            if not await self._may_overwrite(path, saved.found, text):
                return None
            # What was shown is known; somebody may have written another text meanwhile.
            saved = save_file(path, text, OnDisk(path, saved.found, None))
        return saved

    async def _ask_path(self, title: str = "Save as", name: str = "") -> Path | None:
        from .choose_file import ChooseFile

        path = self.open.path
        start = self.open.session.folder
        name = name or (self._suggested() if path is None else path.name)
        chosen = await self.app.push_screen_wait(ChooseFile(title, start, name=name, must_be=False))
        return None if chosen is None else with_suffix(chosen)

    def _suggested(self) -> str:
        analysis = self.open.analysis
        nodes = () if analysis is None else tuple(analysis.workspace.nodes.values())
        return f"{nodes[0].name}.plastron" if nodes else "program.plastron"

    async def _may_overwrite(self, path: Path, found: bytes, text: bytes) -> bool:
        from .question import Question

        answer = await self.app.push_screen_wait(
            Question(
                f"{path.name} holds something else on the disk",
                [("cancel", "Cancel"), ("overwrite", "Overwrite it")],
                text="This is what saving would change there:",
                lines=difference_of(found, text),
            )
        )
        return answer == "overwrite"

    def _saved(self, path: Path, saved: Saved) -> bool:
        if saved.problem is not None:
            self._say_problem(saved.problem)
        if saved.disk is None:
            return False
        open_ = self.open
        open_.journal.drop()
        if open_.path == path:
            open_.disk = saved.disk
            open_.told = None
        else:
            cursor = self.editor.cursor_offset
            self.take(opened(saved.disk, self.studio.state_folder, open_.session.options), cursor)
        self.studio.opened(path)
        self.show_title()
        self.notify(f"saved {path.name}", timeout=2, markup=False)
        return True

    def _say_problem(self, problem: Diagnostic) -> None:
        help_ = f"\n{problem.help}" if problem.help else ""
        self.notify(problem.message + help_, severity="error", timeout=10, markup=False)

    # Leaving.

    async def may_leave(self) -> bool:
        """Ask about what is not saved; tell whether the program may be closed."""
        if not self.open.is_changed:
            self.open.journal.drop()
            return True
        from .question import Question

        answer = await self.app.push_screen_wait(
            Question(
                f"Save {self.open.name}?",
                [("save", "Save"), ("drop", "Don't save"), ("cancel", "Cancel")],
                text="There are changes that are not saved.",
            )
        )
        if answer == "save":
            return await self.save()
        if answer == "drop":
            self.open.journal.drop()
            return True
        return False

    @work(exclusive=True, group="file")
    async def action_quit(self) -> None:
        """Leave the studio."""
        if await self.may_leave():
            self.keep_no_longer()
            self.remember_layout()
            self.app.exit()

    @work(exclusive=True, group="file")
    async def action_welcome(self) -> None:
        """Show recent programs, examples and the tour."""
        from .welcome import Welcome

        studio = self.studio
        kept = self.not_saved()
        answer = await self.app.push_screen_wait(Welcome(studio.remembered.recent, kept))
        match answer:
            case ("kept", str(number)):
                self.offer_kept(kept[int(number)])
            case ("open", str(path)):
                if await self.may_leave():
                    self.take_file(Path(path))
            case ("recipe", str(path)):
                self.action_start_from(path)
            case ("action", str(call)):
                await self.run_action(call)
            case _:
                self.editor.focus()

    @work(exclusive=True, group="recipe")
    async def action_start_from(self, path: str) -> None:
        """Open the recipe of a path in the place of the program at hand."""
        from ..recipes import recipes

        for recipe in recipes():
            if recipe.path == Path(path) and await self.may_leave():
                await self.take_recipe(recipe)

    async def take_recipe(self, recipe: Recipe) -> bool:
        """Open a recipe as a new program; one that brings files along gets its place first.

        The file that is open, where it has nothing in it yet, was named for what comes now. Tell
        whether it was opened.
        """
        studio, options = self.studio, self.open.session.options
        named = self.open.disk if not self.open.saved else None
        if not recipe.files:
            self.take(opened(named, studio.state_folder, options, recipe.text))
            return True
        names = ", ".join(map(str, recipe.files))
        name = recipe.path.name if named is None else named.path.name
        path = await self._ask_path(f"Save as, with {names} beside it", name)
        if path is None:
            return False
        present = read_again(OnDisk(path, None, None))
        if present.text not in (None, recipe.text):
            assert present.text is not None
            if not await self._may_overwrite(path, present.text, recipe.text):
                return False
        from ..recipes import place_files

        placed = place_files(recipe, path.absolute().parent)
        problem = placed.problem
        if problem is None:
            saved = await self._save_asking(path, recipe.text, present)
            if saved is None:
                return False
            problem = saved.refusal
        if problem is not None:
            self._say_problem(problem)
            return False
        for file in placed.kept:
            self.notify(f"{file} was there already, and stays as it is", markup=False)
        return self.take_file(path)

    # Others who write the file.

    def _look_at_loaded(self) -> None:
        """Run the program anew when a file that it loads, or would load, is another one."""
        analysis, session = self.open.analysis, self.open.session
        if analysis is None or analysis.text != self.open.text:
            return
        sources = (node.source for node in analysis.workspace.nodes.values())
        paths = [source.path for source in sources if source is not None]
        if any(found.code == codes.FILE_NOT_FOUND for found in analysis.diagnostics):
            paths += [session.folder, session.output]
        stamps = {path: stamp_of(path) for path in paths}
        before, self._stamps = self._stamps, stamps
        if before.keys() == stamps.keys() and before != stamps:
            session.files_changed()
            self.ask_anew()

    def look_at_disk(self) -> None:
        """Ask, when somebody else has written the file; read anew what the program loads."""
        self._look_at_loaded()
        disk = self.open.disk
        if disk is None or not disk.is_changed or self.app.screen is not self:
            return
        now = read_again(disk)
        if now.text == disk.text:
            self.open.disk = now
        elif now.text is None:
            if self.open.told is None or self.open.told.text is not None:
                self.open.told = now
                self.notify(f"{disk.path.name} is no longer on the disk; save it to keep it",
                            severity="warning", markup=False)  # fmt: skip
        elif self.open.told is None or self.open.told.stamp != now.stamp:
            self.open.told = now
            self._ask_about_disk(self.open, now)

    @work(exclusive=True, group="disk", description="disk")
    async def _ask_about_disk(self, open_: Open, now: OnDisk) -> None:
        from .question import Question

        assert now.text is not None
        answer = await self.app.push_screen_wait(
            Question(
                f"{now.path.name} was changed by another program",
                [("keep", "Keep my text"), ("load", "Load the file")],
                text="This is how the file differs from the text in the editor:",
                lines=difference_of(open_.text, now.text),
            )
        )
        if open_ is not self.open:
            return
        if answer == "keep":
            # What is there now is known, and may be saved over.
            open_.disk = now
            self.show_title()
            self.keep_soon()
        if answer != "load":
            return
        found = open_file(now.path)
        self._say_notes(found)
        if found.problem is not None or found.disk is None:
            message = found.problem.message if found.problem is not None else "it has gone"
            self.notify(message, severity="error", markup=False)
            return
        open_.disk = found.disk
        self.editor.replace_all(found.disk.text or b"")
        self.show_title()
