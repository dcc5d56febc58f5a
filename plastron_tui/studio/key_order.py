"""The order of keys: each is for what has the keys once those before it are done with.

Textual hands a key to what has the focus as soon as it comes, and a key that is bound to something
finds its action later, when it has gone up from there to the app. Keys that come in a burst, or on
a slow line, would all be for what had the focus at the first of them.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable

from textual import events
from textual.dom import DOMNode
from textual.widgets import Input
from textual.worker import Worker

from .undocumented import Failing

_ROUNDS = 4
"""How often messages go up from the focus until all is said: key, box, row and page each say it."""
_LONGEST_ROUND = 0.5
"""Seconds that a widget has to answer; one that goes away meanwhile never does."""
_ASKING = frozenset({"editor.find", "editor.replace", "editor.rename", "editor.go_to_line"})
"""What the editor opens a line for by itself."""
_PAUSE = 0.005
"""Seconds between two looks at a page that is on its way."""


class Paged:
    """A screen of pages: keys are for the page that they are going to find."""

    @property
    def is_turning(self) -> bool:
        """Whether another page is on its way."""
        return False

    @property
    def is_settled(self) -> bool:
        """Whether all is shown that follows from the keys so far."""
        return not self.is_turning


class InOrder(Failing, inherit_bindings=False):
    """An app in which a key that may open something is done with before the next one comes."""

    _waiting: deque[events.Key]
    _let_in: events.Key | None = None
    _keys_worker: Worker[None] | None = None

    def __init__(self) -> None:
        super().__init__()
        self._waiting = deque()

    async def on_event(self, event: events.Event) -> None:
        """Keep a key as long as one before it is on its way."""
        if isinstance(event, events.Key) and not event.is_forwarded and event is not self._let_in:
            is_first = self._keys_worker is None or self._keys_worker.is_finished
            if not is_first or self._is_turning:
                self._waiting.append(event)
                if is_first:
                    self._keys_worker = self.run_worker(self._let_all_in(), group="keys")
                return
            if self._may_open(event):
                self._keys_worker = self.run_worker(self._let_all_in(self._ways()), group="keys")
        await super().on_event(event)

    @property
    def _is_turning(self) -> bool:
        return isinstance(self.screen, Paged) and self.screen.is_turning

    def _may_open(self, event: events.Key) -> bool:
        screen = self.screen
        if screen.is_modal:
            return not (event.is_printable and isinstance(self.focused, Input))
        if event.is_printable:
            return False
        bound = screen.active_bindings.get(event.key)
        if bound is None:
            return False
        return (
            bound.node is screen or bound.binding.id in _ASKING or isinstance(self.focused, Input)
        )

    def _ways(self) -> list[DOMNode]:
        """Return what a key goes through that comes now, from the focus up to the app."""
        return (self.focused or self.screen).ancestors_with_self

    async def _let_all_in(self, ways: list[DOMNode] | None = None) -> None:
        """Let in, one by one, what waits; `ways` are those of a key that is in already."""
        if ways is not None:
            await self._done_with(ways)
        while self._waiting:
            event = self._waiting[0]
            # Who wants to leave need not wait for a page.
            while isinstance(self.screen, Paged) and not self.screen.is_settled:
                if event.key == "escape":
                    break
                await asyncio.sleep(_PAUSE)
            self._let_in = self._waiting.popleft()
            ways = self._ways()
            self.post_message(event)
            await self._done_with(ways)

    async def _done_with(self, ways: list[DOMNode]) -> None:
        """Wait until a key that the app has got, and what was said of it, has gone all its ways."""
        await _reached(self)
        for _ in range(_ROUNDS):
            for node in ways:
                await _reached(node)
            # What has the focus now may have something to say of that.
            ways = self._ways()


async def _reached(node: DOMNode) -> None:
    """Wait until a node has done with all messages that it has got."""
    reached = asyncio.Event()
    tell: Callable[[], None] = reached.set
    if node.call_later(tell):
        try:
            await asyncio.wait_for(reached.wait(), _LONGEST_ROUND)
        except asyncio.TimeoutError:
            return
