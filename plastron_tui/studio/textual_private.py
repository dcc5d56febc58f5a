"""All that the studio uses of Textual without Textual's word for it.

A version of Textual that has it no longer takes away what is said here, and nothing else.
"""

from __future__ import annotations

import codecs
import sys
from collections.abc import Callable, Mapping, MutableMapping
from functools import partial
from typing import IO, TYPE_CHECKING, Any, cast

from textual.app import App
from textual.dom import DOMNode
from textual.driver import Driver
from textual.message import Message
from textual.notifications import Notification
from textual.widget import Widget

if TYPE_CHECKING:
    from textual._compositor import Compositor
    from textual._xterm_parser import XTermParser
    from textual.css.styles import StylesBase
    from textual.screen import Screen


def known_sequences() -> MutableMapping[str, Any] | None:
    """Return what terminals send for keys, as Textual's parser looks it up; None if unknown.

    Without it chords with Alt arrive as far as Textual itself tells them from characters.
    """
    try:
        from textual._ansi_sequences import ANSI_SEQUENCES_KEYS
    except ImportError:
        return None
    if not isinstance(ANSI_SEQUENCES_KEYS, MutableMapping):
        return None
    return cast("MutableMapping[str, Any]", ANSI_SEQUENCES_KEYS)


def linux_driver() -> type[Driver] | None:
    """Return Textual's class for terminals on Unix; None on other systems.

    Without it all that a widget draws goes to the terminal, whatever is there already.
    """
    try:
        from textual.drivers.linux_driver import LinuxDriver
    except ImportError:
        return None
    return LinuxDriver


def output_of(driver: Driver) -> IO[str] | None:
    """Return where a driver for terminals writes; None if unknown.

    Without it all that a widget draws goes to the terminal, whatever is there already.
    """
    file = getattr(driver, "_file", None)
    return cast("IO[str]", file) if callable(getattr(file, "fileno", None)) else None


def write_where_it_is_seen(driver: Driver) -> None:
    """Let a driver write to standard output where standard error goes to a file.

    Without it the file gets all that is drawn, and the terminal nothing.
    """
    output, own = sys.__stdout__, output_of(driver)
    if own is not None and output is not None and output.isatty() and not own.isatty():
        driver._file = output  # type: ignore[attr-defined]


def parse_input_with(parser_of: Callable[[type[XTermParser]], type[XTermParser]]) -> None:
    """Let Textual's driver take what a terminal sends apart with another parser.

    Without it a text that comes at once is that many keys, one after the other.
    """
    try:
        from textual._xterm_parser import XTermParser
        from textual.drivers import linux_driver
    except ImportError:
        return
    if getattr(linux_driver, "XTermParser", None) is None:
        return
    parser = parser_of(XTermParser)
    if _takes_keys(parser):
        linux_driver.XTermParser = parser  # type: ignore[attr-defined]


def take_any_bytes() -> None:
    """Let Textual's driver read U+FFFD where a terminal sends what is no UTF-8.

    Without it such a byte ends the studio; what was typed is in the journal.
    """
    try:
        from textual.drivers import linux_driver
    except ImportError:
        return
    if getattr(linux_driver, "getincrementaldecoder", None) is not None:
        linux_driver.getincrementaldecoder = _forgiving  # type: ignore[assignment, attr-defined]


def _forgiving(encoding: str) -> Callable[[], codecs.IncrementalDecoder]:
    return partial(codecs.getincrementaldecoder(encoding), errors="replace")


def _takes_keys(parser: type[XTermParser]) -> bool:
    """Tell whether a parser that is made and fed as it is now returns a key for a letter."""
    try:
        made = parser(False)
        keys = [getattr(each, "key", None) for each in [*made.feed("a"), *made.tick()]]
        list(made.feed(""))
    except Exception:
        return False
    return keys == ["a"]


def tell_first_sizes(screen: Screen[Any]) -> None:
    """Let widgets of a screen hear of their first size, whoever asked for it before.

    A compositor tells what is new by the last map of the screen; but a question for the place of a
    widget that was just mounted, from a panel or the mouse, makes another map, with the widget in
    it. Without this the widget then hears of no `Show` and no `Resize`.
    """
    compositor = getattr(screen, "_compositor", None)
    reflow = getattr(compositor, "reflow", None)
    if compositor is None or reflow is None or not hasattr(compositor, "_full_map"):
        return
    told: Any = None

    def reflow_from_told(*args: Any, **kwargs: Any) -> Any:
        nonlocal told
        if told is not None:
            compositor._full_map = told
        result = reflow(*args, **kwargs)
        told = compositor._full_map
        return result

    compositor.reflow = reflow_from_told


