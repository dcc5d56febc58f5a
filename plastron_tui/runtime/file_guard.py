"""What a process may do that works on files of strangers: read where it may, and nothing else.

Python tells its audit hooks before it opens a file, starts a process or asks for a connection
(PEP 578). That is no wall against code that breaks out of Python; it keeps what a file says, and
the expressions in it, from what they have no business with.
"""

from __future__ import annotations

import errno
import os
import sys
from collections.abc import Callable
from contextlib import suppress
from typing import Any

_LISTS = frozenset({"os.scandir", "os.listdir"})
_HARMLESS = frozenset({"os.walk", "os.fwalk"})
_REFUSED = (
    "_winapi.",
    "ctypes.",
    "fcntl.",
    "ftplib.",
    "http.",
    "mmap.",
    "os.",
    "pty.",
    "resource.",
    "shutil.",
    "signal.",
    "smtplib.",
    "socket.",
    "sqlite3.",
    "subprocess.",
    "tempfile.",
    "urllib.",
    "webbrowser.",
    "winreg.",
)
_MODULES = frozenset(
    {
        "_cffi_backend",
        "_ctypes",
        "_posixshmem",
        "_posixsubprocess",
        "_socket",
        "cffi",
        "ctypes",
        "multiprocessing",
        "socket",
        "subprocess",
    }
)
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
_MOST = 2_000

# Of <linux/sched.h>: a network of its own, which has no interface, and users of its own, without
# which only the superuser gets one.
_NEW_NETWORK = 0x40000000
_NEW_USERS = 0x10000000


class FileGuard:
    """An audit hook that lets files be read that may be, and keeps a list of what was asked for.

    Attributes:
        opened: the files that were opened, or were not there.
        refused: what was asked for and refused, in words.
    """

    def __init__(self, allows: Callable[[str], bool]) -> None:
        """Set which files may be read, besides those of Python itself."""
        self.opened: dict[str, None] = {}
        self.refused: list[str] = []
        self._allows = allows
        self._library = os.path.realpath(os.path.dirname(os.__file__)) + os.sep  # noqa: PTH120

    def __call__(self, event: str, arguments: tuple[Any, ...]) -> None:
        """Judge an event; what is refused is an error of the operating system."""
        if event == "open":
            self._judge_open(*arguments)
        elif event in _LISTS:
            self._judge_path(arguments[0] or os.curdir)
        elif event == "import":
            if arguments[0].partition(".")[0] in _MODULES:
                raise self._refusal(f"they ask for the module `{arguments[0]}`")
        elif event.startswith(_REFUSED) and event not in _HARMLESS:
            raise self._refusal(f"they ask for `{event}`")

    def _judge_open(self, path: Any, mode: str | None, flags: int) -> None:
        if isinstance(path, int):
            return
        is_written = any(each in mode for each in "wax+") if mode else bool(flags & _WRITING)
        if is_written:
            raise self._refusal(f"they write to `{os.fsdecode(path)}`")
        self._judge_path(path)

    def _judge_path(self, path: Any) -> None:
        if isinstance(path, int):
            return
        name = os.fsdecode(path)
        if os.path.realpath(name).startswith(self._library):
            return
        if not self._allows(name):
            outside = "which is neither in the project nor in an installed package"
            raise self._refusal(f"they lead to `{name}`, {outside}")
        if len(self.opened) < _MOST:
            self.opened[name] = None

    def _refusal(self, words: str) -> OSError:
        if len(self.refused) < _MOST:
            self.refused.append(words)
        return PermissionError(errno.EACCES, words)


def leave_network() -> None:
    """Leave the machine's network, where the system lets a process do so."""
    with suppress(Exception):
        import ctypes

        ctypes.CDLL(None).unshare(_NEW_USERS | _NEW_NETWORK)


def guard_files(allows: Callable[[str], bool]) -> FileGuard:
    """Guard this process from now on; a hook stays until the process ends."""
    guard = FileGuard(allows)
    sys.addaudithook(guard)
    return guard
