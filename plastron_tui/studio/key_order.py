"""The order of keys: each is for what has the keys once those before it are done with.

Textual hands a key to what has the focus as soon as it comes, and a key that is bound to something
finds its action later, when it has gone up from there to the app. Keys that come in a burst, or on
a slow line, would all be for what had the focus at the first of them.

So a key waits until nothing is left to handle of one that may move the focus. Which messages follow
from which nobody says, but that there are none left can be seen: twice in a row all nodes between
the focus and the app come to a message that is sent to ask, and nothing else is handled meanwhile,
anywhere. At the first time nobody has begun anything, so that nobody is busy after it; at the
second nothing was left in a queue by those who were. It takes as long as there is something to
handle, whatever the machine and the number of steps, and no more than that, but for messages that
never stop.
"""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Sequence
from contextlib import suppress
from time import monotonic

from textual import events
from textual.await_complete import AwaitComplete
from textual.dom import DOMNode
from textual.message import Message
from textual.widgets import Input
from textual.worker import Worker

from .editor.commands import COMMANDS
from .terminal_driver import Burst
from .textual_private import Failing, hear_messages

_TYPED = (events.Key, events.Paste, Burst)

ASKING = frozenset(command.id for command in COMMANDS if command.asks)
"""What opens a line in the editor, which the keys that follow are for."""
OPENING = frozenset({
    "panel.rename", "panel.code", "live.open", "live.publish", "live.call", "live.goal",
    "live.set", "live.filter", "output.filter",
})  # fmt: skip
"""What opens a dialog or a line from a panel, by the ids of its bindings, letters too."""
_CHOOSING = frozenset({"left", "right", "tab", "shift+tab"})
"""The keys that go from answer to answer."""
_LONGEST_WAIT = 5.0
"""Seconds for which the keys after one wait, at most: where messages never stop coming, or somebody
keeps the others waiting, they are to be had for leaving."""
QUIET = 0.7
"""Seconds without a key, after which somebody has read a question."""
_PAUSE = 0.005
"""Seconds between two looks at a page that is on its way: a thread finds out what is in it."""


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


class Unread:
    """A screen with a question: who types on has not read it yet.

    What it does not hear is no answer. It hears keys once none has come for a while, and from then
    on all of them.

    Attributes:
        appeared: when it appeared, as `time.monotonic` has it; None before that.
        is_read: whether it hears all keys.
        is_unasked: whether it came by itself: what it does not hear is for what it covers.
    """

    appeared: float | None = None
    is_read = False
    is_unasked = False

    def hears(self, event: events.Event, last: float, now: float) -> bool:
        """Tell whether a key or a text counts.

        Args:
            event: the key or the text.
            last: when the one before it came, on whatever screen.
            now: when it came itself.
        """
        if isinstance(event, events.Key):
            # Nobody types Esc on and on: it leaves at once.
            if event.key == "escape":
                return True
            if not self.is_unasked:
                self.is_read = self.is_read or event.key in _CHOOSING
                if not event.is_printable:
                    return True
        if self.appeared is not None and now - max(self.appeared, last) >= QUIET:
            self.is_read = True
        return self.is_read or self.appeared is None

    def hears_late(self, event: events.Event) -> bool:
        """Tell whether a key counts that waited to be let in, and was perhaps typed before."""
        if self.appeared is None or self.appeared <= event.time:
            return True
        return self.hears(event, event.time, event.time)


