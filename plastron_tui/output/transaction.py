"""Files that are replaced all together or not at all.

First every text is written to a temporary file beside its target and synced; only then are the
targets renamed over, one after the other. Whatever fails, up to the last rename, is undone in
reverse order. What stays possible is a machine that stops between two renames: then each single
file is whole, and either old or new.
"""

from __future__ import annotations

import errno
import fcntl
import os
import stat
import time
from collections.abc import Callable, Iterable
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from types import TracebackType

from .interrupts import Interrupts
from .plan import TEMPORARY_PREFIX

LOCK_SECONDS = 10.0
"""How long to wait for another process that writes to the same folder."""

# File systems that have no hard links, or a user who may not make one, answer with these.
_NO_LINKS = {errno.EPERM, errno.EACCES, errno.EOPNOTSUPP, errno.ENOSYS, errno.EMLINK, errno.EXDEV}


@dataclass(slots=True)
class Step:
    """One file of a transaction.

    Attributes:
        path: the file that is replaced.
        text: its new text.
        is_executable: whether it gets the executable bit.
        status: what `lstat` said when `before` was read; None for a file that is new.
        before: its present text.
        keeps_backup: whether the present text stays beside it, as `NAME.bak`.
        backup: the backup's path, once there is one.
    """

    path: str
    text: bytes
    is_executable: bool
    status: os.stat_result | None = None
    before: bytes | None = None
    keeps_backup: bool = False
    backup: str | None = None


class ChangedError(Exception):
    """A file is no longer what it was when the plan was made."""


class BusyError(Exception):
    """Another process holds a folder's lock."""


class Transaction:
    """The steps that were taken, and how to undo them.

    `at` is the path that is worked on, for the diagnostic of an `OSError`. Leaving the context
    without `commit` undoes everything; what could not be undone is in `failures`.
    """

    def __init__(self, interrupts: Interrupts) -> None:
        self.at = ""
        self.failures: list[tuple[str, OSError]] = []
        self._interrupts = interrupts
        self._undo = ExitStack()
        self._locks = ExitStack()
        self._folders: dict[str, int] = {}
        self._synced_too: list[str] = []
        self._temporaries: list[tuple[Step, str, str]] = []

    def __enter__(self) -> Transaction:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        try:
            self._undo.close()
        finally:
            self._locks.close()

    def open_folders(self, folders: Iterable[str]) -> None:
        """Make the folders where they are missing, and lock each against other writers.

        Raises:
            OSError: the operating system refuses.
            BusyError: another process did not give the lock back in `LOCK_SECONDS`.
        """
        for folder in sorted(set(folders)):  # sorted, so that two writers cannot wait in a ring
            self.at = folder
            self._make_folder(folder)
            descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
            self._locks.callback(_close, descriptor)
            self._folders[folder] = descriptor
            self._lock(descriptor)

    def stage(self, step: Step) -> None:
        """Write a step's text to a temporary file beside its target, and sync it."""
        self._interrupts.check()
        self.at = step.path
        folder = os.path.dirname(step.path)
        stem = os.path.join(folder, f"{TEMPORARY_PREFIX}{len(self._temporaries)}")
        new, old = f"{stem}.new", f"{stem}.old"
        self._undo.callback(self._try, _remove, new)
        _write_new(new, step)
        self._temporaries.append((step, new, old))

    def commit(self) -> None:
        """Put all temporary files in their places.

        An interrupt that arrives once this has begun waits until it is done.

        Raises:
            OSError: the operating system refuses.
            ChangedError: a file is not what it was when the plan was made.
        """
        self._interrupts.check()
        for step, _, old in self._temporaries:
            if step.status is not None:
                self.at = step.path
                self._keep(step, old)
        self._interrupts.check()
        for step, new, old in self._temporaries:
            self.at = step.path
            if not is_unchanged(step.path, step.status):
                raise ChangedError
            if step.status is None:
                self._undo.callback(self._try, _take_away, step.path, new)
            else:
                self._undo.callback(self._try, _put_back, step.path, new, old)
            os.replace(new, step.path)
        for folder, descriptor in self._folders.items():
            self.at = folder
            _sync_folder(descriptor)
        for folder in self._synced_too:
            self.at = folder
            self._sync_path(folder)
        self._undo.pop_all()
        with ExitStack() as leftovers:
            for step, _, old in self._temporaries:
                if step.status is not None:
                    leftovers.callback(_remove_quietly, old)

    def _keep(self, step: Step, old: str) -> None:
        """Keep a file's present text aside, to put it back or as the backup."""
        self._undo.callback(self._drop, old, step.path)
        try:
            _link_or_copy(step, old)
        except FileExistsError:
            _remove(old)  # left behind by a process that was killed: we hold the folder's lock
            _link_or_copy(step, old)
        if step.keeps_backup:
            step.backup = self._back_up(step)

    def _back_up(self, step: Step) -> str:
        number = 0
        while True:
            backup = f"{step.path}.bak{number or ''}"
            self._undo.callback(self._try, _remove_if_same, backup, step.path)
            try:
                was_linked = _link_or_copy(step, backup)
            except FileExistsError:
                number += 1
                continue
            if not was_linked:
                self._undo.callback(self._try, _remove, backup)
            return backup

    def _make_folder(self, folder: str) -> None:
        missing = []
        while not os.path.isdir(folder):
            missing.append(folder)
            parent = os.path.dirname(folder)
            if parent == folder:
                break
            folder = parent
        for path in reversed(missing):
            self._undo.callback(self._try, _remove_folder, path)
            with suppress(FileExistsError):  # another process was faster; a file fails below
                os.mkdir(path)
            self._synced_too.append(os.path.dirname(path))

    def _lock(self, descriptor: int) -> None:
        deadline = time.monotonic() + LOCK_SECONDS
        while True:
            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
                return
            except BlockingIOError:
                if time.monotonic() > deadline:
                    raise BusyError from None
            except OSError:
                # A file system without locks: each file is still replaced as a whole.
                return
            self._interrupts.check()
            time.sleep(0.02)

    def _sync_path(self, folder: str) -> None:
        if folder in self._folders:
            return
        descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
        try:
            _sync_folder(descriptor)
        finally:
            os.close(descriptor)

    def _drop(self, old: str, path: str) -> None:
        """Remove a text that was kept aside, unless it is the last that is left of a file."""
        if path not in (failed for failed, _ in self.failures):
            self._try(_remove, old)

    def _try(self, undo: Callable[..., None], path: str, *others: str) -> None:
        try:
            undo(path, *others)
        except OSError as error:
            self.failures.append((path, error))


