"""Going from tab to tab, and closing one or all."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from textual.screen import Screen

from .active_program import ActiveProgram, Tab
from .file_actions import FileActions


@dataclass(frozen=True, eq=False)
class TabActions:
    """Turns to other tabs, closes them, and asks what is to become of what is not saved.

    Attributes:
        screen: shows the questions.
        program: the programs that are open.
        files: saves them, and brings another one in front.
        on_close: called with a tab that goes.
        on_change: called when another program is there.
    """

    screen: Screen[None]
    program: ActiveProgram
    files: FileActions
    on_close: Callable[[Tab], object]
    on_change: Callable[[], object]

    def turn(self, by: int) -> None:
        """Bring the next tab in front, or with -1 the one before; behind the last is the first."""
        tabs = self.program.tabs
        if len(tabs) > 1:
            self.bring((tabs.index(self.program.tab) + by) % len(tabs))

    def bring(self, number: int) -> None:
        """Bring the tab of a number in front."""
        self.files.bring(self.program.tabs[number])

    def jump(self, by: int) -> None:
        """Go to the place that one jumped from last, in whichever tab; with 1 forth again."""
        place = self.program.editor.jumps.turn(by)
        tab = None if place is None else self.program.tab_with(place.session)
        if place is None or tab is None:
            where = "back" if by < 0 else "forward"
            self.screen.notify(f"there is no place to go {where} to", timeout=2)
            return
        if tab is not self.program.tab:
            self.program.bring(tab)
            self.on_change()
        self.program.show_at(place.offset)
        self.program.editor.focus()

    async def close(self) -> None:
        """Close the program in front; behind the last one there is a new one."""
        if not await self.files.may_leave():
            return
        self.on_close(self.program.tab)
        if len(self.program.tabs) == 1:
            self.files.new(in_place=True)
        else:
            self.program.remove()
            self.on_change()
        self.program.editor.focus()

    async def may_quit(self) -> bool:
        """Ask, once, about all that is not saved; tell whether the studio may end."""
        changed = [tab for tab in self.program.tabs if tab.open.is_changed]
        if len(changed) < 2:
            self.files.bring(changed[0] if changed else self.program.tab)
            return await self.files.may_leave()
        from ..screens.question import Question

        answer = await self.screen.app.push_screen_wait(
            Question(
                f"Save {len(changed)} programs?",
                [("save", "Save all"), ("drop", "Don't save"), ("cancel", "Cancel")],
                text="Not saved: " + ", ".join(tab.open.name for tab in changed),
            )
        )
        if answer == "save":
            return await self._save(changed)
        if answer == "drop":
            for tab in changed:
                tab.open.journal.drop()
        return answer == "drop"

    async def _save(self, changed: list[Tab]) -> bool:
        for tab in changed:
            self.files.bring(tab)
            if not await self.files.save():
                return False
        return True
