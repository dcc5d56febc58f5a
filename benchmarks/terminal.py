"""A process in a terminal of its own, that answers nothing."""

from __future__ import annotations

import fcntl
import os
import pty
import select
import signal
import struct
import termios
from pathlib import Path
from time import perf_counter

_ROWS, _COLUMNS = 40, 120
_LONGEST = 20.0
"""Seconds to wait for any output at most."""


class Terminal:
    """A process in a terminal of its own."""

    def __init__(self, command: list[str], home: Path) -> None:
        environ = {**os.environ, "TERM": "xterm-256color", "COLORTERM": "truecolor"}
        environ |= {"XDG_CONFIG_HOME": str(home), "XDG_STATE_HOME": str(home)}
        # Installed packages are compiled once; so is a checkout, where the environment allows it.
        environ.pop("PYTHONDONTWRITEBYTECODE", None)
        self.start = perf_counter()
        self.pid, self.file = pty.fork()
        if self.pid == 0:
            os.execvpe(command[0], command, environ)
        size = struct.pack("HHHH", _ROWS, _COLUMNS, 0, 0)
        fcntl.ioctl(self.file, termios.TIOCSWINSZ, size)
        self.output = b""

    def wait_for(self, text: bytes) -> float:
        """Wait until a text was printed, and return how many seconds after the start it was."""
        while text not in self.output:
            ready, _, _ = select.select([self.file], [], [], _LONGEST)
            if not ready:
                raise TimeoutError(text)
            self.output += os.read(self.file, 1 << 16)
        return perf_counter() - self.start

    def rest(self, seconds: float) -> None:
        """Take what is printed for a while."""
        end = perf_counter() + seconds
        while (left := end - perf_counter()) > 0:
            if select.select([self.file], [], [], left)[0]:
                os.read(self.file, 1 << 16)

    def quiet(self, seconds: float) -> bytes:
        """Take what is printed until nothing is for a while, or a cursor blinks; return it."""
        printed, end = b"", perf_counter() + 3 * seconds
        while perf_counter() < end and select.select([self.file], [], [], seconds)[0]:
            printed += os.read(self.file, 1 << 16)
        return printed

    def answer(self, text: bytes, seconds: float) -> bytes:
        """Let keys come; return what is printed until nothing is for a while."""
        os.write(self.file, text)
        return self.quiet(seconds)

    def processor_seconds(self) -> float:
        """Return how long the process has worked so far."""
        fields = Path(f"/proc/{self.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def type(self, text: bytes) -> None:
        """Let keys come; what was printed until then is forgotten."""
        self.output = b""
        os.write(self.file, text)

    def close(self) -> None:
        os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)
        os.close(self.file)
