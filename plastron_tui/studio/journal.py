"""What was typed and not saved, kept beside the program's life: a crash loses a second of it."""

from __future__ import annotations

import errno
import json
import os
import threading
from contextlib import suppress
from itertools import count
from pathlib import Path
from time import time
from typing import Any, NamedTuple
from zlib import crc32

from plastron_tui.private_files import is_running, process_mark, read_private, sweep, write_private
from plastron_tui.project.program_file import LARGEST_PROGRAM
from plastron_tui.regular_files import is_same_file

_FORMAT = 1
_NEW = count(1)
"""Tells the programs without a file apart that one studio has open."""
_LATEST = 4e9
"""A time that every calendar has, in seconds since the epoch; a broken journal may name others."""
_LARGEST = 2 * LARGEST_PROGRAM
"""The largest journal, in bytes: while one types, a program may be larger than one that is read."""
_PATIENCE = 2.0
"""Seconds to wait for a disk that is still busy with the text before."""


class Kept(NamedTuple):
    """A text that was not saved.

    Attributes:
        file: the journal.
        path: the program's file, None for a program that had none.
        folder: where a program without a file was begun; None where that is not known.
        text: what was typed.
        cursor: where the cursor was, in bytes.
        when: when it was kept, in seconds since the epoch.
    """

    file: Path
    path: Path | None
    folder: Path | None
    text: bytes
    cursor: int
    when: float

    def belongs_to(self, path: Path | None, folder: Path) -> bool:
        """Tell whether it is the text of a program: of a file, or without one of a folder."""
        if path is None or self.path is None:
            return path is self.path and is_same_file(folder, self.folder)
        return is_same_file(self.path, path)

    def drop(self) -> None:
        """Forget it."""
        with suppress(OSError):
            self.file.unlink()


class Journal:
    """The journal of one program that is open."""

    def __init__(self, journals: Path, path: Path | None, folder: Path | None = None) -> None:
        """Choose the file; nothing is written yet.

        Args:
            journals: where journals are.
            path: the program's file.
            folder: the program's folder, where it has no file.
        """
        self.path = path
        self.folder = folder
        self._turns = 0
        self._latest = 0
        self._writing = threading.Lock()
        self._counting = threading.Lock()
        name = f"new-{next(_NEW)}" if path is None else _name(path)
        # With the process in its name no studio writes over what another one kept.
        self.file = journals / f"{name}-{process_mark()}.journal"

    def turn(self) -> int:
        """Return the number of a text among those to be kept; the last one is kept."""
        with self._counting:
            self._turns += 1
            return self._turns

    def write(self, text: bytes, cursor: int, turn: int | None = None) -> OSError | None:
        """Keep a text in place of the one that was kept, from any thread; return why that failed.

        Args:
            text: the program.
            cursor: where the cursor is, in bytes.
            turn: the text's number, where it was taken before; what was dropped, or written, in a
                later turn stays so.
        """
        turn = turn or self.turn()
        if not self._writing.acquire(timeout=_PATIENCE):
            return OSError(errno.ETIMEDOUT, "the disk does not answer")
        try:
            if turn > self._latest:
                self._write(self._head(cursor) + text)
                self._written(turn)
        except OSError as error:
            return error
        finally:
            self._writing.release()
        return None

    def _head(self, cursor: int) -> bytes:
        head = {
            "plastron-journal": _FORMAT,
            "path": _text_of(self.path),
            "folder": _text_of(self.folder),
            "cursor": cursor,
            "pid": os.getpid(),
            "when": time(),
        }
        return json.dumps(head).encode() + b"\n"

    def _write(self, data: bytes) -> None:
        if len(data) > _LARGEST:
            raise OSError(errno.EFBIG, f"it is larger than {_LARGEST // 1024**2} MB")
        write_private(self.file, data)

    def _written(self, turn: int) -> None:
        with self._counting:
            was_dropped = turn < self._latest
            self._latest = max(turn, self._latest)
        if was_dropped:
            self.file.unlink(missing_ok=True)

    def drop(self) -> None:
        """Forget what was kept: it is saved, or not wanted."""
        turn = self.turn()
        with self._counting:
            self._latest = turn
        with suppress(OSError):
            self.file.unlink()


def _text_of(path: Path | None) -> str | None:
    return None if path is None else os.fspath(path.absolute())


def _name(path: Path) -> str:
    # What a journal is of stands in it: its name tells it from those of this studio's other ones.
    return f"{path.stem[:40]}-{crc32(os.fsencode(path.absolute())):08x}"


def kept_texts(journals: Path) -> list[Kept]:
    """Return what programs that are no longer open did not save, the newest first."""
    sweep(journals)
    found = []
    with suppress(OSError):
        for file in journals.glob("*.journal"):
            kept = _read(file)
            if kept is not None:
                found.append(kept)
    return sorted(found, key=lambda kept: kept.when, reverse=True)


def _read(file: Path) -> Kept | None:
    try:
        head, _, text = read_private(file, _LARGEST).partition(b"\n")
        data = json.loads(head)
        if data["plastron-journal"] != _FORMAT or is_running(int(data["pid"])):
            return None
        when = min(max(0.0, float(data["when"])), _LATEST)
        # Earlier versions did not say the folder.
        path, folder = _path_of(data["path"]), _path_of(data.get("folder"))
        return Kept(file, path, folder, text, int(data["cursor"]), when)
    except (OSError, ValueError, ArithmeticError, TypeError, KeyError, RecursionError):
        return None


def _path_of(value: Any) -> Path | None:
    if value is None:
        return None
    if "\0" in value:
        raise ValueError("no path has a NUL character")
    return Path(value)
