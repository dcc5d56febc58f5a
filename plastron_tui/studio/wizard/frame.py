"""What is around a page of the wizard: the statements, the code, the graph, the buttons."""

from __future__ import annotations

import asyncio
from typing import ClassVar

from textual import events
from textual.app import ComposeResult
from textual.containers import Horizontal, Vertical
from textual.content import Content
from textual.geometry import Size
from textual.types import CSSPathType
from textual.widget import Widget
from textual.widgets import Button, Label

from plastron_tui.diagnostics.terminal import visible

from ..key_order import Paged
from ..screens.dialog import Dialog
from . import strings
from .done_menu import DONE, done_items
from .flow import Course
from .form import Form
from .form_page import FormPage
from .form_rows import Key
from .key_hints import drawn_keys
from .menu import Offer
from .menu_page import Item, MenuPage, ReviewPage
from .pages import Heard, Look, Page, PageKind
from .result_view import ResultView
from .statement_view import StatementView
from .style_sheets import STYLES
from .view import View

NARROW = 76
"""With fewer columns the code and the graph have a page of their own."""
MENUS = (PageKind.START, PageKind.PURPOSE, PageKind.AWAY, PageKind.RECIPES)
"""The pages on which an entry is chosen."""
SPACIOUS = 110
"""From so many columns on the page has the width of a text, and the code all the rest."""
STATEMENTS, FEW_STATEMENTS = 6, 4
"""The most rows of statements, but for the last page, where they are what is looked at: in a high
window, and where the form needs the room."""
LOW = 22
"""With fewer rows no empty ones part the sentence, the form and what is said of it."""
HIGH = 32
"""From so many rows on there are empty ones around what is asked, and frames."""


def _size_classes(size: Size) -> dict[str, bool]:
    """Return the classes of the screen, and whether a size has them."""
    return {
        "-narrow": size.width < NARROW,
        "-tight": size.width < SPACIOUS,
        "-spacious": size.width >= SPACIOUS,
        "-framed": size.width >= SPACIOUS and size.height >= HIGH,
        "-low": size.height < LOW,
        "-high": size.height >= HIGH,
    }


class Buttons(Horizontal):
    """The line at the bottom: where one can go, and the keys."""

    def compose(self) -> ComposeResult:
        """Make the buttons; which of them there are is known with the first page."""
        back = Button("Back", id="wizard-back", compact=True)
        # Tab leads from the last field on, and F2 back.
        back.can_focus = False
        following = Button("Next", id="wizard-next", variant="primary", compact=True)
        turn = Button("Code", id="wizard-turn", compact=True)
        leave = Button("Leave", id="wizard-leave", compact=True)
        # Tab goes round the fields: one too many, and Enter, would forget them all.
        leave.can_focus = False
        for button in (back, following, turn, leave):
            button.display = False
            yield button
        yield Label("", id="wizard-keys", markup=False)

    def show(self, course: Course, look: Look, *, is_done: bool, is_narrow: bool) -> None:
        """Show the buttons that the page has.

        Args:
            course: the state of the wizard.
            look: what follows from it.
            is_done: whether the statements are in the program.
            is_narrow: whether the code has a page of its own.
        """
        kind = course.page.kind
        self.query_one("#wizard-back", Button).display = not is_done and course.at > 0
        following = self.query_one("#wizard-next", Button)
        following.display = not (is_done or kind in MENUS)
        is_last = kind is PageKind.REVIEW
        following.label = "Finish" if is_last else "Next"
        following.variant = "default" if is_last and look.problems else "primary"
        self.query_one("#wizard-turn", Button).display = is_narrow and look.outcome is not None
        # At the end the menu has an entry that leaves.
        self.query_one("#wizard-leave", Button).display = not is_done


