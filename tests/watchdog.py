"""Ends a process in which a test hangs, and says where each thread is.

pytest's own `faulthandler_timeout` starts and joins a thread of the system for each test: with
twenty thousand tests that was half of a minute of the processor's time, and on a busy machine as
much of waiting. Here one thread watches over all the tests of a minute.
"""

from __future__ import annotations

import faulthandler
import os
import sys
import time

_LONGEST = 1800
"""Seconds that a test may take, or up to `_RENEWED` less."""

_RENEWED = 60
"""Seconds after which a test that begins gets the whole time again."""


class Watchdog:
    """Watches over the tests of this process; even one that keeps other threads from running."""

    def __init__(self) -> None:
        # What is told is seen although pytest takes away what tests print.
        self._stream = os.dup(sys.__stderr__.fileno() if sys.__stderr__ else 2)
        self._since: float | None = None

    def pytest_runtest_logstart(self) -> None:
        """Begin to count anew, where the last time was a while ago."""
        now = time.monotonic()
        if self._since is None or now - self._since > _RENEWED:
            faulthandler.dump_traceback_later(_LONGEST, file=self._stream, exit=True)
            self._since = now

    def pytest_unconfigure(self) -> None:
        """Stop."""
        faulthandler.cancel_dump_traceback_later()
        os.close(self._stream)
