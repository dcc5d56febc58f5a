"""The topics that a monitor listens to, whatever goes wrong with a single one of them."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Collection
from typing import Any

from monitor_pipes import send


class NotInstalledError(Exception):
    """A type whose class is not there."""

    def __init__(self, type_name: str) -> None:
        super().__init__(f"{type_name} is not installed here")


class Subscriptions:
    """Listens to the topics that the studio looks at.

    Names, types and messages come from the network, and the classes of types from packages that
    anybody has made: what fails with one of them is told in that topic's row, and tried again with
    the next look.

    Attributes:
        types: the types of the topics that are there, by name.
    """

    def __init__(self, make: Callable[[str, str], Any]) -> None:
        """Start with no topic.

        Args:
            make: subscribes to a topic by its name and type. What it returns has a `topic` (a
                `WatchedTopic`), `take` (note what came), `look` (follow the publishers that are
                there now) and `close`.
        """
        self.types: dict[str, str] = {}
        self._make = make
        self._watched: dict[str, Any] = {}
        self._full: Collection[str] = ()
        self._failed: dict[str, str] = {}

    def __bool__(self) -> bool:
        """Tell whether a topic is listened to."""
        return any(each is not None for each in self._watched.values())

    def hears(self, name: str) -> bool:
        """Tell whether a topic is listened to."""
        return self._watched.get(name) is not None

    def watch(self, names: Collection[str], full: Collection[str]) -> None:
        """Listen to these topics and to no others; of some each field is wanted."""
        self._full = set(full)
        for name in set(self._watched) - set(names):
            self._close(name)
            del self._watched[name]
            self._failed.pop(name, None)
        for name in sorted(set(names) - set(self._watched)):
            self._watched[name] = None
            self._subscribe(name)
        for name, watching in self._watched.items():
            if watching is not None:
                watching.topic.is_full = name in self._full

    def look(self) -> None:
        """Subscribe to what has come, and follow the publishers of what was there."""
        for name, watching in list(self._watched.items()):
            if watching is None:
                self._subscribe(name)
            else:
                self._try(name, watching.look)

    def take(self) -> None:
        """Note the messages that came."""
        for name, watching in list(self._watched.items()):
            if watching is not None:
                self._try(name, watching.take)

    def report(self) -> None:
        """Tell what is new."""
        reports = {name: each.topic.report() for name, each in self._watched.items() if each}
        rows = {name: report for name, report in reports.items() if report is not None}
        if rows:
            send(tell="topics", rows=rows)

    def _subscribe(self, name: str) -> None:
        if name in self.types:
            self._try(name, lambda: self._made(name))

    def _made(self, name: str) -> None:
        watching = self._watched[name] = self._make(name, self.types[name])
        watching.topic.is_full = name in self._full
        self._failed.pop(name, None)

    def _try(self, name: str, work: Callable[[], None]) -> None:
        try:
            work()
        except Exception as error:  # whatever a foreign package, or the middleware, raises
            self._close(name)
            said = str(error) or type(error).__name__
            text = said if isinstance(error, NotInstalledError) else f"cannot be heard: {said}"
            if self._failed.get(name) != text:
                self._failed[name] = text
                row = {"count": 0, "rate": 0, "text": text, "number": None}
                send(tell="topics", rows={name: row})

    def _close(self, name: str) -> None:
        watching, self._watched[name] = self._watched[name], None
        if watching is not None:
            with contextlib.suppress(Exception):
                watching.close()
