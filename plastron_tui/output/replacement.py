"""Files that are replaced: one after the other forward, or back, whoever began with it.

A process that writes and one that finds another's journal do the same with the same files, as often
as it takes: each step looks first whether it was taken.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, auto
from itertools import count

from .file_calls import digest_of, is_same_file, link_or_move
from .journal import Entry
from .own_files import new_name, old_name


class ChangedError(Exception):
    """A file is no longer what it was when the plan was made; the argument is its path."""


class Progress(Enum):
    """How far a replacement has come."""

    WAITING = auto()
    """The old text is there, and the new one waits beside it."""

    DONE = auto()
    """The new text is there, or what was made of it by hand since."""

    TAKEN_BACK = auto()
    """The old text is there again."""

    BLOCKED = auto()
    """The new text waits, but the old one is there no more: it was changed by hand."""


@dataclass(frozen=True, slots=True)
class Replacement:
    """A file of a folder that is replaced: the place of its entry gives its temporary names."""

    folder: str
    place: int
    entry: Entry

    @property
    def path(self) -> str:
        """The file."""
        return os.path.join(self.folder, self.entry.name)

    @property
    def new(self) -> str:
        """Where its new text waits."""
        return os.path.join(self.folder, new_name(self.place))

    @property
    def old(self) -> str:
        """Where its old text is kept."""
        return os.path.join(self.folder, old_name(self.place))

    def progress(self) -> Progress:
        """Look how far this has come.

        Raises:
            OSError: the operating system refuses.
        """
        before, after = self.entry.before, self.entry.after
        present = digest_of(self.path)
        if os.path.lexists(self.new):
            is_as_said = present == before and digest_of(self.new) == after
            return Progress.WAITING if is_as_said else Progress.BLOCKED
        is_back = present == before and before != after
        return Progress.TAKEN_BACK if is_back else Progress.DONE

    def replace(self) -> None:
        """Replace the file, for the process that has just made the new text.

        Raises:
            OSError: the operating system refuses, or the new text is gone.
            ChangedError: the file does not hold its old text, or another new text waits.
        """
        waiting = digest_of(self.new)
        if waiting is None:
            reason = f"somebody removed `{new_name(self.place)}`"
            raise FileNotFoundError(errno.ENOENT, reason, self.new)
        if waiting != self.entry.after or digest_of(self.path) != self.entry.before:
            raise ChangedError(self.path)
        os.replace(self.new, self.path)

    def finish(self) -> None:
        """Replace the file, unless the process that was killed has done it; errors as `replace`."""
        if os.path.lexists(self.new):
            self.replace()

    def check(self) -> None:
        """Check that the file holds its new text.

        Raises:
            OSError: the operating system refuses.
            ChangedError: it does not.
        """
        if digest_of(self.path) != self.entry.after:
            raise ChangedError(self.path)

    def take_back(self) -> None:
        """Put the old text back, unless it was never replaced.

        Raises:
            OSError: the operating system refuses, or the old text is gone.
            ChangedError: the new text was changed by hand.
        """
        entry = self.entry
        if os.path.lexists(self.new):
            return
        present = digest_of(self.path)
        kept = next(self._kept(), None)
        if present == entry.before and (kept is None or entry.before != entry.after):
            self._remove_backup()
        elif present != entry.after:
            raise ChangedError(self.path)
        elif entry.before is None:
            os.unlink(self.path)
        elif kept is None:
            raise FileNotFoundError(errno.ENOENT, "its old text is gone", self.path)
        else:
            os.replace(kept, self.path)
            self._remove_backup()

    def can_be_taken_back(self) -> bool:
        """Tell whether `take_back` would do it."""
        if os.path.lexists(self.new):
            return True
        present = digest_of(self.path)
        if present == self.entry.before:
            return True
        return present == self.entry.after and (self.entry.before is None or any(self._kept()))

    def _kept(self) -> Iterator[str]:
        """Yield where the old text is kept."""
        names = (self.old, self.entry.backup and os.path.join(self.folder, self.entry.backup))
        for path in names:
            if path and self.entry.before is not None and digest_of(path) == self.entry.before:
                yield path

    def keep_backup(self) -> str | None:
        """Give the old text the name that it stays under; return its path, None where it goes."""
        if self.entry.backup is None or not os.path.lexists(self.old):
            name = self.entry.backup
            return name and os.path.join(self.folder, name)
        for backup in backup_names(self.path, os.path.join(self.folder, self.entry.backup)):
            if is_same_file(self.old, backup):
                return backup
            try:
                link_or_move(self.old, backup)
                return backup
            except FileExistsError:  # somebody made one of this name meanwhile
                continue
        return None

    def _remove_backup(self) -> None:
        if self.entry.backup is not None:
            backup = os.path.join(self.folder, self.entry.backup)
            if is_same_file(backup, self.path):
                os.unlink(backup)


def backup_names(path: str, first: str | None = None) -> Iterator[str]:
    """Yield the names that a backup may have: `first`, then NAME.bak, NAME.bak1 and so on."""
    if first is not None:
        yield first
    for number in count():
        yield f"{path}.bak{number or ''}"


def free_backup(path: str) -> str:
    """Return the name for a backup of a file."""
    return next(name for name in backup_names(path) if not os.path.lexists(name))
