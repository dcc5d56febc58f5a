"""Another editor, which the user prefers, on a text of this one."""

from __future__ import annotations

import os
import shlex
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path
from shutil import rmtree, which
from tempfile import mkdtemp

from plastron_tui.project.program_file import LARGEST_PROGRAM
from plastron_tui.regular_files import read_regular, reason

USUAL: tuple[str, ...] = ("sensible-editor", "editor", "nano", "vim", "vi")
"""The editors that are looked for where no variable names one, the user's own choice first."""

NO_EDITOR = "no editor is found: name one in $EDITOR"


def external_editor(environ: Mapping[str, str]) -> list[str] | str:
    """Return the command of the user's editor, or why there is none.

    Where no variable names one, it is the system's, or one that most systems have.
    """
    for variable in ("VISUAL", "EDITOR"):
        written = environ.get(variable, "")
        try:
            command = shlex.split(written)
        except ValueError:
            return f"${variable} is `{written}`, where a quote is not closed"
        if command:
            return command
    found = (which(name, path=environ.get("PATH")) for name in USUAL)
    return next(([command] for command in found if command is not None), NO_EDITOR)


_WAYS = {
    "sensible-editor editor vi vim nvim view gvim ex elvis vile nano pico emacs emacsclient mg jed "
    "joe ne micro kak gedit pluma xed mcedit tilde": ("+{line}", "{file}"),
    "hx helix subl sublime_text zed zeditor lapce": ("{file}:{line}",),
    "code code-insiders codium vscodium code-oss": ("--goto", "{file}:{line}"),
    "kate kwrite geany": ("--line", "{line}", "{file}"),
}
"""What editors, by the names of their commands, are given to open a file at a line."""


def command_at(command: Sequence[str], file: Path, line: int) -> list[str]:
    """Return the command that opens a file at a line, from 1; of an unknown editor without it."""
    # Absolute: a name may start with what an option starts with.
    path, name = os.fspath(file.absolute()), Path(command[0]).name
    ways = (words for names, words in _WAYS.items() if name in names.split())
    return [*command, *(word.format(line=line, file=path) for word in next(ways, ("{file}",)))]


def run_editor(
    command: Sequence[str], file: Path, line: int = 1, *, and_so: str = ""
) -> str | None:
    """Open a file in an editor, and return what went wrong.

    Nothing is raised: Textual takes the terminal back only when all went well.

    Args:
        command: the editor.
        file: the file.
        line: the line, from 1.
        and_so: what follows from a status that is not 0, behind what is said of it.
    """
    try:
        done = subprocess.run(command_at(command, file, line), check=False)
    except OSError as error:
        return f"`{command[0]}` cannot be started: {reason(error)}"
    if done.returncode < 0:
        from plastron_tui.runtime.child import signal_name

        return f"`{command[0]}` was ended by {signal_name(-done.returncode)}{and_so}"
    if done.returncode:
        return f"`{command[0]}` ended with status {done.returncode}{and_so}"
    return None


class EditedElsewhere:
    """A text in a temporary file, for another editor; it is gone afterwards unless it is kept.

    After an error it stays: nobody has read what is in it.
    """

    def __init__(self, text: bytes, name: str) -> None:
        self._folder = Path(mkdtemp(prefix="plastron-"))
        self.file = self._folder / name
        self.file.write_bytes(text)
        self.is_kept = False

    def read(self) -> bytes:
        """Return what is in the file.

        Raises:
            FileNotFoundError: it is gone.
            OSError: it cannot be read, is no regular file, or is larger than a program may be.
        """
        return read_regular(self.file, LARGEST_PROGRAM)

    def __enter__(self) -> EditedElsewhere:
        return self

    def __exit__(self, error: type[BaseException] | None, *_: object) -> None:
        if error is None and not self.is_kept:
            rmtree(self._folder, ignore_errors=True)
