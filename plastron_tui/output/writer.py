"""Carry out a plan: everything, or nothing.

Conflicts are left alone and reported, and the other files are written; with `force` they are
overwritten and what they held stays beside them, as `NAME.bak`, `NAME.bak1` and so on.

An interrupt while the texts are written leaves the disk as it was. One that arrives when the
files are being renamed waits for the few milliseconds that this takes, so that the disk is then
wholly new; either way the caller sees the interrupt. Two processes that write to one folder take
turns by a lock on the folder; the second finds what the first one wrote, and stops when that is
not what its plan saw.
"""

from __future__ import annotations

import os
import stat
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic

from .interrupts import Interrupts
from .layers import Layers
from .manifest import NAME, Base, digest, load_manifest, manifest_text
from .plan import FilePlan, FileState, PlannedFile, cannot_write
from .transaction import BusyError, ChangedError, Step, Transaction, is_unchanged


@dataclass(frozen=True, slots=True)
class WrittenFile:
    """A file that was written, and where the text that was there by hand is kept."""

    file: PlannedFile
    backup: Path | None = None


class WriteResult(NamedTuple):
    """What was written, in the order of the plan, and what was not and why."""

    written: tuple[WrittenFile, ...]
    diagnostics: tuple[Diagnostic, ...]


def write(plan: FilePlan, *, force: bool = False) -> WriteResult:
    """Write the files of a plan.

    Nothing is raised for what the operating system refuses: that is a diagnostic `cannot-write`,
    and the disk is as it was. Files that already hold what they shall are not touched.

    Args:
        plan: what to write, as `make_plan` gave it.
        force: overwrite what was written by hand, and keep a backup.

    Raises:
        KeyboardInterrupt: the process was interrupted.
    """
    wanted = [file for file in plan.files if force or file.state is not FileState.CONFLICT]
    conflicts = () if force else plan.conflicts
    if not _has_work(plan.folder, wanted):
        return WriteResult((), conflicts)
    with Interrupts() as interrupts:
        transaction = Transaction(interrupts)
        problem = None
        written: tuple[WrittenFile, ...] = ()
        try:
            with transaction:
                written = _write(plan.folder, wanted, transaction)
        except ChangedError:
            problem = _changed(transaction.at)
        except BusyError:
            message = "another plastron is writing to this folder"
            problem = Diagnostic("cannot-write", message, file=Path(transaction.at))
        except (OSError, ValueError) as error:
            problem = cannot_write(Path(transaction.at), error)
        if problem is None:
            return WriteResult(written, conflicts)
        lost = (_not_restored(path, error) for path, error in transaction.failures)
        return WriteResult((), (*conflicts, problem, *lost))


def _has_work(folder: Path, files: list[PlannedFile]) -> bool:
    if any(file.state is not FileState.IDENTICAL for file in files):
        return True
    return any(
        not load_manifest(Path(home))[0].is_up_to_date(*news)
        for home, news in _news(folder, files).items()
    )


def _write(
    folder: Path, files: list[PlannedFile], transaction: Transaction
) -> tuple[WrittenFile, ...]:
    news = _news(folder, files)
    folders = {os.path.dirname(file.path) for file in files if _is_written(file)}
    transaction.open_folders({*folders, *news})
    steps = []
    for file in files:
        transaction.at = os.fspath(file.path)
        current = _settled(file)
        if _is_written(current):
            step = _step(current)
            transaction.stage(step)
            steps.append((file, step))
    for home, new in news.items():
        transaction.at = os.path.join(home, NAME)
        remembered = _manifest_step(home, new)
        if remembered is not None:
            transaction.stage(remembered)
    transaction.commit()
    return tuple(
        WrittenFile(file, Path(step.backup) if step.backup else None) for file, step in steps
    )


def _is_written(file: PlannedFile) -> bool:
    return file.state is not FileState.IDENTICAL


def _settled(file: PlannedFile) -> PlannedFile:
    """Look at the disk again: the plan may be old, or another process may have been faster."""
    path = os.fspath(file.path)
    if is_unchanged(path, file.status):
        return file
    status = os.lstat(path) if os.path.lexists(path) else None
    if status is None or not stat.S_ISREG(status.st_mode):
        raise ChangedError
    text = file.path.read_bytes()
    if text == file.text and (status.st_mode & stat.S_IXUSR or not file.is_executable):
        return replace(file, state=FileState.IDENTICAL, before=text, status=status)
    if text in (file.before, file.text):
        return replace(file, before=text, status=status)
    raise ChangedError


def _step(file: PlannedFile) -> Step:
    return Step(
        os.fspath(file.path),
        file.text,
        file.is_executable,
        file.status,
        file.before,
        keeps_backup=file.state is FileState.CONFLICT and file.before is not None,
    )


class _News(NamedTuple):
    """What a manifest is to remember of files, as `Manifest.updated` takes it."""

    entries: dict[str, str]
    bases: dict[str, Base]
    superseded: dict[str, str]
    layers: dict[str, Layers]


def _manifest_step(home: str, news: _News) -> Step | None:
    """Return the step that brings a manifest up to date, None when it is.

    The manifest is read again, under the lock: another process may have written other files.
    """
    path = os.path.join(home, NAME)
    manifest, _ = load_manifest(Path(home))
    if manifest.is_up_to_date(*news):
        return None
    present = {*os.listdir(home), *news.entries, *news.bases, *news.layers}
    updated = manifest.updated(news.entries, present, news.bases, news.superseded, news.layers)
    text = manifest_text(updated)
    if not os.path.lexists(path):
        return Step(path, text, is_executable=False)
    status = os.lstat(path)
    if not stat.S_ISREG(status.st_mode):
        raise ValueError("it is not a plain file")
    return Step(path, text, False, status, Path(path).read_bytes(), manifest.is_foreign)


def _news(folder: Path, files: list[PlannedFile]) -> dict[str, _News]:
    """Return what is to be remembered, by the folder that has the manifest.

    It is the output folder, but for what is known of a file that is changed in place.
    """
    home = os.path.realpath(folder)
    news: dict[str, _News] = {}

    def at(folder: str) -> _News:
        return news.setdefault(folder, _News({}, {}, {}, {}))

    for file in files:
        if file.entry is not None:
            at(home).entries[file.entry] = digest(file.text)
        if file.base is not None:
            at(home).bases[file.name] = file.base
        if file.supersedes is not None:
            at(home).superseded[file.supersedes] = file.name
        if file.layers is not None:
            path = os.fspath(file.path)
            at(os.path.dirname(path)).layers[os.path.basename(path)] = file.layers
    return news


def _changed(path: str) -> Diagnostic:
    return Diagnostic(
        "changed-on-disk",
        f"`{os.path.basename(path)}` changed on the disk since it was read",
        file=Path(path),
        help="run it again to start from what the file holds now",
    )


def _not_restored(path: str, error: OSError) -> Diagnostic:
    return Diagnostic(
        "cannot-write",
        f"cannot put `{os.path.basename(path)}` back: {(error.strerror or str(error)).lower()}",
        file=Path(path),
        help="its text is beside it, in a file whose name starts with `.plastron-`",
    )
