"""What the studio uses of Textual without Textual's word for it: there now, and can be missing."""

from __future__ import annotations

import asyncio
import gc
import sys
import weakref
from collections.abc import Iterator
from contextvars import ContextVar
from typing import ClassVar

import pytest
from textual import events
from textual._context import message_hook
from textual._styles_cache import StylesCache
from textual._xterm_parser import XTermParser
from textual.app import App
from textual.color import Color
from textual.command import CommandPalette
from textual.driver import Driver
from textual.drivers import linux_driver as textual_driver
from textual.drivers.linux_driver import LinuxDriver
from textual.geometry import Offset, Size
from textual.message import Message
from textual.message_pump import MessagePump
from textual.screen import Screen
from textual.widgets import Static
from textual.worker import WorkerFailed

from plastron_tui.studio import terminal_driver
from plastron_tui.studio.app import StudioApp
from plastron_tui.studio.terminal_driver import Burst, for_terminal
from plastron_tui.studio.terminal_keys import teach
from plastron_tui.studio.terminal_output import ShownScreen
from plastron_tui.studio.textual_private import (
    Failing,
    StyledLate,
    forget_notes,
    forget_removed_widgets,
    known_sequences,
    leave_as_drawn,
    linux_driver,
    notes_in_sight,
    output_of,
    parse_input_with,
    take_any_bytes,
    tell_first_sizes,
)


async def test_this_version_of_textual_has_it() -> None:
    known = known_sequences()
    assert known is not None
    assert "\x1bOP" in known
    assert callable(App._handle_exception)
    assert isinstance(App[None]()._exit_renderables, list)
    assert callable(StylesCache.get_inner_outer.cache_clear)
    assert isinstance(message_hook, ContextVar)
    assert linux_driver() is LinuxDriver
    assert output_of(LinuxDriver(App[None]())) is sys.__stderr__
    assert callable(App._unnotify)
    assert notes_in_sight(App[None]()) == []
    assert issubclass(vars(textual_driver)["XTermParser"], XTermParser)
    widget = Static()
    assert (widget._repaint_regions, widget._repaint_required) == (set(), False)
    assert Screen[None]()._compositor._dirty_regions == set()
    assert StyledLate()._get_component_classes() == frozenset()
    assert StyledLate()._component_styles == {}


def test_a_text_that_comes_at_once_is_one_event() -> None:
    assert StudioApp().driver_class is not LinuxDriver
    parser = vars(textual_driver)["XTermParser"]
    reads = ("a", "ab\r" * 40)
    first = parser()
    found = [event for data in reads for event in first.feed(data)]
    assert [(type(event), getattr(event, "text", "a")) for event in found] == [
        (events.Key, "a"),
        (events.Paste, "ab\r" * 40),
    ]
    (burst,) = parser().feed("x" * 80)
    assert isinstance(burst, Burst)
    assert (burst.text, len(burst.keys)) == ("x" * 80, 80)


