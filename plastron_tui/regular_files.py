"""Reading files of other people's folders: regular files only, and never without end.

A folder may hold a FIFO that nobody writes to, or a link to a device that goes on for ever, under
any name that Plastron looks for.
"""

from __future__ import annotations

import errno
import os
import re
import stat
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from pathlib import Path
from typing import TypeAlias

# Open descriptors, which nobody can put into a folder.
_HANDED_OVER = re.compile(r"/dev/stdin|(?:/dev|/proc/self)/fd/[0-9]+")
_FLAGS = os.O_RDONLY | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC

Observer: TypeAlias = Callable[[str, "os.stat_result | None", "bytes | None"], None]
"""Gets a path, the status of the file as it was opened, and what it held; None where it failed."""

_OBSERVER: ContextVar[Observer | None] = ContextVar("observer", default=None)


def observer() -> Observer | None:
    """Return who is to know of what is read, None for nobody."""
    return _OBSERVER.get()


@contextmanager
def observed(tell: Observer) -> Iterator[None]:
    """Let an observer know of each file that `read_regular` is asked for meanwhile.

    So what was made of files can be kept together with all that it hangs on.
    """
    token = _OBSERVER.set(tell)
    try:
        yield
    finally:
        _OBSERVER.reset(token)


def read_regular(path: Path | str, limit: int, *, is_own: bool = False) -> bytes:
    """Return what a regular file holds; symbolic links are followed.

    Args:
        path: the file.
        limit: the most bytes that it may have.
        is_own: whether it has to be the user's own, and no link (`ELOOP`).

    Raises:
        OSError: it cannot be read, is no regular file (`EINVAL`), is larger (`EFBIG`), or belongs
            to another user where it must not (`EPERM`).
        ValueError: the path has a NUL character.
    """
    tell = _OBSERVER.get()
    try:
        status, text = _read(path, limit, is_own=is_own)
    except (OSError, ValueError):
        if tell is not None:
            tell(os.fspath(path), None, None)
        raise
    if tell is not None:
        tell(os.fspath(path), status, text)
    return text


def _read(path: Path | str, limit: int, *, is_own: bool) -> tuple[os.stat_result, bytes]:
    # Without waiting: opening a FIFO would wait for one that writes.
    descriptor = os.open(path, _FLAGS | (os.O_NOFOLLOW if is_own else 0))
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            code = errno.EISDIR if stat.S_ISDIR(status.st_mode) else errno.EINVAL
            reason = "is a directory" if code == errno.EISDIR else "it is not a regular file"
            raise OSError(code, reason, os.fspath(path))
        if is_own and status.st_uid != os.geteuid():
            raise PermissionError(errno.EPERM, "belongs to another user", os.fspath(path))
        if status.st_size <= limit:
            # `open` takes no folder, and then leaves the descriptor open.
            with open(descriptor, "rb", closefd=False) as stream:
                # A file of /proc says 0, and one that grows says too little.
                text = stream.read(limit + 1)
            if len(text) <= limit:
                return status, text
    finally:
        os.close(descriptor)
    raise _too_large(path, limit)


def read_named(path: Path, limit: int) -> bytes:
    """Return what a file holds that a user named; a shell may have put a pipe in its place.

    So it does for `<(command)`. The arguments and errors are those of `read_regular`.
    """
    if _HANDED_OVER.fullmatch(os.fspath(path)) is None:
        return read_regular(path, limit)
    with path.open("rb") as stream:
        text = stream.read(limit + 1)
    if len(text) <= limit:
        return text
    raise _too_large(path, limit)


def reason(error: Exception) -> str:
    """Return why a file cannot be read, as it stands behind a colon."""
    text = getattr(error, "strerror", None) or str(error) or "cannot be read"
    return f"{text[:1].lower()}{text[1:]}"


def _too_large(path: Path | str, limit: int) -> OSError:
    return OSError(errno.EFBIG, f"it is larger than {_shown(limit)}", os.fspath(path))


def _shown(size: int) -> str:
    return f"{size // 1024**2} MB" if size >= 1024**2 else f"{size // 1024} kB"


Stamp: TypeAlias = tuple[int, int, int]
"""When a file was changed, in nanoseconds, its size in bytes, and its inode."""


def stamp_of(path: Path) -> Stamp | None:
    """Return what tells a file from what it was before, without reading it; None for no file."""
    try:
        status = path.stat()
    except (OSError, ValueError):
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino


def is_same_file(path: Path, other: Path | None) -> bool:
    """Tell whether two paths lead to one file: relative or not, through links, or as hard links."""
    if other is None:
        return False
    if os.path.realpath(path) == os.path.realpath(other):
        return True
    with suppress(OSError, ValueError):
        return path.samefile(other)
    return False
