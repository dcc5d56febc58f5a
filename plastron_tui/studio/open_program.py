"""What is open in the studio: a session, what its file holds, and what the text means."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.session import Options, Session

from .files import OnDisk
from .journal import Journal

if TYPE_CHECKING:
    from .analysis import Analysis


@dataclass(repr=False, eq=False)
class Open:
    """The program that is open. Handlers of the main screen own it; nobody else writes here.

    Attributes:
        session: the program; the editor edits it.
        disk: what its file held when it was read or saved last, None for a program without one.
        journal: where what was typed is kept.
        analysis: what the text meant when that was found out last.
        told: what was on the disk when it was asked about; None when nothing was.
        failed: the text that was open when an error of Plastron's own kept it from being known.
    """

    session: Session
    disk: OnDisk | None
    journal: Journal
    analysis: Analysis | None = None
    told: OnDisk | None = None
    failed: bytes | None = None

    @property
    def path(self) -> Path | None:
        """The program's file."""
        return self.session.path

    @property
    def text(self) -> bytes:
        """The program."""
        return self.session.document.text

    @property
    def saved(self) -> bytes:
        """What the file holds, as far as is known."""
        return (self.disk.text or b"") if self.disk is not None else b""

    @property
    def is_changed(self) -> bool:
        """Whether there is something to save."""
        text, saved = self.text, self.saved
        return len(text) != len(saved) or text != saved

    @property
    def is_blank(self) -> bool:
        """Whether it is a program without a file in which nothing is written yet."""
        return self.path is None and not self.text.strip()

    @property
    def name(self) -> str:
        """What the program is called."""
        return "new program" if self.path is None else self.path.name


def opened(
    disk: OnDisk | None,
    journals: Path,
    options: Options | None = None,
    text: bytes | None = None,
    begun: Path | None = None,
) -> Open:
    """Open a program.

    Args:
        disk: its file; None for a new one.
        journals: where journals are.
        options: what the command line sets.
        text: another text than that of the file, which is then not saved yet.
        begun: the folder of a new one; None for the working folder.
    """
    path = None if disk is None else disk.path
    if text is None:
        text = (disk.text or b"") if disk is not None else b""
    session = Session(text, path, options, begun=begun)
    return Open(session, disk, Journal(journals, path, session.folder if path is None else None))
