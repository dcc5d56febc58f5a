"""Lets a process fail, or end, at one of its calls that change the disk."""

from __future__ import annotations

import errno
import fcntl
import os
from collections.abc import Callable
from pathlib import Path

from plastron_tui.output import recovery
from plastron_tui.output.own_files import PREFIX, temporary_kind

CALLS = ("open", "write", "fsync", "link", "replace", "rename", "unlink", "mkdir", "rmdir",
         "fchmod", "fchown", "setxattr")  # fmt: skip

KILLED = 99
"""The status of a process that was killed."""


def no_locks(*_: object) -> None:
    """Answer as a file system without locks."""
    raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))


def break_call(at: int, event: str, calls: tuple[str, ...]) -> list[int]:
    """Let the nth call that changes the disk be the last, or fail; return the counter."""
    count = [0]
    if event == "read":
        fcntl.flock = no_locks

    def broken(name: str) -> Callable[..., object]:
        real = getattr(os, name)

        def call(*args: object, **kwargs: object) -> object:
            if name == "open" and not int(str(args[1])) & os.O_CREAT:
                return real(*args, **kwargs)
            count[0] += 1
            if count[0] != at:
                return real(*args, **kwargs)
            if event == "read":
                for folder in {path.parent for path in Path().rglob(f"{PREFIX}*")}:
                    recovery.settle(folder)
                return real(*args, **kwargs)
            if event == "clean":
                for path in Path().rglob(f"{PREFIX}*"):
                    if temporary_kind(path.name) == "new":
                        os.unlink(path)
                return real(*args, **kwargs)
            if event == "kill":
                if name == "write":
                    real(args[0], bytes(args[1])[: len(bytes(args[1])) // 2])  # type: ignore[arg-type]
                os._exit(KILLED)
            number = getattr(errno, event)
            raise OSError(number, os.strerror(number), args[0])

        return call

    for name in calls:
        setattr(os, name, broken(name))
    return count
