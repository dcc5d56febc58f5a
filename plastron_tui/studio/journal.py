"""What was typed and not saved, kept beside the program's life: a crash loses a second of it."""

from __future__ import annotations

import json
import os
from contextlib import suppress
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from time import time

_FORMAT = 1
_LATEST = 4e9
"""A time that every calendar has, in seconds since the epoch; a broken journal may name others."""


@dataclass(frozen=True, slots=True)
class Kept:
    """A text that was not saved.

    Attributes:
        file: the journal.
        path: the program's file, None for a program that had none.
        text: what was typed.
        cursor: where the cursor was, in bytes.
        when: when it was kept, in seconds since the epoch.
    """

    file: Path
    path: Path | None
    text: bytes
    cursor: int
    when: float

    def drop(self) -> None:
        """Forget it."""
        with suppress(OSError):
            self.file.unlink()


class Journal:
    """The journal of one program that is open."""

    def __init__(self, folder: Path, path: Path | None) -> None:
        """Choose the file; nothing is written yet.

        Args:
            folder: where journals are.
            path: the program's file.
        """
        self.path = path
        self._drops = 0
        name = "new" if path is None else _name(path)
        # With the process in its name no studio writes over what another one kept.
        self.file = folder / f"{name}-{os.getpid()}.journal"

    def write(self, text: bytes, cursor: int) -> OSError | None:
        """Keep a text in place of the one that was kept; return why that failed.

        What is dropped while it is written, by another thread, stays dropped.
        """
        drops = self._drops
        head = {
            "plastron-journal": _FORMAT,
            "path": None if self.path is None else os.fspath(self.path.absolute()),
            "cursor": cursor,
            "pid": os.getpid(),
            "when": time(),
        }
        temporary = self.file.with_name(f"{self.file.name}.{os.getpid()}.tmp")
        try:
            self.file.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            descriptor = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
            with os.fdopen(descriptor, "wb") as stream:
                stream.write(json.dumps(head).encode() + b"\n" + text)
            temporary.replace(self.file)
            if self._drops != drops:
                self.file.unlink()
        except OSError as error:
            with suppress(OSError):
                temporary.unlink()
            return error
        return None

    def drop(self) -> None:
        """Forget what was kept: it is saved, or not wanted."""
        self._drops += 1
        with suppress(OSError):
            self.file.unlink()


def _name(path: Path) -> str:
    whole = os.fsencode(path.absolute())
    return f"{path.stem[:40]}-{sha256(whole).hexdigest()[:16]}"


def kept_texts(folder: Path) -> list[Kept]:
    """Return what programs that are no longer open did not save, the newest first."""
    found = []
    with suppress(OSError):
        for file in folder.glob("*.journal"):
            kept = _read(file)
            if kept is not None:
                found.append(kept)
    return sorted(found, key=lambda kept: kept.when, reverse=True)


def _read(file: Path) -> Kept | None:
    try:
        head, _, text = file.read_bytes().partition(b"\n")
        data = json.loads(head)
        if data["plastron-journal"] != _FORMAT or _is_open(int(data["pid"])):
            return None
        path = None if data["path"] is None else Path(data["path"])
        when = min(max(float(data["when"]), 0.0), _LATEST)
        return Kept(file, path, text, int(data["cursor"]), when)
    except (OSError, ValueError, TypeError, KeyError):
        return None


def _is_open(pid: int) -> bool:
    """Tell whether the studio that wrote a journal still runs."""
    if pid == os.getpid():
        return False
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):
        return True
    with suppress(OSError):
        # Another program may have got the number meanwhile.
        words = Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
        return any(b"plastron" in word.rpartition(b"/")[2] for word in words)
    return True
