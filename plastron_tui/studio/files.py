"""The program's file: how it is read, saved, and looked at for changes by others."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.output.stamps import Stamp, stamp_of
from plastron_tui.program_file import read_program

SUFFIX = ".plastron"


@dataclass(frozen=True, slots=True)
class OnDisk:
    """What a file held when it was read or written last; `text` is None where there was none."""

    path: Path
    text: bytes | None
    stamp: Stamp | None

    @property
    def is_changed(self) -> bool:
        """Whether somebody else has touched the file since."""
        return stamp_of(self.path) != self.stamp


@dataclass(frozen=True, slots=True)
class Opened:
    """A file that was asked for: what it holds, or why that is not known."""

    disk: OnDisk | None
    problem: Diagnostic | None = None


@dataclass(frozen=True, slots=True)
class Saved:
    """What saving led to.

    Attributes:
        disk: what the file holds now, None when it was not written.
        problem: why it was not.
        found: when another text is in the file than the one that was read, that text.
    """

    disk: OnDisk | None
    problem: Diagnostic | None = None
    found: bytes | None = None


def open_file(path: Path) -> Opened:
    """Read a program; a file that is not there yet is an empty one."""
    stamp = stamp_of(path)
    if stamp is None and not os.path.lexists(path):
        return Opened(OnDisk(path, None, None))
    read = read_program(path)
    if read.text is None:
        return Opened(None, read.diagnostics[0])
    return Opened(OnDisk(path, read.text, stamp))


def save_file(path: Path, text: bytes, known: OnDisk | None, *, force: bool = False) -> Saved:
    """Write a program: all of it or nothing; mode and, as the text has them, line endings stay.

    Args:
        path: where to.
        text: the program.
        known: what is known to be there; another text there is not written over.
        force: write over it all the same.
    """
    from plastron_tui.output.manifest import Manifest
    from plastron_tui.output.plan import OutputFile, make_plan
    from plastron_tui.output.writer import write

    present = _present(path)
    expected = known.text if known is not None and known.path == path else None
    if not force and present is not None and present not in (expected, text):
        return Saved(None, found=present)
    if not path.absolute().parent.is_dir():
        return Saved(None, _gone(path))
    if _is_protected(path):
        return Saved(None, _protected(path))
    # A program is handwork: no manifest remembers it.
    file = OutputFile(
        path.name, text, is_executable=False, merged_from=present, path=path, has_handwork=True
    )
    plan, problems = make_plan(path.absolute().parent, [file], Manifest())
    problems = (*problems, *plan.conflicts)
    if not problems:
        problems = write(plan).diagnostics
    if problems:
        return Saved(None, problems[0])
    return Saved(OnDisk(path, text, stamp_of(path)))


def _present(path: Path) -> bytes | None:
    try:
        return path.read_bytes()
    except OSError:
        return None


def _gone(path: Path) -> Diagnostic:
    folder = path.absolute().parent
    message = f"cannot write `{path.name}`: the folder `{folder.name}` is not there"
    return Diagnostic("cannot-write", message, file=path, help="save it under another name")


def _is_protected(path: Path) -> bool:
    """Tell whether nobody is to write a file: a rename would, whatever its mode says."""
    try:
        return not path.stat().st_mode & 0o222 or not os.access(path, os.W_OK)
    except (OSError, ValueError):
        return False


def _protected(path: Path) -> Diagnostic:
    return Diagnostic(
        "cannot-write",
        f"cannot write `{path.name}`: it is read-only",
        file=path,
        help=f"save it under another name, or allow it: chmod u+w {path.name}",
    )


def read_again(disk: OnDisk) -> OnDisk:
    """Return what the file holds now."""
    return OnDisk(disk.path, _present(disk.path), stamp_of(disk.path))


def with_suffix(path: Path) -> Path:
    """Return the path with `.plastron` at its end where it has no suffix."""
    return path if path.suffix else path.with_name(path.name + SUFFIX)
