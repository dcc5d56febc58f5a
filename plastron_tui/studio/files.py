"""The program's file: how it is read, saved, and looked at for changes by others."""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.output.own_files import settled
from plastron_tui.project.program_file import LARGEST_PROGRAM, read_program
from plastron_tui.regular_files import Stamp, is_same_file, read_regular, reason, stamp_of

SUFFIX = ".plastron"


class OnDisk(NamedTuple):
    """What a file held when it was read or written last; `text` is None where there was none."""

    path: Path
    text: bytes | None
    stamp: Stamp | None

    @property
    def is_changed(self) -> bool:
        """Whether somebody else has touched the file since."""
        return stamp_of(self.path) != self.stamp


class Opened(NamedTuple):
    """A file that was asked for: what it holds, or why that is not known.

    Attributes:
        disk: what it holds.
        problem: why that is not known.
        notes: what was found of a write to its folder that was interrupted; nobody finds it again.
    """

    disk: OnDisk | None
    problem: Diagnostic | None = None
    notes: tuple[Diagnostic, ...] = ()

    @property
    def said(self) -> tuple[str, ...]:
        """The notes as texts."""
        return tuple(
            f"{note.message}\n{note.help}" if note.help else note.message for note in self.notes
        )


class Saved(NamedTuple):
    """What saving led to.

    Attributes:
        disk: what the file holds now, None when it was not written.
        problem: why it was not; or, where it was, a warning.
        found: when another text is in the file than the one that was read, that text.
    """

    disk: OnDisk | None
    problem: Diagnostic | None = None
    found: bytes | None = None

    @property
    def refusal(self) -> Diagnostic | None:
        """Why it was not written, None where it was."""
        return self.problem if self.disk is None else None


def open_file(path: Path) -> Opened:
    """Read a program; a file that is not there yet is an empty one."""
    notes = settled(path.parent)
    stamp = stamp_of(path)
    if stamp is None and not os.path.lexists(path):
        return Opened(OnDisk(path, None, None), notes=notes)
    read = read_program(path)
    notes = tuple(note for note in notes if note not in read.diagnostics)
    if read.text is None:
        return Opened(None, read.diagnostics[0], (*read.diagnostics[1:], *notes))
    return Opened(OnDisk(path, read.text, stamp), notes=(*read.diagnostics, *notes))


def save_file(path: Path, text: bytes, known: OnDisk | None) -> Saved:
    """Write a program: all of it or nothing; mode and, as the text has them, line endings stay.

    Args:
        path: where to.
        text: the program.
        known: what is known to be there; another text there is not written over.
    """
    from plastron_tui.boundary import find_boundary
    from plastron_tui.output.manifest import Manifest
    from plastron_tui.output.plan import OutputFile, make_plan
    from plastron_tui.output.writer import write
    from plastron_tui.project.settings import outside_program

    present = _present(path)
    expected = known.text if known is not None and is_same_file(path, known.path) else None
    if present is not None and present not in (expected, text):
        return Saved(None, found=present)
    folder = path.absolute().parent
    if not folder.is_dir():
        return Saved(None, _gone(path))
    outside = outside_program(path, find_boundary(folder))
    if outside is not None:
        return Saved(None, outside)
    # A program is handwork: no manifest remembers it.
    file = OutputFile(
        path.name, text, is_executable=False, merged_from=present, path=path, has_handwork=True
    )
    plan, problems = make_plan(folder, [file], Manifest())
    problems = (*problems, *plan.conflicts)
    if not problems:
        problems = write(plan).diagnostics
    errors = [found for found in problems if found.severity is Severity.ERROR]
    if errors:
        return Saved(None, errors[0])
    return Saved(OnDisk(path, text, stamp_of(path)), problems[0] if problems else None)


def _present(path: Path) -> bytes | None:
    try:
        return read_regular(path, LARGEST_PROGRAM)
    except (OSError, ValueError):
        return None


def _gone(path: Path) -> Diagnostic:
    from plastron_tui.diagnostics import codes

    folder = path.absolute().parent
    message = f"cannot write `{path.name}`: the folder `{folder.name}` is not there"
    return Diagnostic(codes.CANNOT_WRITE, message, file=path, help="save it under another name")


def read_again(disk: OnDisk) -> OnDisk:
    """Return what the file holds now."""
    return OnDisk(disk.path, _present(disk.path), stamp_of(disk.path))


def lost(path: Path) -> str:
    """Say why a program's file has no text any more, and what to do."""
    if not os.path.lexists(path):
        return f"{path.name} is no longer on the disk; save it to keep it"
    why = "it is being written"
    try:
        read_regular(path, LARGEST_PROGRAM)
    except FileNotFoundError:
        why = "it is a link to nothing"
    except IsADirectoryError:
        why = "it is a folder now"
    except (OSError, ValueError) as error:
        why = reason(error)
    return f"{path.name} can no longer be read: {why}; save your text under another name"


def meant_by(path: Path) -> Path:
    """Return the program that a name means: NAME.plastron, where no file has the very name."""
    return path if os.path.lexists(path) else with_suffix(path)


def with_suffix(path: Path) -> Path:
    """Return the path with `.plastron` at its end where it has no suffix."""
    return path if path.suffix else path.with_name(path.name + SUFFIX)
