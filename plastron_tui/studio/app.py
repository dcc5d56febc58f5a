"""The studio: the app around the main screen."""

from __future__ import annotations

import asyncio
import os
import signal
import sys
import threading
from collections.abc import Iterable, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path, PurePath
from time import monotonic
from types import FrameType
from typing import Any, ClassVar

from textual import events, on
from textual.app import App
from textual.binding import Binding, BindingType
from textual.driver import Driver
from textual.filter import LineFilter
from textual.notifications import SeverityLevel
from textual.screen import Screen
from textual.worker import WorkerFailed

from plastron_tui.diagnostics.terminal import visible_text
from plastron_tui.private_files import sweep
from plastron_tui.project.other_files import other_kind
from plastron_tui.regular_files import is_same_file
from plastron_tui.session import Options
from plastron_tui.user_folders import state_folder

from .analysis_worker import AnalysisFailed
from .config import Config, Profile, config_file, load_remembered, save_remembered
from .files import OnDisk, meant_by, open_file
from .journal import Kept
from .key_display import key_name
from .key_order import InOrder
from .legibility import LEGIBLE_TEXT
from .main.screen import MainScreen
from .open_program import Open, opened
from .terminal_driver import for_terminal
from .terminal_keys import teach
from .terminal_output import ShownScreen
from .textual_private import notes_in_sight, translate_colours
from .theme_colours import usual_theme, with_grounds

_SAME_NOTE = 0.3
"""Seconds within which the same note again is the same one."""
_WIZARD = "screen.wizard"
"""The action that shows what one is to learn by watching: no note lies over it."""
_ENDS_WITHIN = 5.0
"""Seconds that the studio has to end in good order once the system says so."""
_AT_ONCE = 5
"""How many of the messages of the start are shown."""
_ANSI_STYLES = Path(__file__).with_name("ansi.tcss")