def is_unchanged(path: str, status: os.stat_result | None) -> bool:
    """Tell whether a file is still the one that `status` was taken of (None: no file)."""
    try:
        now = os.lstat(path)
    except FileNotFoundError:
        return status is None
    return status is not None and _identity(now) == _identity(status)


def _identity(status: os.stat_result) -> tuple[int, int, int, int]:
    return status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns


def _write_new(path: str, step: Step) -> None:
    """Write and sync a file that must not exist, with the mode that its target shall have."""
    # For a new file the process's umask has its say: what it masks is no business of ours.
    descriptor = _create(path, 0o777 if step.is_executable else 0o666)
    try:
        _write_all(descriptor, step.text)
        if step.status is not None:
            _set_mode(descriptor, step.status, is_executable=step.is_executable)
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def _create(path: str, mode: int) -> int:
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC
    try:
        return os.open(path, flags, mode)
    except FileExistsError:
        os.unlink(path)  # left behind, as above
        return os.open(path, flags, mode)


def _write_all(descriptor: int, text: bytes) -> None:
    rest = memoryview(text)
    while rest:
        rest = rest[os.write(descriptor, rest) :]


def _set_mode(descriptor: int, status: os.stat_result, *, is_executable: bool) -> None:
    with suppress(OSError):  # only the superuser can write in another's name
        os.fchown(descriptor, status.st_uid, status.st_gid)
    mode = stat.S_IMODE(status.st_mode)
    if is_executable and not mode & stat.S_IXUSR:
        mode |= (mode & 0o444) >> 2  # whoever may read it may run it
    os.fchmod(descriptor, mode)


def _link_or_copy(step: Step, path: str) -> bool:
    """Give a file's present text a second name; tell whether it is a link."""
    try:
        os.link(step.path, path)
        return True
    except OSError as error:
        if error.errno not in _NO_LINKS or step.status is None:
            raise
    descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
    try:
        try:
            _write_all(descriptor, step.before or b"")
            _set_mode(descriptor, step.status, is_executable=False)
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
    except BaseException:
        _remove_quietly(path)
        raise
    return False


def _close(descriptor: int) -> None:
    """Close a folder, which lets its lock go; there is nothing in it that could be lost."""
    with suppress(OSError):
        os.close(descriptor)


def _take_away(path: str, new: str) -> None:
    """Undo the rename of a file that is new, if it took place."""
    if not os.path.lexists(new):
        _remove(path)


def _put_back(path: str, new: str, old: str) -> None:
    """Undo the rename over a file, if it took place."""
    if not os.path.lexists(new):
        os.replace(old, path)


def _remove(path: str) -> None:
    if os.path.lexists(path):  # a read-only file system refuses even what is not there
        os.unlink(path)


def _remove_quietly(path: str) -> None:
    with suppress(OSError):
        os.unlink(path)


def _remove_if_same(path: str, other: str) -> None:
    with suppress(FileNotFoundError):
        if _identity(os.lstat(path)) == _identity(os.lstat(other)):
            os.unlink(path)


def _remove_folder(path: str) -> None:
    if not os.path.isdir(path):
        return
    try:
        os.rmdir(path)
    except OSError as error:
        if error.errno not in {errno.ENOENT, errno.ENOTEMPTY, errno.EEXIST}:
            raise


def _sync_folder(descriptor: int) -> None:
    try:
        os.fsync(descriptor)
    except OSError as error:
        if error.errno not in {errno.EINVAL, errno.EOPNOTSUPP}:  # it syncs files only
            raise
