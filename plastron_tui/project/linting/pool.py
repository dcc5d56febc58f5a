"""Processes that read files at the same time, and may die of what they read.

Each is a copy of this one, which starts in no time, and gets its work over a pipe of its own: one
that is killed, by the system for the memory that it takes, or by a fault of a parser, takes but
the file along that it was at. When this one ends, however it does, so do they.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from multiprocessing.connection import Connection, wait
from types import TracebackType
from typing import Generic, NamedTuple, TypeVar

from plastron_tui.collector import collect, spare
from plastron_tui.sources.text_memo import MEMO

T = TypeVar("T")

_FEW = 16
"""So few files are read sooner than a process is started."""

_MOST_TRIES = 2
"""A file is left out when so many processes have died of it: one may be killed for another's."""

_MOST_DEAD = 32
"""When so many have died, something else ends them than files: no more are started."""

_LONGEST = 30.0
"""Seconds of a processor that a file may take; the system ends a process that takes more."""

_CONTEXT = multiprocessing.get_context("fork")


class Died(NamedTuple):
    """What is yielded for a value that no process came to an end with."""

    value: str


class Pool(Generic[T]):
    """Calls a function for each of many values, in as many processes as there are cores.

    Where this process has several threads, such as the studio, a copy could wait for ever for what
    another thread had: there is then none.

    Attributes:
        count: how many processes there are at most.
    """

    def __init__(self, function: Callable[[str], T], workers: int | None = None) -> None:
        """Set what is called, and how many processes there are, None for one a core."""
        self._function = function
        self.count = len(os.sched_getaffinity(0)) if workers is None else workers
        self._workers: list[_Worker] = []
        self._dead = 0

    def __enter__(self) -> Pool[T]:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        for worker in self._workers:
            worker.end()
        self._workers.clear()

    def map(self, groups: Iterable[Sequence[str]]) -> Iterator[T | Died]:
        """Yield what the function returns for each value of groups, in no special order.

        Args:
            groups: values that are best left to one process, as they have much in common.
        """
        waiting = deque(deque(group) for group in groups if group)
        is_much = sum(map(len, waiting)) > _FEW
        if is_much and self.count > 1 and threading.active_count() == 1:
            for _ in range(len(self._workers), min(self.count, len(waiting))):
                self._start()
        if not self._workers:
            yield from (self._function(value) for group in waiting for value in group)
            return
        tries: dict[str, int] = {}
        for worker in self._workers:
            worker.give(waiting)
        while busy := [worker for worker in self._workers if worker.values]:
            for ready in wait([worker.connection for worker in busy]):
                worker = next(each for each in busy if each.connection is ready)
                try:
                    yield worker.connection.recv()
                except (EOFError, OSError):
                    value = worker.values[0]
                    tries[value] = tries.get(value, 0) + 1
                    if tries[value] == _MOST_TRIES:
                        worker.values.popleft()
                        yield Died(value)
                    waiting.appendleft(worker.values)
                    self._replace(worker, waiting)
                else:
                    worker.values.popleft()
                    if not worker.values:
                        worker.give(waiting)
        yield from (Died(value) for group in waiting for value in group)

    def _replace(self, worker: _Worker, waiting: deque[deque[str]]) -> None:
        worker.end()
        self._workers.remove(worker)
        self._dead += 1
        if self._dead <= _MOST_DEAD and self._start():
            self._workers[-1].give(waiting)

    def _start(self) -> bool:
        """Start a process, where the system has room for one more."""
        with suppress(OSError):
            self._workers.append(_Worker(self._function, self._workers))
            return True
        return False


class _Worker:
    """A process, and what it is yet to return.

    Attributes:
        connection: what it is asked and answers by.
        values: the values that it has not returned anything for, the one that it is at first.
    """

    def __init__(self, function: Callable[[str], object], others: Sequence[_Worker]) -> None:
        self.connection, theirs = _CONTEXT.Pipe()
        self.values: deque[str] = deque()
        inherited = [self.connection, *(each.connection for each in others)]
        self._process = _CONTEXT.Process(
            target=_serve, args=(function, theirs, inherited), daemon=True
        )
        # Till it takes care of itself, an interrupt waits.
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            self._process.start()
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
        theirs.close()

    def give(self, waiting: deque[deque[str]]) -> None:
        """Give it the next values."""
        while waiting and not self.values:
            self.values = waiting.popleft()
        if self.values:
            # Where it has died, that is seen when it is read from.
            with suppress(OSError):
                self.connection.send(tuple(self.values))

    def end(self) -> None:
        """End it, whatever it is at."""
        self._process.kill()
        self._process.join()
        self.connection.close()


def _serve(
    function: Callable[[str], object], connection: Connection, inherited: Sequence[Connection]
) -> None:
    """Return what a function returns for what is asked, until nobody asks any more."""
    spare()
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    # The one that is asked of ends the others; an interrupt from the keyboard goes to all.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # They would keep the pipes open when the first process is gone.
    for each in inherited:
        each.close()
    with suppress(EOFError, OSError):
        while True:
            for value in connection.recv():
                signal.setitimer(signal.ITIMER_PROF, _LONGEST)
                connection.send(function(value))
            signal.setitimer(signal.ITIMER_PROF, 0)
            # What is known of a group's texts refers to itself, and is of no use to the next one.
            MEMO.clear()
            collect()
