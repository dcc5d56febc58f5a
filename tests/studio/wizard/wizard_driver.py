"""The wizard on the screen, as a user has it."""

from __future__ import annotations

from collections.abc import AsyncIterator, Iterable
from contextlib import asynccontextmanager
from pathlib import Path

from studio_driver import Driver, studio
from textual.widgets import Label, OptionList
from wizard_courses import AWAY, SEND

from plastron_tui.language import Declaration
from plastron_tui.studio.panels.text_view import TextView
from plastron_tui.studio.wizard.form_page import FormPage
from plastron_tui.studio.wizard.goals import GROUPS, Aim, aim_of
from plastron_tui.studio.wizard.menu_page import Menu
from plastron_tui.studio.wizard.offers import FEW, undoing
from plastron_tui.studio.wizard.pages import PageKind
from plastron_tui.studio.wizard.result_view import ResultView
from plastron_tui.studio.wizard.rows import Row
from plastron_tui.studio.wizard.screen import Wizard
from plastron_tui.studio.wizard.statement_view import StatementView

SMALL = (80, 24)


class WizardDriver:
    """The wizard, and what tests ask of it."""

    def __init__(self, driver: Driver) -> None:
        self.driver = driver
        self.pilot = driver.pilot
        self.keys = 0

    @property
    def screen(self) -> Wizard:
        screen = self.driver.app.screen
        assert isinstance(screen, Wizard), screen
        return screen

    @property
    def is_open(self) -> bool:
        return isinstance(self.driver.app.screen, Wizard)

    def _is_settled(self) -> bool:
        if not self.is_open:
            return True
        screen = self.screen
        running = [each for each in screen.workers if each.node is screen and not each.is_finished]
        if running or screen._is_stale or screen._waiting:
            return False
        return screen._shown == (screen.is_done, screen.course.page)

    async def settle(self) -> None:
        for _ in range(3):
            await self.pilot.pause()
            await self.driver.until(self._is_settled)

    async def press(self, *keys: str) -> None:
        for key in keys:
            self.keys += 1
            await self.pilot.press(key)
            await self.settle()

    async def send(self, keys: Iterable[str]) -> None:
        """Press keys at once; they do what they do one by one, see `test_quick_keys`."""
        self.driver.send(keys)
        await self.driver.all_in()
        await self.settle()

    async def type(self, text: str) -> None:
        await self.send(text)

    async def write(self, label: str, text: str) -> None:
        """Go to a row by Tab, and write over what is in it."""
        await self.go_to(label)
        await self.send(["end", "ctrl+u", *text])

    async def go_to(self, label: str) -> None:
        row = self.row(label)
        rows = [*self.form.query(Row)]
        if (here := self.form.row_here) in rows and here is not None:
            # One before it at most: what is walked over may make rows come and go.
            await self.send(["tab"] * (rows.index(row) - rows.index(here) - 1))
        for _ in range(60):
            if self.form.row_here is row:
                return
            await self.pilot.press("tab")
            await self.settle()
        raise AssertionError(f"Tab does not lead to {label}")

    @property
    def title(self) -> str:
        return str(self.screen.query_one("#wizard-title", Label).content)

    @property
    def kind(self) -> PageKind:
        return self.screen.course.page.kind

    @property
    def form(self) -> FormPage:
        return self.screen.query_one(FormPage)

    def row(self, label: str) -> Row:
        return next(row for row in self.form.query(Row) if row._label.strip() == label)

    @property
    def rows(self) -> dict[str, str]:
        return {row._label.strip(): row.text for row in self.form.query(Row)}

    @property
    def help(self) -> str:
        return str(self.screen.query_one("#wizard-help", Label).content)

    @property
    def choices(self) -> list[str]:
        return [choice.label or choice.text for choice in self.form.choices]

    @property
    def menu(self) -> list[str]:
        return [item.title for item in self.screen._items]

    @property
    def here(self) -> str:
        """The entry of the menu that the cursor is on."""
        at = self.screen.query_one(Menu).highlighted
        return "" if at is None else self.menu[at]

    @property
    def statements(self) -> tuple[str, ...]:
        return self.screen.query_one(StatementView).lines

    def view(self, name: str) -> str:
        if name == "code":
            lines = self.screen.query_one(ResultView).code
            return "\n".join("".join(piece.text for piece in line) for line in lines)
        return self.screen.query_one(f"#wizard-{name}", TextView).text

    async def pick(self, title: str) -> None:
        """Choose an entry of a menu by keyboard."""
        for _ in range(len(self.menu)):
            if self.here == title:
                break
            await self.press("down")
        assert self.here == title, (self.here, self.menu)
        await self.press("enter")

    async def go(self, *titles: str) -> None:
        """Choose entries of menus by keyboard, with all suggestions of the forms between them."""
        for title in titles:
            while self.kind is PageKind.FORM:
                await self.press("enter")
            await self.pick(title)

    async def finish(self) -> None:
        """Accept all suggestions until the statements are in the program."""
        for _ in range(8):
            if self.screen.is_done:
                return
            await self.press("enter")
        raise AssertionError(f"it goes on at {self.title}")

    async def click_item(self, title: str) -> None:
        """Choose an entry of a menu by mouse."""
        await self.click_option(self.screen.query_one(Menu), self.menu.index(title))

    async def click_choice(self, label: str) -> None:
        """Take a choice by mouse."""
        options = self.screen.query_one("#wizard-choices", OptionList)
        await self.click_option(options, self.choices.index(label))

    async def click_option(self, options: OptionList, number: int) -> None:
        line = options._index_to_line[number]
        options.scroll_to(y=max(0, line - 1), animate=False, force=True)
        await self.pilot.pause()
        at = line - options.scroll_offset.y
        assert await self.pilot.click(options, offset=(3, at))
        await self.settle()

    async def click(self, selector: str) -> None:
        """Click a button; one that still shows the last click takes no other."""
        await self.driver.until(lambda: not self.screen.query_one(selector).has_class("-active"))
        assert await self.pilot.click(selector)
        await self.settle()


@asynccontextmanager
async def wizard(
    path: Path | None = None, size: tuple[int, int] = SMALL
) -> AsyncIterator[WizardDriver]:
    """Run the studio with the wizard open."""
    async with studio(path, size) as driver:
        found = WizardDriver(driver)
        await driver.pilot.press("ctrl+u")
        await driver.until(lambda: found.is_open)
        await found.settle()
        yield found


@asynccontextmanager
async def wizard_from_welcome() -> AsyncIterator[WizardDriver]:
    """Run the studio without a file, and let the welcome lead to the wizard."""
    async with studio(None, SMALL, welcome=True) as driver:
        found = WizardDriver(driver)
        await driver.dialog("Welcome")
        await found.press("enter")
        await driver.until(lambda: found.is_open)
        await found.settle()
        yield found


def way_to(declaration: Declaration) -> list[str]:
    """Return the entries of the menus that lead to a statement of a program with nodes."""
    group = GROUPS.get(aim_of(declaration))
    if group is not None:
        is_folded = declaration.undoes is not None and len(undoing(aim_of(declaration))) > FEW
        return [group.title, *([AWAY] if is_folded else []), declaration.purpose]
    if aim_of(declaration) in (Aim.NODE, Aim.CHANGE):
        return [declaration.purpose, SEND]
    return [declaration.purpose]
