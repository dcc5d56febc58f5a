"""Where the files of an output folder are on the disk, and what is in their way."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path, PurePosixPath

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.regular_files import reason

from .manifest import NAME as MANIFEST_NAME
from .own_files import PREFIX


class RefusedError(Exception):
    """A file that cannot be planned; what makes plans catches it."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(diagnostic.message)
        self.diagnostic = diagnostic


def real_folder_of(folder: Path, within: Path | None) -> str:
    """Return an output folder with links resolved; see `make_plan`.

    Raises:
        RefusedError: it is no folder, or leads out of where it must lie.
    """
    try:
        real = os.path.realpath(os.fsencode(folder))
        root = None if within is None else os.path.realpath(os.fsencode(within))
    except (OSError, ValueError) as error:
        message = f"`{str(folder)!a}` cannot be the name of a folder"
        raise RefusedError(refusal(codes.CANNOT_WRITE, message, None)) from error
    if root is not None and not _is_inside(real, root):
        message = f"the output folder `{folder}` is a link that leads out of `{within}`"
        remedy = "name the folder with `-o` if that is what you want"
        raise RefusedError(refusal(codes.OUTSIDE_OUTPUT, message, folder, remedy))
    if os.path.lexists(real) and not os.path.isdir(real):
        message = f"the output folder `{folder}` is not a folder"
        raise RefusedError(refusal(codes.CANNOT_WRITE, message, folder))
    return os.fsdecode(real)


def target_of(
    shown: Path, real_folder: str, name: str, elsewhere: Path | None
) -> tuple[str, os.stat_result | None]:
    """Return the real path of the file that is written, and its status.

    Args:
        shown: its path, for people.
        real_folder: the output folder, links resolved.
        name: its name from there.
        elsewhere: where it is written instead; what is there has the name that it has.

    Raises:
        RefusedError: it cannot be written there.
    """
    is_there = elsewhere is not None and os.path.lexists(elsewhere)
    if not is_there and not _is_inner_name(name):
        message = f"{name!a} cannot be the name of a file in the output folder"
        raise RefusedError(refusal(codes.OUTSIDE_OUTPUT, message, None))
    try:
        if elsewhere is not None:
            path = os.path.realpath(elsewhere)
            status = _status(path)
        else:
            _check_folders(shown, real_folder, name)
            path = os.path.join(real_folder, name)
            # A folder on the way may be a link.
            path = os.path.join(os.path.realpath(os.path.dirname(path)), os.path.basename(path))
            status = _status(path)
            if status is not None and stat.S_ISLNK(status.st_mode):
                path = os.path.realpath(path)
                status = _status(path)
    except (OSError, ValueError) as error:
        raise RefusedError(cannot_write(shown, error)) from error
    if elsewhere is None and not _is_inside(os.fsencode(path), os.fsencode(real_folder)):
        raise RefusedError(_leads_out(name, shown))
    if status is not None and not stat.S_ISREG(status.st_mode):
        what = "a folder" if stat.S_ISDIR(status.st_mode) else "not a plain file"
        message = f"cannot write `{name}`: it is {what}"
        raise RefusedError(refusal(codes.CANNOT_WRITE, message, shown))
    return path, status


def _check_folders(shown: Path, real_folder: str, name: str) -> None:
    """Refuse what is in the way of a folder between the output folder and a file."""
    folders = PurePosixPath(name).parents[:-1]
    root = shown.parents[len(folders)]
    for inner in reversed(folders):
        path, folder = os.path.join(real_folder, inner), root / inner
        try:
            is_folder = stat.S_ISDIR(os.stat(path).st_mode)
        except FileNotFoundError:
            is_folder = True  # it will be made, behind a link too
        except PermissionError as error:
            raise RefusedError(cannot_write(folder.parent, error)) from error
        except OSError:
            is_folder = False
        if not is_folder:
            message = f"`{inner}` is in the way: a folder of this name is to be written"
            raise RefusedError(refusal(codes.CANNOT_WRITE, message, folder, "remove it"))
        if not _is_inside(os.fsencode(os.path.realpath(path)), os.fsencode(real_folder)):
            raise RefusedError(_leads_out(f"{inner}", folder))


def _leads_out(name: str, shown: Path) -> Diagnostic:
    message = f"`{name}` is a symbolic link that leads out of the output folder"
    remedy = "remove the link, or choose another folder with `-o`"
    return refusal(codes.OUTSIDE_OUTPUT, message, shown, remedy)


def _is_inner_name(name: str) -> bool:
    """Tell whether a name means a file of the folder or of one in it, and none of Plastron's own.

    Between folders stands `/`.
    """
    return all(map(_is_plain_name, name.split("/")))


def _is_plain_name(name: str) -> bool:
    if not name or name in {".", "..", MANIFEST_NAME} or name.startswith(PREFIX):
        return False
    try:
        os.fsencode(name)
    except UnicodeEncodeError:
        return False
    return name.isprintable() and "\\" not in name


def _is_inside(path: bytes, folder: bytes) -> bool:
    return path == folder or path.startswith(folder.rstrip(b"/") + b"/")


def _status(path: str) -> os.stat_result | None:
    try:
        return os.lstat(path)
    except FileNotFoundError:
        return None


def cannot_write(file: Path, error: Exception) -> Diagnostic:
    """Return the diagnostic for what the operating system said about a file."""
    if isinstance(error, (FileExistsError, IsADirectoryError)) and error.filename is not None:
        # No target that exists is an error: it is a name that the writer needs for itself.
        name = error.filename if error.filename2 is None else error.filename2
        file = Path(os.fsdecode(name))
        return refusal(codes.CANNOT_WRITE, f"`{file.name}` is in the way", file, "remove it")
    remedy = None
    number = getattr(error, "errno", None)
    if number in {errno.ENOSPC, errno.EDQUOT}:
        remedy = "free some space and run it again"
    elif number in {errno.EACCES, errno.EPERM, errno.EROFS}:
        remedy = "choose a folder that you may write to with `-o`"
    message = f"cannot write `{file.name}`: {reason(error)}"
    return refusal(codes.CANNOT_WRITE, message, file, remedy)


def refusal(code: Code, message: str, file: Path | None, remedy: str | None = None) -> Diagnostic:
    """Return why a file is not written."""
    return Diagnostic(code, message, file=file, help=remedy)
