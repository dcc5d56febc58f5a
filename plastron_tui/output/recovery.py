"""Finishing what a process that was killed had begun, and removing what it left behind."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import count
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.regular_files import reason

from .file_calls import digest_of, remove, sync_folder
from .journal import BadJournalError, Journal, read_journal
from .locks import BusyError, FolderLocks
from .own_files import JOURNAL, KEPT, temporary_kind
from .replacement import ChangedError, Progress, Replacement

_MOST_TRIES = 5
"""How often the folders of a write may turn out to be others when they are locked."""

_MOST_COMPARED = 20
"""How many files of one size are compared with an old text that is left."""

_MOST_NAMED = 5
"""How many files are named in a message."""

Notes = tuple[Diagnostic, ...]


def settle(folder: Path) -> Notes:
    """Bring a folder into the state that it would have without the crash, if there was one.

    Nothing is raised: what cannot be done is a warning, and is tried again by the next run; what
    was done, where files were replaced, is a warning as well. A folder that nobody writes to, and
    nobody was killed at, costs two looks.
    """
    try:
        return recover(os.path.realpath(folder))
    except BusyError:
        return (_unfinished(folder, "another plastron is writing to this folder"),)
    except (OSError, ValueError) as error:
        has_journal = os.path.lexists(folder / JOURNAL)
        return (_unfinished(folder, reason(error)),) if has_journal else ()


def recover(
    folder: str, waiting: Callable[[], None] = lambda: None, *, is_writer: bool = False
) -> Notes:
    """Finish or undo what its journal says, under the lock of all folders that this concerns.

    Args:
        folder: the folder, links resolved.
        waiting: called while another process is waited for.
        is_writer: go on where the file system has no locks, as a write has to.

    Raises:
        OSError: the operating system refuses, or has no locks (`ENOLCK`); the journal stays.
        BusyError: another process did not give its lock back.
    """
    for _ in range(_MOST_TRIES):
        involved = _involved(folder)
        with FolderLocks(waiting) as locks:
            locks.take(involved)
            if locks.unlocked and not is_writer:
                # A journal and temporary files may be those of a process that works.
                reason = "the file system has no locks, so that only the next write does it"
                raise OSError(errno.ENOLCK, reason, folder)
            if _involved(folder) != involved:
                continue
            notes = _replay(involved)
            swept = [note for each in sorted(involved) for note in sweep(each)]
            return (*notes, *_bad_journal(folder), *swept)
    raise BusyError(folder)


def _involved(folder: str) -> dict[str, Journal | None]:
    """Return the folders that the write that is journalled in a folder concerns."""
    own = _journal(folder)
    found: dict[str, Journal | None] = {folder: own}
    if own is None:
        return found
    first = folder if own.decided_by is None else _other(folder, own.decided_by)
    deciding = own if first == folder else _journal(first)
    if deciding is None or deciding.write != own.write or deciding.decided_by is not None:
        return found
    found[first] = deciding
    for name in deciding.others:
        other = _other(first, name)
        journal = _journal(other)
        if journal is not None and journal.write == own.write:
            found[other] = journal
    return found


def _journal(folder: str) -> Journal | None:
    try:
        return read_journal(folder)
    except BadJournalError:
        return None


def _other(folder: str, name: str) -> str:
    return os.path.realpath(os.path.join(folder, name))


def _replay(involved: Mapping[str, Journal | None]) -> Notes:
    journals = {folder: journal for folder, journal in involved.items() if journal is not None}
    if not journals:
        return ()
    deciding = [each for each, journal in journals.items() if journal.decided_by is None]
    others = [folder for folder in journals if folder not in deciding]
    replacements = [
        Replacement(folder, place, entry)
        for folder, journal in journals.items()
        for place, entry in enumerate(journal.entries)
    ]
    if any(journals[each].is_done for each in deciding):
        _remove_temporaries(replacements)
        drop_journals([*others, *deciding])
        return ()
    states = {each: each.progress() for each in replacements}
    is_forward = bool(deciding) and _leads_forward(states)
    if is_forward:
        notes = tuple(_forward(states))
        drop_journals([*others, *deciding])
    else:
        notes = tuple(_back(states))
        # Without the journal that decides the others lead back, too.
        drop_journals([*deciding, *others])
    return notes


def _leads_forward(states: Mapping[Replacement, Progress]) -> bool:
    """Tell whether all can become new; if not, all become old again, where that is possible.

    A file that has its old text again was put back by hand, or by a writer that failed.
    """
    if all(state in {Progress.WAITING, Progress.DONE} for state in states.values()):
        return True
    return not all(
        state in {Progress.WAITING, Progress.BLOCKED} or each.can_be_taken_back()
        for each, state in states.items()
    )


def _forward(states: Mapping[Replacement, Progress]) -> Iterator[Diagnostic]:
    changed = []
    for each, state in states.items():
        if state is Progress.BLOCKED:
            yield _left_alone(each)
            continue
        try:
            each.finish()
            if state is Progress.WAITING:
                changed.append(each)
        except ChangedError:  # since it was looked at
            yield _left_alone(each)
    folders = {each.folder for each in states}
    for folder in folders:
        sync_folder(folder)
    for each in states:
        each.keep_backup()
    _remove_temporaries(states)
    for folder in folders:
        sync_folder(folder)
    yield from _told("finished", changed)


def _remove_temporaries(replacements: Iterable[Replacement]) -> None:
    for each in replacements:
        remove(each.old)
        remove(each.new)


def _back(states: Mapping[Replacement, Progress]) -> Iterator[Diagnostic]:
    changed = []
    for each in reversed(list(states)):
        left_alone = _taken_back(each)
        yield from left_alone
        if states[each] is Progress.DONE and not left_alone:
            changed.append(each)
    for folder in {each.folder for each in states}:
        sync_folder(folder)
    yield from _told("taken back", changed)


def _taken_back(replacement: Replacement) -> Notes:
    try:
        replacement.take_back()
    except (ChangedError, FileNotFoundError):
        return (_left_alone(replacement),)
    remove(replacement.old)
    return ()


def drop_journals(folders: list[str]) -> None:
    """Remove the journals of a write, one after the other, each for good before the next."""
    for at, folder in enumerate(folders):
        remove(os.path.join(folder, JOURNAL))
        if at + 1 < len(folders):
            sync_folder(folder)


def sweep(folder: str) -> list[Diagnostic]:
    """Remove the temporary files of processes that are gone; the folder's lock is held.

    An old text of which there is no other copy is kept under another name, whoever made it.
    """
    if _journal(folder) is not None or not os.access(folder, os.W_OK):
        return []
    notes = []
    with suppress(OSError):
        # From the last to the first: see `has_leftovers`.
        for name in sorted(os.listdir(folder), reverse=True):
            kind = temporary_kind(name)
            path = os.path.join(folder, name)
            if kind is None or stat.S_ISDIR(os.lstat(path).st_mode) or not _is_own(path):
                continue
            try:
                # What is no regular file, a link for one, is removed itself and holds no text.
                is_text = stat.S_ISREG(os.lstat(path).st_mode)
                if kind == "old" and is_text and not _has_copy(folder, path):
                    notes.append(_kept(folder, path))
                else:
                    os.unlink(path)
            except OSError as error:
                notes.append(not_removed(path, error))
    return notes


def _is_own(path: str) -> bool:
    return os.lstat(path).st_uid == os.geteuid()


def _has_copy(folder: str, path: str) -> bool:
    status = os.lstat(path)
    if status.st_nlink > 1:
        return True
    text = digest_of(path)
    with os.scandir(folder) as entries:
        same = [
            entry.path
            for entry in entries
            if entry.path != path
            and not temporary_kind(entry.name)
            and entry.is_file(follow_symlinks=False)
            and entry.stat(follow_symlinks=False).st_size == status.st_size
        ]
    return any(digest_of(other) == text for other in same[:_MOST_COMPARED])


def not_removed(path: str, error: OSError) -> Diagnostic:
    """Return the warning that a temporary file stays."""
    name = os.path.basename(path)
    return Diagnostic(
        codes.LEFTOVER_FILE,
        f"cannot remove `{name}`: {reason(error)}",
        file=Path(path),
        help="the next run tries it again",
    )


def _kept(folder: str, path: str) -> Diagnostic:
    """Give an old text a name that nobody removes."""
    names = (f"{KEPT}{number or ''}" for number in count())
    name = next(name for name in names if not os.path.lexists(os.path.join(folder, name)))
    os.rename(path, os.path.join(folder, name))
    return Diagnostic(
        codes.LEFTOVER_FILE,
        f"a process that was killed left the only copy of an earlier text, now in `{name}`",
        file=Path(folder) / name,
        help="rename it if you want to keep it, or remove it",
    )


def _told(done: str, changed: Sequence[Replacement]) -> Iterator[Diagnostic]:
    """Yield the warning that files were replaced, which nobody asked this process for."""
    if changed:
        names = [f"`{each.entry.name}`" for each in changed[:_MOST_NAMED]]
        if len(changed) > len(names):
            names.append(f"… and {len(changed) - len(names)} more")
        yield Diagnostic(
            codes.INTERRUPTED_WRITE,
            f"a write that was interrupted was {done}: {', '.join(names)}",
            file=Path(changed[0].path),
        )


def _left_alone(replacement: Replacement) -> Diagnostic:
    name = replacement.entry.name
    return Diagnostic(
        codes.INTERRUPTED_WRITE,
        f"`{name}` was changed by hand before a write that was interrupted could be finished",
        file=Path(replacement.path),
        help=f"`{name}` is as you left it; see with `plastron generate --diff` what it lacks",
    )


def _unfinished(folder: Path, reason: str) -> Diagnostic:
    return Diagnostic(
        codes.INTERRUPTED_WRITE,
        f"a write to this folder was interrupted, and cannot be finished: {reason}",
        file=folder / JOURNAL,
        help="until it is, some files may be new and others old",
    )


def _bad_journal(folder: str) -> Notes:
    try:
        read_journal(folder)
    except BadJournalError as error:
        warning = Diagnostic(
            codes.INTERRUPTED_WRITE,
            f"`{JOURNAL}` is no journal of this folder: {error}",
            file=Path(folder) / JOURNAL,
            help="remove it; if a write was interrupted here, some files may be new and others old",
        )
        return (warning,)
    return ()