class Frame(Paged, Dialog[str]):
    """Shows what was found out.

    Attributes:
        course: the state of the wizard.
        look: all that follows from it, as it is shown.
        is_done: whether the statements are in the program.
    """

    CSS_PATH: ClassVar[CSSPathType | None] = STYLES
    # The first page has the focus once it is known, and nothing before.
    AUTO_FOCUS = ""

    course: Course
    look: Look
    is_done: bool

    def __init__(self) -> None:
        # Until something is known there is nothing beside the first page.
        super().__init__(classes="-empty -menu")
        # Who holds it is the only one to look at the course, or to change it.
        self._lock = asyncio.Lock()
        self._is_stale = False
        self._offers: list[Offer] = []
        self._items: list[Item] = []
        self._actions: list[str] = []
        self._heard: Heard | None = None
        self._unanswered = ""
        # By form, the row that had the focus last.
        self._places: dict[Form, Key] = {}
        self._shown: tuple[bool, Page] | None = None

    def changed(self) -> None:
        """Find out what follows from a change."""

    def compose(self) -> ComposeResult:
        """Make the parts that all pages share."""
        with Horizontal(id="wizard-head"):
            yield Label("", id="wizard-title", markup=False)
            yield Label("", id="wizard-step", markup=False)
        with Horizontal(id="wizard-body"):
            yield Vertical(id="wizard-page")
            yield ResultView(id="wizard-side")
        yield StatementView(id="wizard-statements")
        yield Buttons(id="wizard-buttons")

    @property
    def _form_page(self) -> FormPage | None:
        found = self.query(FormPage)
        return found.first() if found else None

    async def _show(self, view: View) -> None:
        self.look = view.look
        page = self.course.page
        wanted = (self.is_done, page)
        if wanted != self._shown:
            self._shown = wanted
            await self._turn_to(page, view)
            if page.kind is PageKind.REVIEW and not self.is_done:
                self.query_one("#wizard-next", Button).focus()
            if page.form is not None and not self.is_done:
                self._is_stale = True
        form_page = self._form_page
        if form_page is not None and page.form is not None:
            filled = view.look.of(page.form)
            if filled is not None:
                await form_page.show(filled, view.look.problems, view.helps)
                form_page.show_choices(view.choices)
        self._show_frame(page, view.look)

    async def _turn_to(self, page: Page, view: View) -> None:
        place = self.query_one("#wizard-page", Vertical)
        await place.remove_children()
        await place.mount(self._page_widget(page, view))

    def _page_widget(self, page: Page, view: View) -> Widget:
        course = self.course
        if self.is_done:
            heard = self._heard.topic if self._heard else ""
            items = done_items(course.session, heard, self._unanswered)
            self._items, self._actions = list(items.values()), list(items)
            return MenuPage(DONE, self._items)
        if page.kind is PageKind.FORM and page.form is not None:
            return FormPage(page.form, self._places.get(page.form))
        if page.kind is PageKind.REVIEW:
            return ReviewPage(strings.review(view.look), course.options(view.look))
        self._offers = view.offers
        self._items = [Item(o.title, o.term, o.about, o.closed, o.is_advised) for o in view.offers]
        here = next((n for n, o in enumerate(view.offers) if course.is_chosen(o)), None)
        return MenuPage(strings.question(page, view.look, course.group), self._items, here)

    def _show_frame(self, page: Page, look: Look) -> None:
        """Show what is around the page."""
        title = strings.title(page, self.is_done, self.course.group)
        path = self.course.session.path
        is_counted = not (self.is_done or page.kind is PageKind.START)
        name = "" if path is None else visible(path.name)
        step = strings.place(name, self.course.at if is_counted else 0)
        self.query_one("#wizard-title", Label).update(title)
        self.query_one("#wizard-step", Label).update(step)
        frame = self.query_one("#wizard-page", Vertical)
        frame.border_title, frame.border_subtitle = Content(title), Content(step)
        is_narrow = self.has_class("-narrow")
        buttons = self.query_one(Buttons)
        buttons.show(self.course, look, is_done=self.is_done, is_narrow=is_narrow)
        self._show_keys()
        outcome = look.outcome
        self.set_class(outcome is None, "-empty")
        self.set_class(page.kind is PageKind.REVIEW, "-last")
        self.set_class(self.is_done or page.kind in MENUS, "-menu")
        shown = self.query_one("#wizard-statements", StatementView)
        if outcome is not None:
            filled = None if page.form is None else look.of(page.form)
            rows = STATEMENTS if self.has_class("-high") else FEW_STATEMENTS
            if page.kind is PageKind.REVIEW:
                rows = self.size.height // 2
            shown.show(outcome.lines, "" if filled is None else filled.text, rows)
        for review in self.query(ReviewPage):
            review.say(strings.review(look), look.problems[0].words if look.problems else "")

    def on_descendant_focus(self) -> None:
        """Say what the keys do where the focus is."""
        self._show_keys()

    def _show_keys(self) -> None:
        is_turn = self.focused is not None and self.focused.id == "wizard-turn"
        words = strings.keys(self.course.page, self.is_done, is_turn=is_turn)
        self.query_one("#wizard-keys", Label).update(drawn_keys(words))

    def on_resize(self, event: events.Resize) -> None:
        """Make the best of another size."""
        for name, is_so in _size_classes(event.size).items():
            self.set_class(is_so, name)
        if event.size.width >= NARROW:
            self.remove_class("-turned")
        self.changed()
