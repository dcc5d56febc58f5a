"""What tells what files hold, without keeping it: by what an earlier run has read, where it may.

A file whose size, inode and times are as they were when it was read holds what it held then: the
system sets the time of the last change of status (`ctime`) itself, whatever a program says of the
others. Only a file that was changed shortly before it was read may have been changed again without
a trace, as clocks of file systems have ticks: it is read again.

Source: git, `Documentation/technical/racy-git.txt`.
"""

from __future__ import annotations

import errno
import hashlib
import os
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from typing import NamedTuple

from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.regular_files import observed, read_regular

Digest = bytes

SLACK = 2_000_000_000
"""The longest tick of the clock of a file system, that of FAT, in nanoseconds."""


class Status(NamedTuple):
    """What the system says of a file: it is another one when the file is changed."""

    size: int
    written: int
    changed: int
    inode: int

    @staticmethod
    def of(found: os.stat_result) -> Status:
        """Take it from what the system says."""
        return Status(found.st_size, found.st_mtime_ns, found.st_ctime_ns, found.st_ino)


Seen = tuple[Status, Digest]
"""What a file held when it had a status."""


class Reads(NamedTuple):
    """What was read of files.

    Attributes:
        digests: what each held, None where it could not be read.
        seen: what tells so another time, where that is sure.
    """

    digests: dict[str, Digest | None]
    seen: dict[str, Seen]


def digest(*texts: bytes | memoryview) -> Digest:
    """Return what tells texts from all others."""
    found = hashlib.blake2b(digest_size=16)
    for text in texts:
        found.update(len(text).to_bytes(8, "little"))
        found.update(text)
    return found.digest()


def digest_of_names(names: Iterable[str]) -> Digest:
    """Return what tells names from all others, in whatever order they come."""
    return digest(b"\0".join(sorted(map(os.fsencode, names))))


@contextmanager
def noted(reads: Reads, slack: int = SLACK) -> Iterator[None]:
    """Note what is read of files meanwhile (`read_regular`)."""

    def note(path: str, status: os.stat_result | None, text: bytes | None) -> None:
        if status is None or text is None:
            # It may be too large for who asked, and yet have been read.
            found = _unread_digest(path)
        else:
            found = digest(text)
            now = Status.of(status)
            if max(now.written, now.changed) + slack < time.time_ns():
                reads.seen[path] = now, found
        if reads.digests.setdefault(path, found) != found:
            # It was changed between two looks: what was made of it is of neither text.
            reads.digests[path] = b""
            reads.seen.pop(path, None)

    with observed(note):
        yield


@contextmanager
def unnoted() -> Iterator[None]:
    """Let nobody note what is read meanwhile."""

    def forget(path: str, status: os.stat_result | None, text: bytes | None) -> None:
        del path, status, text

    with observed(forget):
        yield


class Fingerprints:
    """What files hold now; each is looked at once, and read only where that is not known."""

    def __init__(self, known: Mapping[str, Seen]) -> None:
        """Begin with what earlier runs have seen."""
        self._known = known
        self._digests: dict[str, Digest | None] = {}
        self.seen: dict[str, Seen] = {}
        self.read_anew = 0

    def digest_of(self, path: str) -> Digest | None:
        """Return what tells what a file holds, None where it cannot be read."""
        if path not in self._digests:
            self._digests[path] = self._find(path)
        return self._digests[path]

    def take(self, reads: Reads) -> None:
        """Take over what somebody has read."""
        self.seen.update(reads.seen)
        self.read_anew += len(reads.seen)

    def _find(self, path: str) -> Digest | None:
        known = self._known.get(path)
        if known is not None:
            try:
                if Status.of(os.stat(path)) == known[0]:
                    self.seen[path] = known
                    return known[1]
            except (OSError, ValueError):
                return None
        reads = Reads({}, {})
        with noted(reads):
            try:
                read_regular(path, LARGEST_FILE)
            except (OSError, ValueError):
                return reads.digests[path]
        self.take(reads)
        return reads.digests[path]


def _unread_digest(path: str) -> Digest | None:
    """Return what tells what a file holds that somebody could not read, None for nothing."""
    try:
        with unnoted():
            return digest(read_regular(path, LARGEST_FILE))
    except OSError as error:
        if error.errno != errno.EFBIG:
            return None
    except ValueError:
        return None
    try:
        return digest(repr(Status.of(os.stat(path))).encode())
    except OSError:
        return None
