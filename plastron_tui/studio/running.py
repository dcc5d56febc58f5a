"""The nodes that run: `plastron run` as a process beside the studio, and what it prints."""

from __future__ import annotations

import os
import signal
import subprocess
import threading
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path

from plastron_tui import import_path
from plastron_tui.runtime import guard
from plastron_tui.runtime.monitor import MonitorCommand, announced
from plastron_tui.session import Options

_MOST_LINES = 5000
"""So many lines are kept of those that nobody has taken yet."""
_LONGEST = 65536
"""So many bytes of a line are kept; a node may print without ever ending one."""
# The panel is narrow, and names the node before each line: the time and the name can go.
_PLAIN = {
    "RCUTILS_CONSOLE_OUTPUT_FORMAT": "[{severity}] {message}",
    "ROSCONSOLE_FORMAT": "[${severity}] ${message}",
}
_STOPPED = (130, -signal.SIGINT, -signal.SIGTERM)


class Running:
    """A run of a program's nodes; it ends with the studio, however that ends.

    Attributes:
        status: the exit status, None as long as the nodes run.
        monitors: what starts monitors of the nodes; nothing before they are started.
    """

    def __init__(self, path: Path, options: Options, on_news: Callable[[], None]) -> None:
        """Start the nodes of a program.

        Args:
            path: the program.
            options: what the command line of the studio sets.
            on_news: called, in a thread of its own, when there are lines to take or the nodes
                have ended; not again before `take` was called.

        Raises:
            OSError: no process can be started.
        """
        self.status: int | None = None
        self.monitors: tuple[MonitorCommand, ...] = ()
        self._on_news = on_news
        self._lines: deque[str] = deque(maxlen=_MOST_LINES)
        self._is_told = threading.Event()
        announcing, told = os.pipe()
        try:
            self._process = subprocess.Popen(
                _command(path, options, told),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                env={**_PLAIN, **os.environ, "PYTHONUNBUFFERED": "1", "NO_COLOR": "1"},
                start_new_session=True,
                pass_fds=(told,),
            )
        except OSError:
            os.close(announcing)
            raise
        finally:
            os.close(told)
        self._guard = _guarded(self._process.pid)
        threading.Thread(target=self._read, daemon=True).start()
        threading.Thread(target=self._hear, args=(announcing,), daemon=True).start()

    @property
    def was_stopped(self) -> bool:
        """Whether the nodes ended because they were asked to."""
        return self.status in _STOPPED

    def take(self) -> list[str]:
        """Return the lines that were printed since this was called last."""
        self._is_told.clear()
        lines = []
        with suppress(IndexError):
            while True:
                lines.append(self._lines.popleft())
        return lines

    def stop(self) -> None:
        """Interrupt the nodes, as Ctrl-C does."""
        if self.status is None:
            with suppress(ProcessLookupError, PermissionError):
                self._process.send_signal(signal.SIGINT)

    def close(self) -> None:
        """Have the nodes ended by the guard, which takes the time that it takes."""
        if self._guard is None or self._guard.stdin is None:
            self.stop()
        else:
            with suppress(OSError):
                self._guard.stdin.close()

    def _read(self) -> None:
        assert self._process.stdout is not None
        with self._process.stdout as stream:
            is_rest = False
            for line in iter(partial(stream.readline, _LONGEST), b""):
                if not is_rest:
                    self._lines.append(line.decode("utf-8", "replace").rstrip("\r\n"))
                    self._tell()
                is_rest = not line.endswith(b"\n")
        self.status = self._process.wait()
        self._is_told.clear()
        self._tell()
        if self._guard is not None and self._guard.stdin is not None:
            # `ValueError`: it was closed.
            with suppress(OSError, ValueError):
                self._guard.stdin.write(b"-\n")
                self._guard.stdin.close()
            self._guard.wait()

    def _hear(self, announcing: int) -> None:
        """Read what starts the monitors, which is said when the nodes are started."""
        with os.fdopen(announcing, encoding="utf-8", errors="replace") as pipe:
            self.monitors = announced(pipe.readline())
        if self.monitors:
            self._is_told.clear()
            self._tell()

    def _tell(self) -> None:
        if not self._is_told.is_set():
            self._is_told.set()
            self._on_news()


def _command(path: Path, options: Options, told: int) -> list[str]:
    command = [*import_path.command("plastron_tui.cli:main"), "run", os.fspath(path)]
    command += ["--announce", str(told)]
    if options.target is not None:
        command += ["--target", options.target]
    if options.output is not None:
        command += ["--output", os.fspath(options.output)]
    return command


def _guarded(group: int) -> subprocess.Popen[bytes] | None:
    """Start the process that ends a group of processes when this one is gone, if that can be."""
    try:
        process = subprocess.Popen(
            guard.command(),
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
    except OSError:
        return None
    assert process.stdin is not None
    with suppress(OSError):
        process.stdin.write(b"+%d\n" % group)
        process.stdin.flush()
    return process