class InOrder(Failing, inherit_bindings=False):
    """An app in which a key that may open something is done with before the next one comes."""

    _waiting: deque[events.Event]
    _kept: list[events.Event]
    _let_in: events.Event | None = None
    _keys_worker: Worker[None] | None = None
    _last_typed = 0.0
    _handled = 0
    """How many messages were handled since the start."""

    def __init__(self) -> None:
        super().__init__()
        self._waiting = deque()
        self._kept = []

    def on_load(self) -> None:
        """Hear of messages from before there is anything else that handles some."""
        hear_messages(self._count)

    @property
    def since_typed(self) -> float:
        """Seconds since a key, or a text that is pasted, came last."""
        return monotonic() - self._last_typed

    def _count(self, message: Message) -> None:
        # What the time brings follows from no key.
        if not isinstance(message, events.Timer):
            self._handled += 1

    async def on_event(self, event: events.Event) -> None:
        """Keep a key, or a text that is pasted, as long as a key before it is on its way."""
        if isinstance(event, _TYPED) and not event.is_forwarded and event is not self._let_in:
            now, last = monotonic(), self._last_typed
            self._last_typed = now
            if isinstance(self.screen, Unread) and not self.screen.hears(event, last, now):
                self._keep_for_below(event, self.screen)
                return
            is_first = self._keys_worker is None or self._keys_worker.is_finished
            if not is_first or self._is_turning or self._waiting:
                self._waiting.append(event)
                if is_first:
                    self._keep_order(None)
                return
            if isinstance(event, Burst):
                for each in self._taken_as(event):
                    await self.on_event(each)
                return
            if isinstance(event, events.Key) and self._may_open(event):
                self._keep_order(self._key_path())
        await super().on_event(self._as_bound(event))

    def _keep_for_below(self, event: events.Event, screen: Unread) -> None:
        """Keep what a screen does not hear that came by itself: it is for what that covers."""
        if screen.is_unasked:
            self._kept.append(event)

    def pop_screen(self) -> AwaitComplete:
        """Go back to the screen below, if there is one, and let in what was kept for it.

        A screen of Textual's own that is pressed on as it closes would close once more.
        """
        if len(self.screen_stack) < 2:
            return AwaitComplete()
        popped = super().pop_screen()
        if self._kept and not isinstance(self.screen, Unread):
            self._waiting.extend(self._kept)
            self._kept.clear()
            if self._keys_worker is None or self._keys_worker.is_finished:
                self._keep_order(self._key_path())
        return popped

    def _taken_as(self, burst: Burst) -> Sequence[events.Event]:
        """Return what a text that came as keys is for what has the focus: a paste, or keys.

        A question takes it for a paste whatever has the focus: no letter of it is an answer.
        """
        if any(getattr(each, "takes_bursts", False) for each in (self.focused, self.screen)):
            return [events.Paste(burst.text)]
        return burst.keys

    def listens(self) -> bool:
        """Tell whether somebody is there that keys are for: at the start nobody is yet."""
        return True

    @property
    def _is_turning(self) -> bool:
        if not self.listens():
            return True
        return isinstance(self.screen, Paged) and self.screen.is_turning

    async def _until_listening(self) -> None:
        """Wait for somebody to be there, but not for one who never comes."""
        end = monotonic() + _LONGEST_WAIT
        while not self.listens() and monotonic() < end:
            await asyncio.sleep(_PAUSE)

    @property
    def _takes_text(self) -> bool:
        return isinstance(self.focused, Input) or getattr(self.focused, "takes_text", False)

    def _as_bound(self, event: events.Event) -> events.Event:
        """Return a capital letter that does nothing as the small one, which may do something."""
        if not isinstance(event, events.Key) or self._takes_text or not event.key.isupper():
            return event
        small = event.key.lower()
        bound = self.screen.active_bindings
        is_meant = len(small) == 1 and event.key not in bound and small in bound
        return events.Key(small, small) if is_meant else event

    def _may_open(self, event: events.Key) -> bool:
        screen = self.screen
        if screen.is_modal:
            return not (event.is_printable and isinstance(self.focused, Input))
        if event.is_printable and self._takes_text:
            return False
        bound = screen.active_bindings.get(event.key)
        if bound is None:
            return False
        if event.is_printable or bound.binding.id in OPENING:
            return bound.binding.id in OPENING
        return bound.node is screen or bound.binding.id in ASKING or isinstance(self.focused, Input)

    def _key_path(self) -> list[DOMNode]:
        """Return what a key goes through that comes now, from the focus up to the app."""
        return (self.focused or self.screen).ancestors_with_self

    def _keep_order(self, nodes: list[DOMNode] | None) -> None:
        self._keys_worker = self.run_worker(self._let_all_in(nodes), group="keys")

    async def _let_all_in(self, nodes: list[DOMNode] | None) -> None:
        """Let in, one by one, what waits; `nodes` are those of a key that is in already."""
        if nodes is not None:
            await self._settled(nodes)
        while self._waiting:
            await self._until_listening()
            event = self._waiting[0]
            # Who wants to leave need not wait for a page.
            before = self.screen
            while isinstance(self.screen, Paged) and not self.screen.is_settled:
                if isinstance(event, events.Key) and event.key == "escape":
                    break
                await asyncio.sleep(_PAUSE)
            if self.screen is not before:
                # It has just come, and nothing in it has the focus yet.
                await self._settled(self._key_path())
            event = self._waiting.popleft()
            if isinstance(event, Burst):
                self._waiting.extendleft(reversed(self._taken_as(event)))
                continue
            screen = self.screen
            if isinstance(screen, Unread) and not screen.hears_late(event):
                self._keep_for_below(event, screen)
                continue
            self._let_in = event
            nodes = self._key_path()
            self.post_message(event)
            await self._settled(nodes)

    async def _settled(self, nodes: list[DOMNode]) -> None:
        """Wait for what follows from a key, but not for what never ends."""
        with suppress(asyncio.TimeoutError):
            await asyncio.wait_for(self._settle(nodes), _LONGEST_WAIT)

    async def _settle(self, nodes: list[DOMNode]) -> None:
        """Wait until nothing is left to handle of a key that the app has got.

        Args:
            nodes: what the key goes through; it may be no longer what has the focus.
        """
        quiet = 0
        while quiet < 2:
            before = self._handled
            asked = [await _drain(node) for node in dict.fromkeys([*nodes, *self._key_path()])]
            quiet = quiet + 1 if self._handled - before <= sum(asked) else 0


async def _drain(node: DOMNode) -> bool:
    """Wait until a node has handled the messages in its queue; False where it takes no more.

    What a queue has taken is handled, even where its node goes away meanwhile.
    """
    reached = asyncio.Event()
    if not node.call_later(reached.set):
        return False
    await reached.wait()
    return True
