"""Messages that a monitor sends again and again, until it is told to stop, or ends."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

from monitor_pipes import answer, send

_LONGEST_STOP = 1.0
"""Seconds for which is waited for a message that is being sent: a connection may keep it."""


class Sending:
    """Sends a message at a rate, in a thread of its own."""

    def __init__(self, order: dict[str, Any], publish: Callable[[], None], text: str) -> None:
        """Start to send.

        Args:
            order: what the studio wants, with the topic's name and the rate in hertz.
            publish: sends the message once.
            text: what is in it.
        """
        self._order = order
        self._publish = publish
        self._period = 1 / order["rate"]
        self._end = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self.has_failed = False
        """Whether a message could not be sent, and so no other one is."""
        send(tell="sending", name=order["name"], rate=order["rate"], text=text)
        self._thread.start()

    def end(self) -> None:
        """Send no more."""
        self._end.set()
        self._thread.join(_LONGEST_STOP)

    def stop(self) -> None:
        """Send no more, and tell so."""
        self.end()
        send(tell="sending", name=self._order["name"], rate=0, text="")

    def _run(self) -> None:
        due = time.monotonic()
        try:
            while not self._end.wait(max(0.0, due - time.monotonic())):
                self._publish()
                # What the machine had no time for is not sent later, all at once.
                due = max(due + self._period, time.monotonic())
        except Exception as error:  # whatever the middleware raises
            problem = str(error) or type(error).__name__
            send(tell="sending", name=self._order["name"], rate=0, text="", problem=problem)
            self.has_failed = True


class Sendings:
    """What is sent at a rate: one message for each topic."""

    def __init__(self) -> None:
        """Start with nothing that is sent."""
        self._running: dict[str, tuple[Sending, Callable[[], None]]] = {}

    def start(
        self,
        order: dict[str, Any],
        publish: Callable[[], None],
        close: Callable[[], None],
        text: str,
    ) -> None:
        """Send a message at a rate, instead of what was sent to the topic until now.

        Args:
            order: what the studio wants, with the topic's name and the rate in hertz.
            publish: sends the message once.
            close: takes the publisher away.
            text: what is in it.
        """
        self.stop(order["name"])
        # That it is sent is told besides.
        answer(order, "")
        self._running[order["name"]] = Sending(order, publish, text), close

    def stop(self, name: str) -> None:
        """Send no more to a topic."""
        sending, close = self._running.pop(name, (None, None))
        if sending is not None and close is not None:
            sending.stop()
            close()

    def turn(self) -> None:
        """Take the publishers away that cannot send, from the thread that made them."""
        for name, (sending, close) in list(self._running.items()):
            if sending.has_failed:
                del self._running[name]
                close()

    def close(self) -> None:
        """Send no more at all; nobody is there any more who could be told."""
        for sending, _ in self._running.values():
            sending.end()
