"""What comes of a merge."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import FileSet


class Merged(NamedTuple):
    """Merged files, or why there are none.

    Attributes:
        files: the files with the program's changes, None where the merge is refused.
        reason: why it is refused, to follow "the file was changed by hand, and".
        notes: warnings: where program and file now differ, or would.
        unsent: warnings: what the program changed, a message for instance, and the file has not.
        lost: warnings: what was written by hand and is gone.
    """

    files: FileSet | None
    reason: str = ""
    notes: tuple[Diagnostic, ...] = ()
    unsent: tuple[Diagnostic, ...] = ()
    lost: tuple[Diagnostic, ...] = ()

    @property
    def is_whole(self) -> bool:
        """Whether nothing was left out, of the program or of the handwork."""
        return self.files is None or not (self.unsent or self.lost)

    @property
    def all_notes(self) -> tuple[Diagnostic, ...]:
        """All warnings."""
        return (*self.notes, *self.unsent, *self.lost)
