"""Locks on folders, so that processes that write to one take turns."""

from __future__ import annotations

import fcntl
import os
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from types import TracebackType

LOCK_SECONDS = 10.0
"""How long to wait for another process that writes to the same folder."""


class BusyError(Exception):
    """Another process holds a folder's lock; the argument is the folder."""


class FolderLocks:
    """The locks of some folders, until the context is left.

    Attributes:
        descriptors: the open folders, by path.
        unlocked: those of them that are on a file system without locks.
    """

    def __init__(self, waiting: Callable[[], None] = lambda: None) -> None:
        """Set what is called while another process is waited for; what it raises ends that."""
        self.descriptors: dict[str, int] = {}
        self.unlocked: set[str] = set()
        self._waiting = waiting

    def __enter__(self) -> FolderLocks:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.release()

    def take(self, folders: Iterable[str]) -> None:
        """Lock folders, in an order in which two processes cannot wait for each other.

        Raises:
            OSError: the operating system refuses.
            BusyError: another process did not give a lock back in `LOCK_SECONDS`.
        """
        for folder in sorted(set(folders)):
            # The folder may have been removed, and made anew, while another process had its lock.
            while not self._took(folder):
                os.close(self.descriptors.pop(folder))

    def release(self) -> None:
        """Give the locks back."""
        self.unlocked.clear()
        while self.descriptors:
            _, descriptor = self.descriptors.popitem()
            with suppress(OSError):  # there is nothing in a folder that could be lost
                os.close(descriptor)

    def _took(self, folder: str) -> bool:
        """Lock a folder; tell whether it is still the one of that path."""
        flags = os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC
        descriptor = self.descriptors[folder] = os.open(folder, flags)
        self._lock(folder, descriptor)
        return os.path.samestat(os.fstat(descriptor), os.stat(folder))

    def _lock(self, folder: str, descriptor: int) -> None:
        deadline = time.monotonic() + LOCK_SECONDS
        while True:
            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
                return
            except BlockingIOError:
                if time.monotonic() > deadline:
                    raise BusyError(folder) from None
            except OSError:
                # A file system without locks: each file is still replaced as a whole, and a writer
                # that gets in another's way notices.
                self.unlocked.add(folder)
                return
            self._waiting()
            time.sleep(0.02)
