"""The wizard's screen: one page after the other, and what comes of them always in view."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import ClassVar

from textual import events, on
from textual.binding import Binding, BindingType
from textual.widgets import Button
from textual.worker import Worker, WorkType

from plastron_tui.diagnostics import Edit
from plastron_tui.language import DECLARATIONS, Declaration
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.session import Session

from ..panels.text_view import TextView
from ..screens.question import Question
from ..textual_private import tell_first_sizes
from . import pasted, strings
from .flow import Course
from .form_page import Looked, Put, Stepped
from .frame import MENUS, Frame
from .menu import writes_at_once
from .menu_page import Menu, Picked, Wanted
from .pages import Heard, Look, PageKind
from .program_trial import Finding
from .result_view import ResultView
from .rows import REST_OF_PASTE, Confirmed
from .view import Asked, View, view_of

_PAUSE = 0.02
"""Seconds that keys are waited for before anything is looked up."""

_STATEMENTS: dict[str, type[Statement]] = {
    "part": st.HasLink,
    "package": st.CreatePackage,
    "another": st.CreateNode,
}
"""The statements that some answers to what is to be done next lead to."""

Enter = Callable[[Sequence[Edit]], Session]

_BINDINGS: list[BindingType] = [
    Binding("escape", "step_back", "Back"),
    Binding("f2,alt+left", "back", "Back", priority=True),
    Binding("f1", "explain", "Help", priority=True),
    Binding("f3", "turn", "Code and graph", priority=True),
    Binding("enter", "next", "Next", show=False),
    Binding("ctrl+q", "leave", "Leave", show=False, id="quit"),
]


class Wizard(Frame):
    """Builds statements; the result is an action of the main screen to go on with, or ""."""

    BINDINGS: ClassVar[list[BindingType]] = _BINDINGS

    def __init__(self, session: Session, enter: Enter) -> None:
        """Make the wizard.

        Args:
            session: the program as it is, for the wizard alone.
            enter: puts edits into the program as one step, and returns the program then.
        """
        super().__init__()
        tell_first_sizes(self)
        self.course = Course(session)
        self.look = Look()
        self.is_done = False
        self._enter = enter
        self._going = asyncio.Lock()
        self._nexts = self._backs = 0
        self._is_turning = True
        # On its way from the end to a form: Esc leads back from that.
        self._is_starting = False
        self._looks = 0
        self._pasted = ""
        self._waiting: list[Callable[[], object]] = []
        self._steps: list[int] = []
        self._worker: Worker[None] | None = None

    def on_mount(self) -> None:
        """Ask the first question."""
        for view in self.query(TextView):
            view.can_focus = False
        self.changed()

    def changed(self, then: Callable[[], object] | None = None) -> None:
        """Find out what follows; `then` is done before, when nobody else looks at the course."""
        if then is not None:
            self._waiting.append(then)
        self._is_stale = True
        if self._worker is None or self._worker.is_finished:
            self._worker = self.run_worker(self._find_out(), group="look")

    def _turn(self, do: Callable[[], object] | None = None) -> None:
        """Go to another page; keys that come meanwhile are for that one."""
        self._is_turning = True
        self.changed(do)

    async def _find_out(self) -> None:
        while self._is_stale:
            await asyncio.sleep(_PAUSE)
            await self._once()

    async def _once(self) -> None:
        """Do what was asked for, and show what follows from it."""
        try:
            await self._find_and_show()
        except Exception:
            # Who leaves takes away what it was to be shown in.
            if self in self.app.screen_stack:
                raise

    async def _find_and_show(self) -> None:
        self._is_stale = False
        self._looks += 1
        try:
            async with self._lock:
                waiting, self._waiting = self._waiting, []
                asked = self._asked()
                view = await asyncio.to_thread(self._view, waiting, asked)
                await self._show(view)
        finally:
            # What is not drawn yet has no place, and Tab would not find it.
            self.call_after_refresh(self._drawn)
        if not self._is_stale:
            await self.query_one(ResultView).show(
                view.look,
                self.course.session,
                self._lock,
                lambda: view.look is self.look,
                is_last=self.course.page.kind is PageKind.REVIEW,
            )

    def _drawn(self) -> None:
        self._looks -= 1
        if not (self._looks or self._is_stale or self._waiting):
            steps, self._steps = self._steps, []
            for by in steps:
                _step(self, by)
            self._is_turning = False

    @on(Stepped)
    def stepped(self, message: Stepped) -> None:
        """Go to another row; keys that come before its turn are for that one."""
        if self.is_settled:
            _step(self, message.by)
        else:
            self._steps.append(message.by)
            self._is_turning = True

    async def settled(self) -> Look:
        """Return what follows from all that was entered until now."""
        if self._worker is not None and not self._worker.is_finished:
            await self._worker.wait()
        if self._is_stale or self._waiting:
            await self._once()
        return self.look

    def _asked(self) -> Asked | None:
        """Return what choices are wanted for."""
        if (page := self._form_page) is None or (row := page.row_here) is None:
            return None
        return page.form, row.slot.name, row.path, row.query_text

    def _view(self, waiting: Sequence[Callable[[], object]], asked: Asked | None) -> View:
        """Find out, in a thread."""
        for do in waiting:
            do()
        return view_of(self.course, asked, is_done=self.is_done)

    @on(Put)
    def put(self, message: Put) -> None:
        """Take what was entered."""
        self.changed(lambda: message.form.put(message.slot.name, message.path, message.text))

    @on(Looked)
    def looked(self) -> None:
        """Look up the choices of another row."""
        page = self._form_page
        if page is not None and page.key_here is not None:
            self._places[page.form] = page.key_here
        self.changed()

    @on(Wanted)
    def wanted(self, message: Wanted) -> None:
        """Write something along with the statements, or not."""
        self.changed(lambda: self.course.want(message.key, message.value))

    @on(Picked)
    def picked(self, message: Picked) -> None:
        """Take an entry of a menu."""
        if self.is_done:
            self._finish_with(self._actions[message.number])
            return
        offer = self._offers[message.number]
        if writes_at_once(offer, self.course.session.workspace):
            self.dismiss("screen.generate")
            return
        if offer.recipe is not None:
            self.dismiss(f"screen.start_from({str(offer.recipe)!r})")
        else:
            self._turn(lambda: self.course.take(offer))

    def _finish_with(self, action: str) -> None:
        if action == "more":
            self._start_anew(None)
        elif action == "answer":
            self._start_anew(self._heard)
        elif action in _STATEMENTS:
            self._start_anew(None, DECLARATIONS[_STATEMENTS[action]])
        else:
            self.dismiss(action)

    def _start_anew(self, heard: Heard | None, declaration: Declaration | None = None) -> None:
        around = replace(self.course.surroundings, files=None)
        self._is_starting = heard is not None or declaration is not None

        def do() -> None:
            self._is_starting = False
            self.course = Course(self.course.session, around)
            self.is_done = False
            if heard is not None:
                self.course.answer(heard)
            if declaration is not None:
                self.course.begin_with(declaration)

        self.query_one(ResultView).forget()
        self._turn(do)

    def on_paste(self, event: events.Paste) -> None:
        """Take a text that no field has taken; a long one comes in several pieces."""
        event.stop()
        self._pasted += event.text
        work: WorkType[None] = self._take_pasted
        self.run_worker(work, group="pasted", exclusive=True)

    async def _take_pasted(self) -> None:
        """Take a word for an entry of the menu, and else lines for the program."""
        await asyncio.sleep(REST_OF_PASTE)
        text, self._pasted = self._pasted, ""
        lines = pasted.lines_of(text)
        menu = self.query(Menu)
        found = pasted.entry_for(text, self._items) if menu else None
        if found is not None:
            menu.first().highlighted = found
        elif any(line.strip() for line in lines) and self.app.screen is self:
            self.run_worker(self._offer_lines(lines), group="paste")

    async def _offer_lines(self, lines: Sequence[str]) -> None:
        if await self.app.push_screen_wait(pasted.dialog(lines)) != "insert":
            return
        async with self._lock:
            edit = pasted.insertion(self.course.session.document.text, lines)
            self.course.session = self._enter([edit])
        self.notify(pasted.inserted(lines), markup=False)
        self.changed()

    @on(Confirmed)
    @on(Button.Pressed, "#wizard-next")
    def action_next(self) -> None:
        """Go to the next page, or say why not."""
        if not self.is_done:
            self._nexts += 1
            self.run_worker(self._next(), group="next")

    async def _next(self) -> None:
        try:
            async with self._going:
                await self._go()
        finally:
            self._nexts -= 1

    @property
    def is_turning(self) -> bool:
        """Whether another page is on its way."""
        return self._is_turning or self._nexts > 0

    @property
    def is_settled(self) -> bool:
        """Whether the page, and all that it offers, follows from what was entered."""
        return not (self.is_turning or self._looks or self._is_stale or self._waiting)

    async def _go(self) -> None:
        look = await self.settled()
        page = self.course.page
        if page.kind in MENUS or self.is_done:
            return
        blocking = self.course.blocking(look)
        if blocking:
            self._insist_on(blocking[0], look)
        elif self._form_page is not None and self._form_page.goes_on():
            await self.settled()
        elif page.kind is PageKind.REVIEW:
            await self._finish(look)
        else:
            self._turn(self.course.go_on)
            await self.settled()

    def _insist_on(self, finding: Finding, look: Look) -> None:
        self.app.bell()
        page = self.course.page
        if finding.form is not None and finding.form is not page.form:
            self._places[finding.form] = (finding.slot, finding.path)
            number = self.course.page_of(finding.form, look)
            if number is not None:

                def do() -> None:
                    self.course.at = number

                self._turn(do)
        form_page = self._form_page
        if form_page is not None and finding.form in (None, form_page.form):
            form_page.insist(finding)
        else:
            self.notify(finding.words, severity="warning", markup=False)

    async def _finish(self, look: Look) -> None:
        assert look.outcome is not None
        async with self._lock:
            session = self._enter(look.outcome.edits)
            self._heard = self.course.heard(look)
            self._unanswered = strings.unanswered(look)
            self.course = Course(session, self.course.surroundings)
            self.is_done = True
        self._turn()

    @on(Button.Pressed, "#wizard-back")
    def action_back(self) -> None:
        """Go back a page; what was entered is kept."""
        if self._is_starting or not self.is_done:
            self._backs += 1
            self._turn(self._back)

    def _back(self) -> None:
        self._backs -= 1
        self.course.back()

    @on(Button.Pressed, "#wizard-turn")
    def action_turn(self) -> None:
        """Show the code and the graph in the place of the page, or the page again."""
        if self.has_class("-narrow"):
            self.toggle_class("-turned")

    def action_step_back(self) -> None:
        """Go back a page; from the first one, and from the end, leave."""
        # A page that is gone back from already may be shown still.
        is_first = self.is_done or self.course.at <= self._backs
        if is_first and not self._is_starting:
            self.action_leave()
        else:
            self.action_back()

    def action_explain(self) -> None:
        """Explain the page, and the keys of the wizard."""
        if self.app.screen is self:
            title, text = strings.explanation(self.course.page, self.is_done)
            self.app.push_screen(Question(title, [("close", "Close")], text=text))

    @on(Button.Pressed, "#wizard-leave")
    def action_leave(self) -> None:
        """Leave without a trace of what was not finished; ask where somebody filled it in."""
        if self.course.is_filled_in and self.app.screen is self:
            self.run_worker(self._ask_to_leave(), group="leave", exclusive=True)
        else:
            self.dismiss("")

    async def _ask_to_leave(self) -> None:
        answers = [("stay", "Stay"), ("leave", "Leave")]
        dialog = Question(strings.leaving(self.look), answers)
        if await self.app.push_screen_wait(dialog) == "leave":
            self.dismiss("")


def _step(wizard: Wizard, by: int) -> None:
    """Go to the next field, or with -1 to the one before."""
    if by > 0:
        wizard.focus_next()
    else:
        wizard.focus_previous()
