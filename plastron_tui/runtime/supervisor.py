"""Runs processes together: reads them, stops them, and leaves none behind."""

from __future__ import annotations

import contextlib
import os
import selectors
import signal
import threading
import time
from collections.abc import Callable, Iterable
from types import FrameType, TracebackType
from typing import Any

from .child import Child, Exit, Guard, Process, Role

# How often ends are looked for, in seconds; output is read when it comes.
_TICK = 0.05

# What is sent to a process that has to stop, and how long until the next, in seconds.
_STEPS: tuple[tuple[int, float], ...] = (
    (signal.SIGINT, 2.0),
    (signal.SIGTERM, 1.0),
    (signal.SIGKILL, 1.0),
)

OnLine = Callable[[Process, str], None]
OnExit = Callable[[Exit], None]
OnTick = Callable[[], None]


def _is_needed(process: Process) -> bool:
    """Tell whether others need a process until they have ended."""
    return process.is_host or process.role is Role.MASTER


class Supervisor:
    """A set of processes, each in a session of its own, so that only this one stops them.

    A context: leaving it stops what still runs. In the main thread it takes over SIGINT,
    SIGTERM and SIGHUP meanwhile; the first asks the processes to stop, a second one kills
    them. It reads and waits in one thread, so it is created, used and left in one; `stop` may
    be called from any.

    Attributes:
        exits: how the processes ended, in that order.
        stop_signal: the signal that ended the run, None where none did.
    """

    def __init__(
        self, on_line: OnLine, on_exit: OnExit | None = None, on_tick: OnTick | None = None
    ) -> None:
        self.exits: list[Exit] = []
        self.stop_signal: int | None = None
        self._on_line = on_line
        self._on_exit = on_exit
        self._on_tick = on_tick
        self._children: dict[int, Child] = {}
        self._pipes: set[int] = set()
        self._stop_asked = threading.Event()
        self._handlers: dict[int, Any] = {}

    def __enter__(self) -> Supervisor:
        self._selector = selectors.DefaultSelector()
        self._guard = Guard()
        if threading.current_thread() is threading.main_thread():
            for signum in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                # `nohup` asks for a run that outlives its terminal.
                if signum != signal.SIGHUP or signal.getsignal(signum) is not signal.SIG_IGN:
                    self._handlers[signum] = signal.signal(signum, self._on_signal)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        try:
            self._end_all()
        finally:
            for fd in tuple(self._pipes):
                self._close_pipe(fd)
            self._guard.close()
            self._selector.close()
            for signum, handler in self._handlers.items():
                signal.signal(signum, handler)

    def start(self, process: Process) -> bool:
        """Start a process; one that cannot be started is an `Exit` with a reason."""
        try:
            child = Child(process, self._guard)
        except OSError as error:
            reason = f"{error.filename or process.argv[0]}: {error.strerror}"
            self._report(Exit(process, None, reason))
            return False
        self._children[child.fd] = child
        self._selector.register(child.fd, selectors.EVENT_READ, child.read)
        return True

    def read(self, fd: int, on_bytes: Callable[[bytes], None]) -> None:
        """Read a pipe beside the processes' own, and close it in the end."""
        os.set_blocking(fd, False)
        self._pipes.add(fd)

        def _read() -> Iterable[str]:
            with contextlib.suppress(BlockingIOError):
                chunk = os.read(fd, 1 << 16)
                if not chunk:
                    self._close_pipe(fd)
                on_bytes(chunk)
            return ()

        self._selector.register(fd, selectors.EVENT_READ, _read)

    def _close_pipe(self, fd: int) -> None:
        self._pipes.discard(fd)
        self._selector.unregister(fd)
        os.close(fd)

    def stop(self) -> None:
        """Ask for the end of the run, from any thread."""
        self._stop_asked.set()

    @property
    def is_stopping(self) -> bool:
        """Whether the end was asked for, by `stop` or by a signal."""
        return self._stop_asked.is_set()

    def is_running(self, process: Process) -> bool:
        """Tell whether a process was started and has not ended."""
        return any(child.process is process for child in self._children.values())

    def pid_of(self, process: Process) -> int | None:
        """Return the number of a running process."""
        found = (child.pid for child in self._children.values() if child.process is process)
        return next(found, None)

    def wait_for(self, condition: Callable[[], bool], limit: float) -> bool:
        """Read until the condition holds; False when it did not within `limit` seconds."""
        deadline = time.monotonic() + limit
        while not condition():
            if self.is_stopping or time.monotonic() >= deadline:
                return False
            self._pump()
        return True

    def wait(self, duration: float | None = None) -> int:
        """Run until every node has ended, the time is up, or a signal comes.

        Returns:
            The exit status of the whole: 1 where a node died, 128 and the signal's number
            where a signal ended the run, 0 otherwise.
        """
        deadline = None if duration is None else time.monotonic() + duration
        while self._nodes() and not self.is_stopping:
            if deadline is not None and time.monotonic() >= deadline:
                break
            self._pump()
        self._end_all()
        return self.status

    @property
    def status(self) -> int:
        """The exit status of the whole (see `wait`)."""
        if any(end.is_failure and end.process.role is Role.NODE for end in self.exits):
            return 1
        return 0 if self.stop_signal is None else 128 + self.stop_signal

    def _on_signal(self, signum: int, frame: FrameType | None) -> None:
        if self.stop_signal is None:
            self.stop_signal = signum
            self._stop_asked.set()
        else:
            for child in self._all():
                child.send(signal.SIGKILL)

    def _all(self) -> list[Child]:
        return list(self._children.values())

    def _nodes(self) -> list[Child]:
        return [child for child in self._all() if child.process.role is Role.NODE]

    def _end_all(self) -> None:
        # The master last: the nodes sign off there; nodelets do so at their manager before.
        self._end(lambda: [one for one in self._all() if not _is_needed(one.process)])
        self._end(lambda: [one for one in self._all() if one.process.role is not Role.MASTER])
        self._end(self._all)

    def _end(self, left: Callable[[], list[Child]]) -> None:
        for signum, limit in _STEPS:
            for child in left():
                if not child.has_ended():
                    child.send(signum)
            deadline = time.monotonic() + limit
            while left() and time.monotonic() < deadline:
                self._pump()

    def _pump(self) -> None:
        for key, _ in self._selector.select(_TICK):
            child = self._children.get(key.fd)
            for line in key.data():
                if child is not None:
                    self._on_line(child.process, line)
            if child is not None and child.is_at_end:
                self._selector.unregister(key.fd)
        for fd, child in tuple(self._children.items()):
            if child.has_ended():
                self._reap(fd, child)
        if self._on_tick is not None:
            self._on_tick()

    def _reap(self, fd: int, child: Child) -> None:
        del self._children[fd]
        if not child.is_at_end:
            self._selector.unregister(fd)
        for line in child.finish():
            self._on_line(child.process, line)
        self._report(child.exit())

    def _report(self, end: Exit) -> None:
        self.exits.append(end)
        if self._on_exit is not None:
            self._on_exit(end)
