"""Draws some of the pictures of a headless studio: Textual makes each, and throws all away.

What tests look at is what widgets have, not how a terminal shows it, and to draw it takes a third
of the processor's time. That nothing fails while it is drawn is still seen, at each test: the first
picture of a screen is drawn, one of some that follow, with all that has changed since the one
before, and the last. What a click finds is where it was drawn: it is drawn before each.
"""

from __future__ import annotations

from typing import Any
from weakref import WeakKeyDictionary

from rich.console import RenderableType
from textual._compositor import Compositor
from textual._context import visible_screen_stack
from textual.app import App
from textual.pilot import Pilot
from textual.screen import Screen

_ONE_OF = 16
"""One of so many pictures of a screen is drawn."""

_render_update = Compositor.render_update
_post_mouse_events = Pilot._post_mouse_events
_asked: WeakKeyDictionary[Compositor, int] = WeakKeyDictionary()
"""How many pictures of a screen were asked for."""


def render_some(
    compositor: Compositor,
    full: bool = False,
    screen_stack: list[Screen[Any]] | None = None,
    simplify: bool = False,
) -> RenderableType | None:
    """Draw a picture that is asked for as a whole, and one of some others."""
    number = _asked.get(compositor, 0)
    _asked[compositor] = number + 1
    if full or simplify or number % _ONE_OF == 0:
        return _render_update(compositor, full, screen_stack, simplify)
    visible_screen_stack.set([] if screen_stack is None else screen_stack)
    return None


def draw(app: App[Any]) -> None:
    """Draw what is in front as it is now."""
    _render_update(app.screen._compositor, screen_stack=app._background_screens)


async def draw_before(pilot: Pilot[Any], *events: Any, **options: Any) -> bool:
    """Draw what a click is about to find."""
    draw(pilot.app)
    return await _post_mouse_events(pilot, *events, **options)