def leave_as_drawn(screen: Screen[Any]) -> None:
    """Draw nothing again that a screen has just been drawn with as a whole.

    The first layout lets each widget ask for being drawn, because it has a size now, and the
    first frame follows within the same call; but what was asked for is kept, and the frame is
    drawn once or twice more. Without this it is, and the first key waits for that.
    """
    compositor = getattr(screen, "_compositor", None)
    regions = getattr(compositor, "_dirty_regions", None)
    widgets = getattr(compositor, "visible_widgets", None)
    if not isinstance(regions, set) or not isinstance(widgets, Mapping):
        return
    regions.clear()
    for widget in (screen, *widgets):
        asked = getattr(widget, "_repaint_regions", None)
        if isinstance(asked, set) and hasattr(widget, "_repaint_required"):
            asked.clear()
            widget._repaint_required = False


def hear_messages(hear: Callable[[Message], None]) -> None:
    """Let a function hear of each message before it is handled, in this task and those it starts.

    Without it a key may be handled before the messages that the key before it led to.
    """
    try:
        from textual._context import message_hook
    except ImportError:
        return
    message_hook.set(hear)


def forget_removed_widgets() -> None:
    """Free what removed widgets last showed; a cache of Textual's keeps a thousand of them.

    `StylesCache.get_inner_outer` remembers its results by the object that it is called on, which
    has the rendered lines of a widget. Without it the memory grows with each dialog, to a bound.
    """
    try:
        from textual._styles_cache import StylesCache
    except ImportError:
        return
    clear = getattr(getattr(StylesCache, "get_inner_outer", None), "cache_clear", None)
    if clear is not None:
        clear()


def compositor_class(screen: Screen[Any]) -> type[Compositor] | None:
    """Return the class of what puts a screen together; None if it is not as known.

    Without it all widgets are asked to draw that are near to one that has changed.
    """
    compositor = getattr(screen, "_compositor", None)
    known = ("_dirty_regions", "_get_renders", "render_partial_update", "visible_widgets")
    if not all(hasattr(compositor, name) for name in known):
        return None
    return cast("type[Compositor]", type(compositor))


def translate_colours(app: App[Any]) -> None:
    """Have the sixteen colours of a terminal translated, or left alone, as the theme wants it.

    For a theme that is on before anything is drawn. Without it they are translated in any case.
    """
    refresh = getattr(app, "_refresh_truecolor_filter", None)
    if callable(refresh):
        refresh(app.ansi_theme)


def notes_in_sight(app: App[Any]) -> list[Notification]:
    """Return what is said in the corner. Without it the same may stand there twice."""
    return list(getattr(app, "_notifications", ()))


def forget_notes(app: App[Any], is_old: Callable[[Notification], bool]) -> None:
    """Take away what is said in the corner and no longer so. Without it time takes it away."""
    unnotify = getattr(app, "_unnotify", None)
    if callable(unnotify):
        for note in filter(is_old, notes_in_sight(app)):
            unnotify(note)


class StyledLate(Widget):
    """A widget whose components are styled when they are first asked for, and then with it.

    Textual styles all components of a widget whenever it styles the widget, at the start too; a
    list has a dozen, of which it shows one or two. Without this they are styled as Textual does.
    """

    def __init__(self, *, id: str | None = None) -> None:  # noqa: A002 - Textual's word
        super().__init__(id=id)
        self._asked_for: frozenset[str] = frozenset()

    def _get_component_classes(self) -> frozenset[str]:  # type: ignore[override]
        return self._asked_for if self._is_late else super()._get_component_classes()

    @property
    def _is_late(self) -> bool:
        return hasattr(self, "_attach") and hasattr(self, "_component_styles")

    def component(self, name: str) -> StylesBase:
        """Return the styles of one of its components."""
        if self._is_late and name not in self._component_styles:
            self._asked_for |= {name}
            node = DOMNode(classes=name)
            node._attach(self)
            self.app.stylesheet.apply(node)
            self._component_styles[name] = node.styles
        return self.get_component_styles(name)


class Failing(App[None], inherit_bindings=False):
    """An app that is told what went wrong in it.

    Without Textual's `_handle_exception` an error ends the studio with a traceback; what was typed
    is in the journal. Without `_exit_renderables` a traceback follows the studio's last words.
    """

    def survives(self, error: Exception) -> bool:
        """Take note of an error; tell whether the app goes on."""
        return False

    def fail(self, error: Exception) -> None:
        """End as an error in a widget does."""
        self._handle_exception(error)

    def _handle_exception(self, error: Exception) -> None:
        if self.survives(error):
            return
        super()._handle_exception(error)
        # Textual would show what it knows of the error: pages, with pieces of the program in it.
        pages = getattr(self, "_exit_renderables", None)
        if isinstance(pages, list):
            pages.clear()
