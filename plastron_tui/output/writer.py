"""Carry out a plan: everything, or nothing.

Conflicts are left alone and reported, and the other files are written; with `force` they are
overwritten and what they held stays beside them, as `NAME.bak`, `NAME.bak1` and so on.

An interrupt while the texts are written leaves the disk as it was. One that arrives when the
files are being renamed waits for the few milliseconds that this takes, so that the disk is then
wholly new; either way the caller sees the interrupt. When the process is killed, or the machine
stops, the next run finishes what was begun.

Two processes that write to one folder take turns by a lock on the folder; the second finds what the
first one wrote, and stops when that is not what its plan was made of: see `WriteResult.is_stale`.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Severity, codes
from plastron_tui.regular_files import read_regular, reason

from .file_calls import is_unchanged
from .interrupts import Interrupts
from .locks import BusyError
from .manifest import NAME, Base, Manifest, digest, load_manifest, manifest_text
from .patch_stack import Layers
from .plan import LARGEST_OUTPUT, FilePlan, FileState, PlannedFile, is_protected
from .recovery import not_removed
from .replacement import ChangedError
from .target_paths import cannot_write
from .transaction import Step, Transaction

MOST_TRIES = 4
"""How often a plan is made and written before it is given up that the disk stands still."""


@dataclass(frozen=True, slots=True)
class WrittenFile:
    """A file that was written, and where the text that was there by hand is kept."""

    file: PlannedFile
    backup: Path | None = None


class WriteResult(NamedTuple):
    """What was written, in the order of the plan, and what was not and why.

    The diagnostics may be warnings only, where all was written.
    """

    written: tuple[WrittenFile, ...]
    diagnostics: tuple[Diagnostic, ...]

    @property
    def is_stale(self) -> bool:
        """Whether nothing was written because the disk moved on: a new plan may do."""
        found = (diagnostic.code == codes.CHANGED_ON_DISK for diagnostic in self.diagnostics)
        return not self.written and any(found)


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
    # A link may lead elsewhere by now.
    folder = plan.real_folder or Path(os.path.realpath(plan.folder))
    if not _has_work(folder, wanted):
        return WriteResult((), conflicts)
    with Interrupts() as interrupts:
        transaction = Transaction(interrupts)
        problem = None
        written: tuple[WrittenFile, ...] = ()
        notes: list[Diagnostic] = []
        try:
            with transaction:
                written = _write(folder, wanted, transaction, notes)
        except ChangedError:
            problem = _changed(transaction.at)
        except BusyError:
            message = "another plastron is writing to this folder"
            problem = Diagnostic(codes.CANNOT_WRITE, message, file=Path(transaction.at))
        except (OSError, ValueError) as error:
            problem = cannot_write(Path(transaction.at), error)
        left = (not_removed(path, error) for path, error in transaction.left)
        if problem is None:
            return WriteResult(written, (*transaction.notes, *conflicts, *notes, *left))
        lost = (_not_restored(path, error) for path, error in transaction.failures)
        return WriteResult((), (*transaction.notes, *conflicts, problem, *lost, *left))


def write_current(
    plan: FilePlan, again: Callable[[], FilePlan | None], *, force: bool = False
) -> WriteResult:
    """Write the files of a plan, which is made again where the disk has moved on since.

    A plan with a conflict is not written, but for `force`.

    Args:
        plan: what to write.
        again: makes the plan again, or returns None where that is no longer possible.
        force: overwrite what is in conflict.

    Raises:
        KeyboardInterrupt: the process was interrupted.
    """
    notes: tuple[Diagnostic, ...] = ()
    for _ in range(MOST_TRIES):
        result = WriteResult((), plan.conflicts)
        if force or not plan.conflicts:
            result = write(plan, force=force)
        if not result.is_stale:
            break
        made = again()
        if made is None:
            break
        plan = made
        # What was found of interrupted writes is not found again.
        notes += tuple(x for x in result.diagnostics if x.severity is not Severity.ERROR)
    return result._replace(diagnostics=(*notes, *result.diagnostics))


def _has_work(folder: Path, files: list[PlannedFile]) -> bool:
    if any(file.state is not FileState.IDENTICAL for file in files):
        return True
    return any(
        not load_manifest(Path(home))[0].is_up_to_date(*news)
        for home, news in _news(folder, files).items()
    )


def _write(
    folder: Path,
    files: list[PlannedFile],
    transaction: Transaction,
    notes: list[Diagnostic],
) -> tuple[WrittenFile, ...]:
    news = _news(folder, files)
    folders = {os.path.dirname(file.path) for file in files if _is_written(file)}
    transaction.open_folders({*folders, *news})
    manifests: dict[str, Manifest] = {}

    def manifest(home: str) -> Manifest:
        if home not in manifests:
            manifests[home], _ = load_manifest(Path(home))
        return manifests[home]

    steps = []
    for file in files:
        transaction.at = os.fspath(file.path)
        current = _settled(file)
        if _is_written(current):
            _check_manifests(file, manifest)
            step = _step(current)
            transaction.stage(step)
            steps.append((file, step))
    for home, new in news.items():
        transaction.at = os.path.join(home, NAME)
        remembered = _manifest_step(home, new, manifest(home))
        if remembered is not None:
            transaction.stage(remembered)
    transaction.commit()
    for file, step in steps:
        notes += _not_kept(file, step)
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
    text = read_regular(path, LARGEST_OUTPUT)
    if text == file.text and (status.st_mode & stat.S_IXUSR or not file.is_executable):
        return replace(file, state=FileState.IDENTICAL, before=text, status=status)
    if text in (file.before, file.text):
        return replace(file, before=text, status=status)
    raise ChangedError


def _check_manifests(file: PlannedFile, read: Callable[[str], Manifest]) -> None:
    """Check that the text of a file was made of what the manifests say now.

    Another process that wrote after a manifest was read, and before the file was, has changed
    both: what was made of the one as it was and the other as it is would mix two programs.

    Raises:
        ChangedError: another process changed what a manifest says of the file.
    """
    program = (file.base or {}).get("program")
    names = {file.name, file.path.name}
    if not all(read(folder).agrees(seen, names, program) for folder, seen in file.seen):
        raise ChangedError(os.fspath(file.path))


def _not_kept(file: PlannedFile, step: Step) -> Iterator[Diagnostic]:
    """Yield warnings of what a file has no longer, now that another took its place."""
    for name in step.lost:
        yield Diagnostic(
            codes.NOT_KEPT,
            f"`{file.name}` lost its {name}",
            file=file.path,
        )
    if step.status is not None and step.status.st_nlink > 1:
        yield Diagnostic(
            codes.NOT_KEPT,
            f"`{file.name}` had another name, a hard link, which keeps what the file held before",
            file=file.path,
            help="make the link again, or a symbolic one, which stays",
        )


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
    layers: dict[str, Layers]


def _manifest_step(home: str, news: _News, manifest: Manifest) -> Step | None:
    """Return the step that brings a manifest up to date, None when it is.

    The manifest was read under the lock: another process may have written other files.
    """
    path = os.path.join(home, NAME)
    if manifest.is_up_to_date(*news):
        return None
    known = {*manifest.digests, *manifest.bases, *manifest.layers}
    there = {name for name in known if os.path.lexists(os.path.join(home, name))}
    present = {*there, *news.entries, *news.bases, *news.layers}
    updated = manifest.updated(news.entries, present, news.bases, news.layers)
    text = manifest_text(updated)
    if not os.path.lexists(path):
        return Step(path, text, is_executable=False)
    status = os.lstat(path)
    if not stat.S_ISREG(status.st_mode):
        raise ValueError("it is not a plain file")
    if is_protected(path, status):
        raise ValueError("it is read-only")
    return Step(path, text, False, status, read_regular(path, LARGEST_OUTPUT), manifest.is_foreign)


def _news(folder: Path, files: list[PlannedFile]) -> dict[str, _News]:
    """Return what is to be remembered, by the folder that has the manifest.

    It is the output folder, but for what is known of a file that is changed in place.
    """
    home = os.fspath(folder)
    news: dict[str, _News] = {}

    def at(folder: str) -> _News:
        return news.setdefault(folder, _News({}, {}, {}))

    for file in files:
        if file.entry is not None:
            at(home).entries[file.entry] = digest(file.text)
        if file.base is not None:
            at(home).bases[file.known or file.name] = file.base
        if file.layers is not None:
            path = os.fspath(file.path)
            at(os.path.dirname(path)).layers[os.path.basename(path)] = file.layers
    return news


def _changed(path: str) -> Diagnostic:
    return Diagnostic(
        codes.CHANGED_ON_DISK,
        f"`{os.path.basename(path)}` changed on the disk since it was read",
        file=Path(path),
        help="run it again to start from what the file holds now",
    )


def _not_restored(path: str, error: OSError) -> Diagnostic:
    return Diagnostic(
        codes.CANNOT_WRITE,
        f"cannot put `{os.path.basename(path)}` back: {reason(error)}",
        file=Path(path),
        help="its text is beside it, in a file whose name starts with `.plastron-`; the next run "
        "finishes what was begun",
    )
