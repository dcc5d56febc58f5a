"""The journal of a write: which files it replaces, and how far it has come.

A write that replaces files first has every new text beside its target, synced, and every old text
under a second name; then it writes a journal, and only then it renames. Whoever finds a journal in
a folder that no process has locked finishes the write.

    {"generator": "plastron", "version": 1, "write": "6f1e…", "folder": 1234567,
     "files": [{"name": "talker.py", "before": "sha256:…", "after": "sha256:…", "backup": null}]}

The nth file's new text is `.plastron-N.new`, its old one `.plastron-N.old`. A write to several
folders has a journal in each: one decides (`others` names the rest), and is the last to appear and
the last to go; the others name it (`decided_by`), and count for nothing without it. Where an old
text could not be removed at the end, the journal stays and says `"done": true`: no file is replaced
any more, whatever happens to the files, but the old texts still go.

A journal may come from anywhere, with a foreign repository for one. It speaks of the folder that
it lies in, by the folder's inode, and of nothing outside: names are bare, and a file is replaced
only where its digest, and that of what replaces it, are those of the journal. Folder and journal
have to be the user's own: whoever may put another folder in the place of this one, or a journal
into it, would write in the user's name.
"""

from __future__ import annotations

import json
import os
import re
from dataclasses import dataclass
from typing import Any

from plastron_tui.regular_files import read_regular

from .own_files import JOURNAL, PREFIX

_GENERATOR = "plastron"
_VERSION = 1
_LARGEST = 4 * 1024 * 1024
_MOST_FOLDERS = 1000
_DIGEST = re.compile(r"sha256:[0-9a-f]{64}")
_WRITE = re.compile(r"[0-9a-f]{32}")
_BACKUP = re.compile(r"\.bak[0-9]{0,9}")


class BadJournalError(Exception):
    """A file of the journal's name that is none, or is of another folder; says why."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One file of a journal.

    Attributes:
        name: its name in the journal's folder.
        before: the digest of its old text, None where there was no such file.
        after: the digest of its new text.
        backup: the name under which the old text is kept, None where it is not.
    """

    name: str
    before: str | None
    after: str
    backup: str | None = None


@dataclass(frozen=True, slots=True)
class Journal:
    """What a write does in one folder.

    Attributes:
        write: what the journals of one write have in common.
        entries: the files, in the order in which they are replaced.
        decided_by: the folder whose journal decides, relative to this one; None for this one.
        others: where this one decides, the other folders, relative to it.
        is_done: whether the write was reported as done; where this one decides.
    """

    write: str
    entries: tuple[Entry, ...]
    decided_by: str | None = None
    others: tuple[str, ...] = ()
    is_done: bool = False


def journal_text(journal: Journal, folder: str) -> bytes:
    """Return a journal as the text of its file in a folder."""
    data: dict[str, Any] = {
        "generator": _GENERATOR,
        "version": _VERSION,
        "write": journal.write,
        "folder": os.stat(folder).st_ino,
        "decided_by": journal.decided_by,
        "others": journal.others,
        "done": journal.is_done,
        "files": [
            {"name": one.name, "before": one.before, "after": one.after, "backup": one.backup}
            for one in journal.entries
        ],
    }
    return json.dumps(data).encode("ascii") + b"\n"


def read_journal(folder: str) -> Journal | None:
    """Return a folder's journal, None where it has none.

    Raises:
        BadJournalError: what is there is no journal of this folder.
        OSError: the operating system refuses.
    """
    path = os.path.join(folder, JOURNAL)
    try:
        status, home = os.lstat(path), os.stat(folder)
        if os.path.islink(path):
            raise BadJournalError("it is a symbolic link")
        text = read_regular(path, _LARGEST)
    except (FileNotFoundError, NotADirectoryError):
        return None
    if {status.st_uid, home.st_uid} != {os.geteuid()}:
        raise BadJournalError("it, or the folder, belongs to another user")
    try:
        data = json.loads(text)
        if data["generator"] != _GENERATOR or data["version"] != _VERSION:
            raise BadJournalError("it was not written by this version of plastron")
        if data["folder"] != home.st_ino:
            raise BadJournalError("it is of another folder, which this one is a copy of")
        return _journal(data)
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise BadJournalError("it is broken") from error


def _journal(data: dict[str, Any]) -> Journal:
    decided_by, others = data["decided_by"], tuple(data["others"])
    if not _WRITE.fullmatch(data["write"]) or len(others) > _MOST_FOLDERS:
        raise ValueError
    if not all(
        isinstance(each, str) and "\0" not in each
        for each in (*others, *(() if decided_by is None else (decided_by,)))
    ):
        raise ValueError
    entries = tuple(_entry(each) for each in data["files"])
    if len({entry.name for entry in entries}) < len(entries):
        raise ValueError
    return Journal(data["write"], entries, decided_by, others, data.get("done") is True)


def _entry(data: dict[str, Any]) -> Entry:
    entry = Entry(data["name"], data["before"], data["after"], data["backup"])
    if not isinstance(entry.name, str) or not isinstance(entry.backup, str | None):
        raise ValueError
    if not _is_bare(entry.name) or not _DIGEST.fullmatch(entry.after):
        raise ValueError
    if entry.before is not None and not _DIGEST.fullmatch(entry.before):
        raise ValueError
    if entry.backup is not None:
        stem, suffix = entry.backup[: len(entry.name)], entry.backup[len(entry.name) :]
        if stem != entry.name or not _BACKUP.fullmatch(suffix) or entry.before is None:
            raise ValueError
    return entry


def _is_bare(name: str) -> bool:
    """Tell whether a name means a file of the folder itself, and none of the writer's own."""
    is_file = name not in {"", ".", ".."} and not name.startswith(PREFIX)
    return is_file and not {"/", "\0"} & set(name)
