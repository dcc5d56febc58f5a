"""Interrupts that wait for a safe moment.

A signal that arrives between two renames would leave half of the files new. While the writer
works, the signals that ask a program to stop are remembered; it asks for them where it can still
turn back, and they are delivered when it is done.
"""

from __future__ import annotations

import signal
import threading
from types import FrameType, TracebackType

_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class Stopped(BaseException):
    """Raised by `Interrupts.check` when a signal waits; like KeyboardInterrupt, no error."""


class Interrupts:
    """A context in which signals wait; afterwards the first is delivered to its usual handler.

    Outside of the main thread Python delivers no signals, and this does nothing.
    """

    def __init__(self) -> None:
        self._pending: list[int] = []
        self._handlers: dict[int, object] = {}

    def check(self) -> None:
        """Raise `Stopped` when a signal waits."""
        if self._pending:
            raise Stopped

    def __enter__(self) -> Interrupts:
        if threading.current_thread() is threading.main_thread():
            for number in _SIGNALS:
                handler = signal.getsignal(number)
                # None is a handler from outside of Python, which could not be put back.
                if handler not in (signal.SIG_IGN, None):
                    self._handlers[number] = handler
                    signal.signal(number, self._remember)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        for number, handler in self._handlers.items():
            signal.signal(number, handler)  # type: ignore[arg-type]
        if self._pending:
            signal.raise_signal(self._pending[0])
        if isinstance(error, Stopped):
            # Whoever handles the signal elsewhere must still not take this for success.
            raise KeyboardInterrupt

    def _remember(self, number: int, frame: FrameType | None) -> None:
        self._pending.append(number)
