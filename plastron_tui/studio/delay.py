"""Something that is done a while after it was asked for, however busy the machine is.

Textual's timers leave a tick out that comes too late; of a timer that ticks once, that is the only
one, so that after a stop of ten milliseconds at the wrong moment nothing is done at all.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from textual.message_pump import MessagePump


class Delay:
    """Calls a function as a message of a widget, some time after it was last asked to."""

    def __init__(self, pump: MessagePump, callback: Callable[[], object]) -> None:
        """Prepare.

        Args:
            pump: the widget or screen; nothing is called once it is gone.
            callback: what is called.
        """
        self._pump = pump
        self._callback = callback
        self._handle: asyncio.TimerHandle | None = None

    @property
    def is_waiting(self) -> bool:
        """Whether the function is still to be called."""
        return self._handle is not None

    def start(self, seconds: float) -> None:
        """Call the function so many seconds from now, and not when it was to be called before."""
        self.stop()
        self._handle = asyncio.get_running_loop().call_later(seconds, self._post)

    def stop(self) -> None:
        """Do not call it."""
        if self._handle is not None:
            self._handle.cancel()
            self._handle = None

    def _post(self) -> None:
        self._pump.call_later(self._call, self._handle)

    def _call(self, handle: asyncio.TimerHandle) -> object:
        # It may have been stopped, or started anew, on its way through the queue.
        if handle is not self._handle:
            return None
        self._handle = None
        return self._callback()
