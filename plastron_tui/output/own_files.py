"""The names of the files that the writer makes for itself, beside those that it writes.

- `.plastron-journal`: what is being replaced, from when that is decided until it is done;
- `.plastron-0.new`: the text that a file shall get;
- `.plastron-0.old`: the text that it had;
- `.plastron-0.tmp`: a text that is being copied.
"""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plastron_tui.diagnostics import Diagnostic

MANIFEST = ".plastron.json"
"""The memory of an output folder, in the folder: see `manifest`."""

PREFIX = ".plastron-"
"""How all of them start; no file that a program asks for is called so."""

JOURNAL = f"{PREFIX}journal"

JOURNAL_NEW = f"{JOURNAL}.new"
"""The journal while it is written."""

KEPT = f"{PREFIX}kept"
"""An old text of which there is no other copy; a number may follow."""

_TEMPORARY = re.compile(r"\.plastron-(?:journal|[0-9]{1,9})\.(new|old|tmp)")


def new_name(place: int) -> str:
    """Return the name of the new text of a journal's nth file."""
    return f"{PREFIX}{place}.new"


def old_name(place: int) -> str:
    """Return the name of the old text of a journal's nth file."""
    return f"{PREFIX}{place}.old"


def temporary_kind(name: str) -> str | None:
    """Return `new`, `old` or `tmp` for a temporary file's name, None for any other."""
    match = _TEMPORARY.fullmatch(name)
    return match and match[1]


def is_own_name(file: os.PathLike[str] | None) -> bool:
    """Tell whether a file is the journal or a temporary file."""
    name = "" if file is None else os.path.basename(file)
    return name == JOURNAL or temporary_kind(name) is not None


def has_leftovers(folder: str | os.PathLike[str]) -> bool:
    """Tell whether a process writes to a folder just now, or was killed while it did.

    This looks for two names only, so that it can be asked often: the first temporary file is the
    first to be made and the last to be removed.
    """
    return any(os.path.lexists(os.path.join(folder, name)) for name in (JOURNAL, new_name(0)))


def settled(folder: str | os.PathLike[str]) -> tuple[Diagnostic, ...]:
    """Finish what a process that was killed had begun to write to a folder; see `recovery.settle`.

    Every command that reads from a folder calls this first: recovery is only loaded where there is
    something to do.
    """
    if not has_leftovers(folder):
        return ()
    from pathlib import Path

    from .recovery import settle

    return settle(Path(folder))