class StudioApp(InOrder, inherit_bindings=False):
    """Opens a program, and keeps what lasts longer than it."""

    TITLE = "plastron"
    CSS_PATH = "studio.tcss"
    # The studio's own menu knows groups and what was done of late.
    ENABLE_COMMAND_PALETTE = False
    # The editor selects its text itself. Textual's selecting takes it that whatever the mouse is
    # pressed on has a parent, also where it was removed a moment ago.
    ALLOW_SELECT = False
    BINDINGS: ClassVar[list[BindingType]] = []

    def __init__(
        self,
        path: Path | None = None,
        options: Options | None = None,
        first: str | None = None,
        others: Sequence[Path] = (),
    ) -> None:
        """Start the studio.

        Args:
            path: the program to open; it need not be there yet.
            options: what the command line sets.
            first: the action of the main screen that is done first, instead of the welcome.
            others: more programs, each for a tab of its own.
        """
        self._shown = ShownScreen()
        super().__init__()
        folder = state_folder()
        config, self._messages = _configured(self.available_themes)
        self._has_wrong_settings = bool(self._messages)
        self.profile = Profile(config, load_remembered(folder), folder)
        self._begin_with(self._first_theme())
        self._paths = [] if path is None else _different([path, *others])
        self._other_files: list[Path] = []
        self._options = options or Options()
        self._first = None if first is None else f"screen.{first}"
        self._failures: set[str] = set()
        self.last_words = ""
        self._last_note = "", 0.0
        self._is_up = self._is_for_editor = False

    def get_default_screen(self) -> Screen[None]:
        """Open the programs that were asked for."""
        disks: list[OnDisk | None] = []
        for path in self._paths:
            if other_kind(path) is not None:
                self._other_files.append(path)
                continue
            found = open_file(path)
            self._messages += found.said
            if found.disk is not None:
                disks.append(found.disk)
            if found.problem is not None:
                self._messages += (found.problem.message,)
        programs = [opened(disk, self.profile.journals, self._options) for disk in disks or [None]]
        return MainScreen(programs[0], self.profile, programs[1:])

    @property
    def main(self) -> MainScreen:
        """The main screen."""
        screen = self.screen_stack[0]
        assert isinstance(screen, MainScreen)
        return screen

    def on_mount(self) -> None:
        """Take the theme and the keys; offer what was not saved; say what is wrong."""
        self.call_after_refresh(self._came_up)
        first = self.theme
        self.theme_changed_signal.subscribe(self, lambda theme: self._themed(theme.name, first))
        self.app_resume_signal.subscribe(self, lambda _: self.refresh(layout=True))
        keys = {action: keys for action, keys in self.profile.config.keys.items() if keys}
        if keys:
            self.set_keymap(keys)
        sweep(self.profile.folder)
        where = f"{self.main.key_of('config')} lists those of the settings"
        for message in shown_at_once(self._messages, where if self._has_wrong_settings else ""):
            self.notify(message, severity="warning", timeout=10, markup=False)
        if not self.is_headless:
            for number in (signal.SIGTERM, signal.SIGHUP):
                signal.signal(number, partial(self._told_to_end, asyncio.get_running_loop()))
        programs = [tab.open for tab in self.main.program.tabs]
        kept = self.main.recovery.not_saved()
        of = {open_: [each for each in kept if _belongs(each, open_)] for open_ in programs}
        own = [each for belonging in of.values() for each in belonging[:1]]
        others = [each for each in kept if not any(_belongs(each, open_) for open_ in programs)]
        for open_ in reversed(programs):
            if open_.path is not None:
                self.profile.remembered.opened(open_.path)
        # The welcome lists them; it is not in front where something else was asked for.
        if self._first not in (None, _WIZARD) or (self._paths and self._first is None):
            page = f"the welcome page ({self.main.key_of('welcome')})"
            self.main.recovery.tell(others, self.profile.remembered, page)
        if own or self._other_files:
            found = [*own, *self._other_files]
            self.call_after_refresh(self.main.offer_first, found, self._first)
        elif self._first is not None:
            self.call_after_refresh(self.run_call, self._first)
        elif not self._paths:
            self.call_after_refresh(self.main.action_welcome)
        else:
            self._is_for_editor = True

    def on_ready(self) -> None:
        """Let the editor have the keys once it is drawn, where nothing else opens before it."""
        self._is_up |= self._is_for_editor

    def _came_up(self) -> None:
        """Note that there is a screen that keys can go to."""
        self._is_up = True

    def _first_theme(self) -> str:
        wanted = self.profile.config.theme or self.profile.remembered.theme
        if wanted in self.available_themes:
            return wanted
        return usual_theme(os.environ)

    def get_css_variables(self) -> dict[str, str]:
        """Return the colours of the theme, and which of them are the grounds of text and panels."""
        return with_grounds(super().get_css_variables())

    def _begin_with(self, theme: str) -> None:
        """Have a theme before anything is styled; a change of it would style all once more."""
        if theme != self.theme:
            self.set_reactive(App.theme, theme)
            self.stylesheet.set_variables(self.get_css_variables())
        self.watch_theme()
        is_dark = self.current_theme.dark
        self.set_class(is_dark, "-dark-mode", update=False)
        self.set_class(not is_dark, "-light-mode", update=False)
        translate_colours(self)

    def watch_theme(self) -> None:
        """Have the rules for a terminal's own colours where a theme leaves those as they are."""
        if self.native_ansi_color:
            self._add_style_sheet(_ANSI_STYLES)

    watch_ansi_color = watch_theme

    def _add_style_sheet(self, path: PurePath) -> None:
        """Add a style sheet; Textual would read all of them anew, and style all screens again."""
        if not self.stylesheet.has_source(str(path), ""):
            self.stylesheet.add_source(Path(path).read_text("utf-8"), (str(path), ""))

    def _themed(self, name: str, first: str) -> None:
        if name != first or self.profile.remembered.theme is not None:
            self.profile.remembered.theme = name

    def action_change_theme(self) -> None:
        """Choose other colours, and see them meanwhile."""
        from .screens.themes import choose_theme

        remembered = self.profile.remembered
        choose_theme(self, remembered.theme, partial(setattr, remembered, "theme"))

    async def run_call(self, call: str) -> None:
        """Do an action by its call."""
        await self.run_action(call, self.main)

    def get_screen(self, screen: Any, screen_class: Any = None) -> Any:
        """Return a screen, with its style sheets added to the app's."""
        found: Screen[Any] = super().get_screen(screen, screen_class)
        for path in found.css_path:
            self._add_style_sheet(path)
        return found

    def get_driver_class(self) -> type[Driver]:
        """Return what writes to the terminal, and reads what comes from there."""
        return for_terminal(super().get_driver_class(), self._shown, self._no_more_keys)

    def get_key_display(self, binding: Binding) -> str:
        """Return what a key is called, everywhere in the studio."""
        return key_name(binding.key)

    def get_line_filters(self) -> Sequence[LineFilter]:
        """Return what each line passes through: nothing in it is obeyed, and it can be read."""
        return [*super().get_line_filters(), LEGIBLE_TEXT]

    def notify(
        self,
        message: str,
        *,
        title: str = "",
        severity: SeverityLevel = "information",
        timeout: float | None = None,
        markup: bool = True,
    ) -> None:
        """Say something in the corner, once, with what is invisible in it escaped."""
        text = visible_text(message)
        now = monotonic()
        last, self._last_note = self._last_note, (text, now)
        # What was said a moment ago is not among the notes yet.
        is_new = last[0] != text or now - last[1] > _SAME_NOTE
        if is_new and text not in [note.message for note in notes_in_sight(self)]:
            super().notify(text, title=title, severity=severity, timeout=timeout, markup=markup)

    @on(AnalysisFailed)
    def analysis_failed(self, message: AnalysisFailed) -> None:
        """Show what went wrong in the worker; the text is safe in the editor."""
        self.show_error(message.error)

    def show_error(self, error: BaseException) -> None:
        """Show an error of Plastron's own, with the place of the journal and a report; once."""
        from .screens.failure import Failure, report_of

        self.main.recovery.keep_now()
        report = report_of(error)
        if report not in self._failures:
            self._failures.add(report)
            self.push_screen(Failure(report, self.main.open.journal.file))

    def _no_more_keys(self, error: Exception) -> None:
        """End, from the thread that reads from the terminal: nothing can be typed any more."""
        self.call_later(self.fail, error)

    def survives(self, error: Exception) -> bool:
        """Survive what goes wrong in a worker; end with a report what ends a widget's loop."""
        if isinstance(error, WorkerFailed):
            self.show_error(error.error)
            return True
        from .screens.failure import last_words

        self.last_words = last_words(error, self._keep_all(), self.profile.folder)
        return False

    def _keep_all(self) -> Path | None:
        """Keep what is not saved; return where, None when all is saved or nothing is open."""
        with suppress(Exception):
            self.main.recovery.keep_now()
            changed = (tab.open for tab in self.main.program.tabs if tab.open.is_changed)
            return next((open_.journal.file for open_ in changed), None)
        return None

    def _told_to_end(
        self, loop: asyncio.AbstractEventLoop, number: int, frame: FrameType | None
    ) -> None:
        """End because the system says so: the terminal has gone, or the machine goes down."""
        status = 128 + number  # as a shell has it
        # What Textual writes to a terminal that has gone is taken by nobody, and the event loop
        # may wait for that without end: it has its time, and no more.
        guard = threading.Timer(_ENDS_WITHIN, self._end_at_once, [status])
        guard.daemon = True
        guard.start()
        loop.call_soon_threadsafe(self._end, status)

    def _end(self, status: int) -> None:
        self._keep_all()
        self.exit(return_code=status)

    def _end_at_once(self, status: int) -> None:
        self._keep_all()
        os._exit(status)

    def listens(self) -> bool:
        """Tell whether keys reach somebody; the editor has them where nothing else has."""
        if not self.is_running or not self._is_up:
            return False
        if self.screen is self.main and self.main.focused is None:
            self.main.set_focus(self.main.editor.view)
        return True

    def on_app_blur(self, event: events.AppBlur) -> None:
        """Leave the focus where it is: some terminals say at the start that they lost it."""
        event.prevent_default()

    def on_app_focus(self) -> None:
        """Let the editor have the keys, when the window gets the focus before anything else."""
        self.listens()

    def on_resize(self, event: events.Resize) -> None:
        """Draw all anew, for the same size too: there may have been another one meanwhile."""
        self._shown.forget()
        if event.size == self.size:
            self.refresh()

    def on_unmount(self) -> None:
        """Remember what lasts."""
        save_remembered(self.profile.folder, self.profile.remembered)


