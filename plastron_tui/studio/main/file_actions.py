"""Opening, saving and leaving."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from textual.screen import Screen

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.project.other_files import other_kind, program_beside
from plastron_tui.regular_files import is_same_file

from ..config import Profile
from ..files import OnDisk, Opened, Saved, open_file, read_again, save_file, with_suffix
from ..journal import Kept
from ..open_program import Open, opened
from .active_program import ActiveProgram, Tab
from .recovery import Recovery
from .workers import start_exclusive

if TYPE_CHECKING:
    from ..recipes import Recipe


@dataclass(frozen=True, eq=False)
class FileActions:
    """Opens, saves and leaves programs, and asks what has to be asked.

    Attributes:
        screen: shows dialogs and messages.
        program: what is saved; another program gets a tab beside it.
        profile: remembers what was open.
        recovery: offers what was typed in a file and not saved.
        on_open: called when another program is there.
        on_change: called when the program is saved.
    """

    screen: Screen[None]
    program: ActiveProgram
    profile: Profile
    recovery: Recovery
    on_open: Callable[[], object]
    on_change: Callable[[], object]

    def take(self, open_: Open, cursor: int = 0, *, in_place: bool = False) -> None:
        """Show another program, in a tab of its own.

        One in which nothing is written gives its place up, as does the text of the same file.

        Args:
            open_: the program.
            cursor: where the cursor is put, in bytes.
            in_place: whether the program in the editor gives its place up in any case.
        """
        same = None if open_.path is None else self.program.tab_of(open_.path)
        if same not in (None, self.program.tab) or not (in_place or self.program.open.is_blank):
            self.program.editor.jumps.leave()
        if same is not None:
            self.program.bring(same)
        if in_place or same is not None or self.program.open.is_blank:
            self.program.replace(open_, cursor)
        else:
            self.program.add(open_, cursor)
        if open_.path is not None:
            self.profile.remembered.opened(open_.path)
        self.on_open()
        if open_.is_changed:
            self.recovery.keep_soon()
        self.program.editor.focus()

    def bring(self, tab: Tab) -> None:
        """Bring a tab in front."""
        if tab is not self.program.tab:
            self.program.editor.jumps.leave()
            self.program.bring(tab)
            self.on_open()
        self.program.editor.focus()

    def open_file(self, path: Path) -> bool:
        """Open a file in a tab, or bring the tab in front that has it; tell whether it is there."""
        tab = self.program.tab_of(path)
        if tab is None:
            return self.take_file(path)
        self.bring(tab)
        return True

    def take_file(self, path: Path, *, kept: Kept | None = None) -> bool:
        """Read a file and show it, or say why that cannot be.

        For one that is no program, one that loads it is offered.
        """
        if kept is None and other_kind(path) is not None:
            start_exclusive(self.screen, "load", self.offer_loading, path)
            return False
        found = self.read(path)
        if found.problem is not None:
            self._say_problem(found.problem)
            return False
        if kept is not None:
            self.take(self._opened(found.disk, kept.text), kept.cursor)
            return True
        self.take(self._opened(found.disk))
        for other in self.recovery.not_saved():
            if other.belongs_to(path, path.parent):
                start_exclusive(self.screen, "kept", self.offer, other)
                break
        return True

    async def offer_loading(self, path: Path) -> None:
        """Offer a program that loads a file, beside it."""
        from .loading_offer import ask_to_load

        kind, beside = other_kind(path), program_beside(path)
        wanted = None if kind is None else await ask_to_load(self.screen, path, kind)
        if wanted is None:
            return
        if wanted == beside or self.program.tab_of(beside) is not None:
            self.open_file(beside)
        else:
            assert isinstance(wanted, bytes)
            self.take(self._opened(OnDisk(beside, None, None), wanted))

    def read(self, path: Path) -> Opened:
        """Read a file; say what was found of a write that was interrupted."""
        found = open_file(path)
        for text in found.said:
            self.screen.notify(text, severity="warning", timeout=10, markup=False)
        return found

    def _opened(
        self, disk: OnDisk | None, text: bytes | None = None, begun: Path | None = None
    ) -> Open:
        options = self.program.open.session.options
        return opened(disk, self.profile.journals, options, text, begun)

    def new(self, *, in_place: bool = False) -> None:
        """Start an empty program."""
        self.take(self._opened(None), in_place=in_place)

    async def choose(self) -> None:
        """Open a program that is asked for."""
        from ..screens.choose_file import ChooseFile

        start = self.program.open.session.folder
        recent = [
            name
            for name in self.profile.remembered.recent
            if self.program.tab_of(Path(name)) is None
        ]
        present = self.program.path
        dialog = ChooseFile("Open", start, must_be=True, recent=recent, present=present)
        path = await self.screen.app.push_screen_wait(dialog)
        if path is not None:
            self.open_file(path)

    async def offer_any(self, found: Kept | Path) -> None:
        """Offer a text that was not saved, or a program that loads a file."""
        await (self.offer_loading(found) if isinstance(found, Path) else self.offer(found))

    async def offer(self, kept: Kept, *, is_asked_for: bool = False) -> None:
        """Offer a text that was not saved before the studio ended, and open it."""
        if not await self.recovery.is_wanted(kept, is_asked_for=is_asked_for):
            return
        there = None if kept.path is None else self.program.tab_of(kept.path)
        if there is not None:
            self.bring(there)
            if there.open.is_changed and not await self.may_leave():
                return
            # One step, so that what the file holds comes back by undoing it.
            self.program.editor.replace_all(kept.text)
            self.program.editor.go_to(kept.cursor)
        elif kept.path is None:
            begun = kept.folder
            if begun is not None and not begun.is_dir():
                begun = None
                message = "the folder in which it was begun is gone"
                self.screen.notify(message, severity="warning")
            self.take(self._opened(None, kept.text, begun), kept.cursor)
        elif not self.take_file(kept.path, kept=kept):
            return
        self.recovery.adopt(kept)

    async def welcome(self) -> None:
        """Show recent programs, examples and the tour."""
        from ..screens.welcome import Welcome

        kept = self.recovery.not_saved()
        welcome = Welcome(self.profile.remembered.recent, kept)
        match await self.screen.app.push_screen_wait(welcome):
            case ("kept", str(number)):
                await self.offer(kept[int(number)], is_asked_for=True)
            case ("open", str(path)):
                self.open_file(Path(path))
            case ("recipe", str(path)):
                await self.start_from(path)
            case ("action", str(call)):
                await self.screen.run_action(call)
            case _:
                self.program.editor.focus()

    async def start_from(self, path: str) -> None:
        """Open the recipe of a path."""
        from ..recipes import recipes

        for recipe in recipes():
            if recipe.path == Path(path):
                await self.take_recipe(recipe)

    async def take_recipe(self, recipe: Recipe) -> bool:
        """Open a recipe as a new program; one that brings files along gets its place first.

        The file that is open, where it has nothing in it yet, was named for what comes now. Tell
        whether it was opened.
        """
        open_ = self.program.open
        named = open_.disk if not open_.text.strip() and not open_.saved else None
        if not recipe.files:
            self.take(self._opened(named, recipe.text))
            return True
        names = ", ".join(map(str, recipe.files))
        name = recipe.path.name if named is None else named.path.name
        path = await self._ask_path(f"Save as, with {names} beside it", name)
        if path is None:
            return False
        if is_same_file(path, open_.path) and open_.is_changed and not await self.may_leave():
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
            message = f"{file} was there already, and stays as it is"
            self.screen.notify(message, markup=False)
        return self.take_file(path)

    async def save(self, *, other: bool = False, title: str = "Save as") -> bool:
        """Save, and ask what has to be asked; tell whether it was done."""
        path = self.program.path
        if path is None or other:
            path = await self._ask_path(title)
            if path is None:
                return False
        open_ = self.program.open
        saved = await self._save_asking(path, open_.text, open_.disk)
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
        from ..screens.choose_file import ChooseFile

        path = self.program.path
        start = self.program.open.session.folder
        name = name or (self._suggested() if path is None else path.name)
        dialog = ChooseFile(title, start, name=name, must_be=False)
        chosen = await self.screen.app.push_screen_wait(dialog)
        if chosen is None:
            return None
        path = with_suffix(chosen)
        kind = other_kind(path)
        if kind is not None:
            message = f"by its name {path.name} is {kind.title}; a program's ends in .plastron"
            self.screen.notify(message, severity="warning", markup=False)
            return None
        tab = self.program.tab_of(path)
        if tab not in (None, self.program.tab):
            message = f"{path.name} is open in another tab: close it there first"
            self.screen.notify(message, severity="warning", markup=False)
            return None
        return path

    def _suggested(self) -> str:
        analysis = self.program.open.analysis
        nodes = () if analysis is None else tuple(analysis.workspace.nodes.values())
        return f"{nodes[0].name}.plastron" if nodes else "program.plastron"

    async def _may_overwrite(self, path: Path, found: bytes, text: bytes) -> bool:
        from ..panels.diff_lines import difference
        from ..screens.question import Question

        answer = await self.screen.app.push_screen_wait(
            Question(
                f"{path.name} holds something else on the disk",
                [("cancel", "Cancel"), ("overwrite", "Overwrite it")],
                text="This is what saving would change there:",
                lines=difference(found, text, path),
            )
        )
        return answer == "overwrite"

    def _saved(self, path: Path, saved: Saved) -> bool:
        if saved.problem is not None:
            self._say_problem(saved.problem)
        if saved.disk is None:
            return False
        open_ = self.program.open
        open_.journal.drop()
        if is_same_file(path, open_.path):
            open_.disk = saved.disk
            open_.told = None
            self.profile.remembered.opened(path)
        else:
            cursor = self.program.editor.cursor_offset
            self.take(self._opened(saved.disk), cursor, in_place=True)
        self.on_change()
        self.screen.notify(f"saved {path.name}", timeout=2, markup=False)
        return True

    def _say_problem(self, problem: Diagnostic) -> None:
        help_ = f"\n{problem.help}" if problem.help else ""
        self.screen.notify(problem.message + help_, severity="error", timeout=10, markup=False)

    async def may_leave(self) -> bool:
        """Ask about what is not saved; tell whether the program may be closed."""
        open_ = self.program.open
        if not open_.is_changed:
            open_.journal.drop()
            return True
        from ..screens.question import Question

        answer = await self.screen.app.push_screen_wait(
            Question(
                f"Save {open_.name}?",
                [("save", "Save"), ("drop", "Don't save"), ("cancel", "Cancel")],
                text="There are changes that are not saved.",
            )
        )
        if answer == "save":
            return await self.save()
        if answer == "drop":
            self.program.open.journal.drop()
            return True
        return False
