"""What was read of files before: in the user's cache, by what they hold.

One file a workspace, written as a whole in the place of the old one: of two runs at once the last
one's stays, and either is right. What is damaged, or was left by another Plastron, is not there.
It is the user's own file, and of what it may hold only data of Plastron's own classes is made.
"""

from __future__ import annotations

import io
import os
import pickle
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from copy import copy
from pathlib import Path
from typing import Any, NamedTuple

import plastron_tui
from plastron_tui.collector import paused
from plastron_tui.private_files import read_private, sweep, write_private
from plastron_tui.user_folders import cache_folder

from .fingerprints import (
    Digest,
    Fingerprints,
    Reads,
    Seen,
    Status,
    digest,
    digest_of_names,
    unnoted,
)

_LARGEST = 256 * 1024 * 1024
_MOST_FILES = 64
_MOST_BYTES = 512 * 1024 * 1024
"""What is left of old workspaces in all."""

_STAYS = 24 * 3600
"""After how many seconds a file that is used without a change is marked as used."""

_OWN = "plastron_tui."
_PLAIN = {
    ("builtins", "frozenset"), ("builtins", "set"), ("builtins", "slice"),
    ("collections", "OrderedDict"), ("pathlib", "PosixPath"), ("pathlib", "PurePosixPath"),
    ("types", "MappingProxyType"),
}  # fmt: skip
# What unpickling raises, by its documentation, for bytes that are no pickle of data.
_NO_DATA = (
    pickle.UnpicklingError, AttributeError, EOFError, ImportError, IndexError, KeyError,
    MemoryError, TypeError, ValueError,
)  # fmt: skip


class Entry(NamedTuple):
    """What was read, and what of.

    Attributes:
        needs: the files that it was read from, each with what it held, None where there was none.
        data: what was read, as bytes.
    """

    needs: tuple[tuple[str, Digest | None], ...]
    data: bytes


def packed(value: object) -> bytes:
    """Return data as bytes."""
    return pickle.dumps(value, pickle.HIGHEST_PROTOCOL)


def unpacked(data: bytes) -> Any:
    """Return the data that bytes stand for.

    Raises:
        pickle.UnpicklingError: they stand for something else.
    """
    return _Unpickler(io.BytesIO(data)).load()


