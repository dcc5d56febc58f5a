"""Single steps of safe writing: a new file, a second name, an owner and a mode, a sync."""

from __future__ import annotations

import errno
import os
import stat
import sys
from contextlib import suppress
from hashlib import sha256

LARGEST = 256 * 1024 * 1024
"""The largest file that is ever compared, in bytes; programs and nodes have a few kilobytes."""

UNKNOWN = "unknown"
"""The digest of what is no regular file, or too large; it equals no real digest."""

# File systems that have no hard links, or a user who may not make one, answer with these.
_NO_LINKS = {errno.EPERM, errno.EACCES, errno.EOPNOTSUPP, errno.ENOSYS, errno.EMLINK, errno.EXDEV}

_CHUNK = 1024 * 1024


def digest_of(path: str) -> str | None:
    """Return the digest of a file's text, None where there is no file; links are not followed.

    Raises:
        OSError: the operating system refuses.
    """
    flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC
    try:
        descriptor = os.open(path, flags)
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError as error:
        if error.errno in {errno.ELOOP, errno.ENXIO}:  # a symbolic link, a socket
            return UNKNOWN
        raise
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode) or status.st_size > LARGEST:
            return UNKNOWN
        found = sha256()
        while chunk := os.read(descriptor, _CHUNK):
            found.update(chunk)
    finally:
        os.close(descriptor)
    return f"sha256:{found.hexdigest()}"


def identity(status: os.stat_result) -> tuple[int, int, int, int]:
    """Return what tells a file from another, and from itself after a change."""
    return status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns


def is_unchanged(path: str, status: os.stat_result | None) -> bool:
    """Tell whether a file is still the one that `status` was taken of (None: no file)."""
    try:
        now = os.lstat(path)
    except FileNotFoundError:
        return status is None
    return status is not None and identity(now) == identity(status)


def is_same_file(path: str, other: str) -> bool:
    """Tell whether two names are links to one file."""
    try:
        return os.path.samestat(os.lstat(path), os.lstat(other))
    except FileNotFoundError:
        return False


def write_new(path: str, text: bytes, mode: int) -> int:
    """Write a file that takes the place of none, and return its open descriptor.

    What fails leaves no file, if that can be helped. The process's umask has its say: what it masks
    is no business of ours.
    """
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC
    descriptor = os.open(path, flags, mode)
    try:
        rest = memoryview(text)
        while rest:
            rest = rest[os.write(descriptor, rest) :]
    except BaseException:
        os.close(descriptor)
        with suppress(OSError):
            os.unlink(path)
        raise
    return descriptor


def take_after(
    descriptor: int, path: str, status: os.stat_result, *, is_executable: bool
) -> list[str]:
    """Give a file another's owner, group, mode and extended attributes.

    Args:
        descriptor: the file.
        path: the other file.
        status: the other's status.
        is_executable: whether it gets the executable bit where the other has none.

    Returns:
        What could not be kept: "owner", "group", and "extended attribute" with its name.
    """
    lost = _give(descriptor, status)
    mode = stat.S_IMODE(status.st_mode)
    if lost:
        # What runs in the name of its owner or group would run in another's.
        mode &= ~(stat.S_ISUID | stat.S_ISGID)
    lost += [f"extended attribute {name!a}" for name in _copy_attributes(descriptor, path)]
    if is_executable and not mode & stat.S_IXUSR:
        mode |= (mode & 0o444) >> 2  # whoever may read it may run it
    # After the attributes: an access control list among them is one with the mode.
    os.fchmod(descriptor, mode)
    return lost


def _give(descriptor: int, status: os.stat_result) -> list[str]:
    """Give a file another's owner and group; return which of them it could not be given."""
    try:
        os.fchown(descriptor, status.st_uid, status.st_gid)
    except OSError:  # only the superuser can write in another's name
        with suppress(OSError):
            os.fchown(descriptor, -1, status.st_gid)
    now = os.fstat(descriptor)
    found = {"owner": now.st_uid == status.st_uid, "group": now.st_gid == status.st_gid}
    return [name for name, is_kept in found.items() if not is_kept]


def _copy_attributes(descriptor: int, path: str) -> list[str]:
    if sys.platform != "linux":
        return []
    try:
        names = os.listxattr(path, follow_symlinks=False)
    except OSError:  # a file system without them, or a file that was taken away meanwhile
        return []
    lost = []
    for name in names:
        value = None
        try:
            value = os.getxattr(path, name, follow_symlinks=False)
            os.setxattr(descriptor, name, value)
        except OSError:
            # The kernel may have set it itself, as it does with labels of security.
            try:
                is_kept = value is not None and os.getxattr(descriptor, name) == value
            except OSError:
                is_kept = False
            if not is_kept:
                lost.append(name)
    return lost


def link_or_copy(path: str, other: str, text: bytes, status: os.stat_result) -> None:
    """Give a file's text a second name, which must be free; where links cannot be, as a copy."""
    try:
        os.link(path, other)
        return
    except OSError as error:
        if error.errno not in _NO_LINKS:
            raise
    copy_to(other, path, text, status)


def copy_to(other: str, path: str, text: bytes, status: os.stat_result) -> None:
    """Write a file's earlier text under another name, which must be free, as a whole.

    Args:
        other: the new name.
        path: the file, whose extended attributes the copy gets.
        text: the text.
        status: the file's status when it held that text.
    """
    copy = os.path.splitext(other)[0] + ".tmp"
    if os.path.lexists(other):
        raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), other)
    descriptor = write_new(copy, text, 0o600)
    try:
        try:
            take_after(descriptor, path, status, is_executable=False)
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
        os.rename(copy, other)
    except BaseException:
        with suppress(OSError):
            os.unlink(copy)
        raise


def link_or_move(path: str, other: str) -> None:
    """Give a file a second name, or where links cannot be another.

    Raises:
        FileExistsError: there is such a file.
    """
    try:
        os.link(path, other)
        return
    except OSError as error:
        if error.errno not in _NO_LINKS:
            raise
    if os.path.lexists(other):
        raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), other)
    os.rename(path, other)


def remove(path: str) -> None:
    """Remove a file, if it is there."""
    if os.path.lexists(path):  # a read-only file system refuses even what is not there
        os.unlink(path)


def sync_folder(folder: str | int) -> None:
    """Let no crash undo what was made, renamed or removed in a folder."""
    if isinstance(folder, str):
        descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
        try:
            sync_folder(descriptor)
        finally:
            os.close(descriptor)
        return
    try:
        os.fsync(folder)
    except OSError as error:
        if error.errno not in {errno.EINVAL, errno.EOPNOTSUPP}:  # it syncs files only
            raise
