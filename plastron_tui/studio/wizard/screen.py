"""The wizard's screen: one page after the other, and what comes of them always in view."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

from textual import events, on
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal, Vertical
from textual.screen import ModalScreen
from textual.widget import Widget
from textual.widgets import Button, Label
from textual.worker import Worker

from plastron_tui.diagnostics import Edit
from plastron_tui.language import SlotKind
from plastron_tui.session import Session

from ..panels.text_view import TextView
from ..panels.tones import Lines
from ..screens.question import Question
from . import words
from .aims import Aim, aim_of
from .ask import Choice
from .checking import Finding
from .course import Course, Look, Offer, Page, PageKind
from .form import Form
from .form_page import FormPage, Key, Looked, Put
from .libraries import installed
from .menu_page import Generates, Item, MenuPage, Picked, ReviewPage
from .rows import Confirmed
from .showing import arrows_of, changed_rows, code_of, drawing_of
from .statement_view import StatementView
from .values import Path

NARROW = 76
"""With fewer columns the code and the graph have a page of their own."""
WIDE = 116
"""From so many columns on, the graph is a picture."""

LOW = 22
"""With fewer rows the form does without the sentence above it."""

_PAUSE = 0.02
"""Seconds that keys are waited for before anything is looked up."""
_LONGEST_WAIT = 8.0
"""Seconds that the look for an installed ROS may take, before it is done without."""

_Asked = tuple[Form, str, "Path | None", str]
"""The row that choices are wanted for: its form, its slot, its field, and what was written."""

Enter = Callable[[Sequence[Edit]], Session]


@dataclass(frozen=True, slots=True)
class _View:
    """What was found out, in a thread."""

    look: Look
    helps: dict[Key, str]
    choices: list[Choice]
    offers: list[Offer]


class Wizard(ModalScreen[str]):
    """Builds statements; the result is an action of the main screen to go on with, or ""."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape", "leave", "Leave"),
        Binding("f2,alt+left", "back", "Back", priority=True),
        Binding("f1", "explain", "Help", priority=True),
        Binding("f3", "turn", "Code and graph", priority=True),
        Binding("enter", "next", "Next", show=False),
    ]

    def __init__(self, session: Session, enter: Enter) -> None:
        """Make the wizard.

        Args:
            session: the program as it is, for the wizard alone.
            enter: puts edits into the program as one step, and returns the program then.
        """
        super().__init__()
        self.course = Course(session)
        self.look = Look()
        self.is_done = False
        self._enter = enter
        self._lock = asyncio.Lock()
        self._going = asyncio.Lock()
        self._waiting: list[Callable[[], None]] = []
        self._is_stale = False
        self._worker: Worker[None] | None = None
        self._offers: list[Offer] = []
        self._items: list[Item] = []
        self._code: Lines = ()
        self._shown: tuple[bool, Page] | None = None
        self._environments = asyncio.Event()

    def compose(self) -> ComposeResult:
        """Make the parts that all pages share."""
        with Horizontal(id="wizard-head"):
            yield Label("", id="wizard-title", markup=False)
            yield Label("", id="wizard-step", markup=False)
        with Horizontal(id="wizard-body"):
            yield Vertical(id="wizard-page")
            with Vertical(id="wizard-side"):
                yield Label("Who sends what to whom", classes="wizard-caption", markup=False)
                yield TextView(id="wizard-graph")
                yield Label("", id="wizard-file", classes="wizard-caption", markup=False)
                yield TextView(id="wizard-code")
        yield StatementView(id="wizard-statements")
        with Horizontal(id="wizard-buttons"):
            yield Button("Back", id="wizard-back", compact=True)
            yield Button("Next", id="wizard-next", variant="primary", compact=True)
            yield Button("Code", id="wizard-turn", compact=True)
            yield Button("Leave", id="wizard-leave", compact=True)
            yield Label("", id="wizard-keys", markup=False)

    def on_mount(self) -> None:
        """Ask the first question, and look for an installed ROS meanwhile."""
        for view in self.query(TextView):
            view.can_focus = False
        self.run_worker(self._look_for_ros(), group="ros")
        self.changed()

    async def _look_for_ros(self) -> None:
        found = await asyncio.to_thread(installed, os.environ)
        async with self._lock:
            self.course.surroundings.environments = found
        self._environments.set()
        self.changed()

    # Finding out.

    def changed(self, then: Callable[[], None] | None = None) -> None:
        """Find out what follows; `then` is done before, when nobody else looks at the course."""
        if then is not None:
            self._waiting.append(then)
        self._is_stale = True
        if self._worker is None or self._worker.is_finished:
            self._worker = self.run_worker(self._find_out(), group="look")

    async def _find_out(self) -> None:
        while self._is_stale:
            await asyncio.sleep(_PAUSE)
            await self._once()

    async def _once(self) -> None:
        """Do what was asked for, and show what follows from it."""
        self._is_stale = False
        async with self._lock:
            waiting, self._waiting = self._waiting, []
            asked = self._asked()
            view = await asyncio.to_thread(self._view, waiting, asked)
            await self._show(view)
        if not self._is_stale:
            await self._show_result(view.look)

    async def settled(self) -> Look:
        """Return what follows from all that was entered until now."""
        if self._worker is not None and not self._worker.is_finished:
            await self._worker.wait()
        if self._is_stale or self._waiting:
            await self._once()
        return self.look

    def _asked(self) -> _Asked | None:
        """Return what choices are wanted for."""
        page = self._form_page
        row = None if page is None else page.row_here
        if page is None or row is None:
            return None
        return page.form, row.slot.name, row.path, row.query_text

    def _view(self, waiting: Sequence[Callable[[], None]], asked: _Asked | None) -> _View:
        """Find out, in a thread."""
        course = self.course
        for do in waiting:
            do()
        look = course.look()
        page = course.page
        offers: list[Offer] = []
        helps: dict[Key, str] = {}
        choices: list[Choice] = []
        if self.is_done:
            pass
        elif page.kind is PageKind.START:
            offers = course.start_offers()
        elif page.kind is PageKind.PURPOSE:
            offers = course.purpose_offers()
        elif page.form is not None:
            filled = look.of(page.form)
            if filled is not None:
                helps = course.helps(filled)
                if asked is not None and asked[0] is page.form:
                    choices = course.choices(filled, *asked[1:])
        return _View(look, helps, choices, offers)

    # Showing.

    @property
    def _form_page(self) -> FormPage | None:
        found = self.query(FormPage)
        return found.first() if found else None

    async def _show(self, view: _View) -> None:
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

    async def _turn_to(self, page: Page, view: _View) -> None:
        place = self.query_one("#wizard-page", Vertical)
        await place.remove_children()
        await place.mount(self._page_widget(page, view))

    def _page_widget(self, page: Page, view: _View) -> Widget:
        course = self.course
        if self.is_done:
            self._items = words.done_items(course.session)
            return MenuPage(words.DONE, self._items)
        if page.kind is PageKind.FORM and page.form is not None:
            return FormPage(page.form)
        if page.kind is PageKind.REVIEW:
            offer = f"write {view.look.node} to its file, too" if view.look.can_generate else ""
            return ReviewPage(words.review(view.look), offer, course.generates)
        self._offers = view.offers
        self._items = [Item(o.title, o.term, o.about, o.closed, o.is_advised) for o in view.offers]
        here = next((n for n, o in enumerate(view.offers) if course.is_chosen(o)), None)
        return MenuPage(words.question(page, view.look), self._items, here)

    def _show_frame(self, page: Page, look: Look) -> None:
        """Show what is around the page."""
        pages = self.course.pages(look)
        self.query_one("#wizard-title", Label).update(words.title(page, self.is_done))
        step = "" if self.is_done or page.kind is PageKind.START else f"step {self.course.at}"
        self.query_one("#wizard-step", Label).update(step)
        is_menu = self.is_done or page.kind in (PageKind.START, PageKind.PURPOSE)
        is_last = page.kind is PageKind.REVIEW
        back = self.query_one("#wizard-back", Button)
        back.display = not self.is_done and self.course.at > 0
        following = self.query_one("#wizard-next", Button)
        following.display = not is_menu
        following.label = "Finish" if is_last else "Next"
        turn = self.query_one("#wizard-turn", Button)
        turn.display = self.has_class("-narrow") and look.outcome is not None
        self.query_one("#wizard-leave", Button).label = "Close" if self.is_done else "Leave"
        self.query_one("#wizard-keys", Label).update(words.keys(page, self.is_done))
        outcome = look.outcome
        self.set_class(outcome is None, "-empty")
        shown = self.query_one("#wizard-statements", StatementView)
        if outcome is not None:
            here = [
                number
                for number, line in enumerate(outcome.lines)
                if page.form is not None and line == self._text_of(page.form, look)
            ]
            shown.show(outcome.lines, frozenset(here[:1]))
        if is_last and not self.is_done and pages:
            review = self.query(ReviewPage)
            if review:
                problem = look.problems[0].words if look.problems else ""
                review.first().say(problem)

    def _text_of(self, form: Form, look: Look) -> str:
        filled = look.of(form)
        return "" if filled is None else filled.text

    async def _show_result(self, look: Look) -> None:
        """Show the code and the graph; it takes longer than the rest, and comes after it."""
        outcome = look.outcome
        # As long as something is wrong, what was right before it stays in view.
        if outcome is None or (look.problems and self._code):
            return
        is_wide = self.app.size.width >= WIDE
        session = self.course.session
        side = self.query_one("#wizard-side").size
        room = side.width - 3, side.height // 3

        def find() -> tuple[str, Lines, Lines]:
            name, lines = code_of(outcome.session, look.node)
            if is_wide:
                return name, lines, drawing_of(session, outcome.session, *room)
            return name, lines, arrows_of(session, outcome.session)

        async with self._lock:
            name, lines, graph = await asyncio.to_thread(find)
        if look is not self.look or not self.is_attached:
            return
        self.query_one("#wizard-graph", TextView).show(graph)
        self.query_one("#wizard-file", Label).update(name or "The file of the node")
        code = self.query_one("#wizard-code", TextView)
        rows = changed_rows(self._code, lines) if self._code else range(0)
        code.show(lines)
        if rows:
            middle = rows.start + min(len(rows), code.size.height) // 2
            top = max(0, middle - code.size.height // 2)
            self.call_after_refresh(code.scroll_to, y=top, animate=False)
        self._code = lines

    def on_resize(self, event: events.Resize) -> None:
        """Make the best of another size."""
        self.set_class(event.size.width < NARROW, "-narrow")
        self.set_class(event.size.height < LOW, "-low")
        if event.size.width >= NARROW:
            self.remove_class("-turned")
        self.changed()

    # What comes from the pages.

    @on(Put)
    def put(self, message: Put) -> None:
        """Take what was entered."""
        form, slot, path, text = message.form, message.slot, message.path, message.text

        def do() -> None:
            if path is None:
                form.entered[slot.name] = text
            else:
                form.values[path] = text

        self.changed(do)

    @on(Looked)
    def looked(self) -> None:
        """Look up the choices of another row."""
        self.changed()

    @on(Generates)
    def generates(self, message: Generates) -> None:
        """Generate the node, or not."""

        def do() -> None:
            self.course.generates = message.value

        self.changed(do)

    @on(Picked)
    def picked(self, message: Picked) -> None:
        """Take an entry of a menu."""
        if self.is_done:
            self._finish_with(words.DONE_ACTIONS[message.number])
            return
        offer = self._offers[message.number]
        if self._writes_at_once(offer):
            self.dismiss("screen.generate")
            return
        self.changed(lambda: self.course.choose(offer.declaration))

    def _writes_at_once(self, offer: Offer) -> bool:
        """Tell whether all that could be generated is: then the files can be written."""
        if offer.declaration is None or aim_of(offer.declaration) is not Aim.WRITE:
            return False
        workspace = self.course.session.workspace
        generated = {made.node.variable for made in workspace.generations}
        return all(node.is_idle or name in generated for name, node in workspace.nodes.items())

    def _finish_with(self, action: str) -> None:
        if action != "more":
            self.dismiss(action)
            return
        self._start_anew()

    def _start_anew(self) -> None:
        around = replace(self.course.surroundings, files=None)

        def do() -> None:
            self.course = Course(self.course.session, around)
            self.is_done = False

        self._code = ()
        self.changed(do)

    # Going on.

    @on(Confirmed)
    def confirmed(self) -> None:
        """Go on."""
        self.action_next()

    @on(Button.Pressed, "#wizard-next")
    def action_next(self) -> None:
        """Go to the next page, or say why not."""
        if not self.is_done:
            self.run_worker(self._next(), group="next")

    async def _next(self) -> None:
        # A second Enter counts for the page that the first one leads to.
        async with self._going:
            await self._go()

    async def _go(self) -> None:
        look = await self.settled()
        page = self.course.page
        if page.kind in (PageKind.START, PageKind.PURPOSE) or self.is_done:
            return
        if page.form is not None and page.form.slot_of(SlotKind.LIBRARY) is not None:
            await self._wait_for_ros()
            look = await self.settled()
        blocking = self.course.blocking(look)
        if blocking:
            self._refuse(blocking[0], look)
        elif page.kind is PageKind.REVIEW:
            await self._finish(look)
        else:
            self.changed(self._forwards)
            await self.settled()

    def _forwards(self) -> None:
        self.course.at += 1

    async def _wait_for_ros(self) -> None:
        try:
            await asyncio.wait_for(self._environments.wait(), _LONGEST_WAIT)
        except asyncio.TimeoutError:
            self._environments.set()

    def _refuse(self, finding: Finding, look: Look) -> None:
        self.app.bell()
        page = self.course.page
        if finding.form is not None and finding.form is not page.form:
            number = self.course.page_of(finding.form, look)
            if number is not None:

                def do() -> None:
                    self.course.at = number

                self.changed(do)
        form_page = self._form_page
        if form_page is not None and finding.form in (None, form_page.form):
            form_page.insist(finding)
        else:
            self.notify(finding.words, severity="warning", markup=False)

    async def _finish(self, look: Look) -> None:
        assert look.outcome is not None
        async with self._lock:
            session = self._enter(look.outcome.edits)
            self.course = Course(session, self.course.surroundings)
            self.is_done = True
        self.changed()

    @on(Button.Pressed, "#wizard-back")
    def action_back(self) -> None:
        """Go back a page; what was entered is kept."""
        if not self.is_done:
            self.changed(self._backwards)

    def _backwards(self) -> None:
        self.course.back()

    @on(Button.Pressed, "#wizard-turn")
    def action_turn(self) -> None:
        """Show the code and the graph in the place of the page, or the page again."""
        if self.has_class("-narrow"):
            self.toggle_class("-turned")

    def action_explain(self) -> None:
        """Explain the page, and the keys of the wizard."""
        if self.app.screen is self:
            title, text = words.explanation(self.course.page, self.is_done)
            self.app.push_screen(Question(title, [("close", "Close")], text=text))

    @on(Button.Pressed, "#wizard-leave")
    def action_leave(self) -> None:
        """Leave without a trace of what was not finished."""
        self.dismiss("")