class _Unpickler(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        """Refuse what is no data class of Plastron's."""
        if module.startswith(_OWN) or (module, name) in _PLAIN:
            found = super().find_class(module, name)
            if isinstance(found, type):
                return found
        raise pickle.UnpicklingError(f"{module}.{name} is no data")


class FactCache:
    """The entries of a workspace, by words that say what was read and of which file.

    Attributes:
        files: what the files hold now.
    """

    def __init__(self, root: Path, folder: Path | None = None, paths: Sequence[Path] = ()) -> None:
        """Set which cache it is.

        Args:
            root: the folder of the workspace.
            folder: where the cache is, by default that of the user.
            paths: what is read of the workspace, where that is not all.
        """
        places = (os.fsencode(os.path.realpath(each)) for each in paths or (root,))
        name = digest(*places).hex()
        self._file = (cache_folder() if folder is None else folder) / "lint" / name
        self._stamp = _program_stamp()
        self._old: Mapping[str, Entry] = {}
        self._new: dict[str, Entry] = {}
        self._is_changed = False
        self.files = Fingerprints({})

    def beside(self, suffix: str) -> FactCache:
        """Return another cache of the same workspace."""
        other = copy(self)
        other._file = self._file.with_name(f"{self._file.name}.{suffix}")
        return other

    def needs(self) -> dict[str, Digest | None]:
        """Return what each file held that this run has used something of."""
        return {path: known for entry in self._new.values() for path, known in entry.needs}

    def begin(self) -> None:
        """Read what an earlier run has left, for a run; what cannot be read is not there."""
        self._old, self._new, self._is_changed = {}, {}, False
        seen: Mapping[str, Seen] = {}
        with suppress(OSError, *_NO_DATA), paused(), unnoted():
            entries, seen = _checked(read_private(self._file, _LARGEST), self._stamp)
            self._old = {key: Entry(*each) for key, each in entries.items()}
        self.files = Fingerprints(
            {path: (Status(*each[0]), each[1]) for path, each in seen.items()}
        )

    def get(self, key: str) -> Any:
        """Return what was read before, in a tuple; None where that was nothing, or other texts."""
        entry = self._old.get(key)
        if entry is None:
            return None
        digest_of = self.files.digest_of
        if any(digest_of(path) != known for path, known in entry.needs):
            return None
        with suppress(*_NO_DATA):
            found = (unpacked(entry.data),)
            self._new[key] = entry
            return found
        return None

    def put(self, key: str, reads: Reads, data: bytes) -> None:
        """Remember what was read."""
        self.files.take(reads)
        self._new[key] = Entry(tuple(reads.digests.items()), data)
        self._is_changed = True

    def save(self) -> None:
        """Leave what this run has used to the next; where it cannot be written, nothing is left."""
        # What was read to see that it is as it was is worth the writing where it was much.
        much = self.files.read_anew * 8 > len(self.files.seen)
        with suppress(OSError, ValueError):
            if self._is_changed or much or len(self._new) != len(self._old):
                data = packed(_without_repetitions(self._new, self.files.seen))
                write_private(self._file, digest(self._stamp, data) + data)
                _forget_old(self._file)
            else:
                self.touch()

    def touch(self) -> None:
        """Mark as used what is left as it is: what was not used for longest is forgotten first."""
        with suppress(OSError, ValueError):
            if time.time() - os.stat(self._file).st_mtime > _STAYS:
                os.utime(self._file)


_Plain = tuple[dict[str, tuple[Any, ...]], dict[str, tuple[Any, ...]]]


def _without_repetitions(entries: Mapping[str, Entry], seen: Mapping[str, Seen]) -> _Plain:
    """Return entries, and what was seen of their files, with each path and digest once."""
    once: dict[Any, Any] = {}
    needed: set[str] = set()
    plain = {}
    for key, entry in entries.items():
        needed.update(path for path, _ in entry.needs)
        needs = tuple(
            (once.setdefault(path, path), once.setdefault(known, known))
            for path, known in entry.needs
        )
        plain[key] = (needs, entry.data)
    files = {
        once.setdefault(path, path): (tuple(status), once.setdefault(known, known))
        for path, (status, known) in seen.items()
        if path in needed
    }
    return plain, files


def _checked(data: bytes, stamp: bytes) -> _Plain:
    """Return what a file of this Plastron holds: bytes, texts, numbers, tuples, dictionaries.

    Raises:
        ValueError: it is damaged, or was left by another Plastron.
        pickle.UnpicklingError: it holds something else.
    """
    length = len(digest())
    found = memoryview(data)[length:]
    if digest(stamp, found) != data[:length]:
        raise ValueError("it is damaged")
    entries, seen = _PlainUnpickler(io.BytesIO(found)).load()
    return entries, seen


class _PlainUnpickler(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        """Refuse every class."""
        raise pickle.UnpicklingError(f"{module}.{name} is no plain data")


def _forget_old(kept: Path) -> None:
    """Remove what killed writers have left, and the workspaces that were not used for longest."""
    sweep(kept.parent)
    with suppress(OSError):
        with os.scandir(kept.parent) as entries:
            found = [
                (each.stat().st_mtime, each.stat().st_size, each.path)
                for each in entries
                if each.is_file(follow_symlinks=False) and not each.name.startswith(".")
            ]
        left = _MOST_BYTES
        for at, (_, size, path) in enumerate(sorted(found, reverse=True)):
            left -= size
            if (at >= _MOST_FILES or left < 0) and path != os.fspath(kept):
                os.unlink(path)


def _program_stamp() -> bytes:
    """Return what tells this Plastron from any other, an edited one included.

    All files of the package count: what is read of a source rests on catalogs, too.
    """
    package = os.path.dirname(plastron_tui.__file__)
    told = [plastron_tui.__version__]
    for place, folders, files in os.walk(package):
        if "__pycache__" in folders:
            folders.remove("__pycache__")
        within = place[len(package) :]
        for file in files:
            with suppress(OSError):
                status = os.stat(f"{place}/{file}")
                told.append(f"{within}/{file} {status.st_size} {status.st_mtime_ns}")
    return digest_of_names(told)
