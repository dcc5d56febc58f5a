"""The folders that the user trusts, as the user's state remembers them.

Each has a file of its own, whose name is the digest of the folder's real path and whose text is
that path: nothing has to be merged or locked, and a broken file takes no other with it. What
others could have written counts for nothing.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Iterator
from hashlib import sha256
from pathlib import Path

from plastron_tui.regular_files import reason

from .private_files import read_private, sweep, write_private
from .user_folders import state_folder

_LONGEST_PATH = 64 * 1024
_OTHERS = stat.S_IWGRP | stat.S_IWOTH


class TrustStoreError(Exception):
    """The store cannot be read or written, or not be relied on; the message says why."""


class UnsafeStoreError(TrustStoreError):
    """The store is not the user's alone."""


class TrustStore:
    """The folders that the user trusts; each question looks at the disk."""

    def __init__(self, folder: Path | None = None) -> None:
        """Set where they are remembered; without a folder, in the user's state."""
        self.folder = folder or state_folder() / "trusted"

    def __contains__(self, folder: object) -> bool:
        """Tell whether exactly this folder is trusted; in doubt it is not."""
        if not isinstance(folder, Path):
            return False
        path = real_path(folder)
        return self.problem() is None and _text_of(self._file(path)) == os.fsencode(path)

    def problem(self) -> str | None:
        """Tell why nothing is trusted, None where the store can be relied on or is not there."""
        try:
            return _fault(self.folder, os.lstat(self.folder), stat.S_ISDIR)
        except FileNotFoundError:
            return None
        except OSError as error:
            return _reason(self.folder, error)

    def folders(self) -> list[Path]:
        """Return the folders that are trusted.

        Raises:
            TrustStoreError: the store cannot be relied on.
        """
        self._check()
        return sorted(Path(os.fsdecode(path)) for path, _ in self._entries() if path is not None)

    def broken(self) -> list[Path]:
        """Return the files of the store that count for nothing.

        Raises:
            TrustStoreError: the store cannot be relied on.
        """
        self._check()
        return sorted(file for path, file in self._entries() if path is None)

    def add(self, folder: Path) -> None:
        """Trust a folder.

        Raises:
            TrustStoreError: the store cannot be relied on, or cannot be written.
        """
        self._check()
        path = real_path(folder)
        try:
            write_private(self._file(path), os.fsencode(path))
        except OSError as error:
            raise TrustStoreError(_reason(self.folder, error)) from error
        sweep(self.folder)

    def remove(self, folder: Path) -> bool:
        """Trust a folder no longer; tell whether it was remembered.

        Raises:
            TrustStoreError: the store cannot be relied on, or cannot be written.
        """
        self._check()
        file = self._file(real_path(folder))
        try:
            file.unlink()
        except FileNotFoundError:
            return False
        except OSError as error:
            raise TrustStoreError(_reason(file, error)) from error
        return True

    def _check(self) -> None:
        problem = self.problem()
        if problem is not None:
            raise UnsafeStoreError(problem)

    def _file(self, path: Path) -> Path:
        return self.folder / sha256(os.fsencode(path)).hexdigest()

    def _entries(self) -> Iterator[tuple[bytes | None, Path]]:
        """Yield each file of the store with the path that it holds, None where that is broken."""
        try:
            files = [file for file in self.folder.iterdir() if not file.name.startswith(".")]
        except FileNotFoundError:
            return
        except OSError as error:
            raise TrustStoreError(_reason(self.folder, error)) from error
        for file in files:
            text = _text_of(file)
            is_right = text is not None and sha256(text).hexdigest() == file.name
            yield text if is_right else None, file


def real_path(folder: Path) -> Path:
    """Return the absolute path of a folder, without symbolic links."""
    return Path(os.path.realpath(folder))


def _text_of(file: Path) -> bytes | None:
    """Return what a file of the store holds, None where others may have written it."""
    try:
        if _fault(file, os.lstat(file), stat.S_ISREG) is not None:
            return None
        return read_private(file, _LONGEST_PATH)
    except (OSError, ValueError):
        return None


def _fault(path: Path, status: os.stat_result, is_kind: Callable[[int], bool]) -> str | None:
    """Tell why something of the store cannot be relied on."""
    if not is_kind(status.st_mode):
        return f"`{path}` is not what plastron has made there"
    if status.st_uid != os.geteuid():
        return f"`{path}` belongs to another user"
    if status.st_mode & _OTHERS:
        return f"others may write to `{path}`"
    return None


def _reason(path: Path, error: OSError) -> str:
    return f"`{path}`: {reason(error)}"
