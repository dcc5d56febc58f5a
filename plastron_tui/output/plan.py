"""What writing would do, file by file, before anything is written.

Making a plan reads the disk and changes nothing. `--dry-run` and `--diff` stop at the plan; the
writer carries it out.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.regular_files import read_regular

from .manifest import Base, Manifest
from .patch_stack import Layers
from .target_paths import RefusedError, cannot_write, real_folder_of, refusal, target_of

LARGEST_OUTPUT = 64 * 1024 * 1024
"""The largest file that is compared and replaced, in bytes: what a huge program generates."""


class FileState(str, Enum):
    """What writing would do to a file. The values are what a person reads."""

    CREATE = "create"
    IDENTICAL = "identical"
    CHANGED = "changed"
    CONFLICT = "conflict"


@dataclass(frozen=True, slots=True)
class OutputFile:
    """A file that is wanted.

    Attributes:
        name: the file's name from the output folder; between folders stands `/`.
        text: what it shall hold.
        is_executable: whether it gets the executable bit: where it is new, or starts with `#!`. One
            that has the bit keeps it.
        merged_from: the bytes that the text was derived from, where they are the file's own
            present bytes: such a text keeps what was written by hand, and replaces exactly these
            bytes. None for a text that was made anew.
        path: where to write instead of the output folder (`--in-place`); the caller vouches
            for it, and a symbolic link there is followed.
        has_handwork: whether the text keeps what was written by hand, in another file perhaps.
        base: what the program has, for the manifest to remember.
        problem: why the handwork that is there cannot be merged: the file is then in conflict.
        layers: what programs made of a loaded file, for the manifest of the file's folder to
            remember; empty to forget it, None to leave it.
        seen: the manifests that the text was made with, each with its folder: the writer checks
            that they still say the same of the file.
        entry: the name by which the output folder's manifest knows a file that lies elsewhere, as
            seen from there; None for a file that it only knows in the folder.
    """

    name: str
    text: bytes
    is_executable: bool = True
    merged_from: bytes | None = None
    path: Path | None = None
    has_handwork: bool = False
    base: Base | None = None
    problem: Diagnostic | None = None
    layers: Layers | None = None
    seen: tuple[tuple[Path, Manifest], ...] = ()
    entry: str | None = None


@dataclass(frozen=True, slots=True)
class PlannedFile:
    """A file, what is on the disk now, and what shall be.

    Attributes:
        name: the file's name, for people.
        path: the file that is written, symbolic links resolved.
        text: what it shall hold.
        state: what writing does.
        is_executable: whether it gets the executable bit.
        before: what it holds now; None when there is no such file.
        status: the file's status when `before` was read: the writer looks again.
        entry: the name under which the manifest remembers `text` once it is written; None for a
            text that holds handwork, and for a file elsewhere that it does not know.
        base: what the manifest remembers of the program once it is written.
        known: the name under which it remembers that, handwork or not; None for `name`.
        problem: why a conflict is one, as the diagnostic to give where it is not forced.
        layers: what the manifest in the file's own folder then remembers of loaded text.
        seen: the manifests that text and state were made with, each with its folder, links
            resolved.
    """

    name: str
    path: Path
    text: bytes
    state: FileState
    is_executable: bool = True
    before: bytes | None = None
    status: os.stat_result | None = None
    entry: str | None = None
    base: Base | None = None
    problem: Diagnostic | None = None
    layers: Layers | None = None
    seen: tuple[tuple[str, Manifest], ...] = ()
    known: str | None = None

    @property
    def mode_before(self) -> int | None:
        """The permission bits of the file now, None when there is no such file."""
        return None if self.status is None else stat.S_IMODE(self.status.st_mode)


@dataclass(frozen=True, slots=True)
class FilePlan:
    """All files of one `generate`, in the order in which they were asked for.

    Attributes:
        folder: the output folder, as it was named.
        files: the files.
        real_folder: the folder that the name led to when the plan was made and judged; None where
            there was no such plan.
    """

    folder: Path
    files: tuple[PlannedFile, ...]
    real_folder: Path | None = None

    @property
    def conflicts(self) -> tuple[Diagnostic, ...]:
        """The diagnostics of the files that only `--force` overwrites."""
        # Files that belong together have the one of the main file, which is told once.
        found = (file.problem for file in self.files if file.problem is not None)
        return tuple(dict.fromkeys(found))


def make_plan(
    folder: Path,
    files: Sequence[OutputFile],
    manifest: Manifest,
    *,
    within: Path | None = None,
) -> tuple[FilePlan, tuple[Diagnostic, ...]]:
    """Compare the wanted files with the disk.

    The diagnostics are errors that no `--force` mends; a file that has one is not in the plan,
    and the plan should then not be written. Conflicts are not among them: see
    `FilePlan.conflicts`. A file that was asked for twice with the same text is planned once.

    Args:
        folder: the output folder; it need not exist.
        files: the files that are wanted.
        manifest: what Plastron wrote there before.
        within: where the folder must lie, links resolved, when nobody named it expressly: so
            that a link in somebody's repository does not lead the default folder astray.
    """
    try:
        real_folder = real_folder_of(folder, within)
    except RefusedError as refused:
        return FilePlan(folder, ()), (refused.diagnostic,)
    planned: dict[Path, PlannedFile] = {}
    diagnostics: list[Diagnostic] = []
    for file in files:
        new = _plan_or_refuse(folder, real_folder, file, manifest)
        if isinstance(new, Diagnostic):
            # A folder that is none is in the way of each file below it.
            diagnostics += [new] if new not in diagnostics else []
        elif planned.setdefault(new.path, new).text != new.text:
            diagnostics.append(_same_file(folder, file))
    return FilePlan(folder, tuple(planned.values()), Path(real_folder)), tuple(diagnostics)


def _same_file(folder: Path, file: OutputFile) -> Diagnostic:
    """Return the diagnostic for a second text that would be written to one file."""
    endings = (ending for ending in _LOADED_BY_FILE if file.name.endswith(ending))
    ending = next(endings, None)
    what, remedy = "texts", "give what one of them is of another name"
    if ending is not None:
        what = _LOADED_BY_FILE[ending]
        remedy = (
            "give one of them another name; those that were loaded are changed where they are by "
            "`generate --in-place`"
        )
    message = f"two {what} would be written to `{file.name}`"
    return refusal(codes.SAME_FILE, message, folder / file.name, remedy)


_LOADED_BY_FILE = {
    **dict.fromkeys((".launch", ".launch.xml", ".launch.py"), "launch files"),
    ".msg": "message types",
    ".srv": "service types",
    ".action": "action types",
}
"""What stands in files of an ending, and can be loaded from two folders."""


def _plan_or_refuse(
    folder: Path, real_folder: str, file: OutputFile, manifest: Manifest
) -> PlannedFile | Diagnostic:
    try:
        return _plan_file(folder, real_folder, file, manifest)
    except RefusedError as refused:
        return refused.diagnostic


def _plan_file(folder: Path, real_folder: str, file: OutputFile, manifest: Manifest) -> PlannedFile:
    shown = file.path or folder / file.name
    path, status = target_of(shown, real_folder, file.name, file.path)
    before = None if status is None else _read(path, shown)
    is_inside = file.path is None or os.path.dirname(path) == real_folder
    known = file.entry or (file.name if is_inside else None)
    is_executable = file.is_executable and (status is None or file.text.startswith(b"#!"))
    file = replace(file, is_executable=is_executable)
    state, problem = _state(file, before, status, manifest if known else Manifest(), shown)
    if status is not None and state is not FileState.IDENTICAL and is_protected(path, status):
        raise RefusedError(read_only(shown))
    seen = [(os.path.realpath(folder), each) for folder, each in file.seen]
    if seen and is_inside:
        seen.append((real_folder, manifest))
    is_own = not file.has_handwork and (
        file.merged_from is None or manifest.has(file.name, file.merged_from)
    )
    return PlannedFile(
        file.name,
        Path(path),
        file.text,
        state,
        file.is_executable,
        before,
        status,
        entry=known if is_own else None,
        base=file.base if known else None,
        problem=problem,
        layers=file.layers,
        seen=tuple(seen),
        known=known,
    )


def _state(
    file: OutputFile,
    before: bytes | None,
    status: os.stat_result | None,
    manifest: Manifest,
    shown: Path,
) -> tuple[FileState, Diagnostic | None]:
    if file.merged_from is not None and before != file.merged_from:
        message = f"`{file.name}` changed on the disk since it was read"
        remedy = "run it again to start from what the file holds now"
        return FileState.CONFLICT, refusal(codes.CHANGED_ON_DISK, message, shown, remedy)
    if file.problem is not None:
        return FileState.CONFLICT, file.problem
    if before is None or status is None:
        return FileState.CREATE, None
    if before == file.text:
        lacks_bit = file.is_executable and not status.st_mode & stat.S_IXUSR
        is_mended = lacks_bit and not is_protected(shown, status)
        return FileState.CHANGED if is_mended else FileState.IDENTICAL, None
    if file.merged_from is not None or manifest.has(file.entry or file.name, before):
        return FileState.CHANGED, None
    if file.name in manifest:
        message = f"`{file.name}` was changed by hand"
    else:
        message = f"`{file.name}` exists and was not written by plastron"
    remedy = (
        "`load` it to keep what it holds, or use `generate --force` to overwrite it and keep a "
        "backup"
    )
    return FileState.CONFLICT, refusal(codes.FILE_CONFLICT, message, shown, remedy)


def _read(path: str, shown: Path) -> bytes:
    try:
        return read_regular(path, LARGEST_OUTPUT)
    except OSError as error:
        raise RefusedError(cannot_write(shown, error)) from error


def is_protected(path: Path | str, status: os.stat_result) -> bool:
    """Tell whether nobody is to write a file: a rename would, whatever its mode says.

    Where nobody may write to the folder either, the writer says it better.
    """
    if not status.st_mode & 0o222:
        return True
    return not os.access(path, os.W_OK) and os.access(os.path.dirname(path) or ".", os.W_OK)


def read_only(file: Path) -> Diagnostic:
    """Return the diagnostic for a file that nobody is to write."""
    message = f"cannot write `{file.name}`: it is read-only"
    remedy = f"allow it with `chmod u+w {file.name}`, or write to another file"
    return refusal(codes.CANNOT_WRITE, message, file, remedy)