def test_nothing_between_the_marks_of_a_paste_is_a_key(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr(terminal_driver, "monotonic", lambda: now[0])
    assert StudioApp().driver_class is not LinuxDriver
    parser = vars(textual_driver)["XTermParser"]()
    text = "one \x1b[31mred \x1b]0;t\x07 two\x11"
    (event,) = parser.feed(f"\x1b[200~{text}\x1b[201~")
    assert isinstance(event, events.Paste)
    assert event.text == text
    assert [*parser.feed("\x1b"), *parser.tick()] == []
    now[0] = 0.2
    (event,) = parser.tick()
    assert (event.key, event.character) == ("escape", "\x1b")
    # The end of this one is lost.
    assert [*parser.feed("\x1b[200~lost\x1b"), *parser.tick()] == []
    now[0] = 2
    (event,) = parser.tick()
    assert event.text == "lost"
    now[0] = 5
    assert [getattr(event, "key", "") for event in parser.feed("\x11")] == ["", "ctrl+q"]


def test_what_is_no_utf_8_ends_nothing() -> None:
    assert StudioApp().driver_class is not LinuxDriver
    decoder = vars(textual_driver)["getincrementaldecoder"]("utf-8")()
    assert [decoder.decode(data) for data in (b"caf\xe9x", b"\xc3", b"\xa9\xff")] == [
        "caf\ufffdx",
        "",
        "é\ufffd",
    ]


async def test_the_studio_ends_with_its_own_words_where_no_key_can_be_read(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def fails(self: LinuxDriver) -> None:
        raise OSError("no terminal any more")

    monkeypatch.setattr(LinuxDriver, "run_input_thread", fails)
    monkeypatch.setattr(App, "_handle_exception", lambda self, error: self.exit())
    app = StudioApp()
    async with app.run_test(size=(80, 24)) as pilot:
        app.driver_class(app).run_input_thread()  # type: ignore[attr-defined]

        async def ended() -> None:
            while not app.last_words:
                await pilot.pause()

        await asyncio.wait_for(ended(), 60)
    assert "no terminal any more" in app.last_words


@pytest.mark.parametrize("module", [None, type(sys)("without")])
def test_without_the_driver_all_is_written(module: object, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "textual.drivers.linux_driver", module)
    monkeypatch.setitem(sys.modules, "textual._xterm_parser", module)
    parse_input_with(lambda parser: parser)
    take_any_bytes()
    assert linux_driver() is None
    assert for_terminal(LinuxDriver, ShownScreen(), lambda _: None) is LinuxDriver


async def test_without_a_driver_s_file_all_is_written() -> None:
    class Nowhere(Driver):
        write = start_application_mode = disable_input = stop_application_mode = print

    driver = Nowhere(App[None]())
    assert output_of(driver) is None
    driver._file = object()  # type: ignore[attr-defined]
    assert output_of(driver) is None


class _OtherArguments(XTermParser):
    def __init__(self) -> None:
        super().__init__()


class _OtherEvents(XTermParser):
    def feed(self, data: str) -> Iterator[Message]:
        yield from ()


@pytest.mark.parametrize("other", [_OtherArguments, _OtherEvents, XTermParser])
def test_a_parser_that_lets_no_key_through_is_left_out(
    other: type[XTermParser], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(textual_driver, "XTermParser", LinuxDriver)
    parse_input_with(lambda _: other)
    is_taken = vars(textual_driver)["XTermParser"] is other
    assert is_taken == (other is XTermParser)


class _Heard(Static):
    """A widget that notes of which size it hears."""

    sizes: tuple[Size, ...] = ()

    def on_resize(self, event: events.Resize) -> None:
        self.sizes += (event.size,)


@pytest.mark.parametrize("is_told", [True, False])
async def test_a_widget_that_was_asked_for_its_size_hears_of_it(is_told: bool) -> None:
    """That it does not without is why; a Textual in which it does needs no mending."""
    async with App[None]().run_test() as pilot:
        screen = pilot.app.screen
        if is_told:
            tell_first_sizes(screen)
        await screen.mount(Static("before"))
        await pilot.pause()
        heard = _Heard("new")
        await screen.mount(heard)
        screen._compositor._full_map_invalidated = True
        assert heard.size
        await pilot.pause()
        while is_told and not heard.sizes:
            await pilot.pause()
        assert bool(heard.sizes) is is_told


def test_without_a_compositor_nothing_is_mended() -> None:
    screen = Screen[None]()
    del screen._compositor
    tell_first_sizes(screen)
    leave_as_drawn(screen)


class _Lamp(StyledLate):
    """A widget with components, of which it needs one."""

    DEFAULT_CSS = "_Lamp > .on { color: red; } _Lamp.-dim > .on { color: blue; }"
    COMPONENT_CLASSES: ClassVar[set[str]] = {"on", "off"}


async def test_a_component_is_styled_when_it_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    async with App[None]().run_test() as pilot:
        lamp = _Lamp()
        await pilot.app.mount(lamp)
        assert lamp._component_styles == {}
        assert lamp.component("on").color == Color.parse("red")
        assert [*lamp._component_styles] == ["on"]
        lamp.add_class("-dim")
        pilot.app.stylesheet.apply(lamp)
        assert lamp.component("on").color == Color.parse("blue")
        with monkeypatch.context() as without:
            without.delattr(MessagePump, "_attach")
            assert lamp._get_component_classes() == {"on", "off"}
            assert lamp.component("on").color == Color.parse("blue")


def test_without_the_list_of_notes_they_go_with_time() -> None:
    app = App[None]()
    del app._notifications
    assert notes_in_sight(app) == []
    forget_notes(app, lambda _: True)


@pytest.mark.parametrize("module", [None, type(sys)("without")])
def test_without_the_table_of_sequences_no_chord_is_taught(
    module: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "textual._ansi_sequences", module)
    assert known_sequences() is None
    teach()


def test_without_the_pages_of_an_error_the_studio_ends_with_its_own_words(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    app = StudioApp()
    del app._exit_renderables
    monkeypatch.setattr(App, "_handle_exception", lambda self, error: None)
    app._handle_exception(RuntimeError("a deliberate error"))
    assert "a deliberate error" in app.last_words


async def test_without_a_word_of_errors_the_studio_starts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(Failing, "_handle_exception")
    shown = []
    monkeypatch.setattr(StudioApp, "show_error", lambda self, error: shown.append(error))
    app = StudioApp()
    async with app.run_test(size=(80, 24)) as pilot:
        await pilot.pause()
        assert app.survives(WorkerFailed(RuntimeError("a deliberate error")))
    assert len(shown) == 1


async def test_the_mouse_closes_nothing_twice_and_may_be_pressed_on_what_was_removed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert App.ALLOW_SELECT
    app = StudioApp()
    async with app.run_test(size=(80, 24)) as pilot:
        app.push_screen(palette := CommandPalette(providers=[]))
        await pilot.pause()
        while len(app.screen_stack) > 1:
            app.pop_screen()
        palette.dismiss()
        await pilot.pause()
        main = app.screen
        assert main is app.main
        removed = Static(), Offset(0, 0)
        monkeypatch.setattr(main, "get_widget_and_offset_at", lambda x, y: removed)
        await pilot.mouse_down(offset=(3, 3))
        await pilot.pause()
        assert app.screen is main


async def test_a_dialog_that_was_left_is_freed() -> None:
    app = StudioApp()
    async with app.run_test(size=(80, 24)) as pilot:
        await pilot.press("f1")
        await pilot.pause()
        assert app.screen is not app.main
        shown = [weakref.ref(each._styles_cache) for each in app.screen.query("*")]
        await pilot.press("escape")
        await pilot.pause()
        assert app.screen is app.main
        gc.collect()
        assert [each() for each in shown if each() is not None] == []


@pytest.mark.parametrize("module", [None, type(sys)("without")])
def test_without_the_cache_of_lines_nothing_is_freed(
    module: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "textual._styles_cache", module)
    forget_removed_widgets()


def test_a_cache_of_lines_of_another_kind_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(StylesCache, "get_inner_outer")
    forget_removed_widgets()
