"""Files that are replaced all together or not at all.

First every text is written to a temporary file beside its target and synced; then a journal says
what is about to happen, and is synced as well; only then are the targets renamed over, one after
the other. Whatever fails, up to the last rename, is undone in reverse order. When the process, or
the machine, stops in between, the next run finishes what the journal says: see `recovery`.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from types import TracebackType

from plastron_tui.diagnostics import Diagnostic

from .file_calls import (
    copy_to,
    is_unchanged,
    link_or_copy,
    remove,
    sync_folder,
    take_after,
    write_new,
)
from .interrupts import Interrupts
from .journal import BadJournalError, Entry, Journal, journal_text, read_journal
from .locks import BusyError, FolderLocks
from .own_files import JOURNAL, JOURNAL_NEW, new_name
from .patch_stack import digest
from .recovery import drop_journals, recover, sweep
from .replacement import ChangedError, Replacement, free_backup

_MOST_TRIES = 5
"""How often a folder may get another's journal between looking and locking."""


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
        lost: what the new file could not be given of the old one: see `take_after`.
    """

    path: str
    text: bytes
    is_executable: bool
    status: os.stat_result | None = None
    before: bytes | None = None
    keeps_backup: bool = False
    backup: str | None = None
    lost: tuple[str, ...] = ()


class Transaction:
    """The files that are replaced, and how to undo it.

    Leaving the context without `commit` undoes everything.

    Attributes:
        at: the path that is worked on, for the diagnostic of an `OSError`.
        failures: what could not be undone; the next run tries it again.
        left: the temporary files that could not be removed at the end.
        notes: what was found of earlier writes, in the folders.
    """

    def __init__(self, interrupts: Interrupts) -> None:
        self.at = ""
        self.failures: list[tuple[str, OSError]] = []
        self.left: list[tuple[str, OSError]] = []
        self.notes: list[Diagnostic] = []
        self._interrupts = interrupts
        self._locks = FolderLocks(interrupts.check)
        self._made: list[str] = []
        self._temporaries: list[str] = []
        self._steps: dict[str, list[Step]] = {}
        self._replacements: list[tuple[Step, Replacement]] = []
        self._journals: list[str] = []
        self._deciding: Journal | None = None
        self._is_done = False

    def __enter__(self) -> Transaction:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        try:
            if not self._is_done:
                self._undo()
        finally:
            self._locks.release()

    def open_folders(self, folders: Iterable[str]) -> None:
        """Make the folders where they are missing, and lock each against other writers.

        What earlier processes left there when they were killed is finished, or removed.

        Raises:
            OSError: the operating system refuses.
            BusyError: another process did not give the lock back in time.
        """
        wanted = sorted(set(folders))
        for _ in range(_MOST_TRIES):
            for folder in wanted:
                self.at = folder
                self._make_folder(folder)
                if _has_journal(folder):
                    self.notes += recover(folder, self._interrupts.check, is_writer=True)
            try:
                self._locks.take(wanted)
            except FileNotFoundError:  # who had the lock made the folder, and took it back
                self._locks.release()
                continue
            if not any(_has_journal(folder) for folder in wanted):
                break
            self._locks.release()
        else:
            raise BusyError(self.at)
        for folder in wanted:
            self.at = folder
            self.notes += sweep(folder)

    def stage(self, step: Step) -> None:
        """Write a step's text to a temporary file beside its target, and sync it."""
        self._interrupts.check()
        self.at = step.path
        folder = os.path.dirname(step.path)
        steps = self._steps.setdefault(folder, [])
        new = os.path.join(folder, new_name(len(steps)))
        steps.append(step)
        # Until it has the mode of the old file, nobody else reads it.
        mode = 0o600 if step.status is not None else 0o777 if step.is_executable else 0o666
        with _noted(new, self._temporaries):
            descriptor = write_new(new, step.text, mode)
        try:
            if step.status is not None:
                lost = take_after(
                    descriptor, step.path, step.status, is_executable=step.is_executable
                )
                step.lost = tuple(lost)
            os.fsync(descriptor)
        finally:
            os.close(descriptor)

    def commit(self) -> None:
        """Put all temporary files in their places.

        An interrupt that arrives once the journals are begun waits until it is done.

        Raises:
            OSError: the operating system refuses.
            ChangedError: a file is not what it was when the plan was made.
        """
        self._interrupts.check()
        if not self._steps:
            self._is_done = True
            return
        for folder, steps in self._steps.items():
            for place, step in enumerate(steps):
                self.at = step.path
                self._replacements.append((step, _replacement(folder, place, step)))
        for step, replacement in self._replacements:
            self.at = step.path
            if step.status is not None:
                with _noted(replacement.old, self._temporaries):
                    link_or_copy(step.path, replacement.old, step.before or b"", step.status)
        self._interrupts.check()
        for folder in {os.path.dirname(path) for path in self._made}:
            self.at = folder
            sync_folder(folder)
        self._write_journals()
        for step, replacement in self._replacements:
            self.at = step.path
            if not is_unchanged(step.path, step.status):
                raise ChangedError(step.path)
            replacement.replace()
        self._sync()
        for step, replacement in self._replacements:
            self.at = step.path
            replacement.check()
        for step, replacement in self._replacements:
            self.at = step.path
            step.backup = replacement.keep_backup()
            if step.backup is not None and not os.path.lexists(step.backup):
                raise FileNotFoundError(errno.ENOENT, "somebody removed its old text", step.backup)
        if any(step.backup is not None for step, _ in self._replacements):
            self._sync()
        self._is_done = True
        self._clean_up()

    def _make_folder(self, folder: str) -> None:
        missing = []
        while not os.path.isdir(folder):
            missing.append(folder)
            parent = os.path.dirname(folder)
            if parent == folder:
                break
            folder = parent
        for path in reversed(missing):
            # Another process may be faster; a file in the way fails below.
            with suppress(FileExistsError), _noted(path, self._made):
                os.mkdir(path)

    def _write_journals(self) -> None:
        """Say in each folder what is about to happen; with the last journal it is decided."""
        write = os.urandom(16).hex()
        first, *others = self._steps
        # Undone in this order: without the one that decides the others count for nothing.
        self._journals = [first, *others]
        for folder in (*others, first):
            self.at = folder
            is_first = folder == first
            journal = Journal(
                write,
                tuple(each.entry for _, each in self._replacements if each.folder == folder),
                None if is_first else os.path.relpath(first, folder),
                tuple(os.path.relpath(other, first) for other in others) if is_first else (),
            )
            self._put_journal(folder, journal)
            self._deciding = journal

    def _put_journal(self, folder: str, journal: Journal) -> None:
        path = os.path.join(folder, JOURNAL_NEW)
        with _noted(path, self._temporaries):
            descriptor = write_new(path, journal_text(journal, folder), 0o600)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
        os.rename(path, os.path.join(folder, JOURNAL))
        sync_folder(self._locks.descriptors[folder])

    def _sync(self) -> None:
        for folder in self._steps:
            self.at = folder
            sync_folder(self._locks.descriptors[folder])

    def _clean_up(self) -> None:
        """Remove the old texts, and then the journals: all is in its place."""
        for _, replacement in self._replacements:
            self._remove(replacement.old)
        # With the journal the next run knows what is left, and that it may go.
        ways = [self._drop_journals, self._mark_done]
        self.at = os.path.join(self._journals[0], JOURNAL)
        problem: OSError | None = None
        for way in reversed(ways) if self.left else ways:
            try:
                way()
                break
            except OSError as error:
                problem = error
        if problem is not None and os.path.lexists(self.at):
            self.left.append((self.at, problem))

    def _drop_journals(self) -> None:
        first, *others = self._journals
        drop_journals([*others, first])

    def _mark_done(self) -> None:
        """Let the journal that decides take nothing back: the write is reported as done."""
        if self._deciding is not None:
            self._put_journal(self._journals[0], replace(self._deciding, is_done=True))

    def _undo(self) -> None:
        if self._journals:
            self._take_back()
        if self.failures:
            return
        # The first to be made is the last to go: see `has_leftovers`.
        for path in reversed(self._temporaries):
            self._remove(path)
        for folder in reversed(self._made):
            self._remove(folder, _remove_folder)

    def _take_back(self) -> None:
        for step, replacement in reversed(self._replacements):
            self._take_one_back(step, replacement)
        if self.failures:
            return
        try:
            self._sync()
            drop_journals(self._journals)
        except OSError as error:
            self.failures.append((os.path.join(self._journals[0], JOURNAL), error))

    def _take_one_back(self, step: Step, replacement: Replacement) -> None:
        try:
            try:
                replacement.take_back()
            except FileNotFoundError:
                if step.before is None or step.status is None:
                    raise
                # Somebody removed the old text, which is still known here.
                copy_to(replacement.old, step.path, step.before, step.status)
                replacement.take_back()
        except ChangedError:  # by hand, since it was replaced: that text stays
            return
        except OSError as error:
            self.failures.append((step.path, error))

    def _remove(self, path: str, call: Callable[[str], None] = remove) -> None:
        try:
            call(path)
        except IsADirectoryError:  # in the way of a file that was not made
            return
        except OSError as error:
            self.left.append((path, error))


@contextmanager
def _noted(path: str, made: list[str]) -> Iterator[None]:
    """Note what is made, so that it is undone; what was there is nothing of ours, and stays."""
    made.append(path)
    try:
        yield
    except FileExistsError:
        made.remove(path)
        raise


def _replacement(folder: str, place: int, step: Step) -> Replacement:
    before = None if step.status is None else digest(step.before or b"")
    backup = os.path.basename(free_backup(step.path)) if step.keeps_backup else None
    entry = Entry(os.path.basename(step.path), before, digest(step.text), backup)
    return Replacement(folder, place, entry)


def _has_journal(folder: str) -> bool:
    try:
        return read_journal(folder) is not None
    except BadJournalError:
        return False


def _remove_folder(path: str) -> None:
    if not os.path.isdir(path):
        return
    try:
        os.rmdir(path)
    except OSError as error:
        if error.errno not in {errno.ENOENT, errno.ENOTEMPTY, errno.EEXIST}:
            raise
