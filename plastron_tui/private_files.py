"""Files of the user's own state: closed to other users, written wholly or not at all.

All is done from the descriptor of the folder, which is looked at first: whoever renames folders or
makes links meanwhile does not move what is written.
"""

from __future__ import annotations

import errno
import os
import re
import stat
from contextlib import suppress
from pathlib import Path

from .regular_files import read_regular

_CREATE = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
_FOLDER = os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC
_TOKEN = os.urandom(4).hex()
_TEMPORARY = re.compile(r".+\.(\d+)(?:-([0-9a-f]{8}))?\.tmp", re.DOTALL)


def process_mark() -> str:
    """Return what names this process in a file's name; in a container its number alone may not."""
    return f"{os.getpid()}-{_TOKEN}"


def read_private(file: Path, limit: int) -> bytes:
    """Return what a file of the user's own holds.

    Args:
        file: the file.
        limit: the most bytes that it may have.

    Raises:
        OSError: it cannot be read, is a link or no regular file, belongs to another user, or is
            larger.
    """
    return read_regular(file, limit, is_own=True)


def write_private(file: Path, data: bytes) -> None:
    """Write a file that only the user can read, in the place of what has its name.

    Whenever the process or the machine stops, the file has the text from before or the new one;
    `sweep` removes what else may be left. Missing folders are made.

    Raises:
        OSError: it cannot be written, or the folder belongs to another user (`EPERM`).
    """
    folder = _open_folder(file.parent)
    temporary = f".{file.name}.{process_mark()}.tmp"
    try:
        try:
            _write_new(temporary, folder, data)
            os.replace(temporary, file.name, src_dir_fd=folder, dst_dir_fd=folder)
        except BaseException:
            with suppress(OSError):
                os.unlink(temporary, dir_fd=folder)
            raise
        _sync_folder(folder)
    finally:
        os.close(folder)


def sweep(folder: Path) -> None:
    """Remove what writers that were killed have left in a folder."""
    with suppress(OSError):
        for name in os.listdir(folder):
            found = _TEMPORARY.fullmatch(name)
            if found and not is_running(int(found[1]), found[2]):
                with suppress(OSError):
                    os.unlink(os.path.join(folder, name))


def is_running(process: int, token: str | None = None) -> bool:
    """Tell whether a Plastron of a process number runs; of this process only with its token."""
    if process == os.getpid():
        return token == _TOKEN
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):
        return True
    with suppress(OSError):
        # Another program may have got the number meanwhile.
        words = Path(f"/proc/{process}/cmdline").read_bytes().split(b"\0")
        return any(b"plastron" in word.rpartition(b"/")[2] for word in words)
    return True


def _open_folder(folder: Path) -> int:
    """Open a folder of the user's own, made where it is missing; others may do nothing in it."""
    _make_folder(folder)
    is_link = stat.S_ISLNK(_own(os.lstat(folder), folder).st_mode)
    descriptor = os.open(folder, _FOLDER | (0 if is_link else os.O_NOFOLLOW))
    try:
        mode = stat.S_IMODE(_own(os.fstat(descriptor), folder).st_mode)
        if mode & 0o077:
            os.fchmod(descriptor, mode & 0o700)
    except BaseException:
        os.close(descriptor)
        raise
    return descriptor


def _make_folder(folder: Path) -> None:
    missing = []
    while not os.path.lexists(folder):
        missing.append(folder)
        folder = folder.parent
    for path in reversed(missing):
        with suppress(FileExistsError):
            os.mkdir(path, 0o700)
        # Another Plastron may have been faster, or somebody who waited for it.
        _own(os.lstat(path), path)


def _own(status: os.stat_result, path: Path) -> os.stat_result:
    if status.st_uid != os.geteuid():
        raise PermissionError(errno.EPERM, "belongs to another user", os.fspath(path))
    return status


def _write_new(name: str, folder: int, data: bytes) -> None:
    try:
        descriptor = os.open(name, _CREATE, 0o600, dir_fd=folder)
    except FileExistsError:
        # What this process could not remove when it failed before.
        os.unlink(name, dir_fd=folder)
        descriptor = os.open(name, _CREATE, 0o600, dir_fd=folder)
    try:
        rest = memoryview(data)
        while rest:
            rest = rest[os.write(descriptor, rest) :]
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def _sync_folder(descriptor: int) -> None:
    try:
        os.fsync(descriptor)
    except OSError as error:
        if error.errno not in {errno.EINVAL, errno.EOPNOTSUPP}:  # it syncs files only
            raise
