"""One process of a run: started under guard, read line by line, reaped."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
from collections import deque
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

from . import guard
from .stop_traceback import StopTracebacks

_CHUNK = 1 << 16
_LONGEST_LINE = 1 << 16
# No pipe holds more than this, unless the superuser says so (pipe(7), pipe-max-size).
_MOST_LEFT = 1 << 20
_TAIL = 10


class Role(Enum):
    """What a process is for. A run lasts as long as its nodes do, not as its helpers."""

    NODE = "node"
    OBSERVER = "observer"
    MASTER = "master"


@dataclass(frozen=True, slots=True)
class Process:
    """What is to be started.

    Attributes:
        name: what the output is labelled with.
        argv: the program and its arguments.
        environ: its whole environment; None for the supervisor's own.
        cwd: its working folder; None for the supervisor's own.
        role: what it is for.
        fds: file descriptors that it inherits beside the standard ones.
        is_host: whether others sign off at it when they end, so that it ends after them.
    """

    name: str
    argv: tuple[str, ...]
    environ: Mapping[str, str] | None = None
    cwd: Path | None = None
    role: Role = Role.NODE
    fds: tuple[int, ...] = ()
    is_host: bool = False


@dataclass(frozen=True, slots=True)
class Exit:
    """How a process ended.

    Attributes:
        process: which one.
        status: its exit status, the negative signal number where a signal ended it, None where
            it never started.
        reason: why it never started, "" otherwise.
        last_lines: the end of its output.
        was_asked: whether the supervisor had told it to stop.
    """

    process: Process
    status: int | None
    reason: str = ""
    last_lines: tuple[str, ...] = ()
    was_asked: bool = False

    @property
    def is_failure(self) -> bool:
        """Whether it ended badly, and of its own accord."""
        return not self.was_asked and self.status != 0

    @property
    def words(self) -> str:
        """What happened, in words, to follow the name."""
        if self.status is None:
            return f"never started: {self.reason}"
        if self.status < 0:
            return f"was ended by {signal_name(-self.status)}"
        if self.status:
            return f"died with exit status {self.status}"
        return "finished"


def signal_name(number: int) -> str:
    """Return what a signal is called."""
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


class Guard:
    """This process's end of the guard process (see `guard.py`)."""

    def __init__(self) -> None:
        """Start the guard; `OSError` where that is not possible."""
        self._process = subprocess.Popen(
            guard.command(),
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            bufsize=0,
            start_new_session=True,
        )
        assert self._process.stdin is not None
        self._pipe = self._process.stdin

    def note_own_group(self) -> None:
        """Note the calling process; to be called in a new child, before it becomes the node.

        The child itself tells the guard, so that there is no moment in which the supervisor
        could be killed and the node be unknown.
        """
        self._write(f"+{os.getpid()}\n")

    def note(self, group: int) -> None:
        """Note a group that the calling process has started."""
        self._write(f"+{group}\n")

    def forget(self, group: int | None = None) -> None:
        """Take a group off, or the last one that was noted."""
        self._write(f"-{'' if group is None else group}\n")

    def end(self) -> None:
        """Have every group ended that is still noted, then the guard; nothing waits for that."""
        with contextlib.suppress(OSError):
            self._pipe.close()

    def close(self) -> None:
        """End the guard, and with it every group that is still noted."""
        self.end()
        self._process.wait()

    def _write(self, line: str) -> None:
        # A guard that somebody killed must not keep the nodes from being started; `ValueError`:
        # it was ended.
        with contextlib.suppress(OSError, ValueError):
            self._pipe.write(line.encode())


class Child:
    """A running process, the leader of a session and a process group of its own.

    Attributes:
        was_asked: whether it was told to stop.
        is_at_end: whether its output has ended; it may still run then.
    """

    def __init__(self, process: Process, guard: Guard) -> None:
        """Start the process; `OSError` where that is not possible."""
        self.process = process
        self.was_asked = False
        self.is_at_end = False
        self._guard = guard
        self._partial = bytearray()
        self._tail: deque[str] = deque(maxlen=_TAIL)
        self._tracebacks = StopTracebacks()
        try:
            self._popen = subprocess.Popen(
                process.argv,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                bufsize=0,
                env=process.environ,
                cwd=process.cwd,
                start_new_session=True,
                preexec_fn=guard.note_own_group,
                pass_fds=process.fds,
            )
        except OSError:
            guard.forget()
            raise
        assert self._popen.stdout is not None
        self.fd = self._popen.stdout.fileno()
        os.set_blocking(self.fd, False)

    @property
    def pid(self) -> int:
        """The process, and its process group."""
        return self._popen.pid

    def read(self) -> Iterator[str]:
        """Yield the lines that are there, at most a chunk of them."""
        yield from self._lines(self._chunk() or b"")

    def has_ended(self) -> bool:
        """Tell whether the process is gone, and leave it unreaped.

        As long as it is unreaped its number cannot become another group's.
        """
        flags = os.WEXITED | os.WNOHANG | os.WNOWAIT
        return os.waitid(os.P_PID, self.pid, flags) is not None

    def send(self, signum: int) -> None:
        """Send a signal to the process and to all that it started in its group."""
        self.was_asked = True
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(self.pid, signum)

    def finish(self) -> Iterator[str]:
        """Yield what is left of the output of a process that has ended, and close everything.

        What it started and left in its group is killed: it held the pipe, and nobody would
        stop it later.
        """
        assert self._popen.stdout is not None
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(self.pid, signal.SIGKILL)
        left = _MOST_LEFT
        # What left the group may hold the pipe still, and write into it without end.
        while left > 0 and (chunk := self._chunk()):
            left -= len(chunk)
            yield from self._lines(chunk)
        if self._partial:
            yield from self._lines(b"\n")
        yield from self._tracebacks.rest()
        self._popen.stdout.close()
        self._guard.forget(self.pid)
        self._popen.wait()

    def exit(self) -> Exit:
        """Tell how it ended, after `finish`."""
        status = self._popen.returncode
        return Exit(self.process, status, "", tuple(self._tail), self.was_asked)

    def _chunk(self) -> bytes | None:
        try:
            chunk = os.read(self.fd, _CHUNK)
        except BlockingIOError:
            return None
        self.is_at_end = not chunk
        return chunk

    def _lines(self, chunk: bytes) -> Iterator[str]:
        self._partial += chunk
        *lines, rest = bytes(self._partial).split(b"\n")
        if len(rest) > _LONGEST_LINE:
            lines.append(rest)
            rest = b""
        self._partial = bytearray(rest)
        texts = (line.decode("utf-8", "replace").rstrip("\r") for line in lines)
        for text in self._tracebacks.without(texts) if self.was_asked else texts:
            self._tail.append(text)
            yield text