def _configured(themes: Iterable[str]) -> tuple[Config, tuple[str, ...]]:
    """Return what the configuration file says, and what is wrong with it."""
    file = config_file()
    if not os.path.lexists(file):
        return Config(), ()
    from .actions import key_owners
    from .config_reader import load_config

    return load_config(file, key_owners(), themes)


def _belongs(kept: Kept, open_: Open) -> bool:
    return kept.belongs_to(open_.path, open_.session.folder)


def _different(paths: Iterable[Path]) -> list[Path]:
    """Return the programs that are meant by paths, each file once."""
    different: list[Path] = []
    for path in map(meant_by, paths):
        if not any(is_same_file(path, each) for each in different):
            different.append(path)
    return different


def run(
    path: Path | None,
    options: Options | None = None,
    first: str | None = None,
    others: Sequence[Path] = (),
) -> int:
    """Run the studio in this terminal, and return the exit status."""
    teach()
    # Who writes here runs the nodes here as well.
    app = StudioApp(path, (options or Options())._replace(tells_absent=True), first, others)
    app.run(mouse=app.profile.config.mouse)
    if app.last_words:
        print(app.last_words, file=sys.stderr)
    return app.return_code or 0


def run_served() -> None:
    """Run the studio for a browser's server, with the program's argument as its file, and exit."""
    sys.exit(run(Path(sys.argv[1]) if len(sys.argv) > 1 else None))


def shown_at_once(messages: Sequence[str], where: str = "") -> list[str]:
    """Return messages so that they leave room on the screen: the first of them in one.

    Args:
        messages: what there is to say.
        where: where they are to be read, and the rest too.
    """
    first, more = messages[:_AT_ONCE], len(messages) - _AT_ONCE
    last = [": ".join(filter(None, (f"… and {more} more" if more > 0 else "", where)))]
    return ["\n".join(filter(None, (*first, *last)))] if first else []
