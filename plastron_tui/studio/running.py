"""The nodes that run: `plastron run` as a process beside the studio, and what it prints."""

from __future__ import annotations

import os
import signal
import subprocess
import threading
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from plastron_tui import import_path
from plastron_tui.runtime.child import Guard
from plastron_tui.runtime.labels import OWN_NAME, is_own
from plastron_tui.runtime.monitor import MonitorCommand, announced
from plastron_tui.runtime.process_lines import Backlog, News, lines_of
from plastron_tui.session import Options

_MOST_LINES = 5000
"""So many lines are kept of those that nobody has taken yet."""
MOST_WAITING = 1_000_000
"""So many bytes wait at most: what takes longer to show than two or three seconds."""
AT_ONCE = 20_000
"""So many bytes are taken at once: what is shown between two keys, and nobody notices."""
_MOST_BYTES = 65536
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
        is_started: whether the nodes were started: what they need is built.
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
        self.is_started = False
        self._news = News(on_news)
        self._lines = Backlog(
            most_lines=_MOST_LINES, most_bytes=MOST_WAITING, at_once=AT_ONCE, is_kept=_is_own
        )
        self._is_asked_to_stop = False
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
        self._guard: Guard | None = None
        with suppress(OSError):
            self._guard = Guard()
            self._guard.note(self._process.pid)
        threading.Thread(target=self._read, daemon=True).start()
        threading.Thread(target=self._hear, args=(announcing,), daemon=True).start()

    @property
    def was_stopped(self) -> bool:
        """Whether the nodes ended because they were asked to."""
        return self.status in _STOPPED

    @property
    def has_more(self) -> bool:
        """Whether there are lines that `take` has not returned yet."""
        return len(self._lines) > 0

    def take(self) -> list[str]:
        """Return the first of the lines that were printed since this was called last."""
        self._news.taking()
        return [line.decode("utf-8", "replace") for line in self._lines.take()]

    def stop(self) -> None:
        """Interrupt the nodes, as Ctrl-C does; leave out what would be shown long after that."""
        self._is_asked_to_stop = True
        self._lines.skip()
        if self.status is None:
            with suppress(ProcessLookupError, PermissionError):
                self._process.send_signal(signal.SIGINT)

    def close(self) -> None:
        """Have the nodes ended by the guard, which takes the time that it takes."""
        if self._guard is None:
            self.stop()
        else:
            self._guard.end()

    def _read(self) -> None:
        assert self._process.stdout is not None
        with self._process.stdout as stream:
            for line in lines_of(stream, _MOST_BYTES):
                self._lines.add(line)
                self._news.tell()
        if self._is_asked_to_stop:
            self._lines.skip()
        self.status = self._process.wait()
        self._news.tell_anew()
        if self._guard is not None:
            self._guard.forget()
            self._guard.close()

    def _hear(self, announcing: int) -> None:
        """Read what starts the monitors, which is said when the nodes are started."""
        with os.fdopen(announcing, encoding="utf-8", errors="replace") as pipe:
            self.monitors = announced(pipe.readline())
        self.is_started = True
        self._news.tell_anew()


def _is_own(line: bytes) -> bool:
    """Tell whether a line is the run's own, without reading all of one that is not."""
    return line.startswith(OWN_NAME.encode()) and is_own(line.decode("utf-8", "replace"))


def _command(path: Path, options: Options, told: int) -> list[str]:
    command = [*import_path.command("plastron_tui.cli:main"), "run", os.fspath(path)]
    command += ["--announce", str(told)]
    if options.target is not None:
        command += ["--target", options.target]
    if options.output is not None:
        command += ["--output", os.fspath(options.output)]
    return command
